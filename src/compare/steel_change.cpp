// Steel to cut and to add: what each part alone fills, bit by bit of its surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "compare/mold_change.hpp"
#include "compare/solid_probe.hpp"
#include "mesh/facet_geometry.hpp"

namespace moldlight {

namespace {

/// Of the rounding that the overlay allows: how far off its surface a bit is asked about.
constexpr double k_beside = 2.0;
/// Of the diagonal: what cuts may be off.
constexpr double k_cut_share = 1e-10;

using Triangle = std::array<glm::dvec3, 3>;

/// Where a polygon meets a plane through its inside, along a line in that plane; none where it only touches.
struct Stretch {
  double from = INFINITY, to = -INFINITY;

  void add(double at) {
    from = std::min(from, at);
    to = std::max(to, at);
  }
};
template <typename Corners>
Stretch stretch_in_plane(const Corners& corners, const HalfSpace& plane, const glm::dvec3& along,
                         double rounding) {
  Stretch stretch;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double over_a = beyond(a, plane), over_b = beyond(b, plane);
    if (std::abs(over_a) <= rounding) stretch.add(glm::dot(along, a));
    if ((over_a > rounding && over_b < -rounding) || (over_a < -rounding && over_b > rounding))
      stretch.add(glm::dot(along, glm::mix(a, b, over_a / (over_a - over_b))));
  }
  return stretch;
}

/// Cuts the bits of one facet where another triangle crosses or touches them.
void cut_by(std::vector<ConvexPolygon>& bits, const HalfSpace& own, const Triangle& other,
            const glm::dvec3& other_normal, double rounding) {
  const glm::dvec3 line = glm::cross(own.normal, other_normal);
  if (!(glm::length(line) > 1e-9)) return;
  const glm::dvec3 along = glm::normalize(line);
  const Stretch theirs = stretch_in_plane(other, own, along, rounding);
  if (theirs.from > theirs.to) return;
  const HalfSpace plane{other_normal, glm::dot(other_normal, other[0])};
  for (std::size_t k = 0, count = bits.size(); k < count; ++k) {
    const Stretch ours = stretch_in_plane(bits[k], plane, along, rounding);
    if (std::min(ours.to, theirs.to) - std::max(ours.from, theirs.from) <= rounding) continue;
    auto [below, above] = parted(bits[k], plane, rounding);
    if (polygon_area(below) <= rounding * rounding || polygon_area(above) <= rounding * rounding) continue;
    bits[k] = std::move(below);
    bits.push_back(std::move(above));
  }
}

double distance_in_plane(const glm::dvec3& point, const ConvexPolygon& polygon, const glm::dvec3& normal) {
  double least = INFINITY;
  bool inside = true;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3 &a = polygon[k], along = polygon[(k + 1) % polygon.size()] - a, to = point - a;
    inside = inside && glm::dot(glm::cross(along, to), normal) >= 0.0;
    least = std::min(least, distance_to_segment(point, a, polygon[(k + 1) % polygon.size()]));
  }
  return inside ? 0.0 : least;
}

/// A bit of surface that bounds what was cut or added.
struct SteelBit {
  std::uint32_t place = 0;
  bool of_cut = false;    // else of what is added
  bool is_steel = false;  // the steel's own side of it: of A where it is cut; else the part's new skin
  bool of_b = false;
  ConvexPolygon polygon;
  double chord = 0.0;  // by which its facet may be off the surface
  SteelOwner owner;
};

class BitFinder {
 public:
  BitFinder(const MoldedSide& own, const MoldedSide& other, const SurfaceChange& change, bool of_b)
      : own_(own),
        other_(other),
        probe_(other.side.model().part.mesh),
        left_(of_b ? change.of_b.left : change.of_a.left),
        place_of_(of_b ? change.touched_of_b : change.touched_of_a),
        of_b_(of_b),
        beside_(k_beside * change.tolerance.rounding),
        rounding_(k_cut_share *
                  std::max(own.side.model().frame.diagonal, other.side.model().frame.diagonal)) {
    for (std::uint32_t k = 0; k < left_.size(); ++k)
      if (place_of_[k] != k_no_change) changed_[own.side.facet(left_[k].piece)].push_back(k);
    for (PieceIndex piece = 0; piece < own.assignment.mesh.pieces.size(); ++piece) {
      const auto found = changed_.find(own.assignment.mesh.pieces[piece].facet);
      if (found != changed_.end()) work_.push_back({piece, &found->second});
    }
  }

