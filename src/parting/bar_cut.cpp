#include "parting/bar_cut.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <glm/geometric.hpp>

#include "parting/halves/bodies.hpp"
#include "parting/halves/plane_section.hpp"
#include "parting/piece_edges.hpp"

namespace moldlight {

namespace {

using Facets = std::vector<std::array<VertexIndex, 3>>;

class BarCutter {
 public:
  BarCutter(const TriangleMesh& solid, const BarRoom& room, double size)
      : room_(room), size_(size), tolerance_(1e-10 * size) {
    mesh_.vertices = solid.vertices;
    for (FacetIndex facet = 0; facet < solid.facets.size(); ++facet)
      mesh_.pieces.push_back({.corners = solid.facets[facet], .facet = facet});
  }

  std::optional<BarCut> run() {
    cut_along_sides();
    Facets inside, outside;
    for (const SplitPiece& piece : mesh_.pieces)
      (is_inside(piece) ? inside : outside).push_back(piece.corners);
    if (!find_rims(inside) || !join_along_edges()) return std::nullopt;
    for (std::size_t side = 0; side < room_.sides.size(); ++side) {
      if (!add_wall(side, inside, outside)) return std::nullopt;
    }
    return BarCut{body_mesh(mesh_.vertices, inside), body_mesh(mesh_.vertices, outside)};
  }

 private:
  [[nodiscard]] double off(VertexIndex vertex, std::size_t side) const {
    return beyond(mesh_.vertices[vertex], room_.sides[side]);
  }
  [[nodiscard]] bool lies_in(VertexIndex vertex, std::size_t side) const {
    constexpr double k_rounding = 4.0;
    return std::abs(off(vertex, side)) <= k_rounding * tolerance_;
  }

  /// Only what may be in the bar is cut at its sides.
  void cut_along_sides() {
    for (std::size_t side = 0; side < room_.sides.size(); ++side) {
      std::vector<std::uint8_t> near;
      for (const SplitPiece& piece : mesh_.pieces) {
        bool may_be = true;
        for (std::size_t other = 0; other < room_.sides.size(); ++other)
          may_be = may_be && std::ranges::any_of(piece.corners, [&](VertexIndex corner) {
                     return off(corner, other) < -tolerance_;
                   });
        near.push_back(may_be ? 1 : 0);
      }
      const HalfSpace& half = room_.sides[side];
      cut_at_height(mesh_, near, {.direction = half.normal, .height = half.offset, .tolerance = tolerance_});
    }
  }

  [[nodiscard]] bool is_inside(const SplitPiece& piece) const {
    for (std::size_t side = 0; side < room_.sides.size(); ++side) {
      if (std::ranges::any_of(piece.corners, [&](VertexIndex corner) {
            return off(corner, side) > tolerance_ && !lies_in(corner, side);
          }))
        return false;
    }
    return true;
  }

  /// Where what is inside ends, by the side of the bar, each edge as the wall there runs through it.
  bool find_rims(const Facets& inside) {
    std::map<DirectedEdge, int> uses;
    for (const auto& corners : inside) {
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex from = corners[k], to = corners[(k + 1) % 3];
        from < to ? ++uses[{from, to}] : --uses[{to, from}];
      }
    }
    for (const auto& [edge, count] : uses) {
      if (count == 0) continue;
      std::vector<std::size_t> in;
      for (std::size_t side = 0; side < room_.sides.size(); ++side) {
        if (lies_in(edge[0], side) && lies_in(edge[1], side)) in.push_back(side);
      }
      if (in.size() != 1 || std::abs(count) != 1) return false;
      rims_[in.front()].push_back(count > 0 ? DirectedEdge{edge[1], edge[0]} : edge);
    }
    return true;
  }

  /// Walls also end at the bar's edges, as far as these run through the solid.
  bool join_along_edges() {
    for (std::size_t side = 0; side < room_.sides.size(); ++side) {
      const std::size_t next = (side + 1) % room_.sides.size();
      const std::map<VertexIndex, int> ends = rim_ends(side), others = rim_ends(next);
      std::vector<VertexIndex> pierced;
      for (const auto& [vertex, sign] : ends) {
        if (sign != 0 && lies_in(vertex, next)) pierced.push_back(vertex);
      }
      for (const auto& [vertex, sign] : others) {
        if (sign != 0 && lies_in(vertex, side) && std::ranges::find(pierced, vertex) == pierced.end())
          return false;
      }
      std::ranges::sort(pierced, {},
                        [&](VertexIndex vertex) { return glm::dot(mesh_.vertices[vertex], room_.along); });
      if (pierced.size() % 2 != 0) return false;
      for (std::size_t k = 0; k < pierced.size(); k += 2) {
        const VertexIndex low = pierced[k], high = pierced[k + 1];
        const auto other_low = others.find(low), other_high = others.find(high);
        if (other_low == others.end() || other_high == others.end() || ends.at(low) != -ends.at(high) ||
            std::abs(ends.at(low)) != 1 || other_low->second != -ends.at(low) ||
            other_high->second != -ends.at(high))
          return false;
        const DirectedEdge up{low, high}, down{high, low};
        joints_[side].push_back(ends.at(low) < 0 ? up : down);
        joints_[next].push_back(ends.at(low) < 0 ? down : up);
      }
    }
    return true;
  }

  /// How many more edges of a side's rim begin at a vertex than end there.
  [[nodiscard]] std::map<VertexIndex, int> rim_ends(std::size_t side) const {
    std::map<VertexIndex, int> ends;
    for (const auto& [from, to] : rims_[side]) {
      ++ends[from];
      --ends[to];
    }
    return ends;
  }

  /// The wall in a side, as both have it; false where it cannot be divided into facets.
  bool add_wall(std::size_t side, Facets& inside, Facets& outside) const {
    std::vector<DirectedEdge> edges = rims_[side];
    edges.insert(edges.end(), joints_[side].begin(), joints_[side].end());
    if (edges.empty()) return true;
    const glm::dvec3& normal = room_.sides[side].normal;
    const glm::dvec3 along = glm::normalize(room_.along - glm::dot(room_.along, normal) * normal);
    const auto wall =
        section_facets(mesh_.vertices, edges, {along, glm::cross(normal, along), normal}, size_);
    if (!wall) return false;
    for (const auto& [a, b, c] : *wall) {
      inside.push_back({a, b, c});
      outside.push_back({a, c, b});
    }
    return true;
  }

  const BarRoom& room_;
  double size_, tolerance_;
  SplitMesh mesh_;
  std::array<std::vector<DirectedEdge>, 4> rims_, joints_;
};

}  // namespace

std::optional<BarCut> cut_by_bar(const TriangleMesh& solid, const BarRoom& room, double size) {
  return BarCutter(solid, room, size).run();
}

}  // namespace moldlight
