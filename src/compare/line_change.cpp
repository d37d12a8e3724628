// Where a revision's parting line leaves that of the mold that exists.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "compare/mold_change.hpp"

namespace moldlight {

namespace {

/// Of the diagonal: how far apart a line is looked at.
constexpr double k_step_share = 1e-3;

struct Segment {
  glm::dvec3 from{0.0}, to{0.0};
};

bool parts_halves(const PartingLoop& loop) { return loop.kind != LoopKind::action && loop.points.size() > 1; }

/// Segments by cells of space that are as wide as what is near.
class NearestSegment {
 public:
  NearestSegment(const PartingLine& line, double step, double most) : size_(step), most_(most) {
    for (const PartingLoop& loop : line.loops) {
      if (!parts_halves(loop)) continue;
      for (std::size_t k = 0; k < loop.points.size(); ++k)
        segments_.push_back({loop.points[k], loop.points[(k + 1) % loop.points.size()]});
    }
    for (std::uint32_t k = 0; k < segments_.size(); ++k) {
      const auto [from, to] = segments_[k];
      const auto steps = static_cast<int>(std::ceil(2.0 * glm::distance(from, to) / size_));
      for (int i = 0; i <= steps; ++i) {
        auto& cell = cells_[cell_of(glm::mix(from, to, steps == 0 ? 0.0 : static_cast<double>(i) / steps))];
        if (cell.empty() || cell.back() != k) cell.push_back(k);
      }
    }
  }

  [[nodiscard]] double distance(const glm::dvec3& point) const {
    double least = most_;
    const auto [x, y, z] = cell_of(point);
    for (std::int64_t i = x - 1; i <= x + 1; ++i)
      for (std::int64_t j = y - 1; j <= y + 1; ++j)
        for (std::int64_t k = z - 1; k <= z + 1; ++k) {
          const auto found = cells_.find({i, j, k});
          if (found == cells_.end()) continue;
          for (const std::uint32_t segment : found->second) least = std::min(least, off(point, segment));
        }
    if (least <= 0.5 * size_) return least;
    for (std::uint32_t segment = 0; segment < segments_.size(); ++segment)
      least = std::min(least, off(point, segment));
    return least;
  }

 private:
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;

  [[nodiscard]] Cell cell_of(const glm::dvec3& point) const {
    const glm::dvec3 cell = glm::floor(point / size_);
    return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
            static_cast<std::int64_t>(cell.z)};
  }
  [[nodiscard]] double off(const glm::dvec3& point, std::uint32_t segment) const {
    return distance_to_segment(point, segments_[segment].from, segments_[segment].to);
  }

  double size_, most_;
  std::vector<Segment> segments_;
  std::map<Cell, std::vector<std::uint32_t>> cells_;
};

std::vector<LineStretch> stretches_off(const PartingLine& line, const PartingLine& other, double within,
                                       double diagonal) {
  const double step = std::max(k_step_share * diagonal, within);
  const NearestSegment near(other, 4.0 * step, diagonal);
  std::vector<LineStretch> stretches;
  for (const PartingLoop& loop : line.loops) {
    if (!parts_halves(loop)) continue;
    std::vector<LineStretch> found;
    bool is_off = false, begins_off = false;
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      const glm::dvec3 &from = loop.points[k], &to = loop.points[(k + 1) % loop.points.size()];
      const double length = glm::distance(from, to);
      const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
      for (int i = 0; i < steps; ++i) {
        const glm::dvec3 at = glm::mix(from, to, (i + 0.5) / steps);
        const double off = near.distance(at);
        const bool was_off = std::exchange(is_off, off > within);
        if (k == 0 && i == 0) begins_off = is_off;
        if (!is_off) continue;
        if (!was_off) found.emplace_back();
        LineStretch& stretch = found.back();
        stretch.length += length / steps;
        if (off > stretch.farthest) {
          stretch.farthest = off;
          stretch.at = at;
        }
      }
    }
    // What runs through the loop's first point is one.
    if (is_off && begins_off && found.size() > 1) {
      LineStretch &first = found.front(), &last = found.back();
      first.length += last.length;
      if (last.farthest > first.farthest)
        std::tie(first.farthest, first.at) = std::tie(last.farthest, last.at);
      found.pop_back();
    }
    std::ranges::copy(found, std::back_inserter(stretches));
  }
  // Shorter ones are where the lines cross corners.
  std::erase_if(stretches, [&](const LineStretch& one) { return one.length <= 2.0 * within; });
  std::ranges::stable_sort(stretches, std::greater(), &LineStretch::length);
  return stretches;
}

}  // namespace

LineChange find_line_change(const PartingLine& a, const PartingLine& b, double within, double diagonal) {
  return {within, stretches_off(b, a, within, diagonal), stretches_off(a, b, within, diagonal)};
}

}  // namespace moldlight
