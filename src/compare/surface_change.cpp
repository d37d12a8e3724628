#include "compare/surface_change.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "compare/left_overs.hpp"
#include "mesh/facet_geometry.hpp"

namespace moldlight {

namespace {

/// Draft angles nearer than this are one: beside the greatest draft of near-vertical surface rounding
/// decides.
constexpr double k_same_draft_deg = 0.01;
/// How many facets beyond a place its ends may run.
constexpr int k_rings = 4;
/// Surface that faces farther apart is not the same, whatever its region.
constexpr double k_least_same_facing = 0.5;

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

/// What is explained counts as far as it is a rim, and all of it as what the area may be off. Leaves the
/// places of rims and of what is certain alone in `place_of`.
void measure_places(const LeftOvers& left, std::vector<std::uint32_t>& place_of,
                    std::vector<ChangedPlace>& places) {
  std::vector<Moment> moments(places.size());
  for (std::size_t k = 0; k < left.count(); ++k) {
    if (place_of[k] == k_no_change) continue;
    const LeftOver& one = left[k];
    ChangedPlace& place = places[place_of[k]];
    MeasuredArea& measured = left.is_of_a(k) ? place.gone : place.added;
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
}

void find_places(const OverlaySide& a, const OverlaySide& b, double speck, SurfaceChange& change,
                 const Progress& progress) {
  const LeftOvers left(a, b, change.tolerance, change.of_a, change.of_b);
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
  change.closed = a.model().health.closed && b.model().health.closed;
  change.places.resize(number.size());
  if (change.closed) {
    const PlaceVolumes volumes =
        volumes_of_places(left, static_cast<std::uint32_t>(number.size()), place_of, progress);
    for (std::size_t k = 0; k < change.places.size(); ++k) {
      change.places[k].volume = volumes.of_place[k];
      change.places[k].joined = volumes.joined[k];
    }
    change.volume_elsewhere = volumes.elsewhere;
  }
  std::vector<std::uint32_t> touched = place_of;
  // The ends of a round wall that moved run over several facets.
  for (int ring = 0; ring < k_rings; ++ring) left.add_explained(touched, progress);
  measure_places(left, place_of, change.places);
  const auto order =
      largest_first(change.places, [](const ChangedPlace& p) { return p.gone.area + p.added.area; });
  reorder(change.places, order);
  std::erase_if(change.places, [](const ChangedPlace& p) { return p.gone.area + p.added.area <= 0.0; });
  const auto give = [&](std::vector<std::uint32_t>& places, std::vector<std::uint32_t>& of_a,
                        std::vector<std::uint32_t>& of_b) {
    renumber(places, ranks(order));
    const auto middle = places.begin() + static_cast<std::ptrdiff_t>(left.of_a());
    of_a.assign(places.begin(), middle);
    of_b.assign(middle, places.end());
  };
  give(place_of, change.place_of_a, change.place_of_b);
  give(touched, change.touched_of_a, change.touched_of_b);
  for (const ChangedPlace& place : change.places) {
    change.gone.area += place.gone.area;
    change.gone.error += place.gone.error;
    change.added.area += place.added.area;
    change.added.error += place.added.error;
  }
}

/// Decides which changes of region are none: those that tolerance and tessellation explain.
class RegionChanges {
 public:
  RegionChanges(const OverlaySide& a, const OverlaySide& b, const SurfaceChange& change)
      : a_(a), b_(b), change_(change) {}

  [[nodiscard]] ChangedRegion noted(const OtherRegion& one) const {
    return {.from = a_.region(one.piece), .to = b_.region(one.other)};
  }

  /// No surface of the new part nearby has the region that was there.
  [[nodiscard]] bool is_certain(const OtherRegion& one) const {
    const double draft = draft_deg(a_, one.piece), draft_now = draft_deg(b_, one.other);
    if (a_.direction() == b_.direction() && draft != draft_now &&
        std::abs(draft - draft_now) < k_same_draft_deg && class_may_differ(draft, draft_now))
      return false;
    const FacetIndex here = a_.facet(one.piece), there = b_.facet(one.other);
    const double steps = a_.chords().step[here] + b_.chords().step[there];
    const double reach = 2.0 * change_.tolerance.apart + 2.0 * change_.chords + steps;
    const Region was = a_.region(one.piece);
    const glm::dvec3 centre = polygon_centre(one.polygon);
    bool found = false;
    visit_pieces(b_, centre, reach, [&](PieceIndex piece) {
      if (found || b_.region(piece) != was) return;
      if (glm::dot(b_.normal(piece), a_.normal(one.piece)) < k_least_same_facing) return;
      found = glm::distance(nearest_in_triangle(centre, b_.corners(piece)), centre) <= reach;
    });
    return !found;
  }

 private:
  [[nodiscard]] static double draft_deg(const OverlaySide& side, PieceIndex piece) {
    return glm::degrees(std::asin(std::clamp(glm::dot(side.normal(piece), side.direction()), -1.0, 1.0)));
  }
  [[nodiscard]] bool class_may_differ(double a, double b) const {
    return (std::abs(a) < a_.tau_deg()) != (std::abs(b) < b_.tau_deg());
  }

  const OverlaySide& a_;
  const OverlaySide& b_;
  const SurfaceChange& change_;
};

/// Adds the changes from one region to another.
void add_regions(const RegionChanges& changes, const std::vector<std::uint32_t>& numbers, double speck,
                 SurfaceChange& change, const Progress& progress) {
  const std::vector<OtherRegion>& found = change.of_a.regions;
  std::vector<ReachingPolygon> polygons;
  for (const std::uint32_t k : numbers) polygons.push_back({&found[k].polygon, 0.5 * change.tolerance.apart});
  UnionFind joined = joined_where_touching(polygons, progress);
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

void find_regions(const OverlaySide& a, const OverlaySide& b, double speck, SurfaceChange& change,
                  const Progress& progress) {
  const std::vector<OtherRegion>& found = change.of_a.regions;
  change.change_of_region.assign(found.size(), k_no_change);
  const RegionChanges changes(a, b, change);
  std::array<std::array<std::vector<std::uint32_t>, k_region_count>, k_region_count> numbers;
  for (std::uint32_t k = 0; k < found.size(); ++k) {
    const auto from = static_cast<std::size_t>(a.region(found[k].piece));
    numbers[from][static_cast<std::size_t>(b.region(found[k].other))].push_back(k);
  }
  for (const auto& from : numbers)
    for (const std::vector<std::uint32_t>& some : from) add_regions(changes, some, speck, change, progress);
  const auto order = largest_first(change.regions, [](const ChangedRegion& r) { return r.area; });
  reorder(change.regions, order);
  renumber(change.change_of_region, ranks(order));
}

}  // namespace

SurfaceChange no_surface_change(const OverlaySide& side, const OverlayTolerance& tolerance) {
  SurfaceChange change;
  change.tolerance = tolerance;
  change.closed = side.model().health.closed;
  change.chords = 2.0 * side.chords().greatest;
  for (PieceIndex piece = 0; piece < side.count(); ++piece)
    change.of_a.shares.push_back({piece, piece, side.area(piece)});
  change.of_b.shares = change.of_a.shares;
  return change;
}

SurfaceChange find_surface_change(const OverlaySide& a, const OverlaySide& b,
                                  const OverlayTolerance& tolerance, const Progress& progress) {
  SurfaceChange change;
  change.tolerance = tolerance;
  change.chords = a.chords().greatest + b.chords().greatest;
  change.of_a = lay_on(a, b, tolerance, progress);
  change.of_b = lay_on(b, a, tolerance, progress);
  progress.report("finding what changed", 0.0);
  // Surface farther than the tolerance is more than a corner of a needle.
  const double speck = tolerance.apart * tolerance.apart;
  find_places(a, b, speck, change, progress);
  find_regions(a, b, speck, change, progress);
  return change;
}

}  // namespace moldlight
