#include "renderer/base/jobs.h"

namespace pileus {
namespace {

struct Notifier {
  std::mutex mutex;
  std::function<void()> call;
};

Notifier& notifier() {
  static Notifier n;
  return n;
}

}  // namespace

void setJobNotifier(std::function<void()> call) {
  const std::lock_guard lock(notifier().mutex);
  notifier().call = std::move(call);
}

void notifyJobs() {
  const std::lock_guard lock(notifier().mutex);
  if (notifier().call) notifier().call();
}

}  // namespace pileus
