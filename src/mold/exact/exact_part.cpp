#include "mold/exact/exact_part.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"

namespace moldlight {

namespace {

/// Height above the left facet's plane, in the unit frame, over which the right one's far corner makes an
/// edge concave: far above the rounding of double, far below the bend of any tessellation.
constexpr double k_concave_height = 1e-10;

}  // namespace

ExactPart::ExactPart(const TriangleMesh& mesh, const FacetGeometry& geometry, const UnitFrame& frame,
                     const Progress& progress, double effort, const ExactPartUse& use)
    : mesh_(mesh), geometry_(geometry), frame_(frame), effort_(effort) {
  progress.report("finding edges", 0.0);
  positions_.reserve(mesh.vertices.size());
  for (const glm::dvec3& vertex : mesh.vertices) {
    positions_.push_back((vertex - frame.center) / frame.diagonal);
  }
  find_edges();
  find_equal_facets();
  progress.report("finding crossings", 0.0);
  EncounterBudget budget = encounter_budget(mesh.facets.size(), effort);
  budget.coplanar = use.coplanar;
  budget.in_front = use.in_front;
  encounters_ = facet_encounters(mesh, positions_, geometry.normals, first_equal_, budget, progress);
  if (!use.in_front) encounters_.in_front.emplace().first.assign(mesh.facets.size() + 1, 0);
  regular_ = regular_ && !any_crossings();
}

/// Bodies that coincide are in a file once for each of its many copies.
void ExactPart::find_equal_facets() {
  using Corners = std::array<VertexIndex, 3>;
  const auto irregular = [&](std::uint32_t edge) {
    return edge != k_no_edge && edges_[edge].kind == EdgeKind::irregular;
  };
  std::vector<std::pair<Corners, FacetIndex>> candidates;
  for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
    if (!std::ranges::all_of(side_edges_[facet], irregular)) continue;
    Corners corners = mesh_.facets[facet];
    std::rotate(corners.begin(), std::ranges::min_element(corners),
                corners.end());  // clang 14 lacks ranges::rotate
    candidates.emplace_back(corners, facet);
  }
  std::ranges::sort(candidates);
  for (std::size_t k = 1; k < candidates.size(); ++k) {
    if (candidates[k].first != candidates[k - 1].first) continue;
    if (first_equal_.empty()) {
      first_equal_.resize(mesh_.facets.size());
      std::iota(first_equal_.begin(), first_equal_.end(), 0U);
    }
    first_equal_[candidates[k].second] = first_equal_[candidates[k - 1].second];
  }
  copies_.resize(first_equal_.size());
  for (const FacetIndex first : first_equal_) ++copies_[first];
}

void ExactPart::find_edges() {
  side_edges_.assign(mesh_.facets.size(), {k_no_edge, k_no_edge, k_no_edge});
  edges_.reserve(mesh_.facets.size() * 3 / 2 + 3);
  const EdgeTable table(mesh_);
  table.for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    ExactEdge edge{.a = low, .b = uses.front().high, .left = facet_of(uses.front().half_edge)};
    for (const EdgeUse& use : uses) {
      side_edges_[facet_of(use.half_edge)][use.half_edge % 3] = static_cast<std::uint32_t>(edges_.size());
    }
    const auto runs_up = [&](const EdgeUse& use) { return start_vertex(mesh_, use.half_edge) == low; };
    if (uses.size() != 2 || runs_up(uses[0]) == runs_up(uses[1])) {
      edge.kind = EdgeKind::irregular;
      regular_ = false;
      closed_ = closed_ && 2 * std::ranges::count_if(uses, runs_up) == std::ssize(uses);
      if (uses.size() >= 2) edge.right = facet_of(uses[1].half_edge);
    } else {
      edge.right = facet_of(uses[1].half_edge);
      const VertexIndex far = mesh_.facets[edge.right][(uses[1].half_edge % 3 + 2) % 3];
      const double height = glm::dot(geometry_.normals[edge.left], positions_[far] - positions_[low]);
      if (height > k_concave_height) edge.kind = EdgeKind::concave;
    }
    edges_.push_back(edge);
  });
}

}  // namespace moldlight
