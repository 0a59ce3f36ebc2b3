#pragma once
// Cancellable background work. A Job runs once on its own thread; destroying it cancels and joins,
// but for a LooseJob, which is left to end by itself.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>

#include "renderer/base/result.h"

namespace pileus {

/// What a running job sees: it reports a fraction and looks at `cancelled()` at least every 20 ms or so.
class JobControl {
 public:
  void progress(double fraction) { fraction_.store(fraction, std::memory_order_relaxed); }
  double progress() const { return fraction_.load(std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

 private:
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> cancelled_{false};
};

/// Called after any job has ended or published a part, from the job's thread (the window uses it to wake up).
/// May be null.
void setJobNotifier(std::function<void()> notifier);
void notifyJobs();

/// Runs `work`; what a library throws in it becomes an Error: the thread it runs on has nobody to catch it.
template <class T, class Work>
Result<T> withoutThrowing(Work& work, JobControl& control) {
  try {
    return work(control);
  } catch (const std::bad_alloc&) {
    return Error{Code::Input, "out of memory: close other programs, or make it smaller", true};
  } catch (const std::exception& e) {
    return fail(Code::Internal, "{}", e.what());
  } catch (...) {
    return fail(Code::Internal, "it was ended by an unknown exception");
  }
}

template <class T>
class Job {
 public:
  template <class Work>  // Result<T>(JobControl&)
  explicit Job(Work work) : control_(std::make_unique<JobControl>()) {
    thread_ = std::thread([this, work = std::move(work)] {
      Result<T> r = withoutThrowing<T>(work, *control_);
      {
        const std::lock_guard lock(mutex_);
        result_.emplace(std::move(r));
        done_.store(true, std::memory_order_release);
      }
      ended_.notify_all();
      notifyJobs();
    });
  }
  ~Job() {
    control_->cancel();
    if (thread_.joinable()) thread_.join();
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  bool done() const { return done_.load(std::memory_order_acquire); }
  double progress() const { return control_->progress(); }
  void cancel() { control_->cancel(); }
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  /// At most so many milliseconds; done()?
  bool waitFor(double ms) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, std::chrono::duration<double, std::milli>(ms), [&] { return done(); });
  }
  /// Only after done(). The result stays, so that it can be looked at twice.
  const Result<T>& result() const { return *result_; }

 private:
  std::unique_ptr<JobControl> control_;
  std::atomic<bool> done_{false};
  std::mutex mutex_;
  std::condition_variable ended_;
  std::optional<Result<T>> result_;
  std::thread thread_;
};

/// Keeps a cancelled job until it has ended, without waiting for it: any thread.
void retireJob(std::shared_ptr<void> job, std::function<bool()> done);
/// Waits for all of them; before the program ends.
void joinRetiredJobs();

/// For jobs of which nobody needs to know that they have ended, and that may take a while to notice that they
/// are cancelled. Their work must hold all it uses.
struct RetireJob {
  template <class T>
  void operator()(Job<T>* job) const {
    std::shared_ptr<Job<T>> kept(job);
    kept->cancel();
    if (!kept->done()) retireJob(kept, [job] { return job->done(); });
  }
};
template <class T>
using LooseJob = std::unique_ptr<Job<T>, RetireJob>;
template <class T, class Work>
LooseJob<T> looseJob(Work work) {
  return LooseJob<T>(new Job<T>(std::move(work)));
}

}  // namespace pileus
