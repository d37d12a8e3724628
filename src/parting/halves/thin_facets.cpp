#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/edge_collapse.hpp"
#include "mesh/facet_geometry.hpp"
#include "parting/halves/tidy_solid.hpp"

namespace moldlight {

namespace {

using Corners = std::array<VertexIndex, 3>;

class Collapser {
 public:
  Collapser(TriangleMesh& mesh, const TidyQuery& query) : mesh_(mesh), query_(query), edges_(mesh) {}

  void run() {
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      if (!edges_.is_gone(facet) && leans_by_rounding(facet)) take_out(facet);
    }
    edges_.finish();
  }

 private:
  [[nodiscard]] double length_of(VertexIndex a, VertexIndex b) const {
    return glm::distance(mesh_.vertices[a], mesh_.vertices[b]);
  }
  [[nodiscard]] double leaning_of(const glm::dvec3& normal) const {
    const double size = glm::length(normal);
    return glm::dot(normal, query_.pull) > k_leaning_sine * size ? size : 0.0;
  }

  [[nodiscard]] bool leans_by_rounding(FacetIndex facet) const {
    const Corners& c = mesh_.facets[facet];
    const glm::dvec3 normal = twice_area_vector(mesh_, c);
    const double longest = std::max({length_of(c[0], c[1]), length_of(c[1], c[2]), length_of(c[2], c[0])});
    return leaning_of(normal) > 0.0 && k_leaning_sine * glm::length(normal) < query_.tolerance * longest;
  }

  void take_out(FacetIndex facet) {
    const Corners c = mesh_.facets[facet];
    std::array<std::array<VertexIndex, 2>, 3> edges = {{{c[0], c[1]}, {c[1], c[2]}, {c[2], c[0]}}};
    std::ranges::stable_sort(edges, {}, [&](const auto& edge) { return length_of(edge[0], edge[1]); });
    const auto [a, b] = edges.front();
    if (may_join(a, b)) {
      edges_.join(a, b);
    } else if (may_join(b, a)) {
      edges_.join(b, a);
    }
  }

  /// Whether `from` may go to where `to` is.
  [[nodiscard]] bool may_join(VertexIndex from, VertexIndex to) const {
    double before = 0.0, after = 0.0;
    for (const FacetIndex facet : edges_.around(from)) {
      const Corners& old = mesh_.facets[facet];
      const glm::dvec3 normal = twice_area_vector(mesh_, old);
      before += leaning_of(normal);
      if (std::ranges::find(old, to) != old.end()) continue;
      Corners moved = old;
      std::ranges::replace(moved, from, to);
      const glm::dvec3 turned = twice_area_vector(mesh_, moved);
      const double size = glm::length(normal);
      const double way = std::abs(glm::dot(normal, mesh_.vertices[to] - mesh_.vertices[from]));
      if (way > query_.tolerance * size) return false;
      if (glm::dot(normal, turned) <= 0.5 * size * glm::length(turned)) return false;
      after += leaning_of(turned);
    }
    return after < before && edges_.keeps_edges(from, to);
  }

  TriangleMesh& mesh_;
  const TidyQuery& query_;
  EdgeCollapse edges_;
};

}  // namespace

void collapse_thin_facets(TriangleMesh& mesh, const TidyQuery& query) {
  if (query.pull != glm::dvec3(0.0)) Collapser(mesh, query).run();
}

}  // namespace moldlight
