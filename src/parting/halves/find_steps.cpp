#include "parting/halves/find_steps.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

/// Places nearer to each other than this, in diagonals of the part, are one.
constexpr double k_same_place = 1e-7;
constexpr std::size_t k_most_rims = 2000;
/// As much as this share of the outline that is missed.
constexpr double k_bend_cost = 0.01, k_most_missed = 0.05;
/// Of the height between the levels of the outline.
constexpr double k_most_rise = 1.2;
/// Of the slope that is allowed, so that none has to be brought down.
constexpr double k_of_slope = 0.99;
constexpr std::size_t k_most_knots = 8;
constexpr std::size_t k_directions = 4;   // of the outline that are tried, and those square to them
constexpr int k_partings = 8;             // places across the part at which a profile is parted
constexpr double k_least_stretch = 0.02;  // of the outline, in one direction

/// What heights the outline leaves at one place along the direction.
struct Station {
  double place = 0.0;
  HeightRange range;

  [[nodiscard]] bool takes(double z) const { return range.takes(z, k_step_slack); }
};

double between(double a, double b, double share) {
  if (share <= 0.0) return a;
  if (share >= 1.0) return b;
  return std::isfinite(a) && std::isfinite(b) ? glm::mix(a, b, share) : std::isfinite(a) ? b : a;
}

std::vector<Station> stations_along(const std::vector<RimSegment>& rims, const glm::dvec2& along) {
  std::vector<double> places;
  for (const RimSegment& rim : rims) {
    for (const glm::dvec2& end : rim.ends) places.push_back(glm::dot(along, end));
  }
  std::ranges::sort(places);
  std::vector<Station> stations;
  for (const double place : places) {
    if (stations.empty() || place > stations.back().place + k_same_place) stations.push_back({place, {}});
  }
  for (const RimSegment& rim : rims) {
    const std::array<double, 2> at = {glm::dot(along, rim.ends[0]), glm::dot(along, rim.ends[1])};
    const auto [low, high] = std::minmax(at[0], at[1]);
    auto station = std::ranges::lower_bound(stations, low - k_same_place, {}, &Station::place);
    for (; station != stations.end() && station->place <= high + k_same_place; ++station) {
      const bool across = high - low <= 2.0 * k_same_place;
      const double share = across ? 0.0 : (station->place - at[0]) / (at[1] - at[0]);
      HeightRange range{between(rim.ranges[0].low, rim.ranges[1].low, share),
                        between(rim.ranges[0].high, rim.ranges[1].high, share)};
      if (across) {
        range.low = std::max(rim.ranges[0].low, rim.ranges[1].low);
        range.high = std::min(rim.ranges[0].high, rim.ranges[1].high);
      }
      station->range.low = std::max(station->range.low, range.low);
      station->range.high = std::min(station->range.high, range.high);
    }
  }
  // What walls on both sides of the part ask for cannot be met by either.
  for (Station& station : stations) {
    if (station.range.low > station.range.high + 2.0 * k_step_slack) station.range = {};
  }
  return stations;
}

/// What of the outline lies on one side of a line along the direction, `sign` across it from `parted_at`.
std::vector<RimSegment> on_side(const std::vector<RimSegment>& rims, const glm::dvec2& square,
                                double parted_at, double sign) {
  std::vector<RimSegment> kept;
  for (RimSegment rim : rims) {
    const std::array<double, 2> beyond = {sign * (glm::dot(square, rim.ends[0]) - parted_at),
                                          sign * (glm::dot(square, rim.ends[1]) - parted_at)};
    if (beyond[0] <= 0.0 && beyond[1] <= 0.0) continue;
    for (const std::size_t k : {0, 1}) {
      if (beyond[k] >= 0.0) continue;
      const double share = beyond[k] / (beyond[k] - beyond[1 - k]);
      const HeightRange here = rim.ranges[k], there = rim.ranges[1 - k];
      rim.ends[k] = glm::mix(rim.ends[k], rim.ends[1 - k], share);
      rim.ranges[k] = {between(here.low, there.low, share), between(here.high, there.high, share)};
    }
    kept.push_back(rim);
  }
  return kept;
}

