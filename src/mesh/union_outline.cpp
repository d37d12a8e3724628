// A side of a triangle may be part of the outline unless triangles lie on both sides of it. Such sides are
// cut where they meet, and what has nothing on its right is chained.
#include "mesh/union_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/exterior_product.hpp>

namespace moldlight {

namespace {

using Corners = std::array<std::uint32_t, 3>;

constexpr double k_aside = 6.0 * k_outline_step;  // where it is tested whether the right is covered
constexpr double k_gap = 20.0 * k_outline_step;
constexpr double k_straight = k_outline_step;  // by which a corner must leave the line of its neighbours

/// A square of a grid, as one number.
std::uint64_t cell_key(std::int64_t x, std::int64_t y) {
  return (static_cast<std::uint64_t>(x) << 32) ^ (static_cast<std::uint64_t>(y) & 0xFFFFFFFFU);
}

/// Points, of which those that are near each other are one.
class PointSet {
 public:
  std::uint32_t add(const glm::dvec2& at) {
    const auto x = static_cast<std::int64_t>(std::floor(at.x / k_outline_step));
    const auto y = static_cast<std::int64_t>(std::floor(at.y / k_outline_step));
    for (int around = 0; around < 9; ++around) {
      const auto found = cells_.find(cell_key(x + around % 3 - 1, y + around / 3 - 1));
      if (found != cells_.end() && glm::distance(points_[found->second], at) <= k_outline_step)
        return found->second;
    }
    const auto number = static_cast<std::uint32_t>(points_.size());
    points_.push_back(at);
    cells_.emplace(cell_key(x, y), number);
    return number;
  }
  [[nodiscard]] const glm::dvec2& operator[](std::uint32_t number) const { return points_[number]; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }

 private:
  std::vector<glm::dvec2> points_;
  std::unordered_map<std::uint64_t, std::uint32_t> cells_;
};

/// Whether a point is in some triangle.
class Cover {
 public:
  Cover(const PointSet& points, std::span<const Corners> triangles) : points_(points), triangles_(triangles) {
    glm::dvec2 high(-std::numeric_limits<double>::infinity());
    low_ = -high;
    for (const Corners& corners : triangles) {
      for (const std::uint32_t corner : corners) {
        low_ = glm::min(low_, points[corner]);
        high = glm::max(high, points[corner]);
      }
    }
    count_ = std::clamp<std::int64_t>(std::llround(std::sqrt(static_cast<double>(triangles.size()))), 1, 512);
    size_ = glm::max((high - low_) / static_cast<double>(count_), glm::dvec2(k_outline_step));
    lists_.resize(static_cast<std::size_t>(count_ * count_));
    for (std::uint32_t k = 0; k < triangles.size(); ++k) {
      const glm::dvec2 &a = points[triangles[k][0]], &b = points[triangles[k][1]],
                       &c = points[triangles[k][2]];
      const auto [left, bottom] = cell(glm::min(glm::min(a, b), c));
      const auto [right, top] = cell(glm::max(glm::max(a, b), c));
      for (std::int64_t y = bottom; y <= top; ++y) {
        for (std::int64_t x = left; x <= right; ++x)
          lists_[static_cast<std::size_t>(y * count_ + x)].push_back(k);
      }
    }
  }

  [[nodiscard]] bool covers(const glm::dvec2& at) const {
    const auto [x, y] = cell(at);
    return std::ranges::any_of(lists_[static_cast<std::size_t>(y * count_ + x)], [&](std::uint32_t k) {
      const auto& [a, b, c] = triangles_[k];
      return glm::cross(points_[b] - points_[a], at - points_[a]) >= 0.0 &&
             glm::cross(points_[c] - points_[b], at - points_[b]) >= 0.0 &&
             glm::cross(points_[a] - points_[c], at - points_[c]) >= 0.0;
    });
  }

 private:
  [[nodiscard]] std::array<std::int64_t, 2> cell(const glm::dvec2& at) const {
    const glm::dvec2 place = (at - low_) / size_;
    return {std::clamp<std::int64_t>(static_cast<std::int64_t>(place.x), 0, count_ - 1),
            std::clamp<std::int64_t>(static_cast<std::int64_t>(place.y), 0, count_ - 1)};
  }

