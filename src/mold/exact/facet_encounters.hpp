// Where the facets of a mesh cross each other, as overlapping bodies do, and which stand close in front of
// others.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A segment on a facet, where another facet crosses it. Unit frame.
struct FacetCrossing {
  glm::dvec3 start, end;
};

/// Items of every facet, those of one after those of another.
template <typename Item>
struct FacetLists {
  std::vector<Item> items;
  std::vector<std::uint32_t> first;  // facets + 1 entries

  [[nodiscard]] std::span<const Item> of(FacetIndex facet) const {
    return {items.data() + first[facet], first[facet + 1] - first[facet]};
  }
};

struct FacetEncounters {
  /// Where others cross a facet in a segment; facets that touch or lie in one plane do not, unless asked for.
  /// Empty unless `complete`.
  FacetLists<FacetCrossing> crossings;
  /// False where facets meet so many others that to look at each pair, or to note down each crossing, would
  /// take time and memory out of proportion.
  bool complete = true;
  /// Others that reach over a facet's plane, on its outer side, near it; nothing where they are not asked
  /// for, or so many that noting them down takes more memory than it saves time.
  std::optional<FacetLists<FacetIndex>> in_front;
};

/// Heights over a facet for in_front: others of which some lies above the first and some below the
/// second, no farther beside it than the second. Unit frame.
inline constexpr double k_least_in_front = 1.0 / 8192.0, k_most_in_front = 1.001 / 2048.0;

/// What facet_encounters() may look at and note down for so many facets.
struct EncounterBudget {
  std::size_t pairs = 0, crossings = 0;
  bool coplanar = false;  // facets in one plane cross, too: where sides of one run inside the other
  bool in_front = true;   // else crossings alone are looked for
};
inline constexpr EncounterBudget k_any_crossings{
    .pairs = ~std::size_t{0}, .crossings = ~std::size_t{0}, .coplanar = false, .in_front = false};
[[nodiscard]] EncounterBudget encounter_budget(std::size_t facets, double effort = 1.0);

/// Pairs of facets by a tree of boxes. `positions` in the unit frame, `normals` of the facets. Of facets with
/// the same corners in the same sense only the one that `first_equal` names for each is looked at; it may be
/// empty: none are equal. Uses all cores; the result does not depend on them. Throws Cancelled.
[[nodiscard]] FacetEncounters facet_encounters(const TriangleMesh& mesh,
                                               std::span<const glm::dvec3> positions,
                                               std::span<const glm::dvec3> normals,
                                               std::span<const FacetIndex> first_equal,
                                               const EncounterBudget& budget, const Progress& progress);

/// The part of triangle `a` that lies in triangle `b`, where their planes cross; false if there is none.
/// `normal_b` is b's unit normal. The segment may reach beyond `b` by its `slack`.
struct CrossingQuery {
  const glm::dvec3* a;  // three corners
  const glm::dvec3* b;  // three corners
  glm::dvec3 normal_b{0, 0, 1};
  double slack = 1e-9;
};
[[nodiscard]] bool triangle_crossing(const CrossingQuery& query, FacetCrossing& crossing);

}  // namespace moldlight
