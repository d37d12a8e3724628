#include "parting/halves/shelf_field.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/exterior_product.hpp>

namespace moldlight {

namespace {

/// What is met but for this much, in diagonals of the part, is met: a line that is planar to this is planar.
constexpr double k_slack = 1e-4;
/// How far behind a segment a place may be by rounding.
constexpr double k_behind = 1e-9;
/// Segments of the outline that are looked at together, at most.
constexpr std::uint32_t k_together = 8;

/// A source's greatest height over a place, less the slope times the way beyond the land.
double reached(const Envelope::Source& source, const glm::dvec2& at, double slope) {
  const glm::dvec2 along = source.ends[1] - source.ends[0];
  const double length = glm::length(along);
  const auto from = [&](double share) {
    const double way = glm::distance(at, source.ends[0] + share * along);
    return glm::mix(source.heights[0], source.heights[1], share) - slope * std::max(0.0, way - source.land);
  };
  if (length <= 0.0) return from(0.0);
  const double beside = glm::dot(at - source.ends[0], along) / length;
  const double away = std::abs(glm::cross(along, at - source.ends[0])) / length;
  const double climb = (source.heights[1] - source.heights[0]) / length;
  // Uphill of the nearest point as long as the way grows less.
  double shift = 0.0;
  if (climb != 0.0 && std::abs(climb) < slope) {
    shift = away * std::abs(climb) / std::sqrt(slope * slope - climb * climb);
    if (away < source.land) shift = std::max(shift, std::sqrt(source.land * source.land - away * away));
  } else if (climb != 0.0) {
    shift = length + std::abs(beside);
  }
  return from(std::clamp((beside + (climb < 0.0 ? -shift : shift)) / length, 0.0, 1.0));
}

/// Steeper than this along the outline, a segment has no land: level across, its ends would stand out.
constexpr double k_most_land_climb = 0.1;

double land_of(const Envelope::Source& source, double land) {
  const double climb = std::abs(source.heights[1] - source.heights[0]) /
                       std::max(glm::distance(source.ends[0], source.ends[1]), 1e-300);
  return land * std::clamp(1.0 - climb / k_most_land_climb, 0.0, 1.0);
}

/// Corners of the sources, as high as the higher of the two that meet there, in front of either; where more
/// meet, everywhere.
std::vector<Envelope::Source> corners_of(const std::vector<Envelope::Source>& sources) {
  std::map<std::pair<double, double>, std::pair<Envelope::Source, int>> corners;
  for (const Envelope::Source& source : sources) {
    for (std::size_t end = 0; end < 2; ++end) {
      const glm::dvec2& at = source.ends[end];
      auto& [corner, count] = corners[{at.x, at.y}];
      if (count == 0) corner = {{at, at}, {-INFINITY, -INFINITY}, 0.0, {}};
      corner.heights[0] = corner.heights[1] = std::max(corner.heights[0], source.heights[end]);
      corner.land = std::max(corner.land, source.land);
      if (count < 2) corner.fronts[static_cast<std::size_t>(count)] = source.fronts[0];
      if (count >= 2) corner.fronts = {};
      ++count;
    }
  }
  std::vector<Envelope::Source> found;
  for (auto& [place, entry] : corners) {
    if (entry.second == 1) entry.first.fronts[1] = entry.first.fronts[0];
    found.push_back(entry.first);
  }
  return found;
}

/// Lengths by height: how much is at or below one.
class LengthsBelow {
 public:
  void add(double height, double length) { heights_.emplace_back(height, length); }
  void sort() {
    std::ranges::sort(heights_);
    double sum = 0.0;
    for (auto& [height, length] : heights_) length = sum += length;
  }
  [[nodiscard]] double at(double height) const {
    const auto next = std::ranges::upper_bound(heights_, height, {}, &std::pair<double, double>::first);
    return next == heights_.begin() ? 0.0 : std::prev(next)->second;
  }

 private:
  std::vector<std::pair<double, double>> heights_;
};

}  // namespace

bool ShelfPlane::meets(const std::vector<RimSegment>& rims, double slack) const {
  return std::ranges::all_of(rims, [&](const RimSegment& rim) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (!rim.ranges[k].takes(at(rim.ends[k]), slack)) return false;
    }
    return true;
  });
}

Envelope::Envelope(std::vector<Source> sources, double slope) : sources_(std::move(sources)), slope_(slope) {
  if (sources_.empty()) return;
  nodes_.push_back({.first = 0, .last = static_cast<std::uint32_t>(sources_.size())});
  split(0);
}

