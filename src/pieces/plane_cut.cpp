#include "pieces/plane_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>

#include "parting/halves/bodies.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/halves/plane_section.hpp"

namespace moldlight {

namespace {

constexpr double k_off_plane = 1e-9;

using Facets = std::vector<std::array<VertexIndex, 3>>;

class Cutter {
 public:
  Cutter(const TriangleMesh& solid, const HalfSpace& half) : half_(half), vertices_(solid.vertices) {
    for (const glm::dvec3& vertex : vertices_) heights_.push_back(beyond(vertex, half));
  }

  std::optional<CutSolid> run(const Facets& facets) {
    for (const auto& facet : facets) {
      for (const VertexIndex corner : facet)
        if (std::abs(heights_[corner]) < k_off_plane) return std::nullopt;
      add(facet);
    }
    if (!close()) return std::nullopt;
    return CutSolid{bodies(inside_), bodies(outside_)};
  }

 private:
  [[nodiscard]] bool is_inside(VertexIndex vertex) const { return heights_[vertex] < 0.0; }

  /// Where an edge meets the plane, the same for both of its facets.
  VertexIndex crossing(VertexIndex a, VertexIndex b) {
    if (a > b) std::swap(a, b);
    const auto [entry, fresh] = crossings_.try_emplace({a, b}, static_cast<VertexIndex>(vertices_.size()));
    if (fresh)
      vertices_.push_back(glm::mix(vertices_[a], vertices_[b], heights_[a] / (heights_[a] - heights_[b])));
    return entry->second;
  }

  void add(std::array<VertexIndex, 3> facet) {
    const auto within = std::ranges::count_if(facet, [&](VertexIndex corner) { return is_inside(corner); });
    if (within == 0 || within == 3) {
      (within == 3 ? inside_ : outside_).push_back(facet);
      return;
    }
    // The corner that is alone on its side first.
    const bool alone_inside = within == 1;
    const auto alone =
        std::ranges::find_if(facet, [&](VertexIndex corner) { return is_inside(corner) == alone_inside; });
    std::rotate(facet.begin(), alone, facet.end());  // clang 14 lacks ranges::rotate
    const auto [a, b, c] = facet;
    const VertexIndex to = crossing(a, b), from = crossing(c, a);
    Facets &own = alone_inside ? inside_ : outside_, &other = alone_inside ? outside_ : inside_;
    own.push_back({a, to, from});
    other.push_back({to, b, c});
    other.push_back({to, c, from});
    rim_.push_back({to, from});
  }

  /// Puts the section on both sides.
  bool close() {
    if (rim_.empty()) return true;
    const auto section = section_facets(vertices_, rim_, frame_along(half_.normal), 1.0);
    if (!section) return false;
    for (const auto& [a, b, c] : *section) {
      inside_.push_back({a, b, c});
      outside_.push_back({a, c, b});
    }
    return check_body(vertices_, inside_).open_edges == 0 && check_body(vertices_, outside_).open_edges == 0;
  }

  [[nodiscard]] std::vector<TriangleMesh> bodies(const Facets& facets) const {
    std::vector<TriangleMesh> meshes;
    for (const Facets& body : connected_bodies(vertices_.size(), facets))
      meshes.push_back(body_mesh(vertices_, body));
    return meshes;
  }

  const HalfSpace& half_;
  std::vector<glm::dvec3> vertices_;
  std::vector<double> heights_;  // of those of the solid
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> crossings_;
  std::vector<DirectedEdge> rim_;
  Facets inside_, outside_;
};

}  // namespace

std::optional<CutSolid> cut_solid(const TriangleMesh& solid, const HalfSpace& half) {
  return Cutter(solid, half).run(solid.facets);
}

}  // namespace moldlight
