#include "compare/left_overs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_few_rims = 64;           // rims that are asked pair by pair
constexpr double k_most_growth = 1.7;            // of their number, where a plane divides them
constexpr int k_most_divisions = 60;             // one after the other
constexpr std::size_t k_pairs_between = 10'000;  // two looks at whether to go on
constexpr double k_cell_rounding = 1e-12;        // of the greatest coordinate

bool overlap(const Bounds& a, const Bounds& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.min[axis] > b.max[axis] || b.min[axis] > a.max[axis]) return false;
  return true;
}

/// Finds pairs of polygons whose rims may come as near to each other as both reach: planes divide space, with
/// what of each rim is on either side, until few are left in a cell, or as many as before. So rims as long as
/// the part meet only what is beside them.
class NearRims {
 public:
  /// Calls visit(a, b) once or more a pair; `kinds`, where there are any: of pairs of one kind none matters.
  NearRims(std::span<const ReachingPolygon> polygons, std::span<const char> kinds,
           const std::function<void(std::uint32_t, std::uint32_t)>& visit, const Progress& progress)
      : polygons_(polygons), kinds_(kinds), visit_(visit), progress_(progress) {
    constexpr double k_infinity = std::numeric_limits<double>::infinity();
    const Bounds everywhere{glm::dvec3(-k_infinity), glm::dvec3(k_infinity)};
    std::vector<Rim> all;
    for (std::uint32_t k = 0; k < polygons.size(); ++k)
      for (const glm::dvec3& corner : *polygons[k].polygon)
        for (int axis = 0; axis < 3; ++axis)
          rounding_ = std::max(rounding_, k_cell_rounding * std::abs(corner[axis]));
    for (std::uint32_t k = 0; k < polygons.size(); ++k) add(k, everywhere, all);
    divide(std::move(all), everywhere, 0);
  }

 private:
  /// What of a polygon's rim is in a cell, with its reach.
  struct Rim {
    std::uint32_t polygon;
    Bounds box;
  };

  void add(std::uint32_t polygon, const Bounds& cell, std::vector<Rim>& rims) const {
    const ConvexPolygon& corners = *polygons_[polygon].polygon;
    const double reach = polygons_[polygon].reach + rounding_;
    Rim rim{polygon, {}};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const glm::dvec3 &from = corners[k], along = corners[(k + 1) % corners.size()] - from;
      double first = 0.0, last = 1.0;
      for (int axis = 0; axis < 3; ++axis) {
        double enters = cell.min[axis] - reach - from[axis], leaves = cell.max[axis] + reach - from[axis];
        if (along[axis] == 0.0) {
          if (enters > 0.0 || leaves < 0.0) last = -1.0;
          continue;
        }
        enters /= along[axis];
        leaves /= along[axis];
        first = std::max(first, std::min(enters, leaves));
        last = std::min(last, std::max(enters, leaves));
      }
      if (first > last) continue;
      rim.box.add(from + first * along);
      rim.box.add(from + last * along);
    }
    if (rim.box.min.x > rim.box.max.x) return;
    rim.box.min -= reach;
    rim.box.max += reach;
    rims.push_back(rim);
  }

  void divide(std::vector<Rim> some, const Bounds& cell, int divisions) {
    const auto is_first_kind = [&](const Rim& rim) {
      return kinds_[rim.polygon] == kinds_[some.front().polygon];
    };
    if (some.empty() || (!kinds_.empty() && std::ranges::all_of(some, is_first_kind))) return;
    if (progress_.cancelled()) throw Cancelled();
    for (const int axis : {0, 1, 2}) {
      if (some.size() <= k_few_rims || divisions >= k_most_divisions) break;
      const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
      const auto centre = [&](const Rim& rim) { return rim.box.min[axis] + rim.box.max[axis]; };
      std::ranges::nth_element(some, middle, {}, centre);
      const double at = 0.5 * centre(*middle);
      const auto is_below = [&](const Rim& rim) { return rim.box.max[axis] < at; };
      const auto is_above = [&](const Rim& rim) { return rim.box.min[axis] >= at; };
      const auto below_alone = std::ranges::count_if(some, is_below),
                 above_alone = std::ranges::count_if(some, is_above);
      const auto count = static_cast<std::ptrdiff_t>(some.size());
      if (static_cast<double>(2 * count - below_alone - above_alone) >
              k_most_growth * static_cast<double>(count) ||
          below_alone == 0 || above_alone == 0)
        continue;
      Bounds low = cell, high = cell;
      low.max[axis] = high.min[axis] = at;
      std::vector<Rim> below, above;
      for (const Rim& rim : some) {
        if (is_below(rim)) {
          below.push_back(rim);
        } else if (is_above(rim)) {
          above.push_back(rim);
        } else {
          add(rim.polygon, low, below);
          add(rim.polygon, high, above);
        }
      }
      some = {};
      divide(std::move(below), low, divisions + 1);
      divide(std::move(above), high, divisions + 1);
      return;
    }
    ask(some);
  }

  void ask(std::vector<Rim>& some) {
    std::ranges::sort(some, {}, [](const Rim& rim) { return std::pair(rim.box.min.x, rim.polygon); });
    for (std::size_t i = 0; i < some.size(); ++i) {
      const Rim& a = some[i];
      for (std::size_t k = i + 1; k < some.size() && some[k].box.min.x <= a.box.max.x; ++k) {
        const Rim& b = some[k];
        if (++asked_ % k_pairs_between == 0 && progress_.cancelled()) throw Cancelled();
        if ((kinds_.empty() || kinds_[a.polygon] != kinds_[b.polygon]) && overlap(a.box, b.box))
          visit_(a.polygon, b.polygon);
      }
    }
  }

  std::span<const ReachingPolygon> polygons_;
  std::span<const char> kinds_;
  const std::function<void(std::uint32_t, std::uint32_t)>& visit_;
  const Progress& progress_;
  double rounding_ = 0.0;
  std::size_t asked_ = 0;
};

