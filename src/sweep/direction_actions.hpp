// The side actions of a sweep's directions, several directions at a time.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <tbb/task_arena.h>

#include "actions/least_actions.hpp"
#include "actions/side_action.hpp"
#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight {

/// What the least set of side actions of one direction comes to.
struct DirectionActions {
  UndercutTotals undercuts = {};
  ActionTotals totals = {};
  double weight = 0.0;       // of their kinds, summed up
  double in_vain = 0.0;      // of the weight what does not count
  double travel = 0.0;       // of the one that travels farthest, part's unit; 0 without any
  double formed_area = 0.0;  // of undercuts that the k_most_actions release that form most
  double beyond = 0.0;       // of those that only the others release
  bool given_up = false;     // the search: weight, or what is left, comes to no less than this
  bool whole = false;        // it is known what their bodies allow

  /// "2 slides, 1 lifter"; "none".
  [[nodiscard]] std::string text() const { return actions_text(totals.counts); }
};
/// `split` is what the plan is for. An action counts by the share that is released of the undercut that it
/// forms, since the rest keeps the part in its mold; an insert that forms less than a thousandth of the
/// surface, a detail that the part's designer would rather change, by its share of that.
[[nodiscard]] DirectionActions direction_actions(const ActionPlan& plan, const Classification& split);

/// Where the search for side actions of a direction is not worth it.
struct ActionLimit {
  double most = std::numeric_limits<double>::infinity();  // of their weight and what is added for the surface
  double per_area = 0.0;                                  // that they form, for the part's unit squared
  /// Areas: what the best so far leaves unreleased or to more than k_most_actions, and a difference that
  /// counts. What leaves less than that is not given up by its weight.
  double left = 0.0, left_band = 0.0;
  /// Of a direction beside it whose side actions release all: as many undercuts, as large, need no fewer.
  std::optional<UndercutTotals> beside = {};
  double most_undercut = std::numeric_limits<double>::infinity();  // area beside such directions, if any
  double most_left = std::numeric_limits<double>::infinity();      // area at which the search is given up
  double most_of_many = std::numeric_limits<double>::infinity();   // area where there are many undercuts
  /// What few samples show to be too much is given up, too, and these do where there are many undercuts.
  bool roughly = false;

  [[nodiscard]] bool is_exceeded(const LeastActions& least, const UndercutTotals& undercuts) const;
  [[nodiscard]] bool is_far_exceeded(const DirectionActions& rough) const;
};

class DirectionActionFinder {
 public:
  /// `jobs`: the number of threads. All but them must outlive the finder.
  DirectionActionFinder(const PartModel& model, const MethodSettings& method, const ActionSettings& settings,
                        int jobs);
  ~DirectionActionFinder();

  /// In the order of the directions, whatever the number of threads; nothing for what the clock stops before
  /// it is begun, or cancels. `done` is called after each, from any thread. `limits`: of each, or none.
  /// Bodies are moved where the detail is `whole`. The clock must outlive the finder.
  [[nodiscard]] std::vector<std::optional<DirectionActions>> find(
      std::span<const glm::dvec3> directions, std::span<const ActionLimit> limits, const SweepClock& clock,
      PlanDetail detail = PlanDetail::rank, const std::function<void()>& done = [] {});

 private:
  struct Kept;

  [[nodiscard]] std::optional<DirectionActions> find_one(const glm::dvec3& direction,
                                                         const ActionLimit& limit, PlanDetail detail,
                                                         const SweepClock& clock);
  /// What is possible of a direction that may be asked for as a whole later, as long as there is room.
  void keep(std::unique_ptr<Kept> search);
  [[nodiscard]] std::unique_ptr<Kept> take(const glm::dvec3& direction);

  const PartModel& model_;
  const MethodSettings& method_;
  const ActionSettings& settings_;
  int jobs_;
  tbb::task_arena arena_;
  std::mutex mutex_;  // of what is kept
  std::vector<std::unique_ptr<Kept>> kept_;
};

}  // namespace moldlight
