#include "mold/exact/projected_part.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <tuple>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace moldlight {

namespace {

/// |n . d| up to which a facet is seen from neither side. Far above the rounding of a normal in double.
constexpr double k_edge_on = 1e-12;
/// Curtains narrower than this hide nothing that has an area.
constexpr double k_narrowest = 1e-11;
constexpr std::size_t k_edges_a_task = 64;
/// An edge that more edges cross counts as seen.
constexpr std::size_t k_most_cuts = 256;
/// One that takes more facets to hide is cut.
constexpr int k_most_covering = 16;
constexpr double k_wall_sine = 0.02;
constexpr double k_contour_cells = 2.0, k_facet_cells = 0.25;  // cells an item
/// Edges whose ends agree to so many places per unit lie over one another.
constexpr double k_places = 0x1p40;
constexpr float k_single_rounding =
    1e-6F;  // more than that of a coordinate, and than what counts as touching
constexpr std::size_t k_projection_grain = 4096;
/// The budget: entries of grids that are looked at for all facets, and the cells that they may be cut into.
constexpr std::uint64_t k_always_work = 1'000'000, k_work_a_facet = 300;
constexpr std::uint32_t k_most_work = 1U << 30U, k_least_cells = 64, k_most_cells = 1U << 22U;
constexpr double k_always_cells = 100'000.0, k_cells_a_facet = 8.0;
constexpr double k_most_lattice = 16.0;
/// Facets that are looked at for the points of lattices, which stand where the grids are crowded.
constexpr double k_always_point_looks = 2e7, k_point_looks_a_facet = 2000.0;

std::uint8_t side_of(double sine) {
  if (sine > k_edge_on) return facing::k_up;
  return sine < -k_edge_on ? facing::k_down : 0;
}

/// A frame whose axes lie along most of the walls, so that these are in few cells of a grid.
MapFrame frame_along_walls(const FacetGeometry& geometry, const glm::dvec3& direction) {
  const MapFrame any = map_frame(direction);
  std::complex<double> sum = 0.0;  // of the fourth powers of the normals: a wall counts as one across it does
  for (std::size_t k = 0; k < geometry.areas.size(); ++k) {
    if (std::abs(glm::dot(geometry.normals[k], any.z)) > k_wall_sine) continue;
    const std::complex<double> level(glm::dot(geometry.normals[k], any.x),
                                     glm::dot(geometry.normals[k], any.y));
    const std::complex<double> square = level * level;
    sum += geometry.areas[k] * square * square;
  }
  const double turn = 0.25 * std::arg(sum);
  MapFrame frame{.x = std::cos(turn) * any.x + std::sin(turn) * any.y, .y = {}, .z = any.z};
  frame.y = glm::cross(frame.z, frame.x);
  return frame;
}

}  // namespace

ProjectedPart::ProjectedPart(const ExactPart& part, const glm::dvec3& direction, const Progress& progress)
    : part_(&part), frame_(frame_along_walls(part.geometry(), direction)) {
  const TriangleMesh& mesh = part.mesh();
  points_.resize(mesh.vertices.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points_.size(), k_projection_grain),
                    [&](const auto& range) {
                      for (std::size_t k = range.begin(); k < range.end(); ++k)
                        points_[k] = turned(part.positions()[k]);
                    });
  extents_.resize(mesh.facets.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, extents_.size(), k_projection_grain), [&](const auto& range) {
        for (std::size_t k = range.begin(); k < range.end(); ++k) {
          const auto& [a, b, c] = mesh.facets[k];
          extents_[k] = {
              .low = glm::vec3(glm::min(glm::min(points_[a], points_[b]), points_[c])) - k_single_rounding,
              .high = glm::vec3(glm::max(glm::max(points_[a], points_[b]), points_[c])) + k_single_rounding,
              .facing = side_of(glm::dot(part.geometry().normals[k], frame_.z))};
        }
      });
  box_ = {glm::dvec2(1e300), glm::dvec2(-1e300)};
  for (const Extent& extent : extents_) {
    box_.low = glm::min(box_.low, glm::dvec2(extent.low));
    box_.high = glm::max(box_.high, glm::dvec2(extent.high));
  }
  tbb::parallel_invoke(
      [&] {
        find_contour();
        leave_out_covered_edges();
        fill_contour_grid();
      },
      [&] { fill_facet_grid(facing::k_up); }, [&] { fill_facet_grid(facing::k_down); });
  leave_out_hidden_edges(progress);
  fill_contour_grid();
  plan_work(progress);
}