/// Calls `touch`, once or more, for pairs whose rims come as near to each other as `reach` says, which is
/// asked first and is negative for pairs that do not matter, and at most the sum of theirs. `kinds` as of
/// NearRims. Throws Cancelled.
void visit_touching(const std::vector<ReachingPolygon>& polygons, std::span<const char> kinds,
                    const std::function<double(std::uint32_t, std::uint32_t)>& reach,
                    const std::function<void(std::uint32_t, std::uint32_t)>& touch,
                    const Progress& progress) {
  progress.report("finding what changed", 0.0);
  NearRims(
      polygons, kinds,
      [&](std::uint32_t a, std::uint32_t b) {
        const double within = reach(a, b);
        if (within >= 0.0 && rims_touch(*polygons[a].polygon, *polygons[b].polygon, within)) touch(a, b);
      },
      progress);
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

UnionFind joined_where_touching(const std::vector<ReachingPolygon>& polygons, const Progress& progress) {
  UnionFind joined(polygons.size());
  visit_touching(
      polygons, {},
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
  UnionFind sets = joined_where_touching(polygons(), progress);
  join_faces(a_, 0, split_, sets);
  join_faces(b_, split_, count(), sets);
  return sets;
}

void LeftOvers::add_explained(std::vector<std::uint32_t>& place_of, const Progress& progress) const {
  if (std::ranges::all_of(place_of, [](std::uint32_t place) { return place == k_no_change; })) return;
  // What has a place beside what is explained and has none; what is certain and has none gets none.
  static const ConvexPolygon k_none;
  std::vector<ReachingPolygon> rims;
  std::vector<char> has_place;
  for (std::size_t k = 0; k < count(); ++k) {
    has_place.push_back(place_of[k] != k_no_change ? 1 : 0);
    const bool asked = has_place[k] != 0 || !is_certain(k);
    rims.push_back({asked ? &all_[k]->polygon : &k_none, tolerance_.rounding});
  }
  const std::vector<std::uint32_t> known = place_of;
  visit_touching(
      rims, has_place,
      [&](std::uint32_t a, std::uint32_t b) {
        return is_of_a(a) == is_of_a(b) ? 2.0 * tolerance_.rounding : -1.0;
      },
      [&](std::uint32_t a, std::uint32_t b) {
        if (has_place[a] != 0) std::swap(a, b);
        place_of[a] = std::min(place_of[a], known[b]);
      },
      progress);
}

bool LeftOvers::is_rim(std::size_t k) const {
  constexpr double k_widths = 3.0;
  const ConvexPolygon& polygon = all_[k]->polygon;
  return 2.0 * all_[k]->area <= k_widths * all_[k]->explained * reach_from(polygon.front(), polygon);
}

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
