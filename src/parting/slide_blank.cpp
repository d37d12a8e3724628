#include "parting/slide_blank.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "parting/halves/depth_columns.hpp"

namespace moldlight {

namespace {

const double k_draft = std::tan(glm::radians(3.0));
/// The bottom lies so much within the shelf's plane, in diagonals, so that it does not lie in a face of the
/// part; the sheets make one height of both.
constexpr double k_off_shelf = 1e-8;
/// How deep in the part, in diagonals, the front of a blank is to be: the first of these that can be had.
constexpr double k_depths[] = {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4};
constexpr double k_clear = 1e-6;
constexpr double k_held = 1e-4;  // less of a way is touched, not blocked
/// So much do storeys overlap.
constexpr double k_overlap = 1.1e-3;
constexpr std::size_t k_of_ranges = 11;  // one in so many, across the rows of the section's lines
constexpr std::size_t k_section_lines = 64, k_most_steps = 1500, k_exit_lines = 150;

/// Between what heights along the way the blank has to begin at a place of its section.
struct FrontRange {
  glm::dvec2 at{0.0};
  double low = -INFINITY, high = INFINITY;
};

/// Strips beside each other, each a plane: heights along the way at even places across it, and how they
/// change upward.
struct Front {
  double low = 0.0, high = 0.0;  // across
  std::vector<double> knots;     // at least two
  double tilt = 0.0;

  [[nodiscard]] double across(std::size_t knot) const {
    return glm::mix(low, high, static_cast<double>(knot) / static_cast<double>(knots.size() - 1));
  }
  /// The strip that a place is in, and its share of the way to the next knot.
  [[nodiscard]] std::pair<std::size_t, double> strip(double at) const {
    const double strips = static_cast<double>(knots.size() - 1);
    const double place = std::clamp((at - low) / (high - low), 0.0, 1.0) * strips;
    const double first = std::min(std::floor(place), strips - 1.0);
    return {static_cast<std::size_t>(first), place - first};
  }
  [[nodiscard]] double at(const glm::dvec2& place) const {
    const auto [first, share] = strip(place.x);
    return glm::mix(knots[first], knots[first + 1], share) + tilt * place.y;
  }
};

/// Brings a front into the ranges by `depth` (Agmon 1954); square to the way where that goes.
bool bring_within(const std::vector<FrontRange>& ranges, double depth, Front& front) {
  constexpr double k_close = 1e-3;  // of the depth
  const double least = 2.0 * (1.0 - k_close) * depth;
  if (std::ranges::any_of(ranges, [&](const FrontRange& range) { return range.high - range.low < least; }))
    return false;
  double low = -INFINITY, high = INFINITY, middle = 0.0, spread = 1e-9;
  for (const FrontRange& range : ranges) {
    low = std::max(low, range.low);
    high = std::min(high, range.high);
    middle += range.at.y / static_cast<double>(ranges.size());
  }
  for (const FrontRange& range : ranges) spread = std::max(spread, std::abs(range.at.y - middle));
  const double start = !std::isfinite(high) ? (std::isfinite(low) ? low + depth : 0.0)
                       : std::isfinite(low) ? 0.5 * (low + high)
                                            : high - depth;
  front.tilt = 0.0;
  front.knots.assign(front.knots.size(), start);
  if (low + depth <= high - depth) return true;
  double lean = 0.0;  // per spread, about the middle
  for (std::size_t step = 0; step < k_most_steps; ++step) {
    double worst = 0.0, sign = 0.0;
    glm::dvec2 at(0.0);
    for (const FrontRange& range : ranges) {
      const double here = front.at({range.at.x, 0.0}) + lean * (range.at.y - middle) / spread;
      const double off = std::max(range.low + depth - here, here - (range.high - depth));
      if (off <= worst) continue;
      worst = off;
      sign = here < range.low + depth ? 1.0 : -1.0;
      at = range.at;
    }
    if (worst <= k_close * depth) {
      front.tilt = lean / spread;
      for (double& knot : front.knots) knot -= front.tilt * middle;
      return true;
    }
    const auto [first, share] = front.strip(at.x);
    const double upward = (at.y - middle) / spread;
    const double move =
        1.2 * sign * worst / ((1.0 - share) * (1.0 - share) + share * share + upward * upward);
    front.knots[first] += move * (1.0 - share);
    front.knots[first + 1] += move * share;
    lean += move * upward;
  }
  return false;
}

class BlankMaker {
 public:
  explicit BlankMaker(const BlankWish& wish) : wish_(wish), frame_(frame_along(wish.way)) {}