  /// In the order of the pieces.
  [[nodiscard]] std::vector<SteelBit> find(const Progress& progress) const {
    std::vector<std::vector<SteelBit>> found(work_.size());
    tbb::parallel_for(std::size_t{0}, work_.size(), [&](std::size_t k) {
      if (progress.cancelled()) throw Cancelled();
      found[k] = bits_of(work_[k]);
    });
    std::vector<SteelBit> all;
    for (std::vector<SteelBit>& some : found) std::ranges::move(some, std::back_inserter(all));
    return all;
  }

 private:
  struct Work {
    PieceIndex piece;                        // of the assignment's mesh
    const std::vector<std::uint32_t>* left;  // numbers of its facet's left-overs that are of a place
  };

  [[nodiscard]] std::vector<SteelBit> bits_of(const Work& work) const {
    const SplitMesh& mesh = own_.assignment.mesh;
    const SplitPiece& piece = mesh.pieces[work.piece];
    const glm::dvec3& normal = own_.side.model().geometry.normals[piece.facet];
    const Triangle corners = {mesh.vertices[piece.corners[0]], mesh.vertices[piece.corners[1]],
                              mesh.vertices[piece.corners[2]]};
    std::vector<ConvexPolygon> polygons = {{corners.begin(), corners.end()}};
    if (polygon_area(polygons.front()) <= rounding_ * rounding_) return {};
    cut(polygons, {normal, glm::dot(normal, corners[0])});
    std::vector<SteelBit> bits;
    for (ConvexPolygon& polygon : polygons) {
      const glm::dvec3 centre = polygon_centre(polygon);
      const bool behind_is_in = probe_.winding(centre - beside_ * normal) > 0,
                 front_is_in = probe_.winding(centre + beside_ * normal) > 0;
      if (behind_is_in && !front_is_in) continue;  // on the other's surface
      const LeftOver& nearest = nearest_of(*work.left, centre, normal);
      const auto place = place_of_[static_cast<std::size_t>(&nearest - left_.data())];
      // The skin of what this part alone fills, or inside the other: of what that alone fills.
      const bool skin = !behind_is_in;
      bits.push_back({place, skin == of_b_, !skin, of_b_, std::move(polygon),
                      own_.side.chords().normal[piece.facet], owner_of(work.piece, nearest)});
    }
    return bits;
  }

  void cut(std::vector<ConvexPolygon>& polygons, const HalfSpace& plane) const {
    const glm::dvec3 centre = polygon_centre(polygons.front());
    const double radius = reach_from(centre, polygons.front());
    std::vector<FacetIndex> near;
    visit_pieces(other_.side, centre, radius + beside_,
                 [&](PieceIndex piece) { near.push_back(other_.side.facet(piece)); });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    const PartModel& model = other_.side.model();
    for (const FacetIndex facet : near) {
      if (model.geometry.areas[facet] <= 0.0) continue;
      const Triangle triangle = {model.part.mesh.corner(facet, 0), model.part.mesh.corner(facet, 1),
                                 model.part.mesh.corner(facet, 2)};
      cut_by(polygons, plane, triangle, model.geometry.normals[facet], rounding_);
    }
  }

  [[nodiscard]] const LeftOver& nearest_of(const std::vector<std::uint32_t>& numbers, const glm::dvec3& point,
                                           const glm::dvec3& normal) const {
    std::uint32_t nearest = numbers.front();
    double least = INFINITY;
    for (const std::uint32_t k : numbers) {
      const double here = distance_in_plane(point, left_[k].polygon, normal);
      if (here >= least) continue;
      least = here;
      nearest = k;
    }
    return left_[nearest];
  }

  [[nodiscard]] SteelOwner owner_of(PieceIndex piece, const LeftOver& left) const {
    SteelOwner owner{own_.assignment.sides[piece], {}, of_b_};
    if (owner.side != MoldSide::action || own_.plan == nullptr) return owner;
    const std::int32_t action = own_.plan->action_of_piece[left.piece];
    if (action >= 0) owner.action = static_cast<std::size_t>(action);
    return owner;
  }

  const MoldedSide& own_;
  const MoldedSide& other_;
  SolidProbe probe_;
  const std::vector<LeftOver>& left_;
  const std::vector<std::uint32_t>& place_of_;
  bool of_b_;
  double beside_, rounding_;
  std::map<FacetIndex, std::vector<std::uint32_t>> changed_;
  std::vector<Work> work_;
};

