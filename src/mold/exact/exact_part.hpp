// Facts that exact regions need of the part alone: its edges, and where its facets cross each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/exact/facet_encounters.hpp"

namespace moldlight {

/// How an edge bends. Irregular: open, used by more than two facets, or wound alike by both.
enum class EdgeKind : std::uint8_t { convex_or_flat, concave, irregular };

struct ExactEdge {
  VertexIndex a = 0, b = 0;                 // a < b
  FacetIndex left = 0, right = k_no_facet;  // the first two facets that use it
  EdgeKind kind = EdgeKind::convex_or_flat;
};

/// What is found of a part beyond where its facets cross.
struct ExactPartUse {
  bool coplanar = false;  // facets in one plane cross each other, too
  bool in_front = true;   // others in front of facets: but for a lateral tolerance nobody asks for them
};

/// Made once a part, immutable, shared by any number of threads. References must outlive it. Coordinates are
/// in double in the unit frame, so that areas scale to the bit with the part.
class ExactPart {
 public:
  static constexpr std::uint32_t k_no_edge = ~0U;

  /// Takes some 200 bytes a facet, and at most 2 KiB. `effort` multiplies what all that is found of the part
  /// may cost: beyond it facets are sampled. Throws Cancelled.
  ExactPart(const TriangleMesh& mesh, const FacetGeometry& geometry, const UnitFrame& frame,
            const Progress& progress, double effort = 1.0, const ExactPartUse& use = {});

  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
  [[nodiscard]] const FacetGeometry& geometry() const { return geometry_; }
  [[nodiscard]] const UnitFrame& frame() const { return frame_; }
  [[nodiscard]] double effort() const { return effort_; }
  [[nodiscard]] const std::vector<glm::dvec3>& positions() const { return positions_; }
  [[nodiscard]] const std::vector<ExactEdge>& edges() const { return edges_; }
  /// Edge of each side of a facet (side k runs from corner k to corner k + 1); k_no_edge for a facet with two
  /// equal corners.
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& side_edges() const { return side_edges_; }
  /// Where other facets cross a facet.
  [[nodiscard]] std::span<const FacetCrossing> crossings(FacetIndex facet) const {
    return encounters_.crossings.of(first_equal(facet));
  }
  /// There are some, or they were too many to be found.
  [[nodiscard]] bool any_crossings() const {
    return !encounters_.complete || !encounters_.crossings.items.empty();
  }
  /// False where facets meet so many others that the regions of none of them can be exact.
  [[nodiscard]] bool crossings_known() const { return encounters_.complete; }
  /// False where too many facets stand in front of others; none are known where nobody asks for them.
  [[nodiscard]] bool knows_in_front() const { return encounters_.in_front.has_value(); }
  /// Only where that is known.
  [[nodiscard]] std::span<const FacetIndex> in_front(FacetIndex facet) const {
    return encounters_.in_front->of(first_equal(facet));
  }
  /// The first facet with the same corners in the same sense, mostly the facet itself: others of them hide
  /// nothing that it does not.
  [[nodiscard]] FacetIndex first_equal(FacetIndex facet) const {
    return first_equal_.empty() ? facet : first_equal_[facet];
  }
  /// How many facets the first of equal ones stands for.
  [[nodiscard]] std::uint32_t copies(FacetIndex first) const {
    return first_equal_.empty() ? 1 : copies_[first];
  }
  /// Closed, wound consistently and free of crossings: visibility then changes at convex edges only.
  [[nodiscard]] bool regular() const { return regular_; }
  /// Facets run through each edge as often in the one sense as in the other, so that there is an inside.
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  void find_edges();
  void find_equal_facets();

  const TriangleMesh& mesh_;
  const FacetGeometry& geometry_;
  UnitFrame frame_;
  double effort_;
  std::vector<glm::dvec3> positions_;
  std::vector<ExactEdge> edges_;
  std::vector<std::array<std::uint32_t, 3>> side_edges_;
  std::vector<FacetIndex> first_equal_;  // empty where none are equal
  FacetEncounters encounters_;
  bool regular_ = true, closed_ = true;
  std::vector<std::uint32_t> copies_;  // of first_equal_
};

}  // namespace moldlight
