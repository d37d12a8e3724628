#include "parting/halves/outline_rims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/union_find.hpp"
#include "parting/halves/find_steps.hpp"

namespace moldlight {

namespace {

/// Holes narrower than this, in diagonals of the part, or than their outline is off the plane, get a plane
/// whatever that is: what leads from one height to the other there is an upright wall.
constexpr double k_small_hole = 0.005;
/// How far in the plane the line, which may be a little off the surface, is from the outline, in diagonals of
/// the part.
constexpr double k_line_reach = 1.5e-4;
/// Slack of a hole's plane, in diagonals.
constexpr double k_plane_slack = 1e-5;
/// Shorter stretches of the outline than this, in diagonals, do not pull the surface along.
constexpr double k_tongue = 2e-3;
/// Steps are taken where so much more of the surface is one plane.
constexpr double k_worth_steps = 0.05;
using EndRanges = std::array<HeightRange, 2>;

std::unordered_map<std::uint64_t, EndRanges> segment_ranges(const Sheets& sheets) {
  std::unordered_map<std::uint64_t, EndRanges> ranges;
  for (const Sheet sheet : {Sheet::lower, Sheet::upper}) {
    for (const SegmentEdges& segment : sheets.by_segment(sheets.ends(Sheets::bit(sheet)))) {
      EndRanges& found = ranges[Sheets::edge_key(segment.a, segment.b)];
      for (const SegmentEdge& edge : segment.edges) {
        const std::array<double, 2> z = {sheets.vertices[edge.a].z, sheets.vertices[edge.b].z};
        for (std::size_t k = 0; k < 2; ++k) {
          if (sheet == Sheet::lower) found[k].low = std::max(found[k].low, z[k]);
          if (sheet == Sheet::upper) found[k].high = std::min(found[k].high, z[k]);
        }
      }
    }
  }
  return ranges;
}

/// Both ends of each, somewhat within it, so that what is said of a wall across a corner is not said of it.
std::vector<OutlinePoint> points_within(const std::vector<RimSegment>& rims, double inset) {
  std::vector<OutlinePoint> points;
  for (const RimSegment& rim : rims) {
    const double share = std::min(0.5, inset / std::max(rim.length(), 1e-300));
    points.push_back({glm::mix(rim.ends[0], rim.ends[1], share), rim.ranges[0]});
    points.push_back({glm::mix(rim.ends[1], rim.ends[0], share), rim.ranges[1]});
  }
  return points;
}

/// Without the shortest stretches that the shelf does not meet, which would be tongues too thin to be cut:
/// an upright wall leads from the shelf to the part there.
std::vector<RimSegment> without_tongues(const std::vector<RimSegment>& rims, const ShelfPlane& shelf) {
  const auto missed = [&](const RimSegment& rim) { return !shelf.meets({rim}, k_plane_slack); };
  std::map<std::pair<double, double>, std::uint32_t> first_at;
  UnionFind joined(rims.size());
  for (std::uint32_t k = 0; k < rims.size(); ++k) {
    if (!missed(rims[k])) continue;
    for (const glm::dvec2& end : rims[k].ends)
      joined.join(k, first_at.try_emplace({end.x, end.y}, k).first->second);
  }
  std::vector<double> lengths(rims.size(), 0.0);
  for (std::uint32_t k = 0; k < rims.size(); ++k) lengths[joined.find(k)] += rims[k].length();
  std::vector<RimSegment> kept;
  for (std::uint32_t k = 0; k < rims.size(); ++k) {
    if (!missed(rims[k]) || lengths[joined.find(k)] > k_tongue) kept.push_back(rims[k]);
  }
  return kept;
}

/// Twice the area by the length around: the width of a slot, half of that of a square.
double width_of(const std::vector<RimSegment>& rims) {
  double twice_area = 0.0, around = 0.0;
  for (const RimSegment& rim : rims) {
    const auto& [a, b] = rim.ends;
    twice_area += a.x * b.y - a.y * b.x;
    around += rim.length();
  }
  return around > 0.0 ? std::abs(twice_area) / around : 0.0;
}

/// Of places near the outline how many are in the largest level of a field; `hole`: of all that the outline
/// goes around.
double level_share(const ShelfField& field, const std::vector<RimSegment>& rims, bool hole) {
  constexpr int k_places = 40;
  constexpr double k_around = 0.15, k_one_level = 1e-7;
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const RimSegment& rim : rims) {
    low = glm::min(low, rim.ends[0]);
    high = glm::max(high, rim.ends[0]);
  }
  const double margin = hole ? 0.0 : k_around;
  // However the part lies in the plane.
  const auto near_outline = [&](const glm::dvec2& at) {
    return std::ranges::any_of(rims, [&](const RimSegment& rim) {
      const glm::dvec2 way = rim.ends[1] - rim.ends[0], from = at - rim.ends[0];
      const double share = std::clamp(glm::dot(from, way) / std::max(glm::dot(way, way), 1e-300), 0.0, 1.0);
      return glm::distance(from, share * way) <= k_around;
    });
  };
  std::map<std::int64_t, int> counts;
  int all = 0, most = 0;
  for (int i = 0; i < k_places; ++i) {
    const double y = glm::mix(low.y - margin, high.y + margin, (i + 0.5) / k_places);
    std::vector<double> crossings;
    for (const RimSegment& rim : rims) {
      const auto& [a, b] = rim.ends;
      if ((a.y <= y) != (b.y <= y)) crossings.push_back(glm::mix(a.x, b.x, (y - a.y) / (b.y - a.y)));
    }
    std::ranges::sort(crossings);
    for (int k = 0; k < k_places; ++k) {
      const double x = glm::mix(low.x - margin, high.x + margin, (k + 0.5) / k_places);
      const auto before = std::ranges::upper_bound(crossings, x) - crossings.begin();
      if ((before % 2 == 1) != hole || (!hole && !near_outline({x, y}))) continue;
      ++all;
      most = std::max(most, ++counts[std::llround(field.at({x, y}) / k_one_level)]);
    }
  }
  return all > 0 ? static_cast<double>(most) / all : 0.0;
}

/// Steps in place of a shelf with ramps, where more of them is one plane.
std::optional<ShelfField> better_steps(const ShelfField& shelf, const std::vector<RimSegment>& rims,
                                       bool hole) {
  std::optional<StepProfile> steps = find_steps(rims, shelf.shelf().height, shelf.shape());
  if (!steps) return std::nullopt;
  if (!hole) steps->level_around(rims, shelf.shape());
  ShelfField field(rims, *std::move(steps), shelf.shape());
  if (level_share(field, rims, hole) < level_share(shelf, rims, hole) + k_worth_steps) return std::nullopt;
  return field;
}

/// Facets may be off by so much, in diagonals of the part; points are no nearer to each other than that.
constexpr double k_most_off = 1e-3, k_least_apart = 2e-3;
constexpr int k_most_layout_rounds = 6;
/// A line that is laid passes points as near as this, in diagonals of the part; and so much is in its way.
constexpr double k_passed = 1e-6;
constexpr int k_most_obstacles = 2000;
constexpr std::size_t k_most_points = 1500;
/// Places at which an edge is looked at.
constexpr std::size_t k_samples = 8;

struct Bend {
  double share = 0.5;  // of the edge
  bool kink = false;   // straight on both sides
};

/// Heights along an edge.
using Profile = std::function<double(double share)>;

/// Where the profile, straight on both sides of one place between two shares, bends.
std::optional<double> kink_between(const Profile& profile, double from, double to) {
  const double span = to - from, step = 0.02 * span;
  const double at_from = profile(from), at_to = profile(to);
  const double rise_from = (profile(from + step) - at_from) / step,
               rise_to = (at_to - profile(to - step)) / step;
  if (std::abs(rise_from - rise_to) * span <= 1e-7) return std::nullopt;
  const double way = (at_to - at_from - rise_to * span) / (rise_from - rise_to);
  if (way <= 0.0 || way >= span) return std::nullopt;
  const double expected = at_from + rise_from * way;
  if (std::abs(profile(from + way) - expected) > 0.02 * k_most_off) return std::nullopt;
  return from + way;
}

/// Where the profile is farthest from straight, if that is too far: at a kink if one is there.
std::optional<Bend> bend_of(const Profile& profile, double at_start, double at_end) {
  std::array<double, k_samples + 1> z{};
  z[0] = at_start;
  z[k_samples] = at_end;
  double most = k_most_off;
  std::size_t worst = 0;
  for (std::size_t k = 1; k < k_samples; ++k) {
    const double share = static_cast<double>(k) / k_samples;
    z[k] = profile(share);
    const double off = std::abs(z[k] - glm::mix(at_start, at_end, share));
    if (off <= most) continue;
    most = off;
    worst = k;
  }
  if (worst == 0) return std::nullopt;
  if (const auto kink = kink_between(profile, 0.0, 1.0)) return Bend{*kink, true};
  // Around the sharpest place.
  std::size_t sharpest = worst;
  double bends = 0.0;
  for (std::size_t k = 1; k < k_samples; ++k) {
    const double bend = std::abs(z[k + 1] - 2.0 * z[k] + z[k - 1]);
    if (bend <= bends) continue;
    bends = bend;
    sharpest = k;
  }
  const double low = static_cast<double>(sharpest - 1) / k_samples,
               high = static_cast<double>(sharpest + 1) / k_samples;
  if (const auto kink = kink_between(profile, low, high)) return Bend{*kink, true};
  return Bend{static_cast<double>(worst) / k_samples, false};
}

class Layout {
 public:
  Layout(PlaneMesh& mesh, std::span<const ShelfField> fields) : mesh_(mesh), fields_(fields) {}

