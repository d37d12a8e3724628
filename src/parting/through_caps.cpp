#include "parting/through_caps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/exterior_product.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

constexpr double k_rim_reach = 2.0;  // lateral tolerances: walls of holes lean by their facets

}  // namespace

ThroughCaps::ThroughCaps(const Assignment& sides, const SheetFrame& frame)
    : reach_(k_rim_reach * sides.lateral / frame.diagonal) {
  // Where halves and actions meet.
  UnionFind joined(sides.mesh.vertices.size());
  const auto is_rim = [&](const PieceEdge& edge) {
    return edge.right != k_no_piece &&
           (sides.sides[edge.left] == MoldSide::action) != (sides.sides[edge.right] == MoldSide::action);
  };
  for (const PieceEdge& edge : sides.edges.edges) {
    if (is_rim(edge)) joined.join(edge.from, edge.to);
  }
  std::map<VertexIndex, Chain> chains;
  for (const PieceEdge& edge : sides.edges.edges) {
    if (is_rim(edge))
      chains[joined.find(edge.from)].push_back(
          {frame.in_mold(sides.mesh.vertices[edge.from]), frame.in_mold(sides.mesh.vertices[edge.to])});
  }
  for (const SeenPatch& patch : sides.seen_through) {
    Cap cap;
    cap.sheet = sides.mesh.pieces[patch.pieces.front()].region == Region::core ? Sheet::upper : Sheet::lower;
    for (const PieceIndex piece : patch.pieces) {
      std::array<glm::dvec3, 3>& corners = cap.patch.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = frame.in_mold(sides.mesh.corner(piece, k));
        cap.bounds.add(corners[k]);
      }
    }
    cap.rim = rim_over(cap, chains);
    cap.way = glm::normalize(glm::dvec2(frame.frame.to_mold(patch.way)));
    if (!cap.rim.empty()) caps_.push_back(std::move(cap));
  }
}

/// That over the outline of the patch, the nearest of them.
ThroughCaps::Chain ThroughCaps::rim_over(const Cap& cap, const std::map<VertexIndex, Chain>& chains) const {
  const Chain* nearest = nullptr;
  double least = INFINITY;
  for (const auto& [vertex, chain] : chains) {
    Bounds box;
    for (const Segment& segment : chain) box.add(segment.from);
    const glm::dvec2 low(box.min - cap.bounds.min), high(box.max - cap.bounds.max);
    const double off = std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
    const double above =
        cap.sheet == Sheet::upper ? box.min.z - cap.bounds.max.z : cap.bounds.min.z - box.max.z;
    if (off > k_rim_reach * reach_ || above <= 0.0 || above >= least) continue;
    least = above;
    nearest = &chain;
  }
  return nearest != nullptr ? *nearest : Chain{};
}

double ThroughCaps::height(const Cap& cap, const glm::dvec2& at) const {
  double nearest = INFINITY, there = 0.0;
  std::array<double, 2> ways = {-INFINITY, INFINITY}, heights{};
  for (const auto& [from, to] : cap.rim) {
    const glm::dvec2 run(to - from);
    const double squared = glm::dot(run, run);
    const double along =
        squared > 0.0 ? glm::clamp(glm::dot(at - glm::dvec2(from), run) / squared, 0.0, 1.0) : 0.0;
    const glm::dvec3 place = glm::mix(from, to, along);
    const double distance = glm::distance(glm::dvec2(place), at);
    if (distance < nearest) {
      nearest = distance;
      there = place.z;
    }
    // Where the line through the place, along the way, meets the rim.
    const double turn = glm::cross(cap.way, run);
    if (turn == 0.0) continue;
    const double share = glm::cross(cap.way, at - glm::dvec2(from)) / turn;
    if (share < 0.0 || share > 1.0) continue;
    const glm::dvec3 met = glm::mix(from, to, share);
    const double way = glm::dot(glm::dvec2(met) - at, cap.way);
    const std::size_t side = way < 0.0 ? 0 : 1;
    if (std::abs(way) >= std::abs(ways[side])) continue;
    ways[side] = way;
    heights[side] = met.z;
  }
  if (nearest <= reach_ || !std::isfinite(ways[0]) || !std::isfinite(ways[1])) return there;
  return glm::mix(heights[0], heights[1], -ways[0] / (ways[1] - ways[0]));
}

bool ThroughCaps::is_under(const Cap& cap, const glm::dvec3& at) const {
  if (glm::any(glm::lessThan(at, cap.bounds.min - reach_)) ||
      glm::any(glm::greaterThan(at, cap.bounds.max + reach_)))
    return false;
  return std::ranges::any_of(cap.patch, [&](const std::array<glm::dvec3, 3>& corners) {
    return glm::distance(nearest_in_triangle(at, corners), at) <= reach_;
  });
}

std::optional<std::array<double, 3>> ThroughCaps::heights(Sheet sheet,
                                                          const std::array<glm::dvec3, 3>& corners) const {
  const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const auto cap = std::ranges::find_if(
      caps_, [&](const Cap& one) { return one.sheet == sheet && is_under(one, middle); });
  if (cap == caps_.end()) return std::nullopt;
  std::array<double, 3> heights{};
  for (std::size_t k = 0; k < 3; ++k) heights[k] = height(*cap, glm::dvec2(corners[k]));
  return heights;
}

}  // namespace moldlight
