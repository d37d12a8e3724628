// The sweep: candidate directions from the part and the sphere, scored coarsely, the best refined, and the
// top of them classified with the user's settings.
#pragma once

#include <memory>
#include <string>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// Runs a sweep on the calling thread and `settings.jobs` others. What is listed has exact figures, whatever
/// the method's readout. Cancelling the progress or running into the time limit ends the sweep early: what is
/// done by then is in the result, which says that it is not complete. After the time limit the best direction
/// still gets its figures; once cancelled nothing more is measured, and the list is made by the scores.
/// Throws UsageError, Error.
[[nodiscard]] SweepResult run_sweep(std::shared_ptr<const PartModel> model, const SweepSettings& settings,
                                    const Progress& progress, const SweepListener& listener);

/// What a sweep with the usual settings recommends for a method.
struct BestDirection {
  glm::dvec3 direction{0, 0, 1};  // unit; the core is on its side
  std::string name, why;          // in words
  double off_axis_deg = 0.0;      // from the nearest axis of the file; 0 for an axis
  std::string off_axis;           // that it is none, for the user; empty for an axis
};
/// Looks at no more than that takes. Throws as run_sweep() does.
[[nodiscard]] BestDirection best_direction(const std::shared_ptr<const PartModel>& model,
                                           const MethodSettings& method, const Progress& progress);

}  // namespace moldlight