  void run() {
    for (const ShelfField& field : fields_) {
      if (!field.steps()) continue;
      for (const auto& [a, b] : field.steps()->creases(mesh_.points()[0], mesh_.points()[2])) lay(a, b);
    }
    const std::size_t most = mesh_.points().size() + k_most_points;
    for (int round = 0; round < k_most_layout_rounds && mesh_.points().size() < most; ++round) {
      if (!cut_bends()) return;
    }
  }

 private:
  using Edge = std::array<std::uint32_t, 2>;

  /// A line of the plane as segments, over the points that it passes.
  void lay(const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 way = b - a;
    const double length = glm::length(way);
    if (length < k_passed) return;
    std::vector<std::pair<double, std::uint32_t>> passed;
    for (std::uint32_t k = 0; k < mesh_.points().size(); ++k) {
      const glm::dvec2 from = mesh_.points()[k] - a;
      const double along = glm::dot(from, way) / length;
      if (along > -k_passed && along < length + k_passed &&
          std::abs(way.x * from.y - way.y * from.x) <= k_passed * length)
        passed.emplace_back(along, k);
    }
    std::ranges::sort(passed);
    if (passed.empty() || passed.front().first > k_passed)
      passed.insert(passed.begin(), {0.0, mesh_.add_point(on_grid(a))});
    if (passed.back().first < length - k_passed) passed.emplace_back(length, mesh_.add_point(on_grid(b)));
    int most = k_most_obstacles;
    for (std::size_t k = 1; k < passed.size(); ++k) connect(passed[k - 1].second, passed[k].second, most);
  }

