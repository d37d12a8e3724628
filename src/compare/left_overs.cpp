#include "compare/left_overs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

namespace {

/// Along the extent; a cell is never smaller than what polygons reach.
constexpr double k_cells = 128.0;
constexpr double k_places_a_polygon = 256.0, k_always_places = 4e6;
constexpr std::size_t k_steps_between = 64;  // two looks at whether to go on

struct InCell {
  std::uint64_t cell;
  std::uint32_t polygon;

  auto operator<=>(const InCell&) const = default;
};

bool overlap(const Bounds& a, const Bounds& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.min[axis] > b.max[axis] || b.min[axis] > a.max[axis]) return false;
  return true;
}

/// 21 bits an axis; what lies farther out shares cells, which costs time alone.
std::uint64_t cell_number(const glm::i64vec3& cell) {
  constexpr std::uint64_t k_mask = (1ULL << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x) & k_mask) << 42 |
         (static_cast<std::uint64_t>(cell.y) & k_mask) << 21 | (static_cast<std::uint64_t>(cell.z) & k_mask);
}

/// At least so large, and so that the boxes are in some tens of cells each: one polygon may be as long as the
/// part, or longer where the two parts are of very different size.
double cell_size(const std::vector<Bounds>& boxes, double least) {
  const double most = k_places_a_polygon * static_cast<double>(boxes.size()) + k_always_places;
  for (double size = std::max(least, 1e-300);; size *= 2.0) {
    double places = 0.0;
    for (const Bounds& box : boxes) {
      if (box.min.x > box.max.x) continue;
      const glm::dvec3 cells = (box.max - box.min) / size + 1.0;
      places += cells.x * cells.y * cells.z;
    }
    if (!(places > most)) return size;
  }
}

/// Calls `touch` for pairs whose rims come as near to each other as `reach` says, which is asked first and is
/// negative for pairs that do not matter, and at most the sum of theirs; in an order that depends on the
/// polygons alone, a pair perhaps several times. `extent` is about that of all of them. Throws Cancelled.
void visit_touching(const std::vector<ReachingPolygon>& polygons, double extent,
                    const std::function<double(std::uint32_t, std::uint32_t)>& reach,
                    const std::function<void(std::uint32_t, std::uint32_t)>& touch,
                    const Progress& progress) {
  double greatest = 0.0;
  for (const ReachingPolygon& one : polygons) greatest = std::max(greatest, one.reach);
  std::vector<Bounds> boxes(polygons.size());
  for (std::uint32_t k = 0; k < polygons.size(); ++k) {
    if (polygons[k].polygon->empty()) continue;
    for (const glm::dvec3& corner : *polygons[k].polygon) boxes[k].add(corner);
    boxes[k].min -= polygons[k].reach;
    boxes[k].max += polygons[k].reach;
  }
  const double size = cell_size(boxes, std::max(extent / k_cells, 4.0 * greatest));
  std::vector<InCell> places;
  const auto cell_at = [size](double at) { return static_cast<std::int64_t>(std::floor(at / size)); };
  for (std::uint32_t k = 0; k < polygons.size(); ++k) {
    if (polygons[k].polygon->empty()) continue;
    const glm::dvec3 &low = boxes[k].min, &high = boxes[k].max;
    for (std::int64_t x = cell_at(low.x); x <= cell_at(high.x); ++x)
      for (std::int64_t y = cell_at(low.y); y <= cell_at(high.y); ++y)
        for (std::int64_t z = cell_at(low.z); z <= cell_at(high.z); ++z)
          places.push_back({cell_number({x, y, z}), k});
  }
  std::ranges::sort(places);
  for (std::size_t first = 0, last = 0; first < places.size(); first = last) {
    while (last < places.size() && places[last].cell == places[first].cell) ++last;
    const std::span here(places.data() + first, last - first);
    std::ranges::stable_sort(here, {}, [&](const InCell& one) { return boxes[one.polygon].min.x; });
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (i % k_steps_between == 0)
        progress.report("finding what changed",
                        static_cast<double>(first) / static_cast<double>(places.size()));
      for (std::size_t k = i + 1; k < here.size(); ++k) {
        const std::uint32_t a = here[i].polygon, b = here[k].polygon;
        if (boxes[b].min.x > boxes[a].max.x) break;
        if (!overlap(boxes[a], boxes[b])) continue;
        const double within = reach(a, b);
        if (within >= 0.0 && rims_touch(*polygons[a].polygon, *polygons[b].polygon, within)) touch(a, b);
      }
    }
  }
}

