// Ranking of parting directions: ties, objectives and the Pareto front.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace moldlight {

/// What a direction is judged by; smaller is better.
enum class Criterion : std::uint8_t { undercut, patches, draw_depth, projected_area, undraughted_area };
inline constexpr std::size_t k_criterion_count = 5;
/// "undercut", "patches", "draw-depth", "projected-area", "undraughted-area".
[[nodiscard]] std::string_view criterion_name(Criterion criterion);

/// Figures of one direction: areas in model units squared, draw depth in model units.
struct DirectionFigures {
  std::array<double, k_criterion_count> values{};
  double undercut_uncertainty = 0.0;
  bool exact = false;  // a direction given by the user or by a feature of the part, not by search

  [[nodiscard]] double operator[](Criterion criterion) const {
    return values[static_cast<std::size_t>(criterion)];
  }
  [[nodiscard]] double& operator[](Criterion criterion) {
    return values[static_cast<std::size_t>(criterion)];
  }
};

/// A weighted sum of criteria, each divided by the part's own measure of it (area for areas, diagonal for the
/// depth, one for patches). The undercut area alone by default.
struct Objective {
  std::array<double, k_criterion_count> weights{1.0, 0.0, 0.0, 0.0, 0.0};
};

/// Parses "undercut", "draw-depth" or "undercut:1,draw-depth:0.1"; throws UsageError.
[[nodiscard]] Objective parse_objective(std::string_view text);

/// What the criteria are divided by.
struct PartMeasure {
  double area = 1.0;      // model units squared
  double diagonal = 1.0;  // model units
};

[[nodiscard]] double objective_value(const Objective& objective, const DirectionFigures& figures,
                                     const PartMeasure& part);

struct Ranking {
  std::vector<std::size_t> order;      // best first, indices into the figures
  std::vector<std::size_t> tie_group;  // by index: 0 for the best and all that tie with it, then 1, …
  std::vector<bool> pareto;  // by index: no other is at least as good in undercut area, patches and draw
                             // depth and better in one; undercut areas that differ by less than their
                             // uncertainties are equal
};

/// Directions tie when their objectives differ by no more than their undercut uncertainties make them. A tie
/// group is a best direction and all that tie with it. Within a group exact directions come first, then the
/// smaller draw depth, then the smaller projected area, then the order given.
[[nodiscard]] Ranking rank_directions(std::span<const DirectionFigures> figures, const Objective& objective,
                                      const PartMeasure& part);

}  // namespace moldlight