  /// Over what stands in the way; of that `most` is left.
  void connect(std::uint32_t a, std::uint32_t b, int& most) {
    if (a == b || most-- <= 0) return;
    const auto obstacle = mesh_.add_segment(a, b, PlaneMesh::k_rim);
    if (!obstacle) return;
    std::uint32_t by = obstacle->point;
    if (by == PlaneMesh::k_none && obstacle->segment[0] != PlaneMesh::k_none) {
      const auto& [c, d] = obstacle->segment;
      const glm::dvec2 pa = mesh_.points()[a], pc = mesh_.points()[c], r = mesh_.points()[b] - pa,
                       s = mesh_.points()[d] - pc, to = pc - pa;
      const double t = (to.x * s.y - to.y * s.x) / (r.x * s.y - r.y * s.x);
      const glm::dvec2 at = on_grid(pa + t * r);
      by = glm::distance(at, pc) < k_passed                  ? c
           : glm::distance(at, mesh_.points()[d]) < k_passed ? d
                                                             : mesh_.divide_segment(c, d, at);
    }
    if (by == PlaneMesh::k_none) return;
    connect(a, by, most);
    connect(by, b, most);
  }
  struct Cut {
    std::uint32_t region = 0;
    bool fixed = false;
    glm::dvec2 at{0.0};
    bool kink = false;
    std::uint32_t point = PlaneMesh::k_none;
  };

