#include "parting/halves/slope_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

/// Facets steeper than this share of the slope are brought down to another one, which is less, so that this
/// ends.
constexpr double k_most_share = 0.9995, k_held_share = 0.998, k_free_share = 0.85;
/// So often each facet is brought down at most, on average: where nothing forces the surface to be steeper
/// there is an end to it, which may be far.
constexpr std::size_t k_rounds = 20, k_rounds_to_an_end = 2000, k_most_brought_down = 1'000'000;
/// How much easier a point is moved that no range holds.
constexpr double k_free_mobility = 4.0;
/// Points nearer to each other than this, in diagonals of the part, have one height: between them stands a
/// wall, where the part wants one, and no needle leads from it across the surface.
constexpr double k_one_place = 2e-5;
/// A range that is missed by more than this holds nothing.
constexpr double k_given_up = 1e-4;
constexpr int k_most_steeper = 30, k_most_newton = 12;

struct Way {
  std::uint32_t to = 0;
  double length = 0.0;
};
using Around = std::vector<std::vector<Way>>;

/// Edges outside, between the first of the points near their ends; those of two triangles twice.
Around ways_outside(const PlaneMesh& mesh, const std::vector<std::uint32_t>& first) {
  Around around(mesh.points().size());
  for (const PlaneMesh::Triangle& t : mesh.triangles()) {
    if (t.inside) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = first[t.corners[k]], b = first[t.corners[(k + 1) % 3]];
      const double length = glm::distance(mesh.points()[a], mesh.points()[b]);
      around[a].push_back({b, length});
      around[b].push_back({a, length});
    }
  }
  return around;
}

/// For every point the least of a value + `slope` times the way along edges outside, and from where it comes.
struct Spread {
  std::vector<double> value;
  std::vector<std::uint32_t> source;
};

Spread spread(const Around& around, std::vector<double> value, double slope) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  Spread found{std::move(value), std::vector<std::uint32_t>(around.size())};
  for (std::uint32_t k = 0; k < found.value.size(); ++k) {
    found.source[k] = k;
    if (std::isfinite(found.value[k])) queue.emplace(found.value[k], k);
  }
  while (!queue.empty()) {
    const auto [at, point] = queue.top();
    queue.pop();
    if (at > found.value[point]) continue;
    for (const auto& [other, length] : around[point]) {
      const double reached = at + slope * length;
      if (reached >= found.value[other]) continue;
      found.value[other] = reached;
      found.source[other] = found.source[point];
      queue.emplace(reached, other);
    }
  }
  return found;
}

/// Least (as negative numbers) and greatest heights that ranges leave to each point at a slope.
struct Envelopes {
  Spread low, high;

  [[nodiscard]] HeightRange at(std::size_t point) const { return {-low.value[point], high.value[point]}; }
};

Envelopes envelopes(const Around& around, const std::vector<HeightRange>& ranges, double slope) {
  std::vector<double> from_low, from_high;
  for (const HeightRange& range : ranges) {
    from_low.push_back(-range.low);
    from_high.push_back(range.high);
  }
  return {spread(around, std::move(from_low), slope), spread(around, std::move(from_high), slope)};
}

/// A facet's slope as a linear map of its corners' heights.
struct SlopedFacet {
  std::array<std::uint32_t, 3> corners{};
  std::array<glm::dvec2, 3> gradient{};  // of the height that is 1 at corner k alone
  double width = 0.0;                    // least height in the plane

  [[nodiscard]] double slope(const std::vector<double>& z) const {
    glm::dvec2 g(0.0);
    for (std::size_t k = 0; k < 3; ++k) g += z[corners[k]] * gradient[k];
    return glm::length(g);
  }
};