/// In halves along the longer side.
void Envelope::split(std::uint32_t number) {
  Node node = nodes_[number];
  glm::dvec2 low(INFINITY), high(-INFINITY);  // of the first ends
  for (std::uint32_t k = node.first; k < node.last; ++k) {
    const Source& source = sources_[k];
    node.land = std::max(node.land, source.land);
    low = glm::min(low, source.ends[0]);
    high = glm::max(high, source.ends[0]);
    for (std::size_t end = 0; end < 2; ++end) {
      node.low = glm::min(node.low, source.ends[end]);
      node.high = glm::max(node.high, source.ends[end]);
      node.most = std::max(node.most, source.heights[end]);
    }
  }
  if (node.last - node.first > k_together) {
    const int axis = high.x - low.x >= high.y - low.y ? 0 : 1;
    const auto begin = sources_.begin();
    const std::uint32_t middle = (node.first + node.last) / 2;
    std::ranges::stable_sort(begin + node.first, begin + node.last, {},
                             [&](const Source& source) { return source.ends[0][axis]; });
    node.parts = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.first = node.first, .last = middle});
    nodes_.push_back({.first = middle, .last = node.last});
    split(node.parts);
    split(node.parts + 1);
  }
  nodes_[number] = node;
}

double Envelope::bound(const Node& node, const glm::dvec2& place) const {
  const double way = glm::distance(place, glm::clamp(place, node.low, node.high));
  return node.most - slope_ * std::max(0.0, way - node.land);
}

void Envelope::raise(const Node& node, const glm::dvec2& place, double& most) const {
  if (node.parts > 0) {
    const std::array<const Node*, 2> parts = {&nodes_[node.parts], &nodes_[node.parts + 1]};
    const std::array<double, 2> bounds = {bound(*parts[0], place), bound(*parts[1], place)};
    const std::size_t higher = bounds[1] > bounds[0] ? 1 : 0;
    for (const std::size_t k : {higher, 1 - higher})
      if (bounds[k] > most) raise(*parts[k], place, most);
    return;
  }
  for (std::uint32_t k = node.first; k < node.last; ++k) {
    const Source& source = sources_[k];
    const glm::dvec2 away = place - source.ends[0];
    if (std::max(glm::cross(source.fronts[0], away), glm::cross(source.fronts[1], away)) >= -k_behind)
      most = std::max(most, reached(source, place, slope_));
  }
}

double Envelope::at(const glm::dvec2& place, double least) const {
  if (!nodes_.empty() && bound(nodes_.front(), place) > least) raise(nodes_.front(), place, least);
  return least;
}

ShelfField::ShelfField(const std::vector<RimSegment>& rims, const ShelfPlane& shelf, const ShelfShape& shape)
    : shelf_(shelf), shape_(shape), plane_(shelf.meets(rims, k_slack)) {
  if (plane_) return;
  up_ = side_of(rims, 1.0);
  down_ = side_of(rims, -1.0);
}

ShelfField::ShelfField(const std::vector<RimSegment>& rims, StepProfile steps, const ShelfShape& shape)
    : shelf_{.height = steps.base()}, shape_(shape), steps_(std::move(steps)) {
  up_ = side_of(rims, 1.0);
  down_ = side_of(rims, -1.0);
}

ShelfField::Side ShelfField::side_of(const std::vector<RimSegment>& rims, double sign) const {
  // Heights above the shelf: the least at which each end may be met, and the most.
  const auto above = [&](const RimSegment& rim, std::size_t end, bool least) {
    const HeightRange& range = rim.ranges[end];
    const double z = (sign > 0.0) == least ? range.low : range.high;
    return sign * (z - ground(rim.ends[end]));
  };
  double most = 0.0;
  for (const RimSegment& rim : rims) most = std::max({most, above(rim, 0, true), above(rim, 1, true)});
  std::vector<Envelope::Source> pull, hold;
  for (const RimSegment& rim : rims) {
    const glm::dvec2 along = (rim.ends[1] - rim.ends[0]) / std::max(rim.length(), 1e-300);
    Envelope::Source low{rim.ends, {above(rim, 0, true), above(rim, 1, true)}, 0.0, {along, along}},
        high{rim.ends, {-above(rim, 0, false), -above(rim, 1, false)}, 0.0, {along, along}};
    low.land = land_of(low, shape_.land);
    pull.push_back(low);
    hold.push_back(high);
  }
  const auto matter = [](std::vector<Envelope::Source> sources, double least) {
    const std::vector<Envelope::Source> corners = corners_of(sources);
    sources.insert(sources.end(), corners.begin(), corners.end());
    std::erase_if(sources, [&](const Envelope::Source& source) {
      return std::max(source.heights[0], source.heights[1]) <= least;
    });
    return sources;
  };
  return {Envelope(matter(std::move(pull), k_slack), shape_.ramp),
          Envelope(matter(std::move(hold), -most), shape_.slope)};
}

/// How far the surface is beyond the shelf.
double ShelfField::rise(const Side& side, const glm::dvec2& place, double sign) const {
  const double pulled = side.pull.at(place, 0.0);
  return pulled > 0.0 ? sign * std::max(0.0, -side.hold.at(place, -pulled)) : 0.0;
}