std::uint64_t ProjectedPart::work_budget() const {
  return static_cast<std::uint64_t>(part_->effort() *
                                    static_cast<double>(k_always_work + k_work_a_facet * extents_.size()));
}

/// Most of all parts need a few hundred looks a facet. Where all of them need more than the budget, those
/// that need most are sampled; how many are is known by the part and the direction alone.
void ProjectedPart::plan_work(const Progress& progress) {
  const std::size_t facets = extents_.size();
  std::vector<std::uint32_t> work(part_->crossings_known() ? facets : 0);  // else all are sampled
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, work.size(), k_projection_grain), [&](const auto& range) {
        for (std::size_t k = range.begin(); k < range.end() && !progress.cancelled(); ++k) {
          const auto& [a, b, c] = part_->mesh().facets[k];
          const std::array<glm::dvec2, 3> corners = {glm::dvec2(points_[a]), glm::dvec2(points_[b]),
                                                     glm::dvec2(points_[c])};
          std::size_t looks =
              contour_grid_.count_items(corners) + part_->crossings(static_cast<FacetIndex>(k)).size();
          if (!part_->knows_in_front()) {
            for (const ProjectionGrid& grid : facet_grids_) looks += grid.count_items(corners);
          }
          work[k] = static_cast<std::uint32_t>(std::min<std::size_t>(looks, k_most_work));
        }
      });
  progress.report("finding contour edges", 1.0);
  std::uint64_t sum = 0;
  for (const std::uint32_t looks : work) sum += looks;
  const std::uint64_t budget = work_budget();
  if (sum <= budget && part_->crossings_known()) return;
  proportionate_ = false;
  std::vector<std::uint32_t> sorted = work;
  std::ranges::sort(sorted);
  std::uint64_t within = 0;
  std::size_t kept = 0;
  if (part_->crossings_known()) {
    while (kept < facets && within + sorted[kept] <= budget) within += sorted[kept++];
    // Equal ones are treated alike.
    while (kept > 0 && kept < facets && sorted[kept - 1] == sorted[kept]) within -= sorted[--kept];
    most_work_ = kept == 0 ? 0 : sorted[kept - 1];
  }
  const double cells = part_->effort() * (k_always_cells + k_cells_a_facet * static_cast<double>(facets));
  cells_a_work_ = cells / std::max(1.0, static_cast<double>(within));
  work_ = std::move(work);
  std::uint64_t points_looks = 0;  // of a point a facet
  for (FacetIndex facet = 0; facet < facets; ++facet) {
    if (work_on(facet).sampled) points_looks += looks_at_middle(facet);
  }
  const double looks =
      part_->effort() * (k_always_point_looks + k_point_looks_a_facet * static_cast<double>(facets));
  const double samples = std::min(cells / static_cast<double>(std::max<std::size_t>(facets - kept, 1)),
                                  looks / static_cast<double>(std::max<std::uint64_t>(points_looks, 1)));
  lattice_lines_ = static_cast<std::size_t>(
      std::clamp(std::sqrt(samples), 1.0, k_most_lattice * std::sqrt(part_->effort())));
}

std::size_t ProjectedPart::looks_at_middle(FacetIndex facet) const {
  const auto& [a, b, c] = part_->mesh().facets[facet];
  const glm::dvec2 middle((points_[a] + points_[b] + points_[c]) / 3.0);
  return facet_grids_[0].items_at(middle).size() + facet_grids_[1].items_at(middle).size();
}

ProjectedPart::FacetWork ProjectedPart::work_on(FacetIndex facet) const {
  if (proportionate_) return {.sampled = false, .most_cells = k_most_cells};
  if (!part_->crossings_known() || work_[facet] > most_work_)
    return {.sampled = true, .most_cells = k_most_cells};
  return {.sampled = false,
          .most_cells =
              k_least_cells + static_cast<std::uint32_t>(
                                  std::min(cells_a_work_ * work_[facet], static_cast<double>(k_most_cells)))};
}

void ProjectedPart::fill_contour_grid() {
  const double cells = k_contour_cells * static_cast<double>(contour_.size());
  std::vector<std::uint32_t> all;
  for (std::uint32_t k = 0; k < contour_.size(); ++k) all.push_back(k);
  contour_grid_.fill(box_, cells, all, [&](std::size_t k, glm::dvec2* corners) {
    corners[0] = glm::dvec2(contour_[k].start);
    corners[1] = glm::dvec2(contour_[k].start + contour_[k].along);
    return std::size_t{2};
  });
}