/// Points that have one height: the first of those near each point, and what ranges leave to all of them.
struct NearPoints {
  NearPoints(const PlaneMesh& mesh, const std::vector<HeightRange>& of_points, const std::vector<double>& z)
      : first(z.size()), ranges(z.size()), heights(z.size(), 0.0) {
    UnionFind joined(z.size());
    for (const PlaneMesh::Triangle& t : mesh.triangles()) {
      for (std::size_t k = 0; k < 3 && !t.inside; ++k) {
        const std::uint32_t a = t.corners[k], b = t.corners[(k + 1) % 3];
        if (glm::distance(mesh.points()[a], mesh.points()[b]) < k_one_place) joined.join(a, b);
      }
    }
    std::vector<double> counts(z.size(), 0.0);
    for (std::uint32_t point = 0; point < z.size(); ++point) {
      const std::uint32_t to = first[point] = joined.find(point);
      ranges[to] = {std::max(ranges[to].low, of_points[point].low),
                    std::min(ranges[to].high, of_points[point].high)};
      heights[to] += z[point];
      ++counts[to];
    }
    for (std::uint32_t point = 0; point < z.size(); ++point) {
      HeightRange& range = ranges[point];
      if (counts[point] > 1.0) heights[point] /= counts[point];
      if (counts[point] > 1.0 && !range.empty())
        heights[point] = std::clamp(heights[point], range.low, range.high);
      // What the surface gave up stays so.
      if (heights[point] < range.low - k_given_up || heights[point] > range.high + k_given_up) range = {};
    }
  }

  std::vector<std::uint32_t> first;
  std::vector<HeightRange> ranges;  // and heights: of the first
  std::vector<double> heights;
};

/// The corners are the first of those near them.
std::vector<SlopedFacet> facets_outside(const PlaneMesh& mesh, double narrow,
                                        const std::vector<std::uint32_t>& first) {
  std::vector<SlopedFacet> facets;
  for (const PlaneMesh::Triangle& t : mesh.triangles()) {
    if (t.inside) continue;
    const auto point = [&](std::size_t k) { return mesh.points()[t.corners[k % 3]]; };
    const glm::dvec2 p = point(1) - point(0), q = point(2) - point(0);
    const double twice = p.x * q.y - p.y * q.x;
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, glm::distance(point(k), point(k + 1)));
    if (twice <= narrow * longest) continue;
    SlopedFacet facet{.corners = {first[t.corners[0]], first[t.corners[1]], first[t.corners[2]]},
                      .gradient = {},
                      .width = twice / longest};
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 across = point(k + 2) - point(k + 1);
      facet.gradient[k] = glm::dvec2(-across.y, across.x) / twice;
    }
    facets.push_back(facet);
  }
  return facets;
}

/// Moves the corners' heights of a facet that is steeper than `most` as little as brings it down to `slope`;
/// the mobility of each is how little moving it counts.
bool flatten(const SlopedFacet& facet, const std::vector<double>& mobility, double most, double slope,
             std::vector<double>& z) {
  glm::dvec2 g(0.0);
  for (std::size_t k = 0; k < 3; ++k) g += z[facet.corners[k]] * facet.gradient[k];
  if (glm::length(g) <= most) return false;
  // What moving does to the slope, by its axes.
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2& d = facet.gradient[k];
    const double m = mobility[facet.corners[k]];
    xx += m * d.x * d.x;
    xy += m * d.x * d.y;
    yy += m * d.y * d.y;
  }
  const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const glm::dvec2 u(std::cos(turn), std::sin(turn)), v(-u.y, u.x);
  const double along_u = xx * u.x * u.x + 2.0 * xy * u.x * u.y + yy * u.y * u.y, along_v = xx + yy - along_u;
  const double gu = glm::dot(g, u), gv = glm::dot(g, v);
  // How hard to push, by Newton's method on the reciprocal (Moré and Sorensen 1983).
  glm::dvec2 rest(gu, gv);
  double push = 0.0;
  for (int k = 0; k < k_most_newton && glm::length(rest) > (1.0 + 1e-6) * slope; ++k) {
    const double size = glm::length(rest);
    const double fall = (rest.x * rest.x * along_u / (1.0 + push * along_u) +
                         rest.y * rest.y * along_v / (1.0 + push * along_v)) /
                        size;
    push += size * (size / slope - 1.0) / fall;
    rest = {gu / (1.0 + push * along_u), gv / (1.0 + push * along_v)};
  }
  const glm::dvec2 pull = (gu - rest.x) / along_u * u + (along_v > 0.0 ? (gv - rest.y) / along_v : 0.0) * v;
  for (std::size_t k = 0; k < 3; ++k)
    z[facet.corners[k]] -= mobility[facet.corners[k]] * glm::dot(facet.gradient[k], pull);
  return true;
}