  double height_at(std::uint32_t region, std::uint32_t point) {
    const auto [entry, fresh] = heights_.try_emplace({region, point}, 0.0);
    if (fresh) entry->second = fields_[region].at(mesh_.points()[point]);
    return entry->second;
  }

  std::optional<Cut> cut_of(const Edge& edge, std::uint32_t region, bool fixed) {
    const glm::dvec2 a = mesh_.points()[edge[0]], b = mesh_.points()[edge[1]];
    const double length = glm::distance(a, b);
    if (length < 2.0 * k_least_apart || straight_.contains(Sheets::edge_key(edge[0], edge[1])))
      return std::nullopt;
    const Profile profile = [&](double share) { return fields_[region].at(glm::mix(a, b, share)); };
    const auto bend = bend_of(profile, height_at(region, edge[0]), height_at(region, edge[1]));
    const double least = k_least_apart / length;
    if (!bend || bend->share < least || bend->share > 1.0 - least) {
      straight_.insert(Sheets::edge_key(edge[0], edge[1]));
      return std::nullopt;
    }
    return Cut{region, fixed, on_grid(glm::mix(a, b, bend->share)), bend->kink};
  }

  /// Whether a point would stand so near to others, or to a segment, that its facets would be slivers.
  [[nodiscard]] bool crowded(const glm::dvec2& at) const {
    const PlaneMesh::Triangle& t = mesh_.triangles()[mesh_.locate(at)];
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 &a = mesh_.points()[t.corners[k]], &b = mesh_.points()[t.corners[(k + 1) % 3]];
      if (glm::distance(a, at) < k_least_apart) return true;
      const glm::dvec2 along = b - a, away = at - a;
      if (t.fixed[k] != 0 &&
          std::abs(along.x * away.y - along.y * away.x) < k_least_apart * glm::length(along))
        return true;
    }
    return false;
  }

  bool cut_bends() {
    const std::vector<PlaneMesh::Triangle> before = mesh_.triangles();
    std::map<Edge, std::optional<Cut>> cuts;
    const auto edge_of = [](const PlaneMesh::Triangle& t, std::size_t k) {
      const auto [low, high] = std::minmax(t.corners[k], t.corners[(k + 1) % 3]);
      return Edge{low, high};
    };
    bool any = false;
    for (const PlaneMesh::Triangle& t : before) {
      if (t.inside || fields_[t.region].plane()) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [entry, fresh] = cuts.try_emplace(edge_of(t, k));
        if (!fresh) continue;
        entry->second = cut_of(entry->first, t.region, t.fixed[k] != 0);
        any = any || entry->second;
      }
    }
    if (!any) return false;
    for (auto& [edge, cut] : cuts) {
      if (!cut) continue;
      if (cut->fixed) {
        cut->point = mesh_.divide_segment(edge[0], edge[1], cut->at);
      } else if (!crowded(cut->at)) {
        cut->point = mesh_.add_point(cut->at);
      }
      if (cut->point == PlaneMesh::k_none) straight_.insert(Sheets::edge_key(edge[0], edge[1]));
    }
    for (const PlaneMesh::Triangle& t : before) {
      if (t.inside || fields_[t.region].plane()) continue;
      std::vector<std::uint32_t> on_kink;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& cut = cuts.at(edge_of(t, k));
        if (cut && cut->kink && cut->point != PlaneMesh::k_none) on_kink.push_back(cut->point);
      }
      if (on_kink.size() == 2 && on_kink[0] != on_kink[1])
        static_cast<void>(mesh_.add_segment(on_kink[0], on_kink[1], PlaneMesh::k_rim));
    }
    return true;
  }

  PlaneMesh& mesh_;
  std::span<const ShelfField> fields_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> heights_;
  std::unordered_set<std::uint64_t> straight_;
};

}  // namespace

