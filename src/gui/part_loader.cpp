#include "gui/part_loader.hpp"

#include <utility>

#include "base/error.hpp"

namespace moldlight::gui {

void PartLoader::start(const std::string& path) {
  cancel();
  job_ = std::make_unique<LoadJob>(path, options_, wake_);
}

void PartLoader::cancel() {
  if (!job_) return;
  // Waiting for its thread here would freeze the window.
  job_->cancel();
  given_up_.push_back(std::move(job_));
}

std::optional<Loading> PartLoader::status() const {
  if (!job_) return std::nullopt;
  return Loading{job_->path(), job_->status()};
}

std::optional<PartLoader::Outcome> PartLoader::take() {
  given_up_.remove_if([](const auto& job) { return job->done(); });
  if (!job_ || !job_->done()) return std::nullopt;
  const std::unique_ptr<LoadJob> job = std::move(job_);
  Outcome outcome;
  try {
    outcome.part = job->take();
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    outcome.error = error.what();
  }
  return outcome;
}

}  // namespace moldlight::gui
