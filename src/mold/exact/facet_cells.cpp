#include "mold/exact/facet_cells.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

// Unit frame. Points nearer to a line than the first lie on it: a few hundred roundings of a coordinate in
// double, so that borders that are one in the part do not cut slivers. Segments shorter than the second cut
// nothing that has an area.
constexpr double k_on_line = 1e-13;
constexpr double k_shortest = 1e-10;
/// Cells with more segments are halved first: cutting along the longest takes the square of their number.
constexpr std::size_t k_most_segments = 24;
constexpr double k_least_half = 1e-3;  // of the cell's extent

double height(const glm::dvec2& point, const glm::dvec2& origin, const glm::dvec2& normal) {
  return glm::dot(normal, point - origin);
}

}  // namespace

void FacetCells::begin(const std::array<glm::dvec2, 3>& corners) {
  points_.assign(corners.begin(), corners.end());
  point_sides_.assign(3, 3);
  edges_.clear();
  for (std::uint32_t k = 0; k < 3; ++k) edges_.push_back({k, (k + 1) % 3, k_none, k});
  next_line_ = 3;
  areas_ = {};
  squared_doubt_ = 0.0;
  kept_.clear();
  kept_uses_.clear();
  cells_.clear();
  outlines_.clear();
}

void FacetCells::keep_whole(Region region, double area) {
  areas_ = {};
  squared_doubt_ = 0.0;
  areas_[static_cast<std::size_t>(region)] = area;
  cells_.assign(1, {.region = region, .begin = 0, .end = 0});
}

void FacetCells::append_leaves(const Use& use, std::vector<Use>& out) const {
  const std::uint32_t child = edges_[use.edge].first_child;
  if (child == k_none) {
    out.push_back(use);
    return;
  }
  append_leaves({child + (use.reversed ? 1U : 0U), use.reversed}, out);
  append_leaves({child + (use.reversed ? 0U : 1U), use.reversed}, out);
}

FacetCells::Line FacetCells::choose_line(const std::vector<Use>& outline,
                                         const std::vector<CutSegment>& segments, bool halve) const {
  const auto squared = [](const CutSegment& s) { return glm::dot(s.end - s.start, s.end - s.start); };
  const CutSegment* chosen =
      &*std::max_element(segments.begin(), segments.end(),
                         [&](const CutSegment& a, const CutSegment& b) { return squared(a) < squared(b); });
  if (squared(*chosen) < k_shortest * k_shortest) return {};
  if (halve && segments.size() > k_most_segments) {
    glm::dvec2 low(1e300), high(-1e300);
    for (const Use& use : outline) {
      const glm::dvec2& point = points_[start_of(use)];
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    const int longer = high.x - low.x >= high.y - low.y ? 0 : 1;
    for (const int axis : {longer, 1 - longer}) {
      std::vector<double> middles;
      middles.reserve(segments.size());
      for (const CutSegment& s : segments) middles.push_back(0.5 * (s.start[axis] + s.end[axis]));
      const auto median = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
      std::nth_element(middles.begin(), median, middles.end());
      const auto crossing = std::count_if(segments.begin(), segments.end(), [&](const CutSegment& s) {
        return (s.start[axis] < *median) != (s.end[axis] < *median);
      });
      const double room = k_least_half * (high[axis] - low[axis]);
      if (3 * static_cast<std::size_t>(crossing) < segments.size() && *median > low[axis] + room &&
          *median < high[axis] - room) {
        Line line;
        line.origin[axis] = *median;
        line.normal[axis] = 1.0;
        return line;
      }
    }
    // Long ones side by side: the middle one.
    const glm::dvec2 along = chosen->end - chosen->start, normal(-along.y, along.x);
    std::vector<std::pair<double, std::size_t>> offsets;
    for (std::size_t k = 0; k < segments.size(); ++k) {
      if (squared(segments[k]) < 0.25 * squared(*chosen)) continue;
      offsets.emplace_back(glm::dot(normal, segments[k].start + segments[k].end), k);
    }
    const auto median = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), median, offsets.end());
    chosen = &segments[median->second];
  }
  const glm::dvec2 along = chosen->end - chosen->start;
  return {chosen->start, glm::dvec2(-along.y, along.x) / glm::length(along)};
}

