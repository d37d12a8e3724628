#include "mold/exact/projected_part.hpp"

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
/// Signed distance, in the unit frame, from which a facet lies beyond a point: a touching one does.
constexpr double k_touch = 1e-12;
constexpr double k_contour_cells = 2.0, k_facet_cells = 1.0;  // cells an item
constexpr std::size_t k_grain = 4096;

}  // namespace

ProjectedPart::ProjectedPart(const ExactPart& part, const glm::dvec3& direction)
    : part_(&part), frame_(map_frame(direction)) {
  const TriangleMesh& mesh = part.mesh();
  points_.resize(mesh.vertices.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points_.size(), k_grain), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) points_[k] = turned(part.positions()[k]);
  });
  facing_.resize(mesh.facets.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, facing_.size(), k_grain), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const double sine = glm::dot(part.geometry().normals[k], frame_.z);
      facing_[k] = sine > k_edge_on ? 1 : sine < -k_edge_on ? -1 : 0;
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
          if (facing_[k] == 0) return 0;
          for (int c = 0; c < 3; ++c)
            corners[c] = glm::dvec2(points_[mesh.facets[k][static_cast<std::size_t>(c)]]);
          return 3;
        });
      });
}

void ProjectedPart::find_contour() {
  for (const ExactEdge& edge : part_->edges()) {
    ContourEdge contour;
    if (edge.kind == EdgeKind::irregular) {
      contour.up = contour.down = true;
    } else {
      const Sense left = facing_[edge.left], right = facing_[edge.right];
      if (left == right) continue;
      // Where the solid fills more than a half space nothing appears from behind, unless surfaces cross.
      if (edge.kind == EdgeKind::concave && part_->regular()) continue;
      contour.up = (left > 0) != (right > 0);
      contour.down = (left < 0) != (right < 0);
    }
    contour.start = points_[edge.a];
    contour.along = points_[edge.b] - contour.start;
    const glm::dvec2 level(contour.along);
    const double length = glm::length(level);
    if (length < k_narrowest) continue;
    contour.per_length = 1.0 / length;
    contour.across = glm::dvec2(-level.y, level.x) * contour.per_length;
    contour_.push_back(contour);
  }
}

bool ProjectedPart::blocked(const glm::dvec3& point, Sense sense, bool any) const {
  const TriangleMesh& mesh = part_->mesh();
  const double per_area = 2.0 / (part_->frame().diagonal * part_->frame().diagonal);
  for (const std::uint32_t facet : facet_grid_.items_at(glm::dvec2(point))) {
    if (!any && facing_[facet] != -sense) continue;
    const auto& corners = mesh.facets[facet];
    const std::array<const glm::dvec3*, 3> at = {&points_[corners[0]], &points_[corners[1]],
                                                 &points_[corners[2]]};
    const double beyond = sense > 0 ? std::max({at[0]->z, at[1]->z, at[2]->z}) - point.z
                                    : point.z - std::min({at[0]->z, at[1]->z, at[2]->z});
    if (beyond < -k_touch) continue;
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
      inside = spans[(k + 2) % 3] * facing_[facet] >= 0.0;
    }
    if (!inside) continue;
    const double rise =
        spans[0] * (at[0]->z - point.z) + spans[1] * (at[1]->z - point.z) + spans[2] * (at[2]->z - point.z);
    if (rise * facing_[facet] * sense > -k_touch * per_area * part_->geometry().areas[facet]) return true;
  }
  return false;
}

}  // namespace moldlight
