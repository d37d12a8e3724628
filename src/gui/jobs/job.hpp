// One piece of work at a time on a thread of its own, with progress, cancelling and a result.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/progress.hpp"

namespace moldlight::gui {

/// What a job is at.
struct JobStatus {
  std::string stage;
  double fraction = 0.0;  // of the stage, [0, 1]
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

  /// `wake` is called from the job's thread when it is done, and at each report of progress if that is asked
  /// for.
  explicit Job(std::function<void()> wake, bool wake_for_progress = false)
      : wake_(std::move(wake)), wake_for_progress_(wake_for_progress) {}
  /// Cancels, and waits for the threads.
  ~Job() { cancel(); }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Starts at once; what runs is given up.
  void start(Work work, JobStatus first = {}) {
    give_up();
    run_ = std::make_unique<Run>(std::move(work), std::move(first), *this);
  }
  /// Asks the work to end early; its outcome can be taken.
  void cancel() {
    if (run_) run_->progress.cancel();
  }
  /// Cancels, and forgets the outcome. Does not wait, which would freeze the window.
  void give_up() {
    cancel();
    if (run_) given_up_.push_back(std::move(run_));
  }

  /// Until the outcome was taken.
  [[nodiscard]] bool running() const { return run_ != nullptr; }
  [[nodiscard]] bool cancelled() const { return run_ && run_->progress.cancelled(); }
  /// Of the work that runs.
  [[nodiscard]] JobStatus status() const {
    if (!run_) return {};
    const std::lock_guard lock(run_->mutex);
    return run_->status;
  }
  /// The outcome, once done, once.
  [[nodiscard]] std::optional<Outcome> take() {
    const auto ended = [](const auto& run) { return run->done.load(std::memory_order_acquire); };
    given_up_.remove_if(ended);
    if (!run_ || !ended(run_)) return std::nullopt;
    return std::move(std::exchange(run_, nullptr)->outcome);
  }

 private:
  struct Run {
    Run(Work work, JobStatus first, const Job& job)
        : status(std::move(first)),
          progress([this, wake = job.wake_, wakes = job.wake_for_progress_](std::string_view stage,
                                                                            double fraction) {
            {
              const std::lock_guard lock(mutex);
              status = {std::string(stage), fraction};
            }
            if (wakes) wake();
          }),
          thread([this, work = std::move(work), wake = job.wake_] {
            try {
              outcome.result = work(progress);
            } catch (const Cancelled&) {
            } catch (const std::exception& error) {
              outcome.error = error.what();
            }
            done.store(true, std::memory_order_release);
            wake();
          }) {}

    std::mutex mutex;
    JobStatus status;
    Outcome outcome;
    std::atomic<bool> done = false;
    Progress progress;
    std::jthread thread;
  };

  const std::function<void()> wake_;
  const bool wake_for_progress_;
  std::unique_ptr<Run> run_;
  std::list<std::unique_ptr<Run>> given_up_;  // until their threads have ended
};

}  // namespace moldlight::gui