/// Points of narrow facets alone stand between those around them, as far as their ranges go, lest the surface
/// have notches there.
void fill_notches(const std::vector<SlopedFacet>& facets, const Around& around,
                  const std::vector<HeightRange>& ranges, std::vector<double>& z) {
  std::vector<char> wide(z.size(), 0);
  for (const SlopedFacet& facet : facets) {
    for (const std::uint32_t corner : facet.corners) wide[corner] = 1;
  }
  for (std::uint32_t point = 0; point < z.size(); ++point) {
    double sum = 0.0, weights = 0.0;
    for (const auto& [to, length] : around[point]) {
      if (wide[point] != 0 || wide[to] == 0) continue;
      const double weight = 1.0 / std::max(length, k_one_place);
      sum += weight * z[to];
      weights += weight;
    }
    if (weights > 0.0 && !ranges[point].empty())
      z[point] = std::clamp(sum / weights, ranges[point].low, ranges[point].high);
  }
}

/// Keeps heights in their ranges where it can; empty ranges hold nothing.
struct Hold {
  const std::vector<HeightRange>* ranges = nullptr;  // none: nothing is held
  std::size_t rounds = 0;  // so often each facet is brought down at most, on average
  double share = 1.0;      // of the slope, down to which
};

/// Facets have greater slopes than their edges: those that are too steep are brought down one after the
/// other, with those around them that become so.
class Flattener {
 public:
  Flattener(const PlaneMesh& mesh, const NearPoints& near, double slope, double narrow)
      : facets_(facets_outside(mesh, narrow, near.first)),
        first_(mesh.points().size() + 1, 0),
        mobility_(mesh.points().size(), k_free_mobility),
        slope_(slope) {
    for (const SlopedFacet& facet : facets_) {
      for (const std::uint32_t corner : facet.corners) ++first_[corner + 1];
    }
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    around_.resize(first_.back());
    std::vector<std::uint32_t> filled(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < facets_.size(); ++k) {
      for (const std::uint32_t corner : facets_[k].corners) around_[filled[corner]++] = k;
    }
    for (std::size_t k = 0; k < near.ranges.size(); ++k) {
      if (std::isfinite(near.ranges[k].low) || std::isfinite(near.ranges[k].high)) mobility_[k] = 1.0;
    }
  }

  [[nodiscard]] const std::vector<SlopedFacet>& facets() const { return facets_; }

  /// Whether no facet is too steep afterwards.
  bool run(const Hold& hold, std::vector<double>& z) const {
    std::deque<std::uint32_t> waiting(facets_.size());
    std::iota(waiting.begin(), waiting.end(), 0U);
    std::vector<std::uint8_t> waits(facets_.size(), 1);
    std::size_t left =
        std::max(k_rounds * facets_.size(), std::min(hold.rounds * facets_.size(), k_most_brought_down));
    for (; !waiting.empty() && left > 0; --left) {
      const std::uint32_t number = waiting.front();
      waiting.pop_front();
      waits[number] = 0;
      const SlopedFacet& facet = facets_[number];
      if (!flatten(facet, mobility_, k_most_share * slope_, hold.share * slope_, z)) continue;
      for (const std::uint32_t corner : facet.corners) {
        if (hold.ranges != nullptr && (*hold.ranges)[corner].low <= (*hold.ranges)[corner].high)
          z[corner] = std::clamp(z[corner], (*hold.ranges)[corner].low, (*hold.ranges)[corner].high);
        for (std::uint32_t k = first_[corner]; k < first_[corner + 1]; ++k) {
          if (waits[around_[k]] != 0) continue;
          waits[around_[k]] = 1;
          waiting.push_back(around_[k]);
        }
      }
    }
    return waiting.empty();
  }