  SlideBlank run() {
    SlideBlank blank;
    set_section(wish_.land);
    const std::optional<std::vector<FrontRange>> ranges = front_ranges();
    if (!ranges) {
      blank.refusal = "the part stands in its way";
      return blank;
    }
    // Storeys, each with a front of its own: as few as go.
    const double head = below_ ? low_.y : formed_low_ - wish_.land,
                 top = above_ ? high_.y : formed_high_ + wish_.land;
    const bool extended = !below_ && head > low_.y + k_overlap, hangs = !above_ && top < high_.y - k_overlap;
    std::vector<std::vector<double>> floors = {{low_.y}};
    if (extended) floors.push_back({low_.y, head});
    if (hangs) floors.push_back({low_.y, top});
    for (const int parts : {3, 6}) {
      floors.emplace_back();
      for (int k = 0; k < parts; ++k)
        floors.back().push_back(glm::mix(low_.y, high_.y, static_cast<double>(k) / parts));
    }
    for (const std::size_t strips : {1, 4, 12}) {
      for (const std::vector<double>& floor : floors) {
        if (build(floor, strips, *ranges, blank)) return blank;
      }
    }
    if (blank.refusal.empty()) blank.refusal = "its front does not close on the part";
    return blank;
  }

 private:
  void set_section(double land) {
    low_ = glm::dvec2(INFINITY);
    high_ = glm::dvec2(-INFINITY);
    for (const glm::dvec3& vertex : wish_.formed) {
      low_ = glm::min(low_, glm::dvec2(frame_.of(vertex)));
      high_ = glm::max(high_, glm::dvec2(frame_.of(vertex)));
    }
    formed_low_ = low_.y;
    formed_high_ = high_.y;
    low_.x -= land;
    high_.x += land;
    // It reaches the height at which the halves meet, so that these need not climb to it.
    below_ = low_.y < wish_.shelf - k_clear;
    above_ = high_.y > wish_.shelf + k_clear;
    low_.y = below_ ? low_.y - land : wish_.shelf + k_off_shelf;
    high_.y = above_ ? high_.y + land : wish_.shelf - k_off_shelf;
  }

  /// Nothing where the part is in front of what it forms.
  [[nodiscard]] std::optional<std::vector<FrontRange>> front_ranges() const {
    const LineGrid grid{low_, high_, k_section_lines};
    const auto part = depth_columns(wish_.part, frame_, grid);
    std::vector<FrontRange> ranges;
    for (std::size_t line = 0; line < grid.lines(); ++line) {
      FrontRange range{.at = grid.at(line)};
      if (!part[line].empty()) range.low = part[line].back().from;
      ranges.push_back(range);
    }
    std::size_t behind = 0, formed = 0;
    for (const TriangleMesh* insert : wish_.inserts) {
      const auto own = depth_columns(*insert, frame_, grid);
      for (std::size_t line = 0; line < grid.lines(); ++line) {
        if (own[line].empty()) continue;
        ++formed;
        const double out = own[line].back().to;
        if (!part[line].empty() && part[line].back().from + part[line].back().to > 2.0 * out) {
          ++behind;
          continue;
        }
        ranges[line].high = std::min(ranges[line].high, out);
      }
    }
    // A line along a face may see it as in front.
    if (wish_.alone && 50 * behind > formed) return std::nullopt;
    return ranges;
  }

  /// A storey's front, and its heights.
  struct Storey {
    Front front;
    double low = 0.0, high = 0.0;
  };

  /// From the storey's front to a side of the block.
  struct Edge {
    glm::dvec3 start{0.0}, end{0.0};
    int axis = 0;  // across the side
  };

  [[nodiscard]] Edge edge(const Storey& storey, std::size_t knot, bool top) const {
    const glm::dvec2 corner(storey.front.across(knot), top ? storey.high : storey.low);
    const double beside = 2.0 * (corner.x - low_.x) / (high_.x - low_.x) - 1.0;
    // place(s) = corner + slope · (s − from_)
    const glm::dvec2 slope(beside * k_draft, this->slope(storey, top));
    const double s =
        (storey.front.at(corner) - from_ * storey.front.tilt * slope.y) / (1.0 - storey.front.tilt * slope.y);
    const auto in_mold = [&](double along) {
      const glm::dvec2 place = corner + (along - from_) * slope;
      return place.x * frame_.across + place.y * frame_.up + along * frame_.way;
    };
    const glm::dvec3 start = in_mold(s), onward = in_mold(s + 1.0) - start;
    Edge edge{.start = start};
    double least = INFINITY;
    for (const int axis : {0, 1}) {
      if (std::abs(onward[axis]) < 1e-9) continue;
      const double side = (onward[axis] > 0.0 ? wish_.high : wish_.low)[axis];
      const double way = (side - start[axis]) / onward[axis];
      if (way >= least) continue;
      least = way;
      edge.axis = axis;
      edge.end = start + way * onward;
      edge.end[axis] = side;
    }
    return edge;
  }

