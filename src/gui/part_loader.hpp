// Loads one part at a time; a later request takes the place of an earlier one.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "gui/app_state.hpp"
#include "gui/jobs/load_job.hpp"

namespace moldlight::gui {

class PartLoader {
 public:
  PartLoader(ReadOptions options, std::function<void()> wake) : options_(options), wake_(std::move(wake)) {}

  void start(const std::string& path);
  void cancel();
  [[nodiscard]] bool loading() const { return job_ != nullptr; }
  [[nodiscard]] std::optional<Loading> status() const;

  /// What became of the job, once: a part, or the reason why there is none (empty if it was cancelled).
  struct Outcome {
    std::optional<LoadedPart> part;
    std::string error;
  };
  [[nodiscard]] std::optional<Outcome> take();

 private:
  ReadOptions options_;
  std::function<void()> wake_;
  std::unique_ptr<LoadJob> job_;
  std::list<std::unique_ptr<LoadJob>> given_up_;  // until their threads have ended
};

}  // namespace moldlight::gui
