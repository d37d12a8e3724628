// Exact figures of a sweep's directions, several at a time.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <tbb/task_arena.h>

#include "base/progress.hpp"
#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "parting/line_figures.hpp"
#include "sweep/arena_threads.hpp"
#include "sweep/direction_scorer.hpp"

namespace moldlight {

/// What classify says of a direction, without the facets' fractions.
struct MeasuredDirection {
  Classification classification;
  std::size_t patches = 0;                  // connected undercut patches
  std::vector<FacetIndex> undercut_facets;  // those with some undercut
  std::optional<LineFigures> parting = {};  // where the measurer was asked for it
};

class DirectionMeasurer {
 public:
  /// `jobs`: the number of threads. `with_parting`: the parting line is found, too, in about twice the time.
  DirectionMeasurer(const PartModel& model, const MethodSettings& method, int jobs, bool with_parting = false)
      : model_(model), method_(method), with_parting_(with_parting), arena_(arena_threads(jobs)) {}

  /// In the order of the tasks, whatever the number of threads; nothing where the undercut area is certain to
  /// be above the task's limit, for what is not begun when `stop` says so, and for what `progress` cancels.
  /// `first`: facets likely to be undercut, each once.
  [[nodiscard]] std::vector<std::optional<MeasuredDirection>> measure(std::span<const ScoringTask> tasks,
                                                                      std::span<const FacetIndex> first,
                                                                      const Progress& progress,
                                                                      const std::function<bool()>& stop);

 private:
  [[nodiscard]] std::optional<MeasuredDirection> measure_one(const glm::dvec3& direction,
                                                             const UndercutLimit& limit,
                                                             const Progress& progress) const;

  const PartModel& model_;
  MethodSettings method_;
  bool with_parting_;
  tbb::task_arena arena_;
};

}  // namespace moldlight
