#include "mesh/open_surface.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr VertexIndex k_no_vertex = std::numeric_limits<VertexIndex>::max();

/// Side k of triangle t, from its corner k to the next, is 3 t + k, as that corner is.
using Side = std::uint32_t;

Side next_corner(Side corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// For each side the one across it, k_no_vertex at the border.
std::vector<Side> pair_sides(std::span<const std::array<VertexIndex, 3>> triangles) {
  struct Use {
    VertexIndex low, high;
    Side side;
    auto operator<=>(const Use&) const = default;
  };
  const auto corner = [&](Side side) { return triangles[side / 3][side % 3]; };
  std::vector<Use> uses;
  uses.reserve(3 * triangles.size());
  for (Side side = 0; side < 3 * triangles.size(); ++side) {
    const auto [low, high] = std::minmax({corner(side), corner(next_corner(side))});
    uses.push_back({low, high, side});
  }
  std::ranges::sort(uses);
  std::vector<Side> across(uses.size(), k_no_vertex);
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end) {
    const auto is_here = [&](const Use& use) {
      return use.low == uses[first].low && use.high == uses[first].high;
    };
    while (end < uses.size() && is_here(uses[end])) ++end;
    const Side one = uses[first].side, other = uses[end - 1].side;
    if (end - first != 2 || corner(one) == corner(other)) continue;
    across[one] = other;
    across[other] = one;
  }
  return across;
}

}  // namespace

OpenSurface open_surface(std::span<const glm::dvec3> vertices,
                         std::span<const std::array<VertexIndex, 3>> triangles) {
  const std::vector<Side> across = pair_sides(triangles);
  UnionFind fans(across.size());
  for (Side side = 0; side < across.size(); ++side) {
    if (across[side] == k_no_vertex) continue;
    fans.join(side, next_corner(across[side]));
    fans.join(next_corner(side), across[side]);
  }
  OpenSurface surface;
  std::vector<VertexIndex> number(across.size(), k_no_vertex);
  const auto vertex_of = [&](Side corner) {
    VertexIndex& known = number[fans.find(corner)];
    if (known == k_no_vertex) {
      known = static_cast<VertexIndex>(surface.mesh.vertices.size());
      surface.sources.push_back(triangles[corner / 3][corner % 3]);
      surface.mesh.vertices.push_back(vertices[surface.sources.back()]);
    }
    return known;
  };
  for (Side first = 0; first < across.size(); first += 3)
    surface.mesh.facets.push_back({vertex_of(first), vertex_of(first + 1), vertex_of(first + 2)});

  // A fan that is not closed has one side of the border that leaves its vertex and one that comes to it.
  std::vector<VertexIndex> next(surface.mesh.vertices.size(), k_no_vertex);
  for (Side side = 0; side < across.size(); ++side) {
    if (across[side] == k_no_vertex) next[vertex_of(side)] = vertex_of(next_corner(side));
  }
  for (VertexIndex first = 0; first < next.size(); ++first) {
    std::vector<VertexIndex> border;
    for (VertexIndex at = first; next[at] != k_no_vertex;) {
      border.push_back(at);
      at = std::exchange(next[at], k_no_vertex);
    }
    if (!border.empty()) surface.borders.push_back(std::move(border));
  }
  return surface;
}

glm::dvec3 enclosed_area(const OpenSurface& surface, std::span<const VertexIndex> border) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin = surface.mesh.vertices[border.front()];
  for (std::size_t k = 0; k < border.size(); ++k)
    sum += glm::cross(surface.mesh.vertices[border[k]] - origin,
                      surface.mesh.vertices[border[(k + 1) % border.size()]] - origin);
  return 0.5 * sum;
}

TriangleMesh solid_between(const OpenSurface& surface, std::span<const glm::dvec3> image) {
  CHECK(image.size() == surface.mesh.vertices.size());
  TriangleMesh solid;
  solid.vertices = surface.mesh.vertices;
  solid.vertices.insert(solid.vertices.end(), image.begin(), image.end());
  const auto beyond = [&](VertexIndex vertex) { return static_cast<VertexIndex>(vertex + image.size()); };
  for (const auto& [a, b, c] : surface.mesh.facets) {
    solid.facets.push_back({a, c, b});
    solid.facets.push_back({beyond(a), beyond(b), beyond(c)});
  }
  for (const std::vector<VertexIndex>& border : surface.borders) {
    for (std::size_t k = 0; k < border.size(); ++k) {
      const VertexIndex a = border[k], b = border[(k + 1) % border.size()];
      solid.facets.push_back({a, b, beyond(b)});
      solid.facets.push_back({a, beyond(b), beyond(a)});
    }
  }
  return solid;
}

}  // namespace moldlight
