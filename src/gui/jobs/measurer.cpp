#include "gui/jobs/measurer.hpp"

#include <exception>
#include <utility>

#include "base/error.hpp"
#include "session/classifier.hpp"

namespace moldlight::gui {

/// Context and classifier, kept from one request to the next. Lives on the measurer's thread only.
class Measurer::Worker {
 public:
  Classification measure(const MakeContext& make_context, const Request& request, const Progress& progress) {
    if (!context_ || backend_ != request.settings.backend) {
      classifier_.reset();
      context_.reset();
      context_ = make_context(request.settings.backend);
      backend_ = request.settings.backend;
    }
    context_->make_current();
    if (!classifier_ || &classifier_->model() != request.model.get()) {
      classifier_.reset();
      classifier_.emplace(*context_, request.model);
    }
    return classifier_->classify(request.settings, progress);
  }

 private:
  Backend backend_ = Backend::automatic;
  std::unique_ptr<gl::Context> context_;
  std::optional<Classifier> classifier_;
};

Measurer::Measurer(MakeContext make_context, std::function<void()> wake)
    : make_context_(std::move(make_context)), wake_(std::move(wake)), thread_([this] { run(); }) {}

Measurer::~Measurer() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    if (running_) running_->cancel();
  }
  changed_.notify_all();
  thread_.join();
}

void Measurer::request(std::shared_ptr<const PartModel> model, const MethodSettings& settings) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = Request{std::move(model), settings};
    outcome_.reset();
    if (running_) running_->cancel();
  }
  changed_.notify_all();
}

void Measurer::cancel() {
  const std::lock_guard lock(mutex_);
  waiting_.reset();
  outcome_.reset();
  if (running_) running_->cancel();
}

bool Measurer::busy() const {
  const std::lock_guard lock(mutex_);
  return waiting_.has_value() || (running_ && !running_->cancelled());
}

JobStatus Measurer::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::optional<Measurer::Outcome> Measurer::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(outcome_, std::nullopt);
}

void Measurer::run() {
  Worker worker;
  while (true) {
    Request request;
    std::shared_ptr<Progress> progress;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return ending_ || waiting_.has_value(); });
      if (ending_) return;
      request = *std::exchange(waiting_, std::nullopt);
      progress = std::make_shared<Progress>([this](std::string_view stage, double fraction) {
        const std::lock_guard status_lock(mutex_);
        status_ = {std::string(stage), fraction};
      });
      running_ = progress;
    }
    Outcome outcome{.model = request.model, .settings = request.settings, .classification = {}, .error = {}};
    try {
      outcome.classification = worker.measure(make_context_, request, *progress);
    } catch (const Cancelled&) {
    } catch (const std::exception& error) {
      outcome.error = error.what();
    }
    {
      const std::lock_guard lock(mutex_);
      running_.reset();
      if (!progress->cancelled()) outcome_ = std::move(outcome);
    }
    wake_();
  }
}

}  // namespace moldlight::gui
