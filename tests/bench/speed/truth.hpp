// What the undercut areas are, by exact regions, and how far others are off.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sweep/direction_scorer.hpp"
#include "sweep/scoring.hpp"

namespace moldlight::bench {

struct Truth {
  std::vector<glm::dvec3> directions;
  std::vector<double> undercuts;  // model units squared, one a direction
  double total_area = 0.0;

  /// Root mean square error of the undercut area over the directions, as a share of the part's area.
  [[nodiscard]] double error(std::span<const double> undercuts_found) const;
};

/// Undercut areas of directions by a pool, without giving any up.
std::vector<double> score_all(ScoringPool& pool, std::span<const glm::dvec3> directions);

/// `uniform` directions spread over the half-sphere and the three axes, along which most walls stand.
[[nodiscard]] std::vector<glm::dvec3> bench_directions(std::size_t uniform);

}  // namespace moldlight::bench
