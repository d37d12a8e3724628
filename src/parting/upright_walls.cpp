#include "parting/upright_walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/exterior_product.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

/// Facets lean by rounding where they are less wide than this as seen along the direction, in diagonals of
/// the part, and edges and facets less than this from upright, as a tangent. The wider one of what is
/// upright.
constexpr double k_widest = 1e-5, k_most_lean = 2e-3, k_upright = 1e-10;
constexpr double k_farthest = 2.0 * k_widest;
constexpr int k_most_rounds = 200;

class Straightener {
 public:
  Straightener(const TriangleMesh& mesh, const SheetFrame& frame)
      : mesh_(mesh), frame_(frame), columns_(mesh.vertices.size()) {
    for (const glm::dvec3& vertex : mesh.vertices) at_.push_back(frame.in_mold(vertex));
  }

  std::optional<TriangleMesh> run() {
    if (!find_walls()) return std::nullopt;
    do {
      stand_edges();
      for (int round = 0; round < k_most_rounds && flatten() > 0.01 * k_upright; ++round) {
      }
    } while (leave_far());
    TriangleMesh moved = mesh_;
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (const glm::dvec2 way = way_of(v); way != glm::dvec2(0.0))
        moved.vertices[v] += frame_.diagonal * frame_.frame.to_part(glm::dvec3(way, 0.0));
    }
    return moved;
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;

  /// Whether any of them leans.
  bool find_walls() {
    bool any = false;
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      Corners corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh_.facets[facet][k];
      const glm::dvec3 normal =
          glm::cross(at_[corners[1]] - at_[corners[0]], at_[corners[2]] - at_[corners[0]]);
      double longest = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest,
                           glm::distance(glm::dvec2(at_[corners[k]]), glm::dvec2(at_[corners[(k + 1) % 3]])));
      const double width = longest > 0.0 ? std::abs(normal.z) / longest : 0.0;
      if (width > k_widest || std::abs(normal.z) > k_most_lean * glm::length(normal)) continue;
      walls_.push_back(corners);
      any = any || width > k_upright;
    }
    return any;
  }

  [[nodiscard]] glm::dvec2 way_of(std::uint32_t v) { return place_[columns_.find(v)] - glm::dvec2(at_[v]); }

  /// Walls with corners that moved too far stay as they are; whether there were some.
  bool leave_far() {
    std::vector<char> far(at_.size(), 0);
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (glm::length(way_of(v)) > k_farthest) far[columns_.find(v)] = 1;
    }
    return std::erase_if(walls_, [&](const Corners& wall) {
             return std::ranges::any_of(wall, [&](std::uint32_t v) { return far[columns_.find(v)] != 0; });
           }) > 0;
  }

  /// Ends of edges of walls that are upright but for rounding stand above each other, in their middle.
  void stand_edges() {
    columns_ = UnionFind(at_.size());
    place_.clear();
    for (const glm::dvec3& at : at_) place_.emplace_back(at);
    for (const Corners& wall : walls_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 way = at_[wall[(k + 1) % 3]] - at_[wall[k]];
        const double lean = glm::length(glm::dvec2(way));
        if (lean <= k_widest && lean <= k_most_lean * std::abs(way.z))
          columns_.join(wall[k], wall[(k + 1) % 3]);
      }
    }
    std::vector<double> members(at_.size(), 0.0);
    std::vector<glm::dvec2> sums(at_.size(), glm::dvec2(0.0));
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      const std::uint32_t column = columns_.find(v);
      sums[column] += glm::dvec2(at_[v]);
      ++members[column];
    }
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (members[v] > 1.0) place_[v] = sums[v] / members[v];
    }
  }

  /// Moves the corners of each wall as little as puts them in one line, as seen along the direction; returns
  /// how far the worst one was from it.
  double flatten() {
    double worst = 0.0;
    for (const Corners& wall : walls_) {
      Corners c{};
      for (std::size_t k = 0; k < 3; ++k) c[k] = columns_.find(wall[k]);
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      // The longest side, and what is beside it.
      for (int turn = 0; turn < 2; ++turn) {
        if (glm::distance(place_[c[0]], place_[c[1]]) >=
            std::max(glm::distance(place_[c[1]], place_[c[2]]), glm::distance(place_[c[2]], place_[c[0]])))
          break;
        std::rotate(c.begin(), c.begin() + 1, c.end());
      }
      const glm::dvec2 along = place_[c[1]] - place_[c[0]], away = place_[c[2]] - place_[c[0]];
      const double length = glm::length(along);
      if (length <= 0.0) continue;
      const double off = glm::cross(along, away) / length;
      worst = std::max(worst, std::abs(off));
      const double share = std::clamp(glm::dot(away, along) / (length * length), 0.0, 1.0);
      const glm::dvec2 step = off / (1.0 + share * share + (1.0 - share) * (1.0 - share)) *
                              glm::dvec2(-along.y, along.x) / length;
      place_[c[2]] -= step;
      place_[c[0]] += (1.0 - share) * step;
      place_[c[1]] += share * step;
    }
    return worst;
  }

  const TriangleMesh& mesh_;
  const SheetFrame& frame_;
  std::vector<glm::dvec3> at_;
  std::vector<glm::dvec2> place_;  // of columns
  UnionFind columns_;
  std::vector<Corners> walls_;
};

}  // namespace

std::optional<UprightPart> with_upright_walls(const TriangleMesh& mesh, const SheetFrame& frame, double reach,
                                              const Progress& progress) {
  std::optional<TriangleMesh> moved = Straightener(mesh, frame).run();
  auto divided = with_divided_walls(moved ? *moved : mesh, frame, reach, progress);
  if (divided || !moved) return divided;
  return part_as_it_is(std::move(*moved));
}

UprightPart part_as_it_is(TriangleMesh mesh) {
  UprightPart part{.mesh = std::move(mesh), .facet_of = {}};
  part.facet_of.resize(part.mesh.facets.size());
  std::iota(part.facet_of.begin(), part.facet_of.end(), FacetIndex{0});
  return part;
}

}  // namespace moldlight