/// Share of a face's area above which all of its changes are one.
constexpr double k_changed_face = 0.3;
/// Of its volume, what a place may lack to be closed by itself.
constexpr double k_closed_share = 0.01;
/// Rims of what is gone or new lie as far beside it, in tolerances.
constexpr double k_rim_tolerances = 2.0;

VolumeQuestion volume_question(const LeftOvers& left, std::uint32_t places,
                               const std::vector<std::uint32_t>& place_of) {
  VolumeQuestion question{.bits = {}, .labels = places, .margin = k_rim_tolerances * left.tolerance().apart};
  // Of a piece that is left over elsewhere, what the tolerance explains leans away from where it was; on flat
  // surface what tessellations explain is beside another change.
  std::map<std::pair<bool, PieceIndex>, std::uint32_t> of_piece;
  for (std::size_t k = 0; k < left.count(); ++k)
    if (left.is_certain(k) && place_of[k] != k_no_change)
      of_piece[{left.is_of_a(k), left[k].piece}] = place_of[k];
  for (std::size_t k = 0; k < left.count(); ++k) {
    const LeftOver& one = left[k];
    const double chord = left.side(k).chords().normal[left.side(k).facet(one.piece)];
    std::uint32_t place = place_of[k];
    if (place == k_no_change && (chord > 0.0 || one.explained <= left.tolerance().apart)) {
      const auto found = of_piece.find({left.is_of_a(k), one.piece});
      if (found != of_piece.end()) place = found->second;
    }
    if (place != k_no_change) question.bits.push_back({CellBit::Kind::changed, one.polygon, place});
    if (left.is_certain(k) || chord <= 0.0) continue;
    // Both parts' facets cut about as much off round surface where they are as wide.
    question.bits.push_back({CellBit::Kind::doubt,
                             {polygon_centre(one.polygon)},
                             0,
                             (left.is_of_a(k) ? 1.0 : -1.0) * one.area * chord});
    if (place == k_no_change)
      question.reach = question.margin + left.a().chords().greatest + left.b().chords().greatest;
  }
  return question;
}

/// The place whose box is nearest to that of `place`; itself where it is the only one.
std::uint32_t nearest_place(const std::vector<Bounds>& boxes, std::uint32_t place) {
  std::uint32_t nearest = place;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t other = 0; other < boxes.size(); ++other) {
    if (other == place || boxes[other].min.x > boxes[other].max.x) continue;
    const glm::dvec3 gap =
        glm::max(glm::max(boxes[other].min - boxes[place].max, boxes[place].min - boxes[other].max), 0.0);
    if (glm::length(gap) >= least) continue;
    least = glm::length(gap);
    nearest = other;
  }
  return nearest;
}

}  // namespace

UnionFind joined_where_touching(const std::vector<ReachingPolygon>& polygons, double extent,
                                const Progress& progress) {
  UnionFind joined(polygons.size());
  visit_touching(
      polygons, extent,
      [&](std::uint32_t a, std::uint32_t b) {
        return joined.find(a) == joined.find(b) ? -1.0 : polygons[a].reach + polygons[b].reach;
      },
      [&](std::uint32_t a, std::uint32_t b) { joined.join(a, b); }, progress);
  return joined;
}

LeftOvers::LeftOvers(const OverlaySide& a, const OverlaySide& b, const OverlayTolerance& tolerance,
                     const Overlay& of_a, const Overlay& of_b)
    : a_(a), b_(b), tolerance_(tolerance), split_(of_a.left.size()) {
  for (const LeftOver& one : of_a.left) all_.push_back(&one);
  for (const LeftOver& one : of_b.left) all_.push_back(&one);
}

UnionFind LeftOvers::joined(const Progress& progress) const {
  UnionFind sets = joined_where_touching(polygons(), extent(), progress);
  join_faces(a_, 0, split_, sets);
  join_faces(b_, split_, count(), sets);
  return sets;
}

