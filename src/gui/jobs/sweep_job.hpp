// A sweep on a thread of its own, with a GL context and a classifier of its own, so that its figures are
// those of every other output to the bit.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/progress.hpp"
#include "gui/jobs/load_job.hpp"
#include "gui/jobs/measurer.hpp"
#include "session/sweep/sweep_result.hpp"

namespace moldlight::gui {

class SweepJob {
 public:
  /// Starts at once. `wake` is called from the job's thread when it is done.
  SweepJob(std::shared_ptr<const PartModel> model, SweepSettings settings, Measurer::MakeContext make_context,
           std::function<void()> wake);
  /// Cancels, and waits for the thread.
  ~SweepJob();
  SweepJob(const SweepJob&) = delete;
  SweepJob& operator=(const SweepJob&) = delete;

  /// Ends the sweep early; what is done by then is its result.
  void cancel() { progress_.cancel(); }
  [[nodiscard]] bool cancelled() const { return progress_.cancelled(); }
  [[nodiscard]] bool done() const { return done_.load(std::memory_order_acquire); }
  [[nodiscard]] JobStatus status() const;
  /// Directions scored since the last call, in the order in which their scores came.
  [[nodiscard]] std::vector<EvaluatedDirection> take_evaluated();
  /// The result, once done, once; throws what the sweep threw (UsageError, Error, …).
  [[nodiscard]] SweepResult take();

 private:
  void run();

  const std::shared_ptr<const PartModel> model_;
  const SweepSettings settings_;
  const Measurer::MakeContext make_context_;
  const std::function<void()> wake_;
  mutable std::mutex mutex_;
  JobStatus status_;
  std::vector<EvaluatedDirection> evaluated_;
  SweepResult result_;
  std::exception_ptr failure_;
  std::atomic<bool> done_ = false;
  Progress progress_;
  std::thread thread_;
};

}  // namespace moldlight::gui
