#include "mold/exact/exact_regions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "mold/draft.hpp"
#include "mold/exact/facet_cells.hpp"
#include "mold/exact/projected_part.hpp"
#include "mold/exact/split_assembly.hpp"

namespace moldlight {

namespace {

// Unit frame. Segments are clipped generously, since one too many does no harm and one too few does.
/// A curtain that enters a facet by less than the first only touches it; nearer than the second, it may run
/// between the facet and its neighbour.
constexpr double k_touch = 1e-13, k_near = 1e-8;
/// |n . d| of walls whose projection is left out of the shadow: subdivided walls, tilted this way and that by
/// the rounding of a file in single precision, hide each other in thousands of slivers.
constexpr double k_hardly_tilted = 1e-5;
constexpr unsigned k_all_sides = 7;           // bits
constexpr std::size_t k_grain = 256;          // facets a task
constexpr std::size_t k_block = 4 * k_grain;  // facets between two looks at the limit
constexpr double k_sum_rounding = 1e-10;      // of millions of areas whose sum is some units

/// A plane's own coordinates: the first axis is level, the second rises as steeply as the plane does.
struct PlaneFrame {
  glm::dvec3 origin{0.0}, level{1, 0, 0}, rising{0, 1, 0};

  [[nodiscard]] glm::dvec2 in_plane(const glm::dvec3& point) const {
    return {glm::dot(level, point - origin), glm::dot(rising, point - origin)};
  }
  [[nodiscard]] glm::dvec3 in_space(const glm::dvec2& place) const {
    return origin + place.x * level + place.y * rising;
  }
};

/// What a facet's points are tested for.
struct FacetTest {
  bool plus = true, minus = true;  // accessibility along +d, along -d
  bool beside = false;             // from beside the facet, where anything in the way counts
  glm::dvec3 shift{0.0};           // to the point that is tested
};

/// One thread's room.
class FacetSplitter {
 public:
  FacetSplitter(const ProjectedPart& projected, const ExactQuery& query, const Progress& progress)
      : projected_(projected),
        query_(query),
        progress_(progress),
        sine_of_tau_(std::sin(glm::radians(query.tau_deg))),
        square_(projected.part().frame().diagonal * projected.part().frame().diagonal),
        seen_(projected.contour().size(), 0),
        seen_facets_(projected.part().mesh().facets.size(), 0),
        known_(seen_facets_.size()) {}

  /// From here on facets share regions with each other alone.
  void begin_task() { ++task_; }

  struct Outcome {
    std::array<double, k_region_count> areas{};  // unit frame squared
    FacetClass facet_class = FacetClass::near_vertical;
    double projected_core = 0.0, projected_cavity = 0.0;  // unit frame squared
    double projected_doubt = 0.0;                         // model units squared
    double squared_doubt = 0.0;                           // unit frame to the fourth
  };
  /// Cuts the facet; the cells are those of cells() if they are kept.
  Outcome split(FacetIndex facet, bool keep_cells);

  [[nodiscard]] const FacetCells& cells() const { return cells_; }

 private:
  void run(FacetIndex facet, const FacetTest& test, bool keep_cells);
  void gather(FacetIndex facet, const FacetTest& test);
  void lay_lattice();
  void add_curtain(const ContourEdge& edge, Sense sense);
  void add_crossing(FacetIndex other, const glm::dvec3& normal);
  void close_sides_at(const std::array<double, 3>& heights);
  template <typename RegionAt>
  [[nodiscard]] Region region_of_whole(FacetIndex facet, const FacetTest& test, const RegionAt& region_at);