void ProjectedPart::fill_facet_grid(std::uint8_t facing) {
  std::vector<std::uint32_t> facets;
  for (std::uint32_t k = 0; k < extents_.size(); ++k) {
    if (extents_[k].facing == facing && part_->first_equal(k) == k) facets.push_back(k);
  }
  const TriangleMesh& mesh = part_->mesh();
  const double cells = k_facet_cells * static_cast<double>(facets.size());
  facet_grids_[facing == facing::k_up ? 0 : 1].fill(box_, cells, facets,
                                                    [&](std::size_t k, glm::dvec2* corners) {
                                                      for (std::size_t c = 0; c < 3; ++c)
                                                        corners[c] = glm::dvec2(points_[mesh.facets[k][c]]);
                                                      return std::size_t{3};
                                                    });
}

void ProjectedPart::find_contour() {
  for (const ExactEdge& edge : part_->edges()) {
    std::uint8_t ends = facing::k_up | facing::k_down;
    if (edge.kind != EdgeKind::irregular) {
      const std::uint8_t left = extents_[edge.left].facing, right = extents_[edge.right].facing;
      if (left == right) continue;
      // Where the solid fills more than a half space nothing appears from behind, unless surfaces cross.
      if (edge.kind == EdgeKind::concave && part_->regular()) continue;
      ends = left | right;
    }
    ContourEdge contour;
    contour.start = points_[edge.a];
    contour.along = points_[edge.b] - contour.start;
    const glm::dvec2 level(contour.along);
    const double length = glm::length(level);
    if (length < k_narrowest) continue;
    contour.per_length = 1.0 / length;
    contour.across = glm::dvec2(-level.y, level.x) * contour.per_length;
    contour_.push_back(contour);
    const auto [low, high] = std::minmax({points_[edge.a].z, points_[edge.b].z});
    contour_extents_.push_back({.low = static_cast<float>(low) - k_single_rounding,
                                .high = static_cast<float>(high) + k_single_rounding,
                                .for_below = ends,
                                .for_above = ends,
                                .pierces = edge.kind == EdgeKind::irregular ||
                                           !part_->crossings(edge.left).empty() ||
                                           !part_->crossings(edge.right).empty()});
  }
}

/// Walls along the direction have an edge above and one below, stacks many: of those in one place the curtain
/// of the highest covers the curtains of the others, seen from below.
void ProjectedPart::leave_out_covered_edges() {
  struct Place {
    std::array<std::int64_t, 4> ends;  // of the projection, the lesser first
    std::array<double, 2> heights;     // there
    std::uint32_t edge;
  };
  std::vector<Place> places;
  places.reserve(contour_.size());
  for (std::uint32_t k = 0; k < contour_.size(); ++k) {
    const glm::dvec3 start = contour_[k].start, end = start + contour_[k].along;
    const auto place = [](double x) { return std::llround(x * k_places); };
    Place at{{place(start.x), place(start.y), place(end.x), place(end.y)}, {start.z, end.z}, k};
    if (std::tie(at.ends[2], at.ends[3]) < std::tie(at.ends[0], at.ends[1])) {
      std::swap(at.ends[0], at.ends[2]);
      std::swap(at.ends[1], at.ends[3]);
      std::swap(at.heights[0], at.heights[1]);
    }
    places.push_back(at);
  }
  std::ranges::sort(places, {}, [](const Place& place) { return std::pair(place.ends, place.edge); });
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && places[end].ends == places[begin].ends) ++end;
    if (end - begin == 1) continue;
    const std::span<const Place> stack(places.data() + begin, end - begin);
    for (const std::uint8_t side : {facing::k_up, facing::k_down}) {
      for (const Sense sense : {1, -1}) {
        const auto asked = [&](const Place& p) -> std::uint8_t& {
          ContourExtent& extent = contour_extents_[p.edge];
          return sense > 0 ? extent.for_below : extent.for_above;
        };
        const Place* outermost = nullptr;
        for (const Place& p : stack) {
          const auto height = [&](const Place& q) { return sense * (q.heights[0] + q.heights[1]); };
          if ((asked(p) & side) != 0 && (outermost == nullptr || height(p) > height(*outermost)))
            outermost = &p;
        }
        for (const Place& p : stack) {
          if (&p == outermost || (asked(p) & side) == 0) continue;
          if (sense * (outermost->heights[0] - p.heights[0]) >= 0.0 &&
              sense * (outermost->heights[1] - p.heights[1]) >= 0.0) {
            asked(p) &= static_cast<std::uint8_t>(~side);
          }
        }
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < contour_.size(); ++k) {
    if ((contour_extents_[k].for_below | contour_extents_[k].for_above) == 0) continue;
    contour_[kept] = contour_[k];
    contour_extents_[kept++] = contour_extents_[k];
  }
  contour_.resize(kept);
  contour_extents_.resize(kept);
}