void FacetCells::distribute(const std::vector<CutSegment>& segments, const Line& line,
                            std::vector<CutSegment>& left, std::vector<CutSegment>& right) {
  const auto add = [](std::vector<CutSegment>& to, const CutSegment& s) {
    const glm::dvec2 along = s.end - s.start;
    if (glm::dot(along, along) >= k_shortest * k_shortest) to.push_back(s);
  };
  for (const CutSegment& s : segments) {
    const double from = height(s.start, line.origin, line.normal),
                 to = height(s.end, line.origin, line.normal);
    const bool above = from > k_on_line || to > k_on_line, below = from < -k_on_line || to < -k_on_line;
    if (above && below) {
      const glm::dvec2 middle = s.start + (from / (from - to)) * (s.end - s.start);
      add(from > 0.0 ? left : right, {s.start, middle});
      add(from > 0.0 ? right : left, {middle, s.end});
    } else if (above) {
      add(left, s);
    } else if (below) {
      add(right, s);
    }
  }
}

std::uint32_t FacetCells::cut_edge(const Use& use, const glm::dvec2& at) {
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(at);
  const auto child = static_cast<std::uint32_t>(edges_.size());
  const Edge edge = edges_[use.edge];
  point_sides_.push_back(std::min(edge.line, 3U));
  edges_[use.edge].first_child = child;
  edges_.push_back({edge.from, point, k_none, edge.line});
  edges_.push_back({point, edge.to, k_none, edge.line});
  return point;
}

bool FacetCells::split(const std::vector<Use>& outline, const Line& line, std::vector<Use>& left,
                       std::vector<Use>& right) {
  std::vector<Use> leaves;
  leaves.reserve(outline.size() + 4);
  for (const Use& use : outline) append_leaves(use, leaves);
  const std::size_t count = leaves.size();
  heights_.clear();
  double highest = 0.0, lowest = 0.0;
  for (const Use& use : leaves) {
    double value = height(points_[start_of(use)], line.origin, line.normal);
    if (std::abs(value) <= k_on_line) value = 0.0;
    heights_.push_back(value);
    highest = std::max(highest, value);
    lowest = std::min(lowest, value);
  }
  if (highest <= 0.0 || lowest >= 0.0) return false;
  // Walks around: after a point above comes one below exactly once, and the other way round, points on the
  // line left aside; rounding may have bent the outline so that it is not so, and then it stays in one.
  struct Place {
    std::size_t use = 0;  // the cut lies on this use, or at its start
    bool at_start = false;
  };
  std::array<Place, 2> places{};  // from above to below, and back
  std::array<int, 2> found{};
  std::size_t first = 0;
  while (heights_[first] == 0.0) ++first;
  std::size_t last_sided = first;
  for (std::size_t step = 1; step <= count; ++step) {
    const std::size_t k = (first + step) % count;
    if (heights_[k] == 0.0) continue;
    if ((heights_[k] > 0.0) != (heights_[last_sided] > 0.0)) {
      const std::size_t turn = heights_[k] > 0.0 ? 1 : 0;
      const std::size_t next = (last_sided + 1) % count;
      places[turn] = next == k ? Place{last_sided, false} : Place{next, true};
      ++found[turn];
    }
    last_sided = k;
  }
  if (found[0] != 1 || found[1] != 1) return false;

  // New points first, so that the leaves of a cut use can be distinguished below.
  std::array<std::uint32_t, 2> ends{};
  for (std::size_t turn = 0; turn < 2; ++turn) {
    const Place& place = places[turn];
    const Use use = leaves[place.use];
    if (place.at_start) {
      ends[turn] = start_of(use);
      continue;
    }
    const std::size_t next = (place.use + 1) % count;
    const double from = heights_[place.use], to = heights_[next];
    const glm::dvec2& a = points_[start_of(use)];
    const glm::dvec2& b = points_[start_of(leaves[next])];
    ends[turn] = cut_edge(use, a + (from / (from - to)) * (b - a));
  }
  const auto cut = static_cast<std::uint32_t>(edges_.size());
  edges_.push_back({ends[0], ends[1], k_none, next_line_++});
  // Below: from the place where the walk leaves the upper side to where it comes back.
  const auto walk = [&](const Place& begin, const Place& end, std::vector<Use>& out) {
    const auto half = [&](const Place& place, bool second) {
      const Use use = leaves[place.use];
      const std::uint32_t child = edges_[use.edge].first_child;
      out.push_back({child + (use.reversed != second ? 1U : 0U), use.reversed});
    };
    std::size_t k = begin.use;
    if (!begin.at_start) {
      half(begin, true);
      k = (k + 1) % count;
    }
    for (; k != end.use; k = (k + 1) % count) out.push_back(leaves[k]);
    if (!end.at_start) half(end, false);
  };
  walk(places[0], places[1], right);
  right.push_back({cut, true});
  walk(places[1], places[0], left);
  left.push_back({cut, false});
  return true;
}

