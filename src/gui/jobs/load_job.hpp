// Reading a part on a thread of its own, with progress and cancelling.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "base/progress.hpp"
#include "gui/feature_directions.hpp"
#include "render/view_geometry.hpp"
#include "session/part_model.hpp"

namespace moldlight::gui {

/// What a job is at.
struct JobStatus {
  std::string stage;
  double fraction = 0.0;  // of the stage, [0, 1]
};

/// A part and what its pictures need, ready for the GL; copies share it.
struct LoadedPart {
  std::string path;
  std::shared_ptr<const PartModel> model;
  std::shared_ptr<const ViewGeometry> geometry;
  std::vector<FeatureDirection> features;
};

class LoadJob {
 public:
  /// Starts at once. `wake` is called from the job's thread when there is something new to show.
  LoadJob(std::string path, ReadOptions options, std::function<void()> wake);
  /// Cancels, and waits for the thread.
  ~LoadJob();
  LoadJob(const LoadJob&) = delete;
  LoadJob& operator=(const LoadJob&) = delete;

  void cancel() { progress_.cancel(); }
  [[nodiscard]] bool cancelled() const { return progress_.cancelled(); }
  [[nodiscard]] bool done() const { return done_.load(std::memory_order_acquire); }
  [[nodiscard]] JobStatus status() const;
  [[nodiscard]] const std::string& path() const { return path_; }
  /// The part, once done, once; throws what the reading threw (FileError, Cancelled, …).
  [[nodiscard]] LoadedPart take();

 private:
  void run();

  const std::string path_;
  const ReadOptions options_;
  const std::function<void()> wake_;
  mutable std::mutex mutex_;
  JobStatus status_;
  LoadedPart loaded_;
  std::exception_ptr failure_;
  std::atomic<bool> done_ = false;
  Progress progress_;
  std::thread thread_;
};

}  // namespace moldlight::gui
