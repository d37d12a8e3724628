// The few directions of a ranking that are worth a look, each with what it wins and costs.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/part_model.hpp"
#include "sweep/mold_rank.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// The first is the recommended one.
struct DirectionCard {
  std::size_t candidate = 0;      // of the result
  glm::dvec3 direction{0, 0, 1};  // unit; of the recommended one the core is on its side
  std::string name, verdict;      // "+z"; "1 slide, planar parting line"
  bool here = false;              // it is the direction that is looked at, or its opposite
  bool offered = false;           // it is worth turning to
  MoldTrade trade = {};           // beside the direction that is looked at, or else the recommended one
};

/// The recommended direction, and up to two more that win something beside it and beside the one looked at.
/// Nothing where the result recommends none. `cost`: of the one looked at, where it is known.
[[nodiscard]] std::vector<DirectionCard> direction_cards(const PartModel& model, const SweepResult& result,
                                                         const glm::dvec3& here,
                                                         const std::optional<MoldCost>& cost);

/// The recommended one where it is worth turning to; null else, also where others win something beside it.
[[nodiscard]] const DirectionCard* better_direction(std::span<const DirectionCard> cards);

}  // namespace moldlight
