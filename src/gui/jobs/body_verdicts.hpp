// The verdict on each body of the file as a part of its own, in the background, a few at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/job.hpp"
#include "gui/app_state.hpp"

namespace moldlight::gui {

class BodyVerdicts {
 public:
  /// `wake` is called from another thread when some are there.
  explicit BodyVerdicts(std::function<void()> wake) : job_({.wake = std::move(wake)}) {}

  /// Call it every frame. `wanted`: they are looked at, and no hand is at the settings.
  void update(const AppState& state, BodiesState& bodies, bool wanted);
  void cancel() { job_.give_up(); }

 private:
  using Found = std::vector<std::pair<std::size_t, Verdict>>;
  static Found found(const LoadedPart& whole, const Questions& questions,
                     const std::vector<std::size_t>& asked, const Progress& progress);

  std::shared_ptr<const LoadedPart> of_;
  std::optional<std::pair<Query, ActionSettings>> asked_;
  Job<Found> job_;
};

}  // namespace moldlight::gui