void LeftOvers::add_explained(std::vector<std::uint32_t>& place_of, const Progress& progress) const {
  if (std::ranges::all_of(place_of, [](std::uint32_t place) { return place == k_no_change; })) return;
  std::vector<ReachingPolygon> rims;
  for (const LeftOver* one : all_) rims.push_back({&one->polygon, tolerance_.rounding});
  const std::vector<std::uint32_t> certain = place_of;
  visit_touching(
      rims, extent(),
      [&](std::uint32_t a, std::uint32_t b) {
        const bool one_has = (certain[a] == k_no_change) != (certain[b] == k_no_change);
        const std::uint32_t open = certain[a] == k_no_change ? a : b;
        return one_has && !is_certain(open) && is_of_a(a) == is_of_a(b) ? 2.0 * tolerance_.rounding : -1.0;
      },
      [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t open = certain[a] == k_no_change ? a : b;
        place_of[open] = std::min(place_of[open], certain[open == a ? b : a]);
      },
      progress);
}

bool LeftOvers::is_rim(std::size_t k) const {
  constexpr double k_widths = 3.0;
  const ConvexPolygon& polygon = all_[k]->polygon;
  return 2.0 * all_[k]->area <= k_widths * all_[k]->explained * reach_from(polygon.front(), polygon);
}

double LeftOvers::extent() const { return std::max(a_.model().frame.diagonal, b_.model().frame.diagonal); }

/// None for what is explained.
std::vector<ReachingPolygon> LeftOvers::polygons() const {
  static const ConvexPolygon k_none;
  std::vector<ReachingPolygon> reaching;
  for (std::size_t k = 0; k < count(); ++k) {
    const OverlaySide& side = is_of_a(k) ? a_ : b_;
    const double chord = side.chords().lateral[side.facet(all_[k]->piece)];
    reaching.push_back({is_certain(k) ? &all_[k]->polygon : &k_none, tolerance_.apart + 1.5 * chord});
  }
  return reaching;
}

/// A face most of which changed is one place, though it may have stayed somewhere: a round wall that moved.
void LeftOvers::join_faces(const OverlaySide& side, std::size_t first, std::size_t last,
                           UnionFind& sets) const {
  std::vector<double> whole(side.faces().count(), 0.0), changed(whole);
  const auto face_of = [&](std::size_t k) { return side.faces().of_facet[side.facet(all_[k]->piece)]; };
  for (FacetIndex facet = 0; facet < side.faces().of_facet.size(); ++facet)
    whole[side.faces().of_facet[facet]] += side.model().geometry.areas[facet];
  for (std::size_t k = first; k < last; ++k)
    if (is_certain(k)) changed[face_of(k)] += all_[k]->area;
  std::vector<std::uint32_t> representative(whole.size(), k_no_change);
  for (std::size_t k = first; k < last; ++k) {
    const std::uint32_t face = face_of(k);
    if (!is_certain(k) || changed[face] < k_changed_face * whole[face]) continue;
    if (representative[face] == k_no_change) representative[face] = static_cast<std::uint32_t>(k);
    sets.join(representative[face], static_cast<std::uint32_t>(k));
  }
}

PlaceVolumes volumes_of_places(const LeftOvers& left, std::uint32_t places,
                               std::vector<std::uint32_t>& place_of, const Progress& progress) {
  PlaceVolumes volumes;
  volumes.joined.assign(places, false);
  for (bool open = true; open;) {
    open = false;
    DividedVolume divided = divided_volume(left.a().model().part.mesh, left.b().model().part.mesh,
                                           volume_question(left, places, place_of), progress);
    std::vector<Bounds> boxes(places);
    std::vector<double> areas(places, 0.0);
    for (std::size_t k = 0; k < left.count(); ++k) {
      if (place_of[k] == k_no_change) continue;
      areas[place_of[k]] += left[k].area;
      for (const glm::dvec3& corner : left[k].polygon) boxes[place_of[k]].add(corner);
    }
    UnionFind sets(places);
    for (std::uint32_t place = 0; place < places; ++place) {
      const double allowed =
          k_closed_share * std::abs(divided.of_label[place].volume) + left.tolerance().apart * areas[place];
      const std::uint32_t other = nearest_place(boxes, place);
      if (divided.open[place] <= allowed || other == place) continue;
      sets.join(place, other);
      volumes.joined[place] = volumes.joined[other] = open = true;
    }
    for (std::uint32_t& place : place_of)
      if (place != k_no_change) place = sets.find(place);
    volumes.of_place = std::move(divided.of_label);
    volumes.elsewhere = divided.elsewhere;
  }
  return volumes;
}

}  // namespace moldlight
