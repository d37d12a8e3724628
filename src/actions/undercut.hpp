// Undercuts one by one: each asks for a side action of its own, or shares one.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/part_axes.hpp"
#include "actions/undercut_sample.hpp"
#include "classify/part_model.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// A connected piece of undercut surface. Lengths and areas are in the part's unit.
struct Undercut {
  std::vector<std::uint32_t> pieces;  // of the split mesh, in the order of their places
  double area = 0.0;
  glm::dvec3 centre{0.0};    // of its area
  double size_across = 0.0;  // its greatest extent across the parting direction
  double size_along = 0.0;
};

/// Why a piece counts as no undercut. Small: it fits into a disc of the least depth, or is a thousandth of
/// all undercut at most. Narrow: than the least depth. Shallow: a move across d by the least depth clears it,
/// or it is in a slit of such a width.
enum class SpeckReason : std::uint8_t { small, narrow, shallow };
/// "smaller than a thousandth of the undercut", …
[[nodiscard]] std::string_view speck_text(SpeckReason reason);

/// A connected piece, or a part of one, that counts as no undercut. In the part's unit.
struct Speck {
  double area = 0.0;
  glm::dvec3 place{0.0};  // on it
  SpeckReason reason = SpeckReason::small;
  bool of_undercut = false;  // a part of an undercut that counts with it
};

struct Undercuts {
  std::vector<Undercut> counted;  // the largest first
  std::vector<Speck> specks;      // the largest first
  PartAxes axes;                  // by which places are put into an order
};

/// What a release must move by to be worth an action: less is play.
inline constexpr double k_least_travel_mm = 0.05;
/// The floor of an undercut's depth: the lateral tolerance, or this least travel where that is more; share of
/// the diagonal. Parts below 10 mm have a smaller one: many are in metres or inches that no file names.
[[nodiscard]] double least_depth(const PartModel& model, const ExactQuery& query, double least_travel_mm);

/// The undercut pieces of a part split for `query`, connected where they share a vertex or come as near to
/// each other as twice the lateral tolerance on surface that faces the same way. Throws Cancelled.
[[nodiscard]] Undercuts find_undercuts(const PartModel& model, const SplitMesh& split,
                                       const ExactQuery& query, const Progress& progress,
                                       double least_travel_mm = k_least_travel_mm);

/// How much of a part's unit a millimetre is; 1 for a part whose file names none.
[[nodiscard]] double unit_per_mm(const Part& part);

/// What undercuts come to, without the list of them. Areas are in the part's unit squared.
struct UndercutTotals {
  std::size_t count = 0;
  double area = 0.0;
  std::size_t specks = 0;
  double speck_area = 0.0;
};
[[nodiscard]] UndercutTotals totals_of(const Undercuts& undercuts);

/// Where these facets have undercut, and no others.
struct UndercutCount {
  const ExactQuery& query;
  std::span<const FacetIndex> facets;
  double least_travel_mm = k_least_travel_mm;
};
/// Takes less than the exact regions. Throws Cancelled.
[[nodiscard]] UndercutTotals count_undercuts(const PartModel& model, const UndercutCount& asked,
                                             const Progress& progress);

/// At most `count` points spread evenly over the area, each for an equal share of it; in an order in which
/// each beginning is spread, too, so that few of them show soon that something is in the way.
[[nodiscard]] std::vector<UndercutSample> sample_undercut(const PartModel& model, const SplitMesh& split,
                                                          const Undercut& undercut, std::size_t count);

/// How far an undercut reaches along a direction (unit), from end to end.
[[nodiscard]] double extent_along(const SplitMesh& split, const Undercut& undercut,
                                  const glm::dvec3& direction);

/// Corners of its pieces, moved into them a little: the `count` that lie farthest against `direction`. The
/// area they stand for is 0.
[[nodiscard]] std::vector<UndercutSample> deepest_corners(const PartModel& model, const SplitMesh& split,
                                                          const Undercut& undercut,
                                                          const glm::dvec3& direction, std::size_t count);

}  // namespace moldlight