/// Places along the direction at which the outline crosses a line in it.
std::vector<double> crossings_at(const std::vector<RimSegment>& rims, const glm::dvec2& along,
                                 double parted_at) {
  const glm::dvec2 square(along.y, -along.x);
  std::vector<double> places;
  for (const RimSegment& rim : rims) {
    const double a = glm::dot(square, rim.ends[0]) - parted_at, b = glm::dot(square, rim.ends[1]) - parted_at;
    if ((a <= 0.0) == (b <= 0.0)) continue;
    places.push_back(glm::dot(along, glm::mix(rim.ends[0], rim.ends[1], a / (a - b))));
  }
  std::ranges::sort(places);
  return places;
}

/// A stretch of stations that one straight line meets.
struct Run {
  std::size_t first = 0, last = 0;
  double height = 0.0, tilt = 0.0;  // at place 0

  [[nodiscard]] double at(double place) const { return height + tilt * place; }
};

/// The longest at one height; the one that is nearest to `wish`.
Run level_run(const std::vector<Station>& stations, std::size_t first, double wish) {
  HeightRange range;
  Run run{.first = first, .last = first};
  for (std::size_t k = first; k < stations.size(); ++k) {
    const HeightRange both{std::max(range.low, stations[k].range.low),
                           std::min(range.high, stations[k].range.high)};
    if (both.low > both.high + 2.0 * k_step_slack) break;
    range = both;
    run.last = k;
  }
  run.height = range.empty() ? range.middle() : std::clamp(wish, range.low, range.high);
  return run;
}

/// The longest on an inclined line, no steeper than `ramp`: what lines are left is a polygon of heights and
/// tilts.
Run inclined_run(const std::vector<Station>& stations, std::size_t first, double ramp) {
  const double from = stations[first].place;
  constexpr double k_far = 4.0;  // diagonals
  std::vector<glm::dvec2> lines = {{-k_far, -ramp}, {k_far, -ramp}, {k_far, ramp}, {-k_far, ramp}};
  const auto cut = [&](double place, double limit, double sign) {
    const auto beyond = [&](const glm::dvec2& line) {
      return sign * (line.x + line.y * (place - from) - limit) - k_step_slack;
    };
    std::vector<glm::dvec2> kept;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const glm::dvec2 &a = lines[k], &b = lines[(k + 1) % lines.size()];
      const double at_a = beyond(a), at_b = beyond(b);
      if (at_a <= 0.0) kept.push_back(a);
      if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0))
        kept.push_back(glm::mix(a, b, at_a / (at_a - at_b)));
    }
    return kept;
  };
  Run run{.first = first, .last = first};
  for (std::size_t k = first; k < stations.size(); ++k) {
    const std::vector<glm::dvec2> before = lines;
    if (std::isfinite(stations[k].range.low)) lines = cut(stations[k].place, stations[k].range.low, -1.0);
    if (std::isfinite(stations[k].range.high) && !lines.empty())
      lines = cut(stations[k].place, stations[k].range.high, 1.0);
    if (lines.empty()) {
      lines = before;
      break;
    }
    run.last = k;
  }
  glm::dvec2 middle(0.0);
  for (const glm::dvec2& line : lines) middle += line / static_cast<double>(lines.size());
  run.tilt = middle.y;
  run.height = middle.x - middle.y * from;
  return run;
}

/// Knots of a profile over the runs, where the ramps between them may stand; none where they are too steep.
StepProfile::Knots knots_of(const std::vector<Station>& stations, const std::vector<Run>& runs,
                            const ShelfShape& shape) {
  StepProfile::Knots knots;
  const Run& front = runs.front();
  if (front.tilt != 0.0) knots.push_back({stations.front().place, front.at(stations.front().place)});
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
    const Run &a = runs[k], &b = runs[k + 1];
    std::size_t begin = b.first, end = a.last;
    while (begin > a.first && stations[begin - 1].takes(b.at(stations[begin - 1].place))) --begin;
    while (end < b.last && stations[end + 1].takes(a.at(stations[end + 1].place))) ++end;
    double from = std::min(stations[begin].place, stations[end].place),
           to = std::max(stations[begin].place, stations[end].place);
    if (!knots.empty()) from = std::max(from, knots.back().place);
    if (to <= from) return {};
    const double wide = std::abs(b.at(0.5 * (from + to)) - a.at(0.5 * (from + to))) / shape.ramp;
    if (wide < to - from) {
      const double middle = 0.5 * (from + to);
      from = middle - 0.5 * wide;
      to = middle + 0.5 * wide;
    }
    knots.push_back({from, a.at(from)});
    knots.push_back({to, b.at(to)});
    if (std::abs(knots.back().height - a.at(from)) > k_of_slope * shape.slope * (to - from)) return {};
  }
  const Run& back = runs.back();
  if (back.tilt != 0.0) knots.push_back({stations.back().place, back.at(stations.back().place)});
  return knots;
}

