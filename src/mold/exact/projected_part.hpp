// A part seen along a parting direction: what may hide surface, and the edges under which that changes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mold/exact/exact_part.hpp"
#include "mold/exact/projection_grid.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

/// Which way a surface point looks: +1 along the direction, -1 against it.
using Sense = int;

/// Sets of facets by the side that they face: a sum of these.
namespace facing {
inline constexpr std::uint8_t k_up = 1;
inline constexpr std::uint8_t k_down = 2;
}  // namespace facing

/// What lies below a plane by less than the first may touch it, as bodies that touch hide each other; and how
/// far lines reach beyond their ends, lest they miss each other. Unit frame.
inline constexpr double k_plane_margin = 1e-7, k_clip_slack = 1e-9;

/// A contour edge, or a stretch of one; the strip that hangs from it along the direction is its curtain.
struct ContourEdge {
  glm::dvec3 start{0.0}, along{0.0};  // end - start
  glm::dvec2 across{0.0};             // unit normal of the curtain, in the projection
  double per_length = 0.0;            // 1 / length of the projection
};

/// Coordinates are those of the unit frame, turned so that z is the direction. The part must outlive it.
class ProjectedPart {
 public:
  /// Throws Cancelled.
  ProjectedPart(const ExactPart& part, const glm::dvec3& direction, const Progress& progress);

  [[nodiscard]] const ExactPart& part() const { return *part_; }
  [[nodiscard]] const MapFrame& frame() const { return frame_; }
  [[nodiscard]] const glm::dvec3& point(VertexIndex vertex) const { return points_[vertex]; }
  [[nodiscard]] glm::dvec3 turned(const glm::dvec3& unit) const {
    return {glm::dot(frame_.x, unit), glm::dot(frame_.y, unit), glm::dot(frame_.z, unit)};
  }
  /// What is asked of a facet most often.
  struct Extent {
    glm::vec3 low, high;  // a little generously
    std::uint8_t facing;  // 0 for a facet that is seen edge-on
  };
  [[nodiscard]] const Extent& extent(FacetIndex facet) const { return extents_[facet]; }
  /// What of the contour edges is not hidden itself: below the rest nothing changes.
  [[nodiscard]] const std::vector<ContourEdge>& contour() const { return contour_; }
  /// The same of an edge of contour(): the facets that end there, for a surface below it and for one above.
  /// Of edges that lie over one another only the outermost is asked.
  struct ContourExtent {
    float low, high;
    std::uint8_t for_below, for_above;
    bool pierces;  // it may run into a facet or out of one, as where bodies overlap
  };
  [[nodiscard]] const ContourExtent& contour_extent(std::size_t edge) const { return contour_extents_[edge]; }
  [[nodiscard]] const ProjectionGrid& contour_grid() const { return contour_grid_; }
  /// How a facet is cut, so that the work on all of them stays in proportion to their number.
  struct FacetWork {
    bool sampled = false;          // along a lattice, not along what crosses it: that is too much to look at
    std::uint32_t most_cells = 0;  // beyond these it is not cut
  };
  [[nodiscard]] FacetWork work_on(FacetIndex facet) const;
  /// Parts of a side of a facet between the lines of its lattice; 1: one point stands for all of it.
  [[nodiscard]] std::size_t lattice_lines() const { return lattice_lines_; }
  /// Facets that face up, and down.
  [[nodiscard]] const std::array<ProjectionGrid, 2>& facet_grids() const { return facet_grids_; }

  /// Facets that hide surface which looks the way `sense` says; `beside`: from points beside it. In a closed
  /// mesh what is nearest to the light faces it, whether bodies overlap or touch; an open one has no inside:
  /// what faces the ray from the surface hides it, and anything does from a point beside.
  [[nodiscard]] std::uint8_t blockers(Sense sense, bool beside) const {
    if (part_->closed()) return sense > 0 ? facing::k_up : facing::k_down;
    if (beside) return facing::k_up | facing::k_down;
    return sense > 0 ? facing::k_down : facing::k_up;
  }
  struct Ray {
    glm::dvec3 point{0.0};
    Sense sense = 1;
    bool beside = false;
    FacetIndex own = k_no_facet;  // the facet that the point lies on
    bool clearly = false;         // only what lies beyond it beyond doubt
  };
  /// True if a blocker lies beyond the point. `last`, the one that was found last (or k_no_facet), is asked
  /// first: what hides a point often hides the next one.
  [[nodiscard]] bool blocked(const Ray& ray, FacetIndex& last) const;
  /// How many bodies a point of the facet `own`, which is not seen edge-on, lies in, just in front of it: its
  /// winding number there. Surface of the same sense that lies on it counts as in front if its number is
  /// lower.
  [[nodiscard]] int winding_in_front(const glm::dvec3& point, FacetIndex own) const;

 private:
  void find_contour();
  void fill_contour_grid();
  void fill_facet_grid(std::uint8_t facing);
  void leave_out_covered_edges();
  void leave_out_hidden_edges(const Progress& progress);
  struct Stretch {
    double from, to;  // shares of an edge's length
  };
  /// How far the facet lies over the point, times twice its area; nothing where it lies beside.
  [[nodiscard]] std::optional<double> rise_over(const glm::dvec3& point, FacetIndex facet) const;
  [[nodiscard]] bool blocks(FacetIndex facet, const Ray& ray) const;
  [[nodiscard]] double hidden_until(FacetIndex facet, const ContourEdge& edge, Sense sense,
                                    double from) const;
  [[nodiscard]] bool surely_hidden(const ContourEdge& edge, Sense sense, FacetIndex& last) const;
  [[nodiscard]] double twice_area_of(FacetIndex facet) const {
    return 2.0 * part_->geometry().areas[facet] / (part_->frame().diagonal * part_->frame().diagonal);
  }
  using Visible = std::array<std::vector<Stretch>, 2>;  // for surface below, above
  /// One thread's.
  struct EdgeSearch {
    std::vector<std::uint32_t> met;         // the edge that each contour edge was last met by
    std::array<FacetIndex, 2> hidden_by{};  // the facets that hid the edge before
  };
  void plan_work(const Progress& progress);
  [[nodiscard]] std::size_t looks_at_middle(FacetIndex facet) const;
  [[nodiscard]] std::uint64_t work_budget() const;
  void find_visible(std::uint32_t edge, EdgeSearch& search, Visible& visible) const;

  const ExactPart* part_;
  MapFrame frame_;
  std::vector<glm::dvec3> points_;
  std::vector<Extent> extents_;
  std::vector<ContourEdge> contour_;
  std::vector<ContourExtent> contour_extents_;
  ProjectionGrid::Box box_;
  ProjectionGrid contour_grid_;
  std::array<ProjectionGrid, 2> facet_grids_;
  bool proportionate_ = true;        // no facet is sampled for its work
  std::vector<std::uint32_t> work_;  // of facets: what gathering segments looks at; empty if proportionate
  std::uint32_t most_work_ = 0;      // of a facet that is not sampled
  double cells_a_work_ = 0.0;
  std::size_t lattice_lines_ = 0;
  bool edges_proportionate_ = true;
};

}  // namespace moldlight
