#include "renderer/base/jobs.h"

#include <algorithm>
#include <iterator>
#include <vector>

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

struct Retired {
  struct Entry {
    std::shared_ptr<void> job;
    std::function<bool()> done;
  };
  std::mutex mutex;
  std::vector<Entry> jobs;
};

Retired& retired() {
  static Retired r;
  return r;
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

void retireJob(std::shared_ptr<void> job, std::function<bool()> done) {
  std::vector<Retired::Entry> ended;  // joined outside the lock
  const std::lock_guard lock(retired().mutex);
  std::vector<Retired::Entry>& jobs = retired().jobs;
  const auto split = std::partition(jobs.begin(), jobs.end(), [](const auto& e) { return !e.done(); });
  ended.assign(std::make_move_iterator(split), std::make_move_iterator(jobs.end()));
  jobs.erase(split, jobs.end());
  jobs.push_back({std::move(job), std::move(done)});
}

void joinRetiredJobs() {
  std::vector<Retired::Entry> all;
  {
    const std::lock_guard lock(retired().mutex);
    all.swap(retired().jobs);
  }
  all.clear();
}

}  // namespace pileus
