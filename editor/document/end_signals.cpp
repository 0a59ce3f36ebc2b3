#include "editor/document/end_signals.h"

#include <pthread.h>
#include <signal.h>

#include <atomic>
#include <thread>

#include "renderer/base/jobs.h"

namespace pileus::editor {
namespace {

std::atomic<int> ended{0};

}  // namespace

void watchEndSignals() {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::sigaddset(&set, signal);
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);  // inherited by every thread: only the one below takes them
  std::thread([set] {
    for (int signal = 0; ::sigwait(&set, &signal) == 0;) {
      // Twice: whoever sends it does not want to wait.
      if (ended.exchange(signal) != 0) {
        ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
        ::signal(signal, SIG_DFL);
        ::raise(signal);
      }
      notifyJobs();  // wakes the window
    }
  }).detach();
}

int endSignal() { return ended.load(); }

}  // namespace pileus::editor
