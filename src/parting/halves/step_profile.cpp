#include "parting/halves/step_profile.hpp"

#include <algorithm>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// The part of a line within a rectangle.
std::optional<std::array<glm::dvec2, 2>> clipped(glm::dvec2 a, glm::dvec2 b, const glm::dvec2& low,
                                                 const glm::dvec2& high) {
  double from = 0.0, to = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    if (way == 0.0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double enter = ((way > 0.0 ? low[axis] : high[axis]) - a[axis]) / way,
                 leave = ((way > 0.0 ? high[axis] : low[axis]) - a[axis]) / way;
    from = std::max(from, enter);
    to = std::min(to, leave);
  }
  if (from >= to) return std::nullopt;
  return std::array{glm::clamp(glm::mix(a, b, from), low, high), glm::clamp(glm::mix(a, b, to), low, high)};
}

double height_at(const StepProfile::Knots& knots, double place) {
  if (place <= knots.front().place) return knots.front().height;
  if (place >= knots.back().place) return knots.back().height;
  const auto next = std::ranges::upper_bound(knots, place, {}, &StepProfile::Knot::place);
  const StepProfile::Knot &a = *std::prev(next), &b = *next;
  return glm::mix(a.height, b.height, (place - a.place) / (b.place - a.place));
}

}  // namespace

double StepProfile::rise() const {
  double low = INFINITY, high = -INFINITY;
  for (const Knots& knots : sides_.knots) {
    for (const Knot& knot : knots) {
      low = std::min(low, knot.height);
      high = std::max(high, knot.height);
    }
  }
  return high - low;
}

double StepProfile::at(const glm::dvec2& place) const {
  const glm::dvec2 at = of_plane(place);
  const double above = height_at(sides_.knots[at.x > sides_.parted_at ? 1 : 0], at.y) - base_;
  if (!levels_) return base_ + above;
  const glm::dvec2 away = glm::max(low_ - at, at - high_);
  const double most = std::max(0.0, most_[above > 0.0 ? 0 : 1] - ramp_ * std::max({0.0, away.x, away.y}));
  return base_ + std::clamp(above, -most, most);
}

void StepProfile::level_around(const std::vector<RimSegment>& rims, const ShelfShape& shape) {
  low_ = glm::dvec2(INFINITY);
  high_ = glm::dvec2(-INFINITY);
  for (const RimSegment& rim : rims) {
    for (const glm::dvec2& end : rim.ends) {
      low_ = glm::min(low_, of_plane(end));
      high_ = glm::max(high_, of_plane(end));
    }
  }
  // What lies before and behind the part counts as much as its margin is wide.
  constexpr double k_margin_around = 0.15;
  std::map<double, double> widths;
  for (const Knots& knots : sides_.knots) {
    if (knots.empty()) continue;
    widths[knots.front().height] += knots.front().place - low_.y + k_margin_around;
    widths[knots.back().height] += high_.y - knots.back().place + k_margin_around;
    for (std::size_t k = 1; k < knots.size(); ++k) {
      if (knots[k].height == knots[k - 1].height)
        widths[knots[k].height] += knots[k].place - knots[k - 1].place;
    }
  }
  base_ = std::ranges::max_element(widths, {}, [](const auto& entry) { return entry.second; })->first;
  low_ -= shape.land;
  high_ += shape.land;
  ramp_ = shape.ramp;
  levels_ = true;
  for (Knots& knots : sides_.knots) {
    // Between two knots the height stays on one side of the base.
    Knots divided;
    for (const Knot& knot : knots) {
      const double above = knot.height - base_;
      const double before = divided.empty() ? 0.0 : divided.back().height - base_;
      if (before * above < 0.0)
        divided.push_back({glm::mix(divided.back().place, knot.place, before / (before - above)), base_});
      divided.push_back(knot);
      most_[0] = std::max(most_[0], above);
      most_[1] = std::max(most_[1], -above);
    }
    knots = std::move(divided);
  }
}

double StepProfile::left_at(double above) const {
  return (most_[above > 0.0 ? 0 : 1] - std::abs(above)) / ramp_;
}

