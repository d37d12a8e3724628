#include "mold/exact/projected_part.hpp"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace moldlight {

namespace {

/// |n . d| up to which a facet is seen from neither side. Far above the rounding of a normal in double.
constexpr double k_edge_on = 1e-9;
/// Curtains narrower than this hide nothing that has an area.
constexpr double k_narrowest = 1e-11;
/// Distances of a facet from a point, in the unit frame, up to which they touch.
constexpr double k_touch = 1e-12;
constexpr double k_contour_cells = 2.0, k_facet_cells = 1.0;  // cells an item
constexpr float k_single_rounding =
    1e-6F;  // more than that of a coordinate, and than what counts as touching
constexpr std::size_t k_grain = 4096;

}  // namespace

ProjectedPart::ProjectedPart(const ExactPart& part, const glm::dvec3& direction)
    : part_(&part), frame_(map_frame(direction)) {
  const TriangleMesh& mesh = part.mesh();
  points_.resize(mesh.vertices.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points_.size(), k_grain), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) points_[k] = turned(part.positions()[k]);
  });
  extents_.resize(mesh.facets.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, extents_.size(), k_grain), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const double sine = glm::dot(part.geometry().normals[k], frame_.z);
      const auto& facet = mesh.facets[k];
      const auto [low, high] = std::minmax({points_[facet[0]].z, points_[facet[1]].z, points_[facet[2]].z});
      extents_[k] = {.low = static_cast<float>(low) - k_single_rounding,
                     .high = static_cast<float>(high) + k_single_rounding,
                     .facing = sine > k_edge_on    ? 1
                               : sine < -k_edge_on ? -1
                                                   : 0};
    }
  });
  glm::dvec2 low(1e300), high(-1e300);
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex vertex : facet) {
      low = glm::min(low, glm::dvec2(points_[vertex]));
      high = glm::max(high, glm::dvec2(points_[vertex]));
    }
  }
  tbb::parallel_invoke(
      [&] {
        find_contour();
        contour_grid_.reset(low, high, k_contour_cells * static_cast<double>(contour_.size()));
        contour_grid_.fill(contour_.size(), [&](std::size_t k, glm::dvec2* corners) -> std::size_t {
          corners[0] = glm::dvec2(contour_[k].start);
          corners[1] = glm::dvec2(contour_[k].start + contour_[k].along);
          return 2;
        });
      },
      [&] {
        facet_grid_.reset(low, high, k_facet_cells * static_cast<double>(mesh.facets.size()));
        facet_grid_.fill(mesh.facets.size(), [&](std::size_t k, glm::dvec2* corners) -> std::size_t {
          if (extents_[k].facing == 0) return 0;
          for (int c = 0; c < 3; ++c)
            corners[c] = glm::dvec2(points_[mesh.facets[k][static_cast<std::size_t>(c)]]);
          return 3;
        });
      });
}

void ProjectedPart::find_contour() {
  for (const ExactEdge& edge : part_->edges()) {
    bool up = true, down = true;
    if (edge.kind != EdgeKind::irregular) {
      const Sense left = extents_[edge.left].facing, right = extents_[edge.right].facing;
      if (left == right) continue;
      // Where the solid fills more than a half space nothing appears from behind, unless surfaces cross.
      if (edge.kind == EdgeKind::concave && part_->regular()) continue;
      up = (left > 0) != (right > 0);
      down = (left < 0) != (right < 0);
    }
    ContourEdge contour;
    contour.start = points_[edge.a];
    contour.along = points_[edge.b] - contour.start;
    const glm::dvec2 level(contour.along);
    const double length = glm::length(level);
    if (length < k_narrowest) continue;
    contour.per_length = 1.0 / length;
    contour.across = glm::dvec2(-level.y, level.x) * contour.per_length;
    contour_.push_back(contour);
    const auto [low, high] = std::minmax(points_[edge.a].z, points_[edge.b].z);
    contour_extents_.push_back({.low = static_cast<float>(low) - k_single_rounding,
                                .high = static_cast<float>(high) + k_single_rounding,
                                .up = up,
                                .down = down});
  }
}

bool ProjectedPart::blocked_by(const glm::dvec3& point, const Blockers& blockers) const {
  const Sense sense = blockers.sense;
  const TriangleMesh& mesh = part_->mesh();
  const double per_area = 2.0 / (part_->frame().diagonal * part_->frame().diagonal);
  // Where the blockers face the ray, one that touches the point hides it; else it may be the same surface
  // twice.
  const double least = (blockers.facing == sense ? k_touch : -k_touch) * per_area;
  for (const std::uint32_t facet : facet_grid_.items_at(glm::dvec2(point))) {
    const Extent& extent = extents_[facet];
    if (facet == blockers.own || (blockers.facing != 0 && extent.facing != blockers.facing)) continue;
    if (sense > 0 ? extent.high < point.z : extent.low > point.z) continue;
    const auto& corners = mesh.facets[facet];
    const std::array<const glm::dvec3*, 3> at = {&points_[corners[0]], &points_[corners[1]],
                                                 &points_[corners[2]]};
    // Twice the areas that the point spans with the sides, seen along the direction. Each side is taken from
    // its lower vertex to its higher one, so that two facets agree about their common side.
    std::array<double, 3> spans{};
    bool inside = true;
    for (std::size_t k = 0; k < 3 && inside; ++k) {
      std::size_t from = k, to = (k + 1) % 3;
      const bool swapped = corners[from] > corners[to];
      if (swapped) std::swap(from, to);
      const glm::dvec3& a = *at[from];
      const glm::dvec3& b = *at[to];
      const double span = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
      spans[(k + 2) % 3] = swapped ? -span : span;
      inside = spans[(k + 2) % 3] * extent.facing >= 0.0;
    }
    if (!inside) continue;
    const double rise =
        spans[0] * (at[0]->z - point.z) + spans[1] * (at[1]->z - point.z) + spans[2] * (at[2]->z - point.z);
    if (rise * extent.facing * sense > least * part_->geometry().areas[facet]) return true;
  }
  return false;
}

}  // namespace moldlight
