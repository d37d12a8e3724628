// Work in the background for whoever asks again and again and wants the newest answer only.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "base/stopwatch.hpp"

namespace moldlight {

/// One thread that does the newest request when it is free. A newer request takes the place of the one that
/// waits; what runs is done to its end, so that answers come however fast requests do.
template <typename Request, typename Outcome>
class LatestJob {
 public:
  struct Options {
    /// Called, and at last destroyed, on the job's thread. Cancelled means no outcome; other exceptions must
    /// not leave it.
    std::function<Outcome(const Request&, const Progress&)> work;
    /// Called on the job's thread when an outcome is there.
    std::function<void()> wake = [] {};
    /// How long to leave the cores to others after a piece of work, from the time that it took; seconds.
    std::function<double(double)> pause_s = [](double) { return 0.0; };
  };

  explicit LatestJob(Options options) : options_(std::move(options)), thread_([this] { run(); }) {}
  /// Cancels, and waits for the thread.
  ~LatestJob() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      if (running_) running_->cancel();
    }
    changed_.notify_all();
    thread_.join();
  }
  LatestJob(const LatestJob&) = delete;
  LatestJob& operator=(const LatestJob&) = delete;

  void request(Request request) {
    {
      const std::lock_guard lock(mutex_);
      waiting_ = std::move(request);
    }
    changed_.notify_all();
  }
  /// Gives up what runs or waits, and what was not taken.
  void cancel() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    outcome_.reset();
    if (running_) running_->cancel();
  }
  [[nodiscard]] bool busy() const {
    const std::lock_guard lock(mutex_);
    return waiting_.has_value() || (running_ && !running_->cancelled());
  }
  /// The newest outcome, once.
  [[nodiscard]] std::optional<Outcome> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
  }

 private:
  void run() {
    const auto work = std::move(options_.work);
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ending_ || waiting_.has_value(); });
      if (ending_) return;
      const Request request = *std::exchange(waiting_, std::nullopt);
      const auto progress = std::make_shared<Progress>();
      running_ = progress;
      lock.unlock();
      const Stopwatch stopwatch;
      std::optional<Outcome> outcome;
      try {
        outcome = work(request, *progress);
      } catch (const Cancelled&) {
      }
      const double took_s = stopwatch.elapsed_ms() / 1000.0;
      lock.lock();
      running_.reset();
      if (outcome && !progress->cancelled()) {
        outcome_ = std::move(outcome);
        lock.unlock();
        options_.wake();
        lock.lock();
      }
      const std::chrono::duration<double> pause(options_.pause_s(took_s));
      changed_.wait_for(lock, pause, [this] { return ending_; });
    }
  }

  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> waiting_;
  std::shared_ptr<Progress> running_;
  std::optional<Outcome> outcome_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace moldlight