double ShelfField::at(const glm::dvec2& place) const {
  if (plane_) return shelf_.at(place);
  return ground(place) + rise(up_, place, 1.0) + rise(down_, place, -1.0);
}

double shelf_level(const std::vector<RimSegment>& rims, const std::vector<double>& line, double wish) {
  double total = 0.0;
  LengthsBelow of_line;
  std::vector<double> candidates = {wish};
  for (std::size_t k = 0; k < rims.size(); ++k) {
    total += rims[k].length();
    for (const HeightRange& range : rims[k].ranges) {
      candidates.push_back(range.low);
      candidates.push_back(range.high);
    }
    if (!std::isfinite(line[k])) continue;
    of_line.add(line[k], rims[k].length());
    candidates.push_back(line[k]);
  }
  of_line.sort();
  std::ranges::sort(candidates);
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  constexpr double k_exact = 1e-6, k_band = 2e-3, k_too_little = 0.05, k_near_best = 0.02;
  double level = wish;
  for (const double slack : {k_exact, k_slack, k_band}) {
    LengthsBelow begin, end;
    for (const RimSegment& rim : rims) {
      const auto& [a, b] = rim.ranges;
      const double low = std::max(a.low, b.low) - slack, high = std::min(a.high, b.high) + slack;
      if (low > high) continue;
      begin.add(low, rim.length());
      end.add(std::nextafter(high, INFINITY), rim.length());
    }
    begin.sort();
    end.sort();
    const auto met = [&](double z) { return begin.at(z) - end.at(z); };
    double best = 0.0;
    for (const double z : candidates) best = std::max(best, met(z));
    const double enough = best >= (1.0 - 1e-9) * total ? (1.0 - 1e-9) * total : best - k_near_best * total;
    double most_line = -INFINITY;
    for (const double z : candidates) {
      if (met(z) < enough) continue;
      const double runs = of_line.at(z + k_band) - of_line.at(z - k_band);
      if (runs < most_line - 1e-9 * total) continue;
      if (runs <= most_line + 1e-9 * total && std::abs(z - wish) >= std::abs(level - wish)) continue;
      most_line = std::max(runs, most_line);
      level = z;
    }
    // All of it, or else as much as the next slack leaves.
    if (best >= (1.0 - 1e-9) * total || (slack == k_slack && best >= k_too_little * total)) break;
  }
  return level;
}

ShelfPlane fitted_plane(const std::vector<RimSegment>& rims) {
  // Least squares about the middle.
  glm::dvec2 centre(0.0);
  double weight = 0.0, height = 0.0;
  const auto for_each_end = [&](const auto& visit) {
    for (const RimSegment& rim : rims) {
      for (std::size_t k = 0; k < 2; ++k) visit(rim.ends[k], rim.ranges[k].middle(), rim.length());
    }
  };
  for_each_end([&](const glm::dvec2& at, double z, double length) {
    centre += length * at;
    height += length * z;
    weight += length;
  });
  if (weight <= 0.0) return {};
  centre /= weight;
  height /= weight;
  double xx = 0.0, xy = 0.0, yy = 0.0, xz = 0.0, yz = 0.0;
  for_each_end([&](const glm::dvec2& at, double z, double length) {
    const glm::dvec2 away = at - centre;
    xx += length * away.x * away.x;
    xy += length * away.x * away.y;
    yy += length * away.y * away.y;
    xz += length * away.x * (z - height);
    yz += length * away.y * (z - height);
  });
  const double determinant = xx * yy - xy * xy;
  ShelfPlane plane{.height = height};
  if (determinant > 1e-12 * (xx + yy) * (xx + yy))
    plane.tilt = {(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant};
  plane.height = height - glm::dot(plane.tilt, centre);
  return plane;
}

LevelOutside level_outside(const std::vector<RimSegment>& rims, const ShelfField& field) {
  LevelOutside outside;
  if (field.steps()) {
    for (const glm::dvec2& corner : field.steps()->level_corners()) {
      outside.low = glm::min(outside.low, corner);
      outside.high = glm::max(outside.high, corner);
    }
    return outside;
  }
  const double shelf = field.shelf().height;
  const ShelfShape& shape = field.shape();
  for (const RimSegment& rim : rims) {
    for (std::size_t k = 0; k < 2; ++k) {
      const double climb = std::max(rim.ranges[k].low - shelf, shelf - rim.ranges[k].high);
      const double reach = climb > k_slack ? shape.land + climb / shape.ramp : 0.0;
      outside.low = glm::min(outside.low, rim.ends[k] - reach);
      outside.high = glm::max(outside.high, rim.ends[k] + reach);
    }
  }
  return outside;
}

}  // namespace moldlight