  /// Where the storey's bottom or top meets an upright edge of the block.
  [[nodiscard]] glm::dvec3 corner(const Storey& storey, bool top) const {
    const glm::dvec2 at(frame_.way.x > 0.0 ? wish_.high.x : wish_.low.x,
                        frame_.way.y > 0.0 ? wish_.high.y : wish_.low.y);
    const double along = glm::dot(at, glm::dvec2(frame_.way)) - from_;
    return {at, top ? storey.high + along * slope(storey, true) : storey.low + along * slope(storey, false)};
  }
  /// Of a storey's bottom or top along the way.
  [[nodiscard]] double slope(const Storey& storey, bool top) const {
    if (top) return above_ && storey.high == high_.y ? k_draft : 0.0;
    return below_ && storey.low == low_.y ? -k_draft : 0.0;
  }

  bool build(const std::vector<double>& floors, std::size_t strips, const std::vector<FrontRange>& ranges,
             SlideBlank& blank) {
    std::vector<Storey> storeys;
    for (std::size_t k = 0; k < floors.size(); ++k) {
      Storey storey{{low_.x, high_.x, std::vector<double>(strips + 1), 0.0},
                    floors[k],
                    k + 1 < floors.size() ? floors[k + 1] + k_overlap : high_.y};
      std::vector<FrontRange> own;
      for (const FrontRange& range : ranges) {
        if (range.at.y >= storey.low && range.at.y <= storey.high) own.push_back(range);
      }
      // What some of the ranges do not allow is not looked for in all.
      std::vector<FrontRange> some;
      for (std::size_t n = 0; n < own.size(); n += k_of_ranges) some.push_back(own[n]);
      const auto fits = [&](double depth) {
        return bring_within(some, depth, storey.front) && bring_within(own, depth, storey.front);
      };
      if (own.empty() || std::ranges::none_of(k_depths, fits)) return false;
      storeys.push_back(storey);
    }
    const glm::dvec2 place(0.5 * (low_.x + high_.x), 0.5 * (storeys[0].low + storeys[0].high));
    from_ = storeys[0].front.at(place);
    blank.mesh = {};
    blank.sides = {};
    for (const Storey& storey : storeys) {
      if (!add(storey, blank)) {
        blank.refusal = "it would leave the block at a corner";
        return false;
      }
    }
    blank.end = blank.mesh.vertices[1];
    blank.refusal.clear();
    return true;
  }

  [[nodiscard]] bool add(const Storey& storey, SlideBlank& blank) const {
    const double room = 0.1 * wish_.land;
    TriangleMesh& mesh = blank.mesh;
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    const std::size_t knots = storey.front.knots.size();
    std::vector<int> axes;  // by knot
    for (std::size_t knot = 0; knot < knots; ++knot) {
      for (const bool top : {false, true}) {
        const Edge edge = this->edge(storey, knot, top);
        const int axis = edge.axis;
        const double beside = edge.end[1 - axis];
        if ((edge.end[axis] - edge.start[axis]) * frame_.way[axis] <= 0.0 ||
            beside < wish_.low[1 - axis] + room || beside > wish_.high[1 - axis] - room)
          return false;
        mesh.vertices.push_back(edge.start);
        mesh.vertices.push_back(edge.end);
        blank.sides[static_cast<std::size_t>(axis)] = edge.end[axis];
        if (!top) axes.push_back(axis);
      }
    }
    const auto face = [&](const std::vector<VertexIndex>& corners) {
      for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.facets.push_back({first + corners[0], first + corners[k - 1], first + corners[k]});
    };
    // Four vertices a knot: bit 0 the end, bit 1 the top; seen against the way, the next knot is on the
    // right.
    for (std::size_t knot = 0; knot + 1 < knots; ++knot) {
      const auto k = static_cast<VertexIndex>(4 * knot), r = k + 4;
      face({k, k + 2, r + 2, r});  // front
      if (axes[knot] == axes[knot + 1]) {
        face({k + 1, r + 1, r + 3, k + 3});  // end
        face({k, r, r + 1, k + 1});          // bottom
        face({k + 2, k + 3, r + 3, r + 2});  // top
        continue;
      }
      // It leaves around an edge of the block.
      const VertexIndex low = static_cast<VertexIndex>(mesh.vertices.size()) - first, high = low + 1;
      mesh.vertices.push_back(corner(storey, false));
      mesh.vertices.push_back(corner(storey, true));
      face({k + 1, low, high, k + 3});
      face({low, r + 1, r + 3, high});
      face({low, k + 1, k, r, r + 1});
      face({high, r + 3, r + 2, k + 2, k + 3});
    }
    const auto last = static_cast<VertexIndex>(4 * (knots - 1));
    face({0, 1, 3, 2});                          // left
    face({last, last + 2, last + 3, last + 1});  // right
    return true;
  }