std::vector<glm::dvec2> StepProfile::level_corners() const {
  if (!levels_) return {};
  const double out = std::max(most_[0], most_[1]) / ramp_;
  const glm::dvec2 low = low_ - out, high = high_ + out;
  return {in_plane(low), in_plane({high.x, low.y}), in_plane(high), in_plane({low.x, high.y})};
}

/// Of the level before the first knot, or behind the last one: it is left beyond the rectangle's edge.
std::vector<StepProfile::Line> StepProfile::creases_before(const Knot& knot, double edge, double way) const {
  const double above = knot.height - base_;
  if (above == 0.0) return {};
  const double left = left_at(above), out = most_[above > 0.0 ? 0 : 1] / ramp_;
  const glm::dvec2 inner(low_.x - left, high_.x + left), outer(low_.x - out, high_.x + out);
  const double inner_edge = edge + way * left, outer_edge = edge + way * out;
  std::vector<Line> lines = {{{{inner[0], inner_edge}, {inner[1], inner_edge}}},
                             {{{outer[0], outer_edge}, {outer[1], outer_edge}}}};
  for (const int side : {0, 1}) {
    lines.push_back({{{inner[side], knot.place}, {inner[side], inner_edge}}});
    lines.push_back({{{outer[side], knot.place}, {outer[side], outer_edge}}});
    lines.push_back({{{inner[side], inner_edge}, {outer[side], outer_edge}}});
  }
  return lines;
}

std::vector<StepProfile::Line> StepProfile::creases_of(const Knots& knots) const {
  std::vector<Line> lines = creases_before(knots.front(), low_.y, -1.0);
  const std::vector<Line> behind = creases_before(knots.back(), high_.y, 1.0);
  lines.insert(lines.end(), behind.begin(), behind.end());
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const Knot &from = knots[k - 1], &to = knots[k];
    const std::array<double, 2> above = {from.height - base_, to.height - base_};
    const double sign = above[0] + above[1];
    if (sign == 0.0) continue;
    const double out = most_[sign > 0.0 ? 0 : 1] / ramp_;
    const double first = above[0] == 0.0 ? out : left_at(above[0]),
                 last = above[1] == 0.0 ? out : left_at(above[1]);
    lines.push_back({{{low_.x - first, from.place}, {low_.x - last, to.place}}});
    lines.push_back({{{high_.x + first, from.place}, {high_.x + last, to.place}}});
    lines.push_back({{{low_.x - out, from.place}, {low_.x - out, to.place}}});
    lines.push_back({{{high_.x + out, from.place}, {high_.x + out, to.place}}});
    lines.push_back({{{low_.x - first, from.place}, {high_.x + first, from.place}}});
    lines.push_back({{{low_.x - last, to.place}, {high_.x + last, to.place}}});
  }
  return lines;
}

std::vector<std::array<glm::dvec2, 2>> StepProfile::creases(const glm::dvec2& low,
                                                            const glm::dvec2& high) const {
  const double far = glm::distance(low, high) + glm::length(low) + glm::length(high);
  std::vector<std::array<glm::dvec2, 2>> found;
  for (const std::size_t side : {0, 1}) {
    const Knots& knots = sides_.knots[side];
    if (knots.empty()) continue;
    std::vector<Line> lines;
    if (levels_) {
      lines = creases_of(knots);
    } else {
      for (const Knot& knot : knots) lines.push_back({{{-far, knot.place}, {far, knot.place}}});
    }
    const glm::dvec2 from(side == 1 ? sides_.parted_at : -INFINITY, -INFINITY),
        to(side == 0 ? sides_.parted_at : INFINITY, INFINITY);
    for (const Line& line : lines) {
      const auto its = clipped(line[0], line[1], from, to);
      if (!its) continue;
      const auto within = clipped(in_plane((*its)[0]), in_plane((*its)[1]), low, high);
      if (within) found.push_back(*within);
    }
  }
  return found;
}

double StepProfile::missed_share(const std::vector<RimSegment>& rims) const {
  double missed = 0.0, all = 0.0;
  for (const RimSegment& rim : rims) {
    all += rim.length();
    for (const std::size_t k : {0, 1}) {
      if (!rim.ranges[k].takes(at(rim.ends[k]), k_step_slack)) missed += 0.5 * rim.length();
    }
  }
  return all > 0.0 ? missed / all : 0.0;
}

}  // namespace moldlight