/// Level and inclined runs by turns, all ways that are worth it, and the fewest knots of them.
class RunSearch {
 public:
  RunSearch(const std::vector<Station>& stations, double wish, const ShelfShape& shape)
      : stations_(stations), wish_(wish), shape_(shape) {}

  /// None where no few planes do.
  StepProfile::Knots fewest() {
    go_on(0);
    return std::move(best_);
  }

 private:
  static constexpr std::size_t k_most_runs = 5;

  void go_on(std::size_t first) {
    if (first == stations_.size()) {
      StepProfile::Knots knots = knots_of(stations_, runs_, shape_);
      if (knots.size() >= 2 && (best_.empty() || knots.size() < best_.size())) best_ = std::move(knots);
      return;
    }
    if (runs_.size() == k_most_runs) return;
    const Run level = level_run(stations_, first, wish_);
    take(level);
    if (level.last + 1 == stations_.size()) return;
    const Run inclined = inclined_run(stations_, first, k_of_slope * shape_.slope);
    if (inclined.last > level.last) take(inclined);
  }

  void take(const Run& run) {
    runs_.push_back(run);
    go_on(run.last + 1);
    runs_.pop_back();
  }

  const std::vector<Station>& stations_;
  double wish_;
  const ShelfShape& shape_;
  std::vector<Run> runs_;
  StepProfile::Knots best_;
};

/// A line's direction, of both the one that does not depend on where it began.
glm::dvec2 forward(const glm::dvec2& along) {
  return along.y < 0.0 || (along.y == 0.0 && along.x < 0.0) ? -along : along;
}

/// Directions of the longest straight stretches of the outline, and those square to them.
std::vector<glm::dvec2> directions_of(const std::vector<RimSegment>& rims) {
  constexpr double k_step_deg = 0.1, k_quarter_deg = 90.0;
  std::map<int, std::pair<double, glm::dvec2>> stretches;  // by angle
  double total = 0.0;
  for (const RimSegment& rim : rims) {
    const double length = rim.length();
    if (length <= 0.0) continue;
    total += length;
    const glm::dvec2 along = (rim.ends[1] - rim.ends[0]) / length;
    double angle_deg = std::fmod(glm::degrees(std::atan2(along.y, along.x)) + 360.0, k_quarter_deg);
    if (angle_deg > k_quarter_deg - 0.5 * k_step_deg) angle_deg -= k_quarter_deg;
    auto& [sum, longest] = stretches[static_cast<int>(std::lround(angle_deg / k_step_deg))];
    sum += length;
    // Of equal ones the same, whatever their order.
    const glm::dvec2 stretch = length * forward(along);
    const double of_longest = glm::length(longest);
    if (length > of_longest ||
        (length == of_longest && std::pair(stretch.x, stretch.y) < std::pair(longest.x, longest.y)))
      longest = stretch;
  }
  std::vector<std::pair<double, glm::dvec2>> found;
  for (const auto& [angle, stretch] : stretches) found.push_back(stretch);
  std::ranges::stable_sort(found, std::greater(), &std::pair<double, glm::dvec2>::first);
  std::vector<glm::dvec2> directions;
  for (const auto& [length, stretch] : found) {
    if (directions.size() >= 2 * k_directions || length < k_least_stretch * total) break;
    glm::dvec2 along = glm::normalize(stretch);
    // Upright and level ones are that to the last digit.
    for (int axis = 0; axis < 2; ++axis) {
      if (std::abs(along[axis]) < 1e-9) along = glm::dvec2(axis == 1 ? 1.0 : 0.0, axis == 1 ? 0.0 : 1.0);
    }
    directions.push_back(forward(along));
    directions.push_back(forward({-along.y, along.x}));
  }
  return directions;
}

