#include "parting/bar_cut.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
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
      : room_(room), planes_(room.sides), size_(size), tolerance_(1e-10 * size) {
    if (room.end) planes_.push_back(*room.end);
    rims_.resize(planes_.size());
    joints_.resize(planes_.size());
    mesh_.vertices = solid.vertices;
    for (FacetIndex facet = 0; facet < solid.facets.size(); ++facet)
      mesh_.pieces.push_back({.corners = solid.facets[facet], .facet = facet});
  }

  std::optional<BarCut> run() {
    cut_along_sides();
    weld();
    Facets inside, outside;
    for (const SplitPiece& piece : mesh_.pieces)
      (is_inside(piece) ? inside : outside).push_back(piece.corners);
    if (!find_rims(inside) || !join_along_edges() || !join_at_end()) return std::nullopt;
    for (std::size_t plane = 0; plane < planes_.size(); ++plane) {
      if (!add_wall(plane, inside, outside)) return std::nullopt;
    }
    return BarCut{body_mesh(mesh_.vertices, inside), body_mesh(mesh_.vertices, outside)};
  }

 private:
  [[nodiscard]] double off(VertexIndex vertex, std::size_t plane) const {
    return beyond(mesh_.vertices[vertex], planes_[plane]);
  }
  [[nodiscard]] bool lies_in(VertexIndex vertex, std::size_t plane) const {
    constexpr double k_rounding = 4.0;
    return std::abs(off(vertex, plane)) <= k_rounding * tolerance_;
  }

  /// Only what may be in the bar is cut at its sides: at its end first, then at sides far from each other, so
  /// that little is left for the next.
  void cut_along_sides() {
    const std::size_t sides = room_.sides.size();
    std::vector<std::size_t> order;
    if (room_.end) order.push_back(sides);
    for (std::size_t step = std::bit_ceil(sides); step > 0; step /= 2) {
      for (std::size_t side = 0; side < sides; side += step) {
        if (std::ranges::find(order, side) == order.end()) order.push_back(side);
      }
    }
    std::vector<std::uint8_t> near(mesh_.pieces.size(), 1);
    for (const std::size_t side : order) {
      for (std::size_t piece = 0; piece < near.size(); ++piece) {
        if (near[piece] != 0 && is_beyond(mesh_.pieces[piece])) near[piece] = 0;
      }
      const HalfSpace& half = planes_[side];
      cut_at_height(mesh_, near, {.direction = half.normal, .height = half.offset, .tolerance = tolerance_});
    }
  }
  /// Whether it is wholly beyond one of the planes.
  [[nodiscard]] bool is_beyond(const SplitPiece& piece) const {
    for (std::size_t plane = 0; plane < planes_.size(); ++plane) {
      if (std::ranges::none_of(piece.corners,
                               [&](VertexIndex corner) { return off(corner, plane) < -tolerance_; }))
        return true;
    }
    return false;
  }

  /// Vertices that are one for the walls are one, the one that lies in most planes.
  void weld() {
    const double near = 100.0 * tolerance_;
    std::vector<VertexIndex> order(mesh_.vertices.size());
    std::iota(order.begin(), order.end(), VertexIndex{0});
    std::ranges::sort(order, {},
                      [&](VertexIndex vertex) { return std::pair(mesh_.vertices[vertex].x, vertex); });
    const auto planes_of = [&](VertexIndex vertex) {
      std::size_t count = 0;
      for (std::size_t plane = 0; plane < planes_.size(); ++plane) count += lies_in(vertex, plane) ? 1 : 0;
      return count;
    };
    std::vector<VertexIndex> stands_for(mesh_.vertices.size());
    std::iota(stands_for.begin(), stands_for.end(), VertexIndex{0});
    const auto root = [&](VertexIndex vertex) {
      while (stands_for[vertex] != vertex) vertex = stands_for[vertex];
      return vertex;
    };
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (std::size_t other = k + 1; other < order.size(); ++other) {
        const glm::dvec3 &a = mesh_.vertices[order[k]], &b = mesh_.vertices[order[other]];
        if (b.x - a.x > near) break;
        if (glm::length(b - a) > near) continue;
        const VertexIndex one = root(order[k]), two = root(order[other]);
        if (one == two) continue;
        const bool first = std::pair(planes_of(two), one) <= std::pair(planes_of(one), two);
        stands_for[first ? two : one] = first ? one : two;
      }
    }
    for (SplitPiece& piece : mesh_.pieces) {
      for (VertexIndex& corner : piece.corners) corner = root(corner);
    }
    std::erase_if(mesh_.pieces, [](const SplitPiece& piece) {
      const auto& [a, b, c] = piece.corners;
      return a == b || b == c || c == a;
    });
  }

  [[nodiscard]] bool is_inside(const SplitPiece& piece) const {
    for (std::size_t side = 0; side < planes_.size(); ++side) {
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
      for (std::size_t side = 0; side < planes_.size(); ++side) {
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
      // The bar's end is in the solid there: a corner of it.
      if (pierced.size() % 2 != 0) {
        if (!add_corner(side, next)) return false;
        pierced.insert(pierced.begin(), corners_.at(side));
      }
      for (std::size_t k = 0; k < pierced.size(); k += 2) {
        const VertexIndex low = pierced[k], high = pierced[k + 1];
        const auto sign_at = [&](const std::map<VertexIndex, int>& of, VertexIndex vertex) {
          const auto found = of.find(vertex);
          return found == of.end() ? 0 : found->second;
        };
        const bool from_corner = k == 0 && is_corner(side, low);
        const int below = from_corner ? -sign_at(ends, high) : sign_at(ends, low);
        if (sign_at(ends, high) != -below || std::abs(below) != 1 ||
            (!from_corner && sign_at(others, low) != -below) || sign_at(others, high) != below)
          return false;
        const DirectedEdge up{low, high}, down{high, low};
        joints_[side].push_back(below < 0 ? up : down);
        joints_[next].push_back(below < 0 ? down : up);
      }
    }
    return true;
  }

  bool add_corner(std::size_t side, std::size_t next) {
    if (!room_.end) return false;
    const HalfSpace &a = planes_[side], &b = planes_[next], &end = *room_.end;
    const glm::dvec3 across = glm::cross(b.normal, end.normal);
    corners_[side] = static_cast<VertexIndex>(mesh_.vertices.size());
    mesh_.vertices.push_back((a.offset * across + b.offset * glm::cross(end.normal, a.normal) +
                              end.offset * glm::cross(a.normal, b.normal)) /
                             glm::dot(a.normal, across));
    return true;
  }
  [[nodiscard]] bool is_corner(std::size_t side, VertexIndex vertex) const {
    const auto corner = corners_.find(side);
    return corner != corners_.end() && corner->second == vertex;
  }

  /// The end's wall is bounded by the sides, as far as the solid is there.
  bool join_at_end() {
    if (!room_.end) return true;
    const std::size_t sides = room_.sides.size(), end = sides;
    const std::map<VertexIndex, int> ends = rim_ends(end);
    for (std::size_t side = 0; side < sides; ++side) {
      std::vector<VertexIndex> on_line;
      for (const auto& [vertex, sign] : ends) {
        if (sign != 0 && lies_in(vertex, side)) on_line.push_back(vertex);
      }
      for (const std::size_t corner : {(side + sides - 1) % sides, side}) {
        if (corners_.contains(corner)) on_line.push_back(corners_.at(corner));
      }
      if (on_line.size() % 2 != 0) return false;
      // With the solid on the left, seen against the end's normal.
      const glm::dvec3 along = glm::cross(-planes_[side].normal, planes_[end].normal);
      std::ranges::sort(on_line, {},
                        [&](VertexIndex vertex) { return glm::dot(mesh_.vertices[vertex], along); });
      for (std::size_t k = 0; k < on_line.size(); k += 2) {
        joints_[end].push_back({on_line[k], on_line[k + 1]});
        joints_[side].push_back({on_line[k + 1], on_line[k]});
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
    const glm::dvec3& normal = planes_[side].normal;
    const glm::dvec3& along_wall = side < room_.sides.size() ? room_.along : planes_.front().normal;
    const glm::dvec3 along = glm::normalize(along_wall - glm::dot(along_wall, normal) * normal);
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
  std::vector<HalfSpace> planes_;  // its sides, then its end
  double size_, tolerance_;
  SplitMesh mesh_;
  std::vector<std::vector<DirectedEdge>> rims_, joints_;  // by plane
  std::map<std::size_t, VertexIndex> corners_;            // of the end in the solid, by the side before them
};

}  // namespace

std::optional<BarCut> cut_by_bar(const TriangleMesh& solid, const BarRoom& room, double size) {
  return BarCutter(solid, room, size).run();
}

}  // namespace moldlight