/// An edge that is hidden hides nothing: what hides it does, on both of its sides. Along the others only the
/// stretches count that are seen.
void ProjectedPart::leave_out_hidden_edges(const Progress& progress) {
  struct Found {
    std::uint32_t edge;
    std::array<bool, 2> senses;  // for surface below, above
    Stretch stretch;
  };
  // To look at every edge that crosses another takes too long where all are as long as the part.
  std::uint64_t looks = 0;
  for (std::size_t k = 0; k < contour_.size() && looks <= work_budget(); ++k) {
    const ContourEdge& edge = contour_[k];
    const std::array<glm::dvec2, 2> ends = {glm::dvec2(edge.start), glm::dvec2(edge.start + edge.along)};
    looks += contour_grid_.count_items(ends);
  }
  edges_proportionate_ = looks <= work_budget();
  std::vector<std::vector<Found>> found((contour_.size() + k_edges_a_task - 1) / k_edges_a_task);
  tbb::enumerable_thread_specific<EdgeSearch> searches(
      EdgeSearch{std::vector<std::uint32_t>(contour_.size(), ~0U), {}});
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t task) {
    EdgeSearch& search = searches.local();
    search.hidden_by = {k_no_facet, k_no_facet};  // so that no thread's past shows
    Visible visible;
    const auto& [below, above] = visible;
    const std::size_t end = std::min((task + 1) * k_edges_a_task, contour_.size());
    for (std::size_t k = task * k_edges_a_task; k < end && !progress.cancelled(); ++k) {
      const auto edge = static_cast<std::uint32_t>(k);
      find_visible(edge, search, visible);
      const auto whole = [](const std::vector<Stretch>& v) {
        return v.size() == 1 && v.front().from <= 0.0 && v.front().to >= 1.0;
      };
      if (whole(below) && whole(above)) {
        found[task].push_back({edge, {true, true}, below.front()});
        continue;
      }
      for (const Stretch& stretch : below) found[task].push_back({edge, {true, false}, stretch});
      for (const Stretch& stretch : above) found[task].push_back({edge, {false, true}, stretch});
    }
  });
  progress.report("finding contour edges", 1.0);
  const std::vector<ContourEdge> edges = std::move(contour_);
  const std::vector<ContourExtent> extents = std::move(contour_extents_);
  contour_.clear();
  contour_extents_.clear();
  std::size_t count = 0;
  for (const std::vector<Found>& some : found) count += some.size();
  contour_.reserve(count);
  contour_extents_.reserve(count);
  for (const std::vector<Found>& some : found) {
    for (const Found& one : some) {
      ContourEdge edge = edges[one.edge];
      ContourExtent extent = extents[one.edge];
      if (!one.senses[0]) extent.for_below = 0;
      if (!one.senses[1]) extent.for_above = 0;
      if (one.stretch.from > 0.0 || one.stretch.to < 1.0) {
        const double share = one.stretch.to - one.stretch.from;
        edge.start += one.stretch.from * edge.along;
        edge.along *= share;
        edge.per_length /= share;
        const auto [low, high] = std::minmax({edge.start.z, edge.start.z + edge.along.z});
        extent.low = static_cast<float>(low) - k_single_rounding;
        extent.high = static_cast<float>(high) + k_single_rounding;
      }
      contour_.push_back(edge);
      contour_extents_.push_back(extent);
    }
  }
}

/// Up to which share of the edge a facet hides it beyond doubt, from the share `from` on; `from` itself if
/// not even there.
double ProjectedPart::hidden_until(FacetIndex facet, const ContourEdge& edge, Sense sense,
                                   double from) const {
  const auto& corners = part_->mesh().facets[facet];
  const double turn = extents_[facet].facing == facing::k_up ? 1.0 : -1.0;
  const double twice_area = twice_area_of(facet);
  std::array<std::array<double, 4>, 2> room{};  // at both ends: inside the three sides, and beyond
  for (std::size_t end = 0; end < 2; ++end) {
    const glm::dvec3 point = edge.start + (end == 0 ? from : 1.0) * edge.along;
    double rise = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& a = points_[corners[k]];
      const glm::dvec3& b = points_[corners[(k + 1) % 3]];
      const double span = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
      room[end][k] = span * turn;
      rise += span * (points_[corners[(k + 2) % 3]].z - point.z);
    }
    room[end][3] = rise * turn * sense - k_plane_margin * twice_area;
  }
  double until = 1.0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (room[0][k] < 0.0) return from;
    if (room[1][k] < 0.0) until = std::min(until, room[0][k] / (room[0][k] - room[1][k]));
  }
  return from + until * (1.0 - from);
}

