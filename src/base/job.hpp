// Work in the background, one piece at a time on a thread of the job's own, which gives way to those that
// draw; with progress, cancelling and a result.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/priority.hpp"
#include "base/progress.hpp"
#include "base/stopwatch.hpp"

namespace moldlight {

/// What a job is at.
struct JobStatus {
  std::string stage;
  double fraction = 0.0;  // of the stage, [0, 1]
};

struct JobOptions {
  /// Called on the job's thread when an outcome is there.
  std::function<void()> wake = [] {};
  bool wake_for_progress = false;  // and at each report of progress
  /// How long to leave the cores to others after a piece of work, from the time that it took; seconds.
  std::function<double(double)> pause_s = [](double) { return 0.0; };
  /// Called last on the job's thread, which may have made what is to be destroyed there.
  std::function<void()> at_end = [] {};
};

template <typename Result>
class Job {
 public:
  using Work = std::function<Result(const Progress&)>;
  /// What became of the work.
  struct Outcome {
    std::optional<Result> result = {};
    std::string error = {};  // why there is no result; empty if it was cancelled
  };

  explicit Job(JobOptions options = {}) : options_(std::move(options)), thread_([this] { run(); }) {}
  /// Cancels, and waits for the thread.
  ~Job() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      if (running_) running_->progress.cancel();
    }
    changed_.notify_all();
    thread_.join();
  }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Gives up what runs, and does this in its place. `first`: what it is at until it reports.
  void start(Work work, JobStatus first = {}) {
    give_up();
    follow(std::move(work), std::move(first));
  }
  /// Does this once what runs has ended, in place of what waited for that: answers come however fast one
  /// asks.
  void follow(Work work, JobStatus first = {}) {
    {
      const std::lock_guard lock(mutex_);
      waiting_ = std::make_shared<Run>(std::move(work), std::move(first), options_);
    }
    changed_.notify_all();
  }
  /// Asks what runs to end early; its outcome can be taken.
  void cancel() {
    const std::lock_guard lock(mutex_);
    for (const auto& run : {running_, waiting_})
      if (run) run->progress.cancel();
  }
  /// Gives up what runs or waits, and what was not taken. Does not wait for its end.
  void give_up() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    outcome_.reset();
    if (!running_) return;
    running_->progress.cancel();
    running_->given_up = true;
  }

  /// Until the outcome was taken.
  [[nodiscard]] bool running() const {
    const std::lock_guard lock(mutex_);
    return current() != nullptr || outcome_.has_value();
  }
  [[nodiscard]] bool cancelled() const {
    const std::lock_guard lock(mutex_);
    return current() != nullptr && current()->progress.cancelled();
  }
  /// Of the work that runs or waits.
  [[nodiscard]] JobStatus status() const {
    const std::lock_guard lock(mutex_);
    return current() != nullptr ? current()->last_status() : JobStatus();
  }
  /// The newest outcome, once.
  [[nodiscard]] std::optional<Outcome> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
  }

 private:
  struct Run {
    Run(Work asked, JobStatus first, const JobOptions& options)
        : work(std::move(asked)),
          status(std::move(first)),
          progress([this, wake = options.wake_for_progress ? options.wake : [] {}](std::string_view stage,
                                                                                   double fraction) {
            {
              const std::lock_guard lock(mutex);
              status = {std::string(stage), fraction};
            }
            wake();
          }) {}
    [[nodiscard]] JobStatus last_status() const {
      const std::lock_guard lock(mutex);
      return status;
    }

    const Work work;
    mutable std::mutex mutex;
    JobStatus status;
    Progress progress;
    bool given_up = false;  // under the job's lock
  };

  [[nodiscard]] const Run* current() const {
    return running_ && !running_->given_up ? running_.get() : waiting_.get();
  }

  static Outcome outcome_of(const Run& run) {
    Outcome outcome;
    try {
      outcome.result = run.work(run.progress);
    } catch (const Cancelled&) {
    } catch (const std::exception& error) {
      outcome.error = error.what();
    }
    return outcome;
  }

  void run() {
    give_way();
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ending_ || waiting_; });
      if (ending_) break;
      running_ = std::exchange(waiting_, nullptr);
      lock.unlock();
      const Stopwatch stopwatch;
      Outcome outcome = outcome_of(*running_);
      const std::chrono::duration<double> pause(options_.pause_s(stopwatch.elapsed_ms() / 1000.0));
      lock.lock();
      const bool counts = !running_->given_up;
      if (counts) outcome_ = std::move(outcome);
      running_.reset();
      lock.unlock();
      if (counts) options_.wake();
      lock.lock();
      changed_.wait_for(lock, pause, [this] { return ending_; });
    }
    lock.unlock();
    options_.at_end();
  }

  const JobOptions options_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<Run> waiting_, running_;
  std::optional<Outcome> outcome_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace moldlight
