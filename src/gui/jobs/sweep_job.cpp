#include "gui/jobs/sweep_job.hpp"

#include <utility>

#include <sys/resource.h>

#include "base/check.hpp"
#include "session/classifier.hpp"
#include "session/sweep/sweep.hpp"

namespace moldlight::gui {

namespace {

constexpr int k_niceness = 5;

/// The window's own thread goes first. On Linux this is a matter of the calling thread and those it starts.
void stand_back() { static_cast<void>(setpriority(PRIO_PROCESS, 0, k_niceness)); }

}  // namespace

SweepJob::SweepJob(std::shared_ptr<const PartModel> model, SweepSettings settings,
                   Measurer::MakeContext make_context, std::function<void()> wake)
    : model_(std::move(model)),
      settings_(std::move(settings)),
      make_context_(std::move(make_context)),
      wake_(std::move(wake)),
      progress_([this](std::string_view stage, double fraction) {
        const std::lock_guard lock(mutex_);
        status_ = {std::string(stage), fraction};
      }),
      thread_([this] { run(); }) {}

SweepJob::~SweepJob() {
  cancel();
  thread_.join();
}

JobStatus SweepJob::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::vector<EvaluatedDirection> SweepJob::take_evaluated() {
  const std::lock_guard lock(mutex_);
  return std::exchange(evaluated_, {});
}

SweepResult SweepJob::take() {
  CHECK(done());
  if (failure_) std::rethrow_exception(failure_);
  return std::move(result_);
}

void SweepJob::run() {
  stand_back();
  try {
    const std::unique_ptr<gl::Context> context = make_context_(settings_.method.backend);
    context->make_current();
    Classifier classifier(*context, model_);
    const SweepListener listener{.evaluated = [this](const EvaluatedDirection& direction) {
      const std::lock_guard lock(mutex_);
      evaluated_.push_back(direction);
    }};
    result_ = run_sweep(classifier, settings_, progress_, listener);
  } catch (...) {
    failure_ = std::current_exception();
  }
  done_.store(true, std::memory_order_release);
  wake_();
}

}  // namespace moldlight::gui