/// True if facets hide the whole edge, one after the other; asks a few of them only.
bool ProjectedPart::surely_hidden(const ContourEdge& edge, Sense sense, FacetIndex& last) const {
  const double step = k_clip_slack * edge.per_length;
  double from = 0.0;
  for (int facets = 0; facets < k_most_covering && from < 1.0; ++facets) {
    const double at = std::min(from + step, 1.0);
    if (!blocked({.point = edge.start + at * edge.along, .sense = sense, .clearly = true}, last))
      return false;
    const double until = hidden_until(last, edge, sense, at);
    if (until <= from) return false;
    from = until;
  }
  return from >= 1.0;
}

/// Cuts the edge where contour edges beyond it cross it, and asks for each stretch once.
void ProjectedPart::find_visible(std::uint32_t number, EdgeSearch& search, Visible& visible) const {
  const ContourEdge& edge = contour_[number];
  const ContourExtent& extent = contour_extents_[number];
  // Facets are as crowded as edges are.
  const bool all_seen = extent.pierces || !edges_proportionate_;
  const std::array<bool, 2> asked = {
      extent.for_below != 0 && (all_seen || !surely_hidden(edge, 1, search.hidden_by[0])),
      extent.for_above != 0 && (all_seen || !surely_hidden(edge, -1, search.hidden_by[1]))};
  const std::array<std::uint8_t, 2> facings = {blockers(1, false), blockers(-1, false)};
  const glm::dvec3 end = edge.start + edge.along;
  std::array<std::vector<double>, 2> cuts;
  const std::array<glm::dvec2, 2> footprint = {glm::dvec2(edge.start), glm::dvec2(end)};
  const auto add_cut = [&](std::uint32_t k) {
    const ContourExtent& other = contour_extents_[k];
    const bool over = asked[0] && (other.for_below & facings[0]) != 0 && other.high >= extent.low &&
                      cuts[0].size() <= k_most_cuts;
    const bool under = asked[1] && (other.for_above & facings[1]) != 0 && other.low <= extent.high &&
                       cuts[1].size() <= k_most_cuts;
    if (!(over || under) || k == number || search.met[k] == number) return;
    search.met[k] = number;
    const ContourEdge& beyond = contour_[k];
    const double from = glm::dot(beyond.across, glm::dvec2(edge.start - beyond.start));
    const double to = glm::dot(beyond.across, glm::dvec2(end - beyond.start));
    if ((from > 0.0) == (to > 0.0) || std::abs(from - to) < k_narrowest) return;
    const double at = from / (from - to);
    if (at <= 0.0 || at >= 1.0) return;
    const glm::dvec3 place = edge.start + at * edge.along - beyond.start;
    const double along = place.x * beyond.across.y - place.y * beyond.across.x;
    if (along < -k_clip_slack || along * beyond.per_length > 1.0 + k_clip_slack * beyond.per_length) return;
    const double height = along * beyond.per_length * beyond.along.z - place.z;
    if (over && height >= -k_plane_margin) cuts[0].push_back(at);
    if (under && height <= k_plane_margin) cuts[1].push_back(at);
  };
  if (!all_seen && (asked[0] || asked[1])) contour_grid_.for_each_item(footprint, add_cut);
  const double shortest = k_clip_slack * edge.per_length;
  for (const std::size_t side : {0U, 1U}) {
    std::vector<double>& places = cuts[side];
    visible[side].clear();
    if (!asked[side]) continue;
    if (all_seen || places.size() > k_most_cuts) {
      visible[side].push_back({0.0, 1.0});
      continue;
    }
    places.insert(places.end(), {0.0, 1.0});
    std::sort(places.begin(), places.end());
    FacetIndex last = k_no_facet;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      if (places[k + 1] - places[k] < shortest) continue;
      const glm::dvec3 middle = edge.start + 0.5 * (places[k] + places[k + 1]) * edge.along;
      if (blocked({.point = middle, .sense = side == 0 ? 1 : -1, .clearly = true}, last)) continue;
      // A little longer, so that stretches that meet leave nothing between them.
      const Stretch stretch{places[k] - shortest, places[k + 1] + shortest};
      if (!visible[side].empty() && visible[side].back().to >= stretch.from) {
        visible[side].back().to = stretch.to;
      } else {
        visible[side].push_back(stretch);
      }
    }
  }
}

}  // namespace moldlight
