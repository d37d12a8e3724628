#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include <glm/geometric.hpp>

#include "parting/halves/tidy_solid.hpp"

namespace moldlight {

namespace {

using Corners = std::array<VertexIndex, 3>;

bool has(const Corners& facet, VertexIndex vertex) { return std::ranges::find(facet, vertex) != facet.end(); }

class Collapser {
 public:
  Collapser(TriangleMesh& mesh, const TidyQuery& query)
      : mesh_(mesh), query_(query), dropped_(mesh.facets.size(), 0), around_(mesh.vertices.size()) {
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      for (const VertexIndex corner : mesh.facets[facet]) around_[corner].push_back(facet);
    }
  }

  void run() {
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      if (dropped_[facet] == 0 && leans_by_rounding(facet)) take_out(facet);
    }
    std::size_t kept = 0;
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      if (dropped_[facet] == 0) mesh_.facets[kept++] = mesh_.facets[facet];
    }
    mesh_.facets.resize(kept);
  }

 private:
  /// As long as twice the area.
  [[nodiscard]] glm::dvec3 normal_of(const Corners& facet) const {
    const glm::dvec3& a = mesh_.vertices[facet[0]];
    return glm::cross(mesh_.vertices[facet[1]] - a, mesh_.vertices[facet[2]] - a);
  }
  [[nodiscard]] double length_of(VertexIndex a, VertexIndex b) const {
    return glm::distance(mesh_.vertices[a], mesh_.vertices[b]);
  }
  [[nodiscard]] double leaning_of(const glm::dvec3& normal) const {
    const double size = glm::length(normal);
    return glm::dot(normal, query_.pull) > k_leaning_sine * size ? size : 0.0;
  }

  [[nodiscard]] bool leans_by_rounding(FacetIndex facet) const {
    const Corners& c = mesh_.facets[facet];
    const glm::dvec3 normal = normal_of(c);
    const double longest = std::max({length_of(c[0], c[1]), length_of(c[1], c[2]), length_of(c[2], c[0])});
    return leaning_of(normal) > 0.0 && k_leaning_sine * glm::length(normal) < query_.tolerance * longest;
  }

  void take_out(FacetIndex facet) {
    const Corners c = mesh_.facets[facet];
    std::array<std::array<VertexIndex, 2>, 3> edges = {{{c[0], c[1]}, {c[1], c[2]}, {c[2], c[0]}}};
    std::ranges::stable_sort(edges, {}, [&](const auto& edge) { return length_of(edge[0], edge[1]); });
    const auto [a, b] = edges.front();
    if (may_join(a, b)) {
      join(a, b);
    } else if (may_join(b, a)) {
      join(b, a);
    }
  }

  /// Whether `from` may go to where `to` is.
  [[nodiscard]] bool may_join(VertexIndex from, VertexIndex to) const {
    std::vector<VertexIndex> beside_from, beside_to, common;
    std::size_t shared = 0;
    double before = 0.0, after = 0.0;
    for (const FacetIndex facet : around_[from]) {
      const Corners& old = mesh_.facets[facet];
      for (const VertexIndex corner : old) beside_from.push_back(corner);
      const glm::dvec3 normal = normal_of(old);
      before += leaning_of(normal);
      if (has(old, to)) {
        ++shared;
        continue;
      }
      Corners moved = old;
      std::ranges::replace(moved, from, to);
      const glm::dvec3 turned = normal_of(moved);
      const double size = glm::length(normal);
      const double way = std::abs(glm::dot(normal, mesh_.vertices[to] - mesh_.vertices[from]));
      if (way > query_.tolerance * size) return false;
      if (glm::dot(normal, turned) <= 0.5 * size * glm::length(turned)) return false;
      after += leaning_of(turned);
    }
    if (shared != 2 || after >= before) return false;
    for (const FacetIndex facet : around_[to]) {
      for (const VertexIndex corner : mesh_.facets[facet]) beside_to.push_back(corner);
    }
    for (std::vector<VertexIndex>* each : {&beside_from, &beside_to}) {
      std::ranges::sort(*each);
      each->erase(std::unique(each->begin(), each->end()), each->end());
    }
    std::ranges::set_intersection(beside_from, beside_to, std::back_inserter(common));
    return common.size() == 4;  // both ends and the tips of their two facets: no edge would get more facets
  }

  void join(VertexIndex from, VertexIndex to) {
    for (const FacetIndex facet : around_[from]) {
      if (has(mesh_.facets[facet], to)) {
        dropped_[facet] = 1;
        for (const VertexIndex corner : mesh_.facets[facet]) {
          if (corner != from) std::erase(around_[corner], facet);
        }
      } else {
        std::ranges::replace(mesh_.facets[facet], from, to);
        around_[to].push_back(facet);
      }
    }
    around_[from].clear();
  }

  TriangleMesh& mesh_;
  const TidyQuery& query_;
  std::vector<std::uint8_t> dropped_;
  std::vector<std::vector<FacetIndex>> around_;  // each vertex
};

}  // namespace

void collapse_thin_facets(TriangleMesh& mesh, const TidyQuery& query) {
  if (query.pull != glm::dvec3(0.0)) Collapser(mesh, query).run();
}

}  // namespace moldlight