/// What its bits enclose.
class Enclosed {
 public:
  explicit Enclosed(const glm::dvec3& apex) : apex_(apex) {}

  void add(const SteelBit& bit, const glm::dvec3& direction) {
    const double sense = bit.is_steel ? -1.0 : 1.0, area = polygon_area(bit.polygon);
    for (std::size_t k = 2; k < bit.polygon.size(); ++k) {
      const glm::dvec3 a = bit.polygon[0] - apex_, b = bit.polygon[k - 1] - apex_, c = bit.polygon[k] - apex_;
      const double cone = sense * glm::dot(a, glm::cross(b, c)) / 6.0;
      volume_ += cone;
      moment_ += 0.25 * cone * (a + b + c);
    }
    for (const glm::dvec3& corner : bit.polygon) {
      const double at = glm::dot(corner, direction);
      low_ = std::min(low_, at);
      high_ = std::max(high_, at);
    }
    (bit.is_steel ? steel_ : skin_)[bit.owner] += area;
    (bit.is_steel ? steel_area_ : skin_area_) += area;
    (bit.of_b ? area_of_b_ : area_of_a_) += area;
    chord_ = std::max(chord_, bit.chord);
  }

  [[nodiscard]] double volume() const { return volume_; }
  /// Whether it is nowhere thicker than what is explained, on the whole.
  [[nodiscard]] bool is_explained(double apart) const {
    return volume_ <= (apart + 2.0 * chord_) * std::max(steel_area_, skin_area_);
  }
  [[nodiscard]] SteelChange change(const MeasuredVolume& volume) const {
    SteelChange change;
    change.volume = volume;
    change.area = area_of_b_;
    change.depth = std::max(high_ - low_, 0.0);
    change.centre = volume_ > 0.0 ? apex_ + moment_ / volume_ : apex_;
    // A body of its own has no steel's surface yet.
    for (const auto& [owner, area] : steel_.empty() ? skin_ : steel_) change.of.push_back({owner, area});
    std::ranges::stable_sort(change.of, std::greater(), &OwnedArea::area);
    return change;
  }

 private:
  glm::dvec3 apex_;
  double volume_ = 0.0, low_ = INFINITY, high_ = -INFINITY, chord_ = 0.0;
  glm::dvec3 moment_{0.0};
  double steel_area_ = 0.0, skin_area_ = 0.0, area_of_a_ = 0.0, area_of_b_ = 0.0;
  std::map<SteelOwner, double> steel_, skin_;
};

PlaceSteel place_steel(const ChangedPlace& place, const Enclosed& cut, const Enclosed& add, double apart) {
  const MeasuredVolume& net = place.volume;
  const bool cuts = !cut.is_explained(apart), adds = !add.is_explained(apart);
  double to_cut = std::max(net.volume, 0.0), to_add = std::max(-net.volume, 0.0), error = net.error;
  if (cuts && adds) {
    // Rims that the tolerance takes leave a gap; half of it is each one's.
    const double gap = net.volume - (cut.volume() - add.volume());
    to_cut = std::max({cut.volume() + 0.5 * gap, net.volume, 0.0});
    to_add = to_cut - net.volume;
    error += std::abs(gap);
  } else {
    error += std::min(std::abs(cut.volume()), std::abs(add.volume()));
  }
  PlaceSteel steel;
  if (to_cut > 0.0) steel.cut = cut.change({to_cut, error});
  if (to_add > 0.0) steel.add = add.change({to_add, error});
  return steel;
}

}  // namespace

std::vector<PlaceSteel> find_steel(const MoldedSide& a, const MoldedSide& b, const SurfaceChange& change,
                                   const Progress& progress) {
  progress.report("finding steel to cut and to add", 0.0);
  std::vector<Enclosed> cut, add;
  for (const ChangedPlace& place : change.places) {
    cut.emplace_back(place.centre);
    add.emplace_back(place.centre);
  }
  for (const bool of_b : {false, true}) {
    const BitFinder finder(of_b ? b : a, of_b ? a : b, change, of_b);
    for (const SteelBit& bit : finder.find(progress))
      (bit.of_cut ? cut : add)[bit.place].add(bit, a.side.direction());
  }
  std::vector<PlaceSteel> steel;
  for (std::size_t k = 0; k < change.places.size(); ++k)
    steel.push_back(place_steel(change.places[k], cut[k], add[k], change.tolerance.apart));
  return steel;
}

}  // namespace moldlight