  const BlankWish& wish_;
  WayFrame frame_;
  glm::dvec2 low_{0.0}, high_{0.0};  // the section where it begins
  bool below_ = false, above_ = false;
  double formed_low_ = 0.0, formed_high_ = 0.0;  // heights of what it forms
  double from_ = 0.0;                            // along the way, where drafts begin
};

}  // namespace

namespace {

/// How deep something is met, and to where on the line it reaches.
struct Met {
  double depth = 0.0, to = 0.0;
};

/// What of the other lies beyond where the piece begins: the thinner of the two is what would be cut.
Met met_beyond(const std::vector<Stretch>& own, const std::vector<Stretch>& others) {
  double beyond = 0.0, before = 0.0;
  const double last = others.back().to;
  for (const Stretch& stretch : others)
    beyond += std::max(0.0, stretch.to - std::max(stretch.from, own.front().from));
  for (const Stretch& stretch : own) before += std::max(0.0, std::min(stretch.to, last) - stretch.from);
  return {std::min(beyond, before), last};
}

/// How deep at most one of its stretches goes into one of the other's that is in front of it.
Met met_within(const std::vector<Stretch>& own, const std::vector<Stretch>& others, double reach) {
  Met met;
  for (const Stretch& one : own) {
    for (const Stretch& other : others) {
      if (other.from + other.to <= one.from + one.to) continue;
      const double depth = std::min({one.to + reach - other.from, one.to - one.from, other.to - other.from});
      if (depth > met.depth) met = {depth, other.from};
    }
  }
  return met;
}

}  // namespace

SlideBlank slide_blank(const BlankWish& wish) { return BlankMaker(wish).run(); }

WayOut way_out(const TriangleMesh& piece, const TriangleMesh& still, const glm::dvec3& way, double reach,
               double rim) {
  const WayFrame frame = frame_along(way);
  WayOut found;
  std::size_t lines = 0, held = 0;
  const auto met_on = [&](const LineGrid& grid) {
    const auto own = depth_columns(piece, frame, grid), others = depth_columns(still, frame, grid);
    std::vector<Met> met(grid.lines());
    lines = 0;
    for (std::size_t line = 0; line < grid.lines(); ++line) {
      if (own[line].empty()) continue;
      ++lines;
      if (others[line].empty()) continue;
      met[line] = std::isfinite(reach) ? met_within(own[line], others[line], reach)
                                       : met_beyond(own[line], others[line]);
    }
    return met;
  };
  const LineGrid grid = LineGrid::over(piece, frame, k_exit_lines);
  std::vector<Met> met = met_on(grid);
  for (const Met& one : met) held += one.depth > k_held ? 1 : 0;
  found.share = lines > 0 ? static_cast<double>(held) / static_cast<double>(lines) : 0.0;
  // At a rim some line beside it, so far off, is met less.
  for (int beside = 0; rim > 0.0 && held > 0 && beside < 9; ++beside) {
    const glm::dvec2 shift = rim * glm::dvec2(beside % 3 - 1, beside / 3 - 1);
    if (shift == glm::dvec2(0.0)) continue;
    const std::vector<Met> there = met_on({grid.low + shift, grid.high + shift, grid.count});
    for (std::size_t line = 0; line < met.size(); ++line)
      met[line].depth = std::min(met[line].depth, there[line].depth);
  }
  const auto deepest = std::ranges::max_element(met, {}, &Met::depth);
  if (deepest == met.end() || deepest->depth <= 0.0) return found;
  const glm::dvec2 at = grid.at(static_cast<std::size_t>(deepest - met.begin()));
  found.blocked = deepest->depth;
  found.place = at.x * frame.across + at.y * frame.up + deepest->to * frame.way;
  return found;
}

}  // namespace moldlight
