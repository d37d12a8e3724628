#include "gui/jobs/load_job.hpp"

#include <utility>

#include "base/check.hpp"

namespace moldlight::gui {

LoadJob::LoadJob(std::string path, ReadOptions options, std::function<void()> wake)
    : path_(std::move(path)),
      options_(options),
      wake_(std::move(wake)),
      status_{"reading", 0.0},
      progress_([this](std::string_view stage, double fraction) {
        {
          const std::lock_guard lock(mutex_);
          status_ = {std::string(stage), fraction};
        }
        wake_();
      }),
      thread_([this] { run(); }) {}

LoadJob::~LoadJob() {
  cancel();
  thread_.join();
}

void LoadJob::run() {
  try {
    loaded_.path = path_;
    loaded_.model = load_part(path_, options_, progress_);
    progress_.report("preparing the picture", 0.0);
    const PartModel& model = *loaded_.model;
    loaded_.geometry = std::make_shared<const ViewGeometry>(
        view_geometry(model.part.mesh, model.geometry, model.adjacency, model.frame));
    loaded_.features = feature_directions(model, progress_);
    progress_.report("ready", 1.0);
  } catch (...) {
    failure_ = std::current_exception();
  }
  done_.store(true, std::memory_order_release);
  wake_();
}

JobStatus LoadJob::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

LoadedPart LoadJob::take() {
  CHECK(done());
  if (failure_) std::rethrow_exception(failure_);
  return std::move(loaded_);
}

}  // namespace moldlight::gui
