#include "actions/least_actions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

#include <glm/geometric.hpp>

#include "actions/action_kind.hpp"
#include "mesh/union_find.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

/// How an undercut lies about its centre.
struct Spread {
  double radius = 0.0;    // of the ball around it
  bool is_round = false;  // it goes all the way round the direction through its centre
};

Spread spread(const SplitMesh& split, const Undercut& undercut, const glm::dvec3& direction) {
  constexpr double k_least_hole = 0.2;  // of the greatest distance
  const MapFrame frame = map_frame(direction);
  Spread found;
  unsigned quarters = 0;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (const std::uint32_t piece : undercut.pieces) {
    for (const VertexIndex corner : split.pieces[piece].corners) {
      const glm::dvec3 off = split.vertices[corner] - undercut.centre;
      found.radius = std::max(found.radius, glm::length(off));
      const double x = glm::dot(off, frame.x), y = glm::dot(off, frame.y), across = std::hypot(x, y);
      nearest = std::min(nearest, across);
      farthest = std::max(farthest, across);
      quarters |= 1U << ((x > 0.0 ? 1U : 0U) + (y > 0.0 ? 2U : 0U));
    }
  }
  found.is_round = quarters == 15U && nearest > k_least_hole * farthest;
  return found;
}

}  // namespace

LeastActions least_actions(const PartModel& model, const SplitMesh& split, const Undercuts& undercuts,
                           const glm::dvec3& direction, const ActionSettings& settings) {
  const std::vector<Undercut>& all = undercuts.counted;
  const double reach =
      std::hypot(settings.bundle_across_mm, settings.bundle_along_mm) * unit_per_mm(model.part);
  std::vector<Spread> spreads;
  for (const Undercut& undercut : all) spreads.push_back(spread(split, undercut, direction));
  UnionFind near(all.size());
  for (std::uint32_t b = 0; b < all.size(); ++b) {
    for (std::uint32_t a = 0; a < b; ++a) {
      const double gap = glm::distance(all[a].centre, all[b].centre) - spreads[a].radius - spreads[b].radius;
      if (gap <= reach) near.join(a, b);
    }
  }
  const auto price = [&](ActionKind kind) { return settings.prices[static_cast<std::size_t>(kind)]; };
  const double straight = std::min({price(ActionKind::slide), price(ActionKind::inclined),
                                    price(ActionKind::lifter), price(ActionKind::insert)});
  const double round = std::min({straight, price(ActionKind::unscrew), price(ActionKind::strip)});
  // Of groups, at their first undercuts.
  std::vector<double> weights(all.size(), 0.0), areas(all.size(), 0.0);
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    const double own = spreads[k].is_round ? round : straight;
    double& weight = weights[near.find(k)];
    weight = weight > 0.0 ? std::min(weight, own) : own;
    areas[near.find(k)] += all[k].area;
  }
  std::ranges::sort(areas, std::greater());
  const auto beyond = areas.begin() + static_cast<std::ptrdiff_t>(std::min(k_most_actions, areas.size()));
  return {.weight = std::accumulate(weights.begin(), weights.end(), 0.0),
          .beyond = std::accumulate(beyond, areas.end(), 0.0)};
}

}  // namespace moldlight