FacetCells::Shape FacetCells::shape_of(const std::vector<Use>& outline) const {
  const glm::dvec2& origin = points_[start_of(outline.front())];
  Shape shape;
  glm::dvec2 moment(0.0), mean(0.0);
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    const glm::dvec2 a = points_[start_of(outline[k])] - origin,
                     b = points_[start_of(outline[k + 1])] - origin;
    const double area = 0.5 * (a.x * b.y - a.y * b.x);
    shape.area += area;
    moment += (area / 3.0) * (a + b);
  }
  for (const Use& use : outline)
    mean += (points_[start_of(use)] - origin) / static_cast<double>(outline.size());
  // A sliver's moment is all rounding.
  shape.centroid = origin + (shape.area > k_shortest * k_shortest ? moment / shape.area : mean);
  return shape;
}

glm::dvec2 FacetCells::random_point(const std::vector<Use>& outline) {
  const auto next = [&] {  // in [0, 1): splitmix64 (Steele et al. 2014)
    std::uint64_t z = random_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  };
  double left = next() * shape_of(outline).area;
  const glm::dvec2& origin = points_[start_of(outline.front())];
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    const glm::dvec2 a = points_[start_of(outline[k])] - origin,
                     b = points_[start_of(outline[k + 1])] - origin;
    const double area = 0.5 * (a.x * b.y - a.y * b.x);
    left -= area;
    if (left > 0.0 && k + 2 < outline.size()) continue;
    const double root = std::sqrt(next()), share = next();
    return origin + root * ((1.0 - share) * a + share * b);
  }
  return origin;
}

void FacetCells::keep(const std::vector<Use>& outline, Region region) {
  const auto begin = static_cast<std::uint32_t>(kept_uses_.size());
  kept_uses_.insert(kept_uses_.end(), outline.begin(), outline.end());
  kept_.push_back({region, begin, static_cast<std::uint32_t>(kept_uses_.size())});
}

void FacetCells::make_outlines() {
  const auto line_of = [&](const Use& use) { return edges_[use.edge].line; };
  is_corner_.assign(points_.size(), 0);
  is_corner_[0] = is_corner_[1] = is_corner_[2] = 1;
  for (const Kept& kept : kept_) {
    for (std::uint32_t k = kept.begin; k < kept.end; ++k) {
      const Use& before = kept_uses_[k == kept.begin ? kept.end - 1 : k - 1];
      if (line_of(before) != line_of(kept_uses_[k])) is_corner_[start_of(kept_uses_[k])] = 1;
    }
  }
  std::vector<Use> leaves;
  for (const Kept& kept : kept_) {
    leaves.clear();
    for (std::uint32_t k = kept.begin; k < kept.end; ++k) append_leaves(kept_uses_[k], leaves);
    const auto first = static_cast<std::uint32_t>(outlines_.size());
    for (const Use& use : leaves) {
      if (is_corner_[start_of(use)] != 0) outlines_.push_back(start_of(use));
    }
    cells_.push_back({kept.region, first, static_cast<std::uint32_t>(outlines_.size())});
  }
}

}  // namespace moldlight