/// The level that most stations up to a place, or from it on, leave.
double level_beyond(const std::vector<Station>& stations, double place, bool before, double wish) {
  std::vector<HeightRange> ranges;
  std::vector<double> candidates = {wish};
  for (const Station& station : stations) {
    if (before ? station.place > place + k_same_place : station.place < place - k_same_place) continue;
    ranges.push_back(station.range);
    for (const double z : {station.range.low, station.range.high}) {
      if (std::isfinite(z)) candidates.push_back(z);
    }
  }
  double level = wish;
  std::ptrdiff_t most = -1;
  for (const double z : candidates) {
    const auto met =
        std::ranges::count_if(ranges, [&](const HeightRange& range) { return range.takes(z, k_step_slack); });
    if (met < most || (met == most && std::abs(z - wish) >= std::abs(level - wish))) continue;
    most = met;
    level = z;
  }
  return level;
}

/// Heights that differ from side to side of a line through the part, and are level before and behind it.
std::optional<StepProfile::Sides> parted_sides(const std::vector<RimSegment>& rims,
                                               const std::vector<Station>& all, const glm::dvec2& along,
                                               double parted_at, double wish, const ShelfShape& shape) {
  const std::vector<double> crossings = crossings_at(rims, along, parted_at);
  if (crossings.size() != 2) return std::nullopt;
  std::array<double, 2> levels{};
  for (const std::size_t end : {0, 1}) levels[end] = level_beyond(all, crossings[end], end == 0, wish);
  StepProfile::Sides sides{.parted_at = parted_at, .knots = {}};
  for (const std::size_t side : {0, 1}) {
    std::vector<Station> stations =
        stations_along(on_side(rims, {along.y, -along.x}, parted_at, side == 0 ? -1.0 : 1.0), along);
    for (const std::size_t end : {0, 1}) {
      std::erase_if(stations, [&](const Station& one) {
        return end == 0 ? one.place <= crossings[0] + k_same_place : one.place >= crossings[1] - k_same_place;
      });
      const Station fixed{crossings[end], {levels[end], levels[end]}};
      stations.insert(end == 0 ? stations.begin() : stations.end(), fixed);
    }
    sides.knots[side] = RunSearch(stations, wish, shape).fewest();
    if (sides.knots[side].empty()) {
      // One level all along.
      if (std::abs(levels[1] - levels[0]) > k_step_slack) return std::nullopt;
      sides.knots[side] = {{crossings[0], levels[0]}, {crossings[1], levels[0]}};
    }
  }
  return sides;
}

}  // namespace

std::optional<StepProfile> find_steps(const std::vector<RimSegment>& rims, double wish,
                                      const ShelfShape& shape) {
  if (rims.empty() || rims.size() > k_most_rims) return std::nullopt;
  // Between the levels that no plane across can join.
  double asked_low = INFINITY, asked_high = -INFINITY;
  for (const RimSegment& rim : rims) {
    for (const HeightRange& range : rim.ranges) {
      asked_low = std::min(asked_low, range.high);
      asked_high = std::max(asked_high, range.low);
    }
  }
  const double asked = asked_high - asked_low;
  std::optional<StepProfile> best;
  double least = INFINITY;
  const auto offer = [&](const glm::dvec2& along, StepProfile::Sides sides) {
    StepProfile profile(along, std::move(sides));
    if (profile.bends() > k_most_knots || profile.rise() > k_most_rise * asked ||
        profile.missed_share(rims) > k_most_missed)
      return;
    const double cost = profile.missed_share(rims) + k_bend_cost * static_cast<double>(profile.bends());
    if (cost >= least) return;
    least = cost;
    best = std::move(profile);
  };
  for (const glm::dvec2& along : directions_of(rims)) {
    const std::vector<Station> stations = stations_along(rims, along);
    StepProfile::Knots knots = RunSearch(stations, wish, shape).fewest();
    if (!knots.empty()) offer(along, {.knots = {std::move(knots), {}}});
    if (best && least <= k_bend_cost * static_cast<double>(best->bends())) continue;
    const glm::dvec2 square(along.y, -along.x);
    double low = INFINITY, high = -INFINITY;
    for (const RimSegment& rim : rims) {
      low = std::min(low, glm::dot(square, rim.ends[0]));
      high = std::max(high, glm::dot(square, rim.ends[0]));
    }
    for (int k = 1; k < k_partings; ++k) {
      auto sides = parted_sides(rims, stations, along,
                                glm::mix(low, high, static_cast<double>(k) / k_partings), wish, shape);
      if (sides) offer(along, *std::move(sides));
    }
  }
  return best;
}

}  // namespace moldlight
