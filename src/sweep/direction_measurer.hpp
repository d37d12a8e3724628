// Exact figures of a sweep's directions, several at a time.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <tbb/task_arena.h>

#include "actions/undercut.hpp"
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
  std::vector<FacetIndex> undercut_facets;  // those with some undercut
  // Where the measurer was asked for it:
  std::optional<UndercutTotals> undercuts = {};
  std::optional<LineFigures> parting = {};
  bool lineless = false;  // it was asked for, and there is none, as of Assignment::lineless
};

/// What else is found of a direction, each in about the time that the regions take.
struct MeasuredBeside {
  bool undercuts = false, parting = false;
  double least_travel_mm = k_least_travel_mm;  // of the undercuts that count
};

class DirectionMeasurer {
 public:
  /// `jobs`: the number of threads.
  DirectionMeasurer(const PartModel& model, const MethodSettings& method, int jobs,
                    const MeasuredBeside& beside = {})
      : model_(model), method_(method), beside_(beside), arena_(arena_threads(jobs)) {}

  /// In the order of the tasks, whatever the number of threads; nothing where the undercut area is certain to
  /// be above the task's limit, for what is not begun when `stop` says so, and for what `progress` cancels.
  /// `first`: facets likely to be undercut, each once.
  [[nodiscard]] std::vector<std::optional<MeasuredDirection>> measure(std::span<const ScoringTask> tasks,
                                                                      std::span<const FacetIndex> first,
                                                                      const Progress& progress,
                                                                      const std::function<bool()>& stop);

  /// Finds what else there is of a direction, as far as it is not known. Throws Cancelled.
  void complete(MeasuredDirection& measured, const Progress& progress);
  /// Finds the parting lines of several at a time; of those that `progress` cancels there is none.
  void find_lines(std::span<MeasuredDirection* const> measured, const Progress& progress);

 private:
  void find_beside(MeasuredDirection& measured, const MeasuredBeside& asked, const Progress& progress) const;
  [[nodiscard]] std::optional<MeasuredDirection> measure_one(const glm::dvec3& direction,
                                                             const UndercutLimit& limit,
                                                             const Progress& progress) const;

  const PartModel& model_;
  MethodSettings method_;
  MeasuredBeside beside_;
  tbb::task_arena arena_;
};

}  // namespace moldlight