 private:
  std::vector<SlopedFacet> facets_;
  std::vector<std::uint32_t> first_, around_;  // facets around each point
  std::vector<double> mobility_;
  double slope_ = 0.0;
};

/// What is left too steep becomes about level, and all else no steeper than before: the middle of the two
/// envelopes of the heights, over edges that may climb only so much that no facet at them can be too steep.
void level_rest(const std::vector<SlopedFacet>& facets, Around around, double slope, std::vector<double>& z) {
  constexpr int k_most_levelled = 60;
  for (int round = 0; round < k_most_levelled; ++round) {
    bool any = false;
    for (const SlopedFacet& facet : facets) {
      if (facet.slope(z) <= slope) continue;
      any = true;
      for (std::size_t k = 0; k < 3; ++k) {
        for (Way& way : around[facet.corners[k]]) {
          if (std::ranges::find(facet.corners, way.to) != facet.corners.end())
            way.length = std::min(way.length, 0.5 * facet.width);
        }
      }
    }
    if (!any) return;
    std::vector<double> turned(z.size());
    std::ranges::transform(z, turned.begin(), std::negate());
    const Spread high = spread(around, z, slope), low = spread(around, turned, slope);
    for (std::size_t k = 0; k < z.size(); ++k) z[k] = 0.5 * (high.value[k] - low.value[k]);
  }
}

}  // namespace

ForcedSlope forced_slope(const PlaneMesh& mesh, const std::vector<HeightRange>& ranges, double slope) {
  std::vector<std::uint32_t> all(ranges.size());
  std::iota(all.begin(), all.end(), 0U);
  const Around around = ways_outside(mesh, all);
  ForcedSlope forced;
  for (int round = 0; round < k_most_steeper; ++round) {
    const Envelopes found = envelopes(around, ranges, slope);
    double most = 0.0;
    std::size_t at = 0;
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      const HeightRange range = found.at(k);
      if (range.low - range.high <= most) continue;
      most = range.low - range.high;
      at = k;
    }
    const std::uint32_t high = found.low.source[at], low = found.high.source[at];
    const double rise = ranges[high].low - ranges[low].high;
    const double way = (rise - most) / slope;
    if (most <= 1e-9 * (1.0 + std::abs(rise))) return forced;
    forced = {.tangent = high == low || way <= 1e-12 ? INFINITY : rise / way,
              .high = glm::dvec3(mesh.points()[high], ranges[high].low),
              .low = glm::dvec3(mesh.points()[low], ranges[low].high)};
    if (!std::isfinite(forced.tangent)) return forced;
    slope = forced.tangent;
  }
  return forced;
}

void keep_slope(const PlaneMesh& mesh, const std::vector<HeightRange>& ranges, const SlopeWish& wish,
                std::vector<double>& z) {
  NearPoints near(mesh, ranges, z);
  const Flattener flattener(mesh, near, wish.slope, wish.narrow);
  const Around around = ways_outside(mesh, near.first);
  std::vector<double>& heights = near.heights;
  if (!flattener.run({&near.ranges, wish.forced ? k_rounds : k_rounds_to_an_end, k_held_share}, heights) &&
      !flattener.run({nullptr, k_rounds, k_free_share}, heights))
    level_rest(flattener.facets(), around, wish.slope, heights);
  fill_notches(flattener.facets(), around, near.ranges, heights);
  for (std::size_t point = 0; point < z.size(); ++point) z[point] = heights[near.first[point]];
}

}  // namespace moldlight