RegionRims outline_rims(const Sheets& sheets, const OutlinePlane& plane) {
  const auto ranges = segment_ranges(sheets);
  RegionRims regions(plane.mesh.region_count());
  for (const PlaneMesh::Triangle& t : plane.mesh.triangles()) {
    if (t.inside) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.fixed[k] != PlaneMesh::k_outline) continue;
      const std::uint32_t from = t.corners[k], to = t.corners[(k + 1) % 3];
      const PlanePoint a = plane.column_of[from], b = plane.column_of[to];
      const auto found = ranges.find(Sheets::edge_key(a, b));
      if (found == ranges.end()) continue;
      EndRanges at = found->second;
      if (a > b) std::swap(at[0], at[1]);
      for (HeightRange& range : at) {
        if (range.empty()) range.low = range.high = range.middle();
      }
      regions[t.region].push_back({{plane.mesh.points()[from], plane.mesh.points()[to]}, at});
    }
  }
  return regions;
}

void keep_walls(const RimWishes& wishes, std::vector<RimSegment>& rims) {
  if (wishes.walls.empty()) return;
  const double reach = k_wall_reach * wishes.tolerance;
  const auto by_hand = wall_ranges(points_within(rims, 3.0 * reach), wishes.walls, reach);
  for (std::size_t k = 0; k < by_hand.size(); ++k) {
    HeightRange& range = rims[k / 2].ranges[k % 2];
    const HeightRange both{std::max(range.low, by_hand[k].low), std::min(range.high, by_hand[k].high)};
    if (!both.empty()) range = both;
  }
}

std::vector<ShelfField> shelf_fields(const RegionRims& rims, const RimWishes& wishes, const ShelfShape& shape,
                                     const Progress& progress) {
  std::vector<ShelfField> fields;
  for (const std::vector<RimSegment>& region : rims) {
    const auto of_line =
        line_ranges(points_within(region, 0.25 * k_line_reach), wishes.line, k_line_reach, progress);
    std::vector<double> line;
    for (std::size_t k = 0; k < region.size(); ++k)
      line.push_back(0.5 * (of_line[2 * k].middle() + of_line[2 * k + 1].middle()));
    ShelfPlane shelf{.height = shelf_level(region, line, wishes.height)};
    if (!fields.empty() && !shelf.meets(region, k_plane_slack)) {
      const ShelfPlane inclined = fitted_plane(region);
      if (glm::length(inclined.tilt) <= shape.slope && inclined.meets(region, k_plane_slack))
        shelf = inclined;
    }
    const double width = width_of(region);
    const bool too_narrow = !fields.empty() && (width <= k_small_hole || !shelf.meets(region, width));
    fields.emplace_back(too_narrow ? std::vector<RimSegment>{} : without_tongues(region, shelf), shelf,
                        shape);
    if (fields.back().plane()) continue;
    if (auto steps = better_steps(fields.back(), region, fields.size() > 1))
      fields.back() = *std::move(steps);
  }
  return fields;
}

void lay_shelf(Sheets& sheets, std::span<const ShelfField> fields, double tolerance, OutlinePlane& plane) {
  if (std::ranges::all_of(fields, &ShelfField::plane)) return;
  const std::size_t before = plane.mesh.points().size();
  Layout(plane.mesh, fields).run();
  put_in_columns(sheets, before, tolerance, plane);
}

}  // namespace moldlight
