#include "compare/surface_change.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "compare/touching.hpp"

namespace moldlight {

namespace {

/// Draft angles nearer than this are one: beside the greatest draft of near-vertical surface rounding
/// decides.
constexpr double k_same_draft_deg = 0.01;
/// Surface that faces farther apart is not the same, whatever its region.
constexpr double k_least_same_facing = 0.5;

/// Share of a face's area above which all of its changes are one.
constexpr double k_changed_face = 0.3;

/// Puts values in the order of `order`, and numbers that refer to them.
template <typename T>
void reorder(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> sorted;
  for (const std::uint32_t k : order) sorted.push_back(std::move(values[k]));
  values = std::move(sorted);
}

template <typename T, typename Size>
std::vector<std::uint32_t> largest_first(const std::vector<T>& values, const Size& size) {
  std::vector<std::uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(
      order, [&](std::uint32_t a, std::uint32_t b) { return size(values[a]) > size(values[b]); });
  return order;
}

std::vector<std::uint32_t> ranks(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> rank(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
  return rank;
}

void renumber(std::vector<std::uint32_t>& numbers, const std::vector<std::uint32_t>& rank) {
  for (std::uint32_t& number : numbers)
    if (number != k_no_change) number = rank[number];
}

/// Six times the volume of the cone from `apex` over the polygon.
double cone(const ConvexPolygon& polygon, const glm::dvec3& apex) {
  double sum = 0.0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    sum += glm::dot(polygon[0] - apex, glm::cross(polygon[k - 1] - apex, polygon[k] - apex));
  return sum;
}

struct Moment {
  double area = 0.0;
  glm::dvec3 sum{0.0};

  void add(const ConvexPolygon& polygon, double polygon_area) {
    area += polygon_area;
    sum += polygon_area * polygon_centre(polygon);
  }
  [[nodiscard]] glm::dvec3 centre(const Bounds& bounds) const {
    return area > 0.0 ? sum / area : bounds.center();
  }
};

/// Left-over pieces of both parts, the former's first.
class LeftOvers {
 public:
  LeftOvers(const OverlaySide& former, const OverlaySide& fresh, const SurfaceChange& change)
      : former_(former), fresh_(fresh), tolerance_(change.tolerance), split_(change.of_former.left.size()) {
    for (const LeftOver& one : change.of_former.left) all_.push_back(&one);
    for (const LeftOver& one : change.of_fresh.left) all_.push_back(&one);
  }

  [[nodiscard]] std::size_t count() const { return all_.size(); }
  [[nodiscard]] std::size_t of_former() const { return split_; }
  [[nodiscard]] const LeftOver& operator[](std::size_t k) const { return *all_[k]; }
  [[nodiscard]] bool is_certain(std::size_t k) const { return all_[k]->explained == 0.0; }
  [[nodiscard]] bool is_former(std::size_t k) const { return k < split_; }

  /// Those that are certainly left over, joined where they touch.
  [[nodiscard]] UnionFind joined(const Progress& progress) const {
    UnionFind sets = joined_where_touching(polygons(), extent(), progress);
    join_faces(former_, 0, split_, sets);
    join_faces(fresh_, split_, count(), sets);
    return sets;
  }

  /// Gives what is explained, but touches a place on the same part, to that place.
  void add_explained(std::vector<std::uint32_t>& place_of, const Progress& progress) const {
    std::vector<ReachingPolygon> rims;
    for (const LeftOver* one : all_) rims.push_back({&one->polygon, tolerance_.rounding});
    const std::vector<std::uint32_t> certain = place_of;
    visit_touching(
        rims, extent(),
        [&](std::uint32_t a, std::uint32_t b) {
          const bool one_has = (certain[a] == k_no_change) != (certain[b] == k_no_change);
          const std::uint32_t open = certain[a] == k_no_change ? a : b;
          return one_has && !is_certain(open) && is_former(a) == is_former(b) ? 2.0 * tolerance_.rounding
                                                                              : -1.0;
        },
        [&](std::uint32_t a, std::uint32_t b) {
          const std::uint32_t open = certain[a] == k_no_change ? a : b;
          place_of[open] = std::min(place_of[open], certain[open == a ? b : a]);
        },
        progress);
  }

  /// What is explained by being beside other surface alone: a rim, as wide as the tolerance, of what is not.
  [[nodiscard]] bool is_rim(std::size_t k) const {
    constexpr double k_widths = 3.0;
    const ConvexPolygon& polygon = all_[k]->polygon;
    double extent = 0.0;
    for (const glm::dvec3& corner : polygon)
      extent = std::max(extent, glm::distance(corner, polygon.front()));
    return 2.0 * all_[k]->area <= k_widths * all_[k]->explained * extent;
  }

 private:
  [[nodiscard]] double extent() const {
    return std::max(former_.model().frame.diagonal, fresh_.model().frame.diagonal);
  }

  /// None for what is explained.
  [[nodiscard]] std::vector<ReachingPolygon> polygons() const {
    static const ConvexPolygon k_none;
    std::vector<ReachingPolygon> reaching;
    for (std::size_t k = 0; k < count(); ++k) {
      const OverlaySide& side = is_former(k) ? former_ : fresh_;
      const double chord = side.chords().lateral[side.facet(all_[k]->piece)];
      reaching.push_back({is_certain(k) ? &all_[k]->polygon : &k_none, tolerance_.apart + 1.5 * chord});
    }
    return reaching;
  }

  /// A face most of which changed is one place, though it may have stayed somewhere: a round wall that moved.
  void join_faces(const OverlaySide& side, std::size_t first, std::size_t last, UnionFind& sets) const {
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

  const OverlaySide& former_;
  const OverlaySide& fresh_;
  OverlayTolerance tolerance_;
  std::vector<const LeftOver*> all_;
  std::size_t split_;
};

/// What is explained counts as far as it is a rim, and all of it as what the area may be off. Leaves the
/// places of rims and of what is certain alone in `place_of`.
void measure_places(const LeftOvers& left, std::vector<std::uint32_t>& place_of,
                    std::vector<ChangedPlace>& places) {
  std::vector<Moment> moments(places.size());
  for (std::size_t k = 0; k < left.count(); ++k) {
    if (place_of[k] == k_no_change) continue;
    const LeftOver& one = left[k];
    ChangedPlace& place = places[place_of[k]];
    MeasuredArea& measured = left.is_former(k) ? place.gone : place.fresh;
    if (!left.is_certain(k)) measured.error += one.area;
    if (!left.is_certain(k) && !left.is_rim(k)) {
      place_of[k] = k_no_change;
      continue;
    }
    measured.area += one.area;
    moments[place_of[k]].add(one.polygon, one.area);
    for (const glm::dvec3& corner : one.polygon) place.bounds.add(corner);
  }
  for (std::size_t k = 0; k < places.size(); ++k) places[k].centre = moments[k].centre(places[k].bounds);
  for (std::size_t k = 0; k < left.count(); ++k) {
    if (place_of[k] == k_no_change) continue;
    ChangedPlace& place = places[place_of[k]];
    place.volume += (left.is_former(k) ? -1.0 : 1.0) / 6.0 * cone(left[k].polygon, place.bounds.center());
  }
}

void find_places(const OverlaySide& former, const OverlaySide& fresh, double speck, SurfaceChange& change,
                 const Progress& progress) {
  const LeftOvers left(former, fresh, change);
  UnionFind joined = left.joined(progress);
  std::map<std::uint32_t, double> certain;
  for (std::uint32_t k = 0; k < left.count(); ++k)
    if (left.is_certain(k)) certain[joined.find(k)] += left[k].area;
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<std::uint32_t> place_of(left.count(), k_no_change);
  for (std::uint32_t k = 0; k < left.count(); ++k) {
    const std::uint32_t root = joined.find(k);
    if (left.is_certain(k) && certain[root] > speck)
      place_of[k] = number.try_emplace(root, static_cast<std::uint32_t>(number.size())).first->second;
  }
  left.add_explained(place_of, progress);
  change.places.resize(number.size());
  measure_places(left, place_of, change.places);
  const auto order =
      largest_first(change.places, [](const ChangedPlace& p) { return p.gone.area + p.fresh.area; });
  reorder(change.places, order);
  renumber(place_of, ranks(order));
  const auto middle = place_of.begin() + static_cast<std::ptrdiff_t>(left.of_former());
  change.place_of_former.assign(place_of.begin(), middle);
  change.place_of_fresh.assign(middle, place_of.end());
  for (const ChangedPlace& place : change.places) {
    change.gone.area += place.gone.area;
    change.gone.error += place.gone.error;
    change.fresh.area += place.fresh.area;
    change.fresh.error += place.fresh.error;
  }
}

/// Decides which changes of region are none: those that tolerance and tessellation explain.
class RegionChanges {
 public:
  RegionChanges(const OverlaySide& former, const OverlaySide& fresh, const SurfaceChange& change)
      : former_(former), fresh_(fresh), change_(change) {}

  [[nodiscard]] ChangedRegion noted(const OtherRegion& one) const {
    return {.from = former_.region(one.piece), .to = fresh_.region(one.other)};
  }

  /// No surface of the new part nearby has the region that was there.
  [[nodiscard]] bool is_certain(const OtherRegion& one) const {
    const double draft = draft_deg(former_, one.piece), draft_now = draft_deg(fresh_, one.other);
    if (former_.direction() == fresh_.direction() && draft != draft_now &&
        std::abs(draft - draft_now) < k_same_draft_deg && class_may_differ(draft, draft_now))
      return false;
    const FacetIndex here = former_.facet(one.piece), there = fresh_.facet(one.other);
    const double steps = former_.chords().step[here] + fresh_.chords().step[there];
    const double reach = 2.0 * change_.tolerance.apart + 2.0 * change_.chords + steps;
    const Region was = former_.region(one.piece);
    const glm::dvec3 centre = polygon_centre(one.polygon);
    bool found = false;
    visit_pieces(fresh_, centre, reach, [&](PieceIndex piece) {
      if (found || fresh_.region(piece) != was) return;
      if (glm::dot(fresh_.normal(piece), former_.normal(one.piece)) < k_least_same_facing) return;
      found = glm::distance(nearest_in_triangle(centre, fresh_.corners(piece)), centre) <= reach;
    });
    return !found;
  }

 private:
  [[nodiscard]] static double draft_deg(const OverlaySide& side, PieceIndex piece) {
    return glm::degrees(std::asin(std::clamp(glm::dot(side.normal(piece), side.direction()), -1.0, 1.0)));
  }
  [[nodiscard]] bool class_may_differ(double a, double b) const {
    return (std::abs(a) < former_.tau_deg()) != (std::abs(b) < fresh_.tau_deg());
  }

  const OverlaySide& former_;
  const OverlaySide& fresh_;
  const SurfaceChange& change_;
};

/// Adds the changes from one region to another.
void add_regions(const OverlaySide& former, const RegionChanges& changes,
                 const std::vector<std::uint32_t>& numbers, double speck, SurfaceChange& change,
                 const Progress& progress) {
  const std::vector<OtherRegion>& found = change.of_former.regions;
  std::vector<ReachingPolygon> polygons;
  for (const std::uint32_t k : numbers) polygons.push_back({&found[k].polygon, 0.5 * change.tolerance.apart});
  UnionFind joined = joined_where_touching(polygons, former.model().frame.diagonal, progress);
  std::map<std::uint32_t, double> certain;
  for (std::uint32_t k = 0; k < numbers.size(); ++k)
    if (changes.is_certain(found[numbers[k]])) certain[joined.find(k)] += found[numbers[k]].area;
  std::map<std::uint32_t, std::uint32_t> number;
  std::vector<Moment> moments(change.regions.size());
  for (std::uint32_t k = 0; k < numbers.size(); ++k) {
    const auto root = certain.find(joined.find(k));
    if (root == certain.end() || root->second <= speck) continue;
    const OtherRegion& one = found[numbers[k]];
    const auto [at, is_new] =
        number.try_emplace(root->first, static_cast<std::uint32_t>(change.regions.size()));
    if (is_new) {
      change.regions.push_back(changes.noted(one));
      moments.emplace_back();
    }
    ChangedRegion& noted = change.regions[at->second];
    noted.area += one.area;
    moments[at->second].add(one.polygon, one.area);
    for (const glm::dvec3& corner : one.polygon) noted.bounds.add(corner);
    noted.centre = moments[at->second].centre(noted.bounds);
    change.change_of_region[numbers[k]] = at->second;
  }
}

void find_regions(const OverlaySide& former, const OverlaySide& fresh, double speck, SurfaceChange& change,
                  const Progress& progress) {
  const std::vector<OtherRegion>& found = change.of_former.regions;
  change.change_of_region.assign(found.size(), k_no_change);
  const RegionChanges changes(former, fresh, change);
  std::array<std::array<std::vector<std::uint32_t>, k_region_count>, k_region_count> numbers;
  for (std::uint32_t k = 0; k < found.size(); ++k) {
    const auto from = static_cast<std::size_t>(former.region(found[k].piece));
    numbers[from][static_cast<std::size_t>(fresh.region(found[k].other))].push_back(k);
  }
  for (const auto& from : numbers)
    for (const std::vector<std::uint32_t>& some : from)
      add_regions(former, changes, some, speck, change, progress);
  const auto order = largest_first(change.regions, [](const ChangedRegion& r) { return r.area; });
  reorder(change.regions, order);
  renumber(change.change_of_region, ranks(order));
}

}  // namespace

SurfaceChange no_surface_change(const OverlaySide& side, const OverlayTolerance& tolerance) {
  SurfaceChange change;
  change.tolerance = tolerance;
  change.chords = 2.0 * side.chords().greatest;
  for (PieceIndex piece = 0; piece < side.count(); ++piece)
    change.of_former.shares.push_back({piece, piece, side.area(piece)});
  change.of_fresh.shares = change.of_former.shares;
  return change;
}

SurfaceChange find_surface_change(const OverlaySide& former, const OverlaySide& fresh,
                                  const OverlayTolerance& tolerance, const Progress& progress) {
  SurfaceChange change;
  change.tolerance = tolerance;
  change.chords = former.chords().greatest + fresh.chords().greatest;
  change.of_former = lay_on(former, fresh, tolerance, progress);
  change.of_fresh = lay_on(fresh, former, tolerance, progress);
  progress.report("finding what changed", 0.0);
  // Surface farther than the tolerance is more than a corner of a needle.
  const double speck = tolerance.apart * tolerance.apart;
  find_places(former, fresh, speck, change, progress);
  find_regions(former, fresh, speck, change, progress);
  return change;
}

}  // namespace moldlight