  const ProjectedPart& projected_;
  const ExactQuery& query_;
  const Progress& progress_;
  double sine_of_tau_;
  double square_;     // model units squared per unit frame squared
  PlaneFrame plane_;  // of the facet, shifted
  glm::dvec3 shift_{0.0};
  std::array<glm::dvec3, 3> corners_{};  // shifted
  std::vector<std::uint32_t> seen_;      // round in which a contour edge was last met
  std::vector<std::uint32_t> seen_facets_;
  std::uint32_t round_ = 0;
  unsigned closed_sides_ = 0;  // bits: sides of the facet that a curtain may run along
  /// Regions of whole facets, by kind of test, and the task that they were found in.
  struct Known {
    std::uint32_t task = 0;
    std::array<std::uint8_t, 3> regions{};       // 0: not known
    std::array<std::uint8_t, 3> closed_sides{};  // bits
  };
  std::vector<Known> known_;
  std::uint32_t task_ = 0;
  std::array<FacetIndex, 2> last_blocker_ = {k_no_facet, k_no_facet};  // along +d, along -d
  std::vector<FacetCrossing> segments_;                                // shifted
  std::vector<CutSegment> plane_segments_;
  FacetCells cells_;
};

FacetSplitter::Outcome FacetSplitter::split(FacetIndex facet, bool keep_cells) {
  const ExactPart& part = projected_.part();
  const glm::dvec3& normal = part.geometry().normals[facet];
  const double sine = glm::dot(normal, projected_.frame().z);
  const std::uint8_t faces = projected_.extent(facet).facing;
  Outcome outcome;
  outcome.facet_class = facet_class(sine, sine_of_tau_);
  const auto seen_from_above = [&](const std::array<double, k_region_count>& areas) {
    if (faces == facing::k_up) outcome.projected_core = sine * areas[static_cast<std::size_t>(Region::core)];
    if (faces == facing::k_down)
      outcome.projected_cavity = -sine * areas[static_cast<std::size_t>(Region::cavity)];
  };
  if (outcome.facet_class != FacetClass::near_vertical) {
    const bool up = outcome.facet_class == FacetClass::up;
    run(facet, {.plus = up, .minus = !up}, keep_cells);
    seen_from_above(cells_.areas());
  } else {
    if (std::abs(sine) < k_hardly_tilted) {
      outcome.projected_doubt = std::abs(sine) * part.geometry().areas[facet];
    } else {
      run(facet, {.plus = faces == facing::k_up, .minus = faces == facing::k_down}, false);
      seen_from_above(cells_.areas());
    }
    FacetTest test{.beside = true};
    const glm::dvec2 level(projected_.turned(normal));
    const double length = glm::length(level);
    if (length > 0.0) test.shift = glm::dvec3(level * (query_.lateral / length), 0.0);
    run(facet, test, keep_cells);
  }
  outcome.areas = cells_.areas();
  outcome.squared_doubt = cells_.squared_doubt();
  return outcome;
}

void FacetSplitter::run(FacetIndex facet, const FacetTest& test, bool keep_cells) {
  const auto& vertices = projected_.part().mesh().facets[facet];
  shift_ = test.shift;
  for (std::size_t k = 0; k < 3; ++k) corners_[k] = projected_.point(vertices[k]) + shift_;
  const auto region_at = [&](const glm::dvec3& point) {
    if (progress_.cancelled()) throw Cancelled();  // one facet may be cut into a million cells
    const auto blocked = [&](Sense sense) {
      return projected_.blocked(
          {.point = point, .sense = sense, .beside = test.beside, .own = test.beside ? k_no_facet : facet},
          last_blocker_[sense > 0 ? 0 : 1]);
    };
    return region_of(test.plus && !blocked(1), test.minus && !blocked(-1));
  };
  const ProjectedPart::FacetWork work = projected_.work_on(facet);
  if (work.sampled) {
    lay_lattice();
  } else {
    gather(facet, test);
  }
  if (segments_.empty() && !work.sampled) {
    cells_.keep_whole(region_of_whole(facet, test, region_at),
                      projected_.part().geometry().areas[facet] / square_);
    return;
  }
  const glm::dvec3 normal = projected_.turned(projected_.part().geometry().normals[facet]);
  const double level = std::sqrt(normal.x * normal.x + normal.y * normal.y);
  plane_.origin = corners_[0];
  plane_.level = level > 0.0 ? glm::dvec3(-normal.y / level, normal.x / level, 0.0) : glm::dvec3(1, 0, 0);
  plane_.rising = glm::cross(normal, plane_.level);
  plane_segments_.clear();
  for (const FacetCrossing& segment : segments_) {
    plane_segments_.push_back({plane_.in_plane(segment.start), plane_.in_plane(segment.end)});
  }
  cells_.cut({plane_.in_plane(corners_[0]), plane_.in_plane(corners_[1]), plane_.in_plane(corners_[2])},
             plane_segments_, {.most_cells = work.most_cells, .sampled = work.sampled, .seed = facet},
             keep_cells, [&](const glm::dvec2& place) { return region_at(plane_.in_space(place)); });
  // Where a facet is so thin beside the part that its cells have no area, one point stands for it.
  const auto& areas = cells_.areas();
  if (!(std::accumulate(areas.begin(), areas.end(), 0.0) > 0.0))
    cells_.keep_whole(region_at((corners_[0] + corners_[1] + corners_[2]) / 3.0),
                      projected_.part().geometry().areas[facet] / square_);
}

/// Where no curtain runs between a facet and its neighbour both are in one region.
template <typename RegionAt>
Region FacetSplitter::region_of_whole(FacetIndex facet, const FacetTest& test, const RegionAt& region_at) {
  const ExactPart& part = projected_.part();
  const std::size_t kind = test.beside ? 2 : test.plus ? 0 : 1;
  // Where bodies overlap, one facet may lie inside another body and its neighbour outside.
  if (part.any_crossings()) closed_sides_ = k_all_sides;
  const auto region_of_neighbour = [&](std::uint32_t side) -> std::uint8_t {
    const std::uint32_t number = part.side_edges()[facet][side];
    if ((closed_sides_ >> side & 1) != 0 || number == ExactPart::k_no_edge) return 0;
    const ExactEdge& edge = part.edges()[number];
    if (edge.kind == EdgeKind::irregular) return 0;
    const FacetIndex other = edge.left == facet ? edge.right : edge.left;
    const Known& known = known_[other];
    if (known.task != task_ || known.regions[kind] == 0) return 0;
    const auto& sides = part.side_edges()[other];
    const auto others_side = static_cast<unsigned>(std::ranges::find(sides, number) - sides.begin());
    if ((known.closed_sides[kind] >> others_side & 1) != 0) return 0;
    // Points beside are next to each other if the facets lie in one plane.
    const glm::dvec3 bend = part.geometry().normals[facet] - part.geometry().normals[other];
    return test.beside && glm::length(bend) * query_.lateral > 0.5 * k_near ? 0 : known.regions[kind];
  };
  std::uint8_t region = 0;
  for (std::uint32_t side = 0; side < 3 && region == 0; ++side) region = region_of_neighbour(side);
  if (region == 0)
    region = static_cast<std::uint8_t>(
        1 + static_cast<int>(region_at((corners_[0] + corners_[1] + corners_[2]) / 3.0)));
  Known& known = known_[facet];
  if (known.task != task_) known = {task_, {}, {}};
  known.regions[kind] = region;
  known.closed_sides[kind] = static_cast<std::uint8_t>(closed_sides_);
  return static_cast<Region>(region - 1);
}

/// Lines along two of the sides: cells about as large as each other, each of which a point stands for.
void FacetSplitter::lay_lattice() {
  segments_.clear();
  closed_sides_ = k_all_sides;
  const std::size_t lines = projected_.lattice_lines();
  for (std::size_t k = 1; k < lines; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(lines);
    const auto along = [&](std::size_t a, std::size_t b) {
      return glm::mix(corners_[a], corners_[b], share);
    };
    segments_.push_back({along(0, 1), along(2, 1)});
    segments_.push_back({along(0, 2), along(1, 2)});
  }
}

void FacetSplitter::gather(FacetIndex facet, const FacetTest& test) {
  segments_.clear();
  const ExactPart& part = projected_.part();
  closed_sides_ = k_all_sides;
  if (part.geometry().areas[facet] <= 0.0) return;
  // A ray that runs along its own facet says nothing of others.
  if (projected_.extent(facet).facing != 0 || shift_ != glm::dvec3(0.0)) closed_sides_ = 0;
  const double lowest = std::min({corners_[0].z, corners_[1].z, corners_[2].z}) - k_plane_margin;
  const double highest = std::max({corners_[0].z, corners_[1].z, corners_[2].z}) + k_plane_margin;
  const std::array<glm::dvec2, 3> footprint = {glm::dvec2(corners_[0]), glm::dvec2(corners_[1]),
                                               glm::dvec2(corners_[2])};
  ++round_;
  const std::uint8_t over = test.plus ? projected_.blockers(1, test.beside) : 0;
  const std::uint8_t under = test.minus ? projected_.blockers(-1, test.beside) : 0;
  projected_.contour_grid().for_each_item(footprint, [&](std::uint32_t k) {
    const ProjectedPart::ContourExtent& extent = projected_.contour_extent(k);
    const bool hangs = (extent.for_below & over) != 0 && extent.high > lowest;
    const bool stands = (extent.for_above & under) != 0 && extent.low < highest;
    if (!(hangs || stands) || seen_[k] == round_) return;
    seen_[k] = round_;
    if (hangs) add_curtain(projected_.contour()[k], 1);
    if (stands) add_curtain(projected_.contour()[k], -1);
  });
  for (const FacetCrossing& crossing : part.crossings(facet)) {
    segments_.push_back(
        {projected_.turned(crossing.start) + shift_, projected_.turned(crossing.end) + shift_});
  }
  if (!test.beside || shift_ == glm::dvec3(0.0)) return;
  const glm::dvec3 normal = projected_.turned(part.geometry().normals[facet]);
  const double height = glm::dot(normal, shift_);
  if (part.knows_in_front() && height >= k_least_in_front + k_near &&
      glm::length(shift_) <= k_most_in_front) {
    for (const FacetIndex other : part.in_front(facet)) add_crossing(other, normal);
    return;
  }
  for (const ProjectionGrid& facets : projected_.facet_grids()) {
    facets.for_each_item(footprint, [&](std::uint32_t other) {
      if (seen_facets_[other] == round_) return;
      seen_facets_[other] = round_;
      const ProjectedPart::Extent& extent = projected_.extent(other);
      if (extent.high.z >= lowest && extent.low.z <= highest) add_crossing(other, normal);
    });
  }
}

/// By the corners' heights over a plane in which something may run.
void FacetSplitter::close_sides_at(const std::array<double, 3>& heights) {
  for (unsigned side = 0; side < 3; ++side) {
    if (std::abs(heights[side]) < k_near && std::abs(heights[(side + 1) % 3]) < k_near)
      closed_sides_ |= 1U << side;
  }
}

/// The facet's intersection with what hangs from the edge.
void FacetSplitter::add_curtain(const ContourEdge& edge, Sense sense) {
  std::array<double, 3> heights{};
  for (std::size_t k = 0; k < 3; ++k) {
    heights[k] =
        edge.across.x * (corners_[k].x - edge.start.x) + edge.across.y * (corners_[k].y - edge.start.y);
  }
  const auto [lowest, highest] = std::minmax({heights[0], heights[1], heights[2]});
  if (lowest > k_near || highest < -k_near) return;
  close_sides_at(heights);
  if (highest <= k_touch || lowest >= -k_touch) return;
  std::array<glm::dvec3, 2> ends{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3 && count < 2; ++k) {
    const double from = heights[k], to = heights[(k + 1) % 3];
    if ((from > 0.0) == (to > 0.0)) continue;
    ends[count++] = corners_[k] + (from / (from - to)) * (corners_[(k + 1) % 3] - corners_[k]);
  }
  if (count < 2) return;
  double begin = 0.0, end = 1.0;
  const auto clip = [&](double from, double to) {  // keeps where a line from `from` to `to` is positive
    if (from < 0.0 && to < 0.0) return false;
    if (from < 0.0) begin = std::max(begin, from / (from - to));
    if (to < 0.0) end = std::min(end, from / (from - to));
    return begin < end;
  };
  std::array<double, 2> along{}, room{};
  for (std::size_t k = 0; k < 2; ++k) {
    const glm::dvec3 from_start = ends[k] - edge.start;
    // `across` is the edge's direction turned by a quarter to the left.
    along[k] = from_start.x * edge.across.y - from_start.y * edge.across.x;
    room[k] = sense * (edge.start.z + along[k] * edge.per_length * edge.along.z - ends[k].z) + k_plane_margin;
  }
  const double length = 1.0 / edge.per_length;
  if (!clip(along[0] + k_clip_slack, along[1] + k_clip_slack)) return;
  if (!clip(length - along[0] + k_clip_slack, length - along[1] + k_clip_slack)) return;
  if (!clip(room[0], room[1])) return;
  segments_.push_back({ends[0] + begin * (ends[1] - ends[0]), ends[0] + end * (ends[1] - ends[0])});
}

/// Where the shifted facet runs through another one: there it enters the solid or leaves it.
void FacetSplitter::add_crossing(FacetIndex other, const glm::dvec3& normal) {
  const auto& vertices = projected_.part().mesh().facets[other];
  const std::array<glm::dvec3, 3> corners = {projected_.point(vertices[0]), projected_.point(vertices[1]),
                                             projected_.point(vertices[2])};
  std::array<double, 3> heights{};
  for (std::size_t k = 0; k < 3; ++k) heights[k] = glm::dot(normal, corners[k] - corners_[0]);
  const auto [lowest, highest] = std::minmax({heights[0], heights[1], heights[2]});
  if (lowest > k_near || highest < -k_near) return;
  const glm::dvec3 normal_of_other = projected_.turned(projected_.part().geometry().normals[other]);
  std::array<double, 3> over_other{};
  for (std::size_t k = 0; k < 3; ++k) over_other[k] = glm::dot(normal_of_other, corners_[k] - corners[0]);
  close_sides_at(over_other);
  if (highest <= 0.0 || lowest >= 0.0) return;
  FacetCrossing crossing;
  if (triangle_crossing(
          {.a = corners_.data(), .b = corners.data(), .normal_b = normal_of_other, .slack = k_clip_slack},
          crossing)) {
    segments_.push_back(crossing);
  }
}

using Splitters = tbb::enumerable_thread_specific<FacetSplitter>;

Splitters splitters_for(const ProjectedPart& projected, const ExactQuery& query, const Progress& progress) {
  return Splitters([&] { return FacetSplitter(projected, query, progress); });
}

/// Calls visit(splitter, facet) for these facets from several threads, each with a splitter of its own.
template <typename Visit>
void visit_facets(Splitters& splitters, std::span<const FacetIndex> facets, const Progress& progress,
                  const Visit& visit) {
  tbb::parallel_for(std::size_t{0}, (facets.size() + k_grain - 1) / k_grain, [&](std::size_t task) {
    FacetSplitter& splitter = splitters.local();
    splitter.begin_task();
    const std::size_t end = std::min((task + 1) * k_grain, facets.size());
    for (std::size_t k = task * k_grain; k < end && !progress.cancelled(); ++k) {
      visit(splitter, facets[k]);
    }
  });
  progress.report("computing regions", 1.0);
}

/// All facets, those of `first` before the others.
std::vector<FacetIndex> facet_order(std::size_t count, std::span<const FacetIndex> first) {
  std::vector<FacetIndex> order(first.begin(), first.end());
  order.reserve(count);
  std::vector<bool> is_first(count, false);
  for (const FacetIndex facet : first) is_first[facet] = true;
  for (FacetIndex facet = 0; facet < count; ++facet) {
    if (!is_first[facet]) order.push_back(facet);
  }
  return order;
}

/// Sums in the order of the facets, so that the result does not depend on the number of threads.
ExactAreas summed(const ExactPart& part, const std::vector<FacetSplitter::Outcome>& outcomes) {
  ExactAreas result;
  const double square = part.frame().diagonal * part.frame().diagonal;
  result.facet_fractions.resize(outcomes.size());
  double squared_doubt = 0.0;
  for (std::size_t facet = 0; facet < outcomes.size(); ++facet) {
    const FacetSplitter::Outcome& outcome = outcomes[facet];
    const double area = part.geometry().areas[facet];
    double total = 0.0;
    for (const double of_region : outcome.areas) total += of_region;
    if (area <= 0.0 || total <= 0.0) continue;
    for (std::size_t region = 0; region < k_region_count; ++region) {
      const double share = outcome.areas[region] / total;
      result.facet_fractions[facet][region] = share;
      result.areas.values[region] += share * area;
    }
    if (outcome.facet_class == FacetClass::near_vertical) result.near_vertical_area += area;
    result.projected_core += outcome.projected_core * square;
    result.projected_cavity += outcome.projected_cavity * square;
    result.projected_doubt += outcome.projected_doubt;
    if (outcome.squared_doubt > 0.0) ++result.sampled_facets;
    squared_doubt += outcome.squared_doubt;
  }
  result.sampling_error = std::sqrt(squared_doubt) * square;
  result.projected_doubt += 2.0 * result.sampling_error;  // of either side
  return result;
}

/// The cells of these facets; what finds them is gone before they are put together.
template <typename Visit>
void add_cells(const ExactPart& part, const ExactQuery& query, std::span<const FacetIndex> facets,
               const Progress& progress, SplitAssembly& assembly, const Visit& visit) {
  const ProjectedPart projected(part, query.direction, progress);
  progress.report("computing regions", 0.0);
  Splitters splitters = splitters_for(projected, query, progress);
  visit_facets(splitters, facets, progress, [&](FacetSplitter& splitter, FacetIndex facet) {
    visit(facet, splitter.split(facet, true));
    assembly.add(facet, splitter.cells());
  });
}

}  // namespace

ExactAreas exact_areas(const ExactPart& part, const ExactQuery& query, const Progress& progress) {
  return *exact_areas_within(part, query, {}, progress);
}

ExactSplit exact_split(const ExactPart& part, const ExactQuery& query, const Progress& progress) {
  std::vector<FacetSplitter::Outcome> outcomes(part.mesh().facets.size());
  SplitAssembly assembly(part);
  add_cells(part, query, facet_order(outcomes.size(), {}), progress, assembly,
            [&](FacetIndex facet, const FacetSplitter::Outcome& outcome) { outcomes[facet] = outcome; });
  return {summed(part, outcomes), assembly.finish(progress)};
}

SplitMesh exact_split_around(const ExactPart& part, const ExactQuery& query,
                             std::span<const FacetIndex> facets, const Progress& progress) {
  // Points on the edges between them and others come from both.
  std::vector<FacetIndex> around(facets.begin(), facets.end());
  for (const FacetIndex facet : facets) {
    for (const std::uint32_t number : part.side_edges()[facet]) {
      if (number == ExactPart::k_no_edge) continue;
      const ExactEdge& edge = part.edges()[number];
      const FacetIndex other = edge.left == facet ? edge.right : edge.left;
      if (other != k_no_facet) around.push_back(other);
    }
  }
  std::ranges::sort(around);
  around.erase(std::unique(around.begin(), around.end()), around.end());
  SplitAssembly assembly(part);
  add_cells(part, query, around, progress, assembly, [](FacetIndex, const FacetSplitter::Outcome&) {});
  return assembly.finish(progress);
}

std::optional<ExactAreas> exact_areas_within(const ExactPart& part, const ExactQuery& query,
                                             const UndercutLimit& limit, const Progress& progress) {
  const ProjectedPart projected(part, query.direction, progress);
  progress.report("computing regions", 0.0);
  Splitters splitters = splitters_for(projected, query, progress);
  std::vector<FacetSplitter::Outcome> outcomes(part.mesh().facets.size());
  const std::vector<FacetIndex> order = facet_order(outcomes.size(), limit.first);
  // A sum in another order than that of the facets may be a little larger.
  const double square = part.frame().diagonal * part.frame().diagonal;
  const double most = limit.undercut / square + k_sum_rounding;
  double undercut = 0.0;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    end = std::isfinite(most) ? std::min(begin + k_block, order.size()) : order.size();
    const std::span<const FacetIndex> block(order.data() + begin, end - begin);
    visit_facets(splitters, block, progress, [&](FacetSplitter& splitter, FacetIndex facet) {
      outcomes[facet] = splitter.split(facet, false);
    });
    for (const FacetIndex facet : block)
      undercut += outcomes[facet].areas[static_cast<std::size_t>(Region::undercut)];
    if (undercut > most) return std::nullopt;
  }
  return summed(part, outcomes);
}

}  // namespace moldlight
