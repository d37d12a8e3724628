// Undercuts one by one: each asks for a side action of its own, or shares one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/undercut_sample.hpp"
#include "classify/part_model.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// A connected patch of undercut surface. Lengths and areas are in the part's unit.
struct Undercut {
  std::vector<std::uint32_t> pieces;  // of the split mesh, rising
  double area = 0.0;
  glm::dvec3 centre{0.0};    // of its area
  double size_across = 0.0;  // its greatest extent across the parting direction
  double size_along = 0.0;
};

struct Undercuts {
  std::vector<Undercut> patches;  // the largest first
  std::size_t dropped = 0;        // patches that fit into a disc of the lateral tolerance or are smaller, or
                                  // of which no point is farther than that, across d, from where it is free
  double dropped_area = 0.0;
};

/// The undercut pieces of a part split for `query`, connected where they share a vertex or come as near to
/// each other as twice the lateral tolerance on surface that faces the same way. Throws Cancelled.
[[nodiscard]] Undercuts find_undercuts(const PartModel& model, const SplitMesh& split,
                                       const ExactQuery& query, const Progress& progress);

/// What undercuts come to, without the list of them. Areas are in the part's unit squared.
struct UndercutTotals {
  std::size_t count = 0;
  double area = 0.0;
  std::size_t specks = 0;  // what is dropped
  double speck_area = 0.0;
};
[[nodiscard]] UndercutTotals totals_of(const Undercuts& undercuts);

/// The same where these facets have undercut, and no others. Takes less than the exact regions. Throws
/// Cancelled.
[[nodiscard]] UndercutTotals count_undercuts(const PartModel& model, const ExactQuery& query,
                                             std::span<const FacetIndex> facets, const Progress& progress);

/// At most `count` points spread evenly over the area, each for an equal share of it; in an order in which
/// each beginning is spread, too, so that few of them tell soon that something is in the way.
[[nodiscard]] std::vector<UndercutSample> sample_undercut(const PartModel& model, const SplitMesh& split,
                                                          const Undercut& undercut, std::size_t count);

/// Corners of its pieces, moved into them a little: the `count` that lie farthest against `direction`. The
/// area they stand for is 0.
[[nodiscard]] std::vector<UndercutSample> deepest_corners(const PartModel& model, const SplitMesh& split,
                                                          const Undercut& undercut,
                                                          const glm::dvec3& direction, std::size_t count);

}  // namespace moldlight