  const PointSet& points_;
  std::span<const Corners> triangles_;
  glm::dvec2 low_{0.0}, size_{1.0};
  std::int64_t count_ = 1;
  std::vector<std::vector<std::uint32_t>> lists_;
};

using Edge = std::array<std::uint32_t, 2>;

/// Sides with triangles on one side alone, run through with those on the left.
std::vector<Edge> open_sides(std::span<const Corners> triangles) {
  std::map<Edge, int> uses;
  for (const Corners& corners : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
      ++uses[{from, to}];
    }
  }
  std::vector<Edge> sides;
  for (const auto& [edge, count] : uses) {
    if (!uses.contains({edge[1], edge[0]})) sides.push_back(edge);
  }
  return sides;
}

/// The sides, cut where they cross and where they run past ends of others; each once.
std::vector<Edge> cut_sides(const std::vector<Edge>& sides, PointSet& points) {
  std::vector<std::vector<std::pair<double, std::uint32_t>>> cuts(sides.size());
  std::vector<std::size_t> order(sides.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto left = [&](std::size_t k) { return std::min(points[sides[k][0]].x, points[sides[k][1]].x); };
  const auto right = [&](std::size_t k) { return std::max(points[sides[k][0]].x, points[sides[k][1]].x); };
  std::ranges::stable_sort(order, {}, left);
  const auto note_end = [&](std::size_t k, std::uint32_t end) {
    const glm::dvec2 from = points[sides[k][0]], way = points[sides[k][1]] - from;
    const double length = glm::length(way), along = glm::dot(points[end] - from, way) / length;
    if (along > 0.0 && along < length &&
        std::abs(glm::cross(way, points[end] - from)) <= k_outline_step * length)
      cuts[k].emplace_back(along / length, end);
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    const glm::dvec2 from = points[sides[a][0]], to = points[sides[a][1]];
    const double bottom = std::min(from.y, to.y) - k_outline_step,
                 top = std::max(from.y, to.y) + k_outline_step;
    for (std::size_t j = i + 1; j < order.size() && left(order[j]) <= right(a) + k_outline_step; ++j) {
      const std::size_t b = order[j];
      const glm::dvec2 start = points[sides[b][0]], end = points[sides[b][1]];
      if (std::max(start.y, end.y) < bottom || std::min(start.y, end.y) > top) continue;
      for (const std::uint32_t corner : sides[b]) note_end(a, corner);
      for (const std::uint32_t corner : sides[a]) note_end(b, corner);
      const double turn = glm::cross(to - from, end - start);
      if (turn == 0.0) continue;
      const double on_a = glm::cross(start - from, end - start) / turn,
                   on_b = glm::cross(start - from, to - from) / turn;
      if (!(on_a > 0.0 && on_a < 1.0 && on_b > 0.0 && on_b < 1.0)) continue;
      const std::uint32_t met = points.add(from + on_a * (to - from));
      cuts[a].emplace_back(on_a, met);
      cuts[b].emplace_back(on_b, met);
    }
  }
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    std::ranges::sort(cuts[k]);
    std::uint32_t last = sides[k][0];
    cuts[k].emplace_back(1.0, sides[k][1]);
    for (const auto& [along, point] : cuts[k]) {
      if (point != last) edges.push_back({last, point});
      last = point;
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Puts edges together to loops.
class Chain {
 public:
  Chain(const std::vector<Edge>& edges, const PointSet& points) : points_(points) {
    for (const Edge& edge : edges) left_.emplace(edge[0], edge[1]);
  }

  /// The next loop; nothing where no edges are left, or they leave it open.
  std::optional<std::vector<glm::dvec2>> next() {
    if (left_.empty()) return std::nullopt;
    const std::uint32_t first = left_.begin()->first;
    std::vector<glm::dvec2> loop;
    std::uint32_t at = first;
    glm::dvec2 came(0.0);
    do {
      if (!left_.contains(at)) {
        const std::optional<std::uint32_t> beyond = across_gap(at, first);
        broken_ = !beyond;
        if (broken_) return std::nullopt;
        at = *beyond;
        continue;
      }
      const auto edge = leftmost(at, came);
      came = points_[edge->second] - points_[at];
      loop.push_back(points_[at]);
      at = edge->second;
      left_.erase(edge);
    } while (at != first);
    return loop;
  }
  [[nodiscard]] bool broken() const { return broken_; }

 private:
  using Edges = std::multimap<std::uint32_t, std::uint32_t>;

  /// Where several lead on: so loops that touch stay apart.
  [[nodiscard]] Edges::const_iterator leftmost(std::uint32_t at, const glm::dvec2& came) const {
    const auto [begin, end] = left_.equal_range(at);
    const auto turn = [&](const auto& edge) {
      const glm::dvec2 way = points_[edge.second] - points_[at];
      return std::atan2(glm::cross(came, way), glm::dot(came, way));
    };
    return std::max_element(begin, end, [&](const auto& a, const auto& b) { return turn(a) < turn(b); });
  }

  /// A sliver that was taken for another side leaves a gap: the nearest start of an edge, or of the loop.
  [[nodiscard]] std::optional<std::uint32_t> across_gap(std::uint32_t at, std::uint32_t first) const {
    std::optional<std::uint32_t> nearest;
    double least = k_gap;
    const auto look_at = [&](std::uint32_t point) {
      const double distance = glm::distance(points_[point], points_[at]);
      if (point == at || distance > least) return;
      least = distance;
      nearest = point;
    };
    look_at(first);
    for (const auto& [from, to] : left_) look_at(from);
    return nearest;
  }

  const PointSet& points_;
  Edges left_;
  bool broken_ = false;
};

/// Without corners that are none.
std::vector<glm::dvec2> straightened(const std::vector<glm::dvec2>& loop) {
  std::vector<glm::dvec2> kept;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const glm::dvec2& before = kept.empty() ? loop.back() : kept.back();
    const glm::dvec2 way = loop[(k + 1) % loop.size()] - before;
    const double length = glm::length(way);
    if (length > 0.0 && std::abs(glm::cross(way, loop[k] - before)) <= k_straight * length &&
        glm::dot(loop[k] - before, way) >= 0.0)
      continue;
    kept.push_back(loop[k]);
  }
  return kept;
}

}  // namespace

std::optional<std::vector<std::vector<glm::dvec2>>> union_outline(std::span<const glm::dvec2> points,
                                                                  std::span<const Corners> triangles,
                                                                  std::size_t most_edges) {
  PointSet joined;
  std::vector<std::uint32_t> number;
  for (const glm::dvec2& point : points) number.push_back(joined.add(point));
  std::vector<Corners> turned;
  for (const Corners& corners : triangles) {
    Corners each = {number[corners[0]], number[corners[1]], number[corners[2]]};
    if (each[0] == each[1] || each[1] == each[2] || each[2] == each[0]) continue;
    const double area = glm::cross(joined[each[1]] - joined[each[0]], joined[each[2]] - joined[each[0]]);
    if (area == 0.0) continue;
    if (area < 0.0) std::swap(each[1], each[2]);
    turned.push_back(each);
  }
  std::vector<std::vector<glm::dvec2>> loops;
  if (turned.empty()) return loops;
  const std::vector<Edge> sides = open_sides(turned);
  if (sides.size() > most_edges) return std::nullopt;
  std::vector<Edge> edges = cut_sides(sides, joined);
  const Cover cover(joined, turned);
  std::erase_if(edges, [&](const Edge& edge) {
    const glm::dvec2 way = glm::normalize(joined[edge[1]] - joined[edge[0]]);
    const glm::dvec2 middle = 0.5 * (joined[edge[0]] + joined[edge[1]]);
    return cover.covers(middle + k_aside * glm::dvec2(way.y, -way.x));
  });

  Chain chain(edges, joined);
  while (auto loop = chain.next()) {
    *loop = straightened(*loop);
    if (loop->size() > 2) loops.push_back(std::move(*loop));
  }
  if (chain.broken()) return std::nullopt;
  std::ranges::stable_sort(loops, std::greater(),
                           [](const auto& loop) { return std::abs(enclosed_area(std::span(&loop, 1))); });
  return loops;
}

double enclosed_area(std::span<const std::vector<glm::dvec2>> loops) {
  double area = 0.0;
  for (const std::vector<glm::dvec2>& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      area += 0.5 * glm::cross(loop[k] - loop.front(), loop[(k + 1) % loop.size()] - loop.front());
  }
  return area;
}

}  // namespace moldlight
