// Surface of two parts that is left over where one is laid on the other, and the volumes that it encloses by
// place.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.hpp"
#include "compare/overlay.hpp"
#include "compare/place_volume.hpp"
#include "mesh/convex_polygon.hpp"
#include "mesh/union_find.hpp"

namespace moldlight {

/// A polygon and how far around its rim others are one with it; one without corners touches nothing.
struct ReachingPolygon {
  const ConvexPolygon* polygon = nullptr;
  double reach = 0.0;
};

/// Joins all that touch each other.
[[nodiscard]] UnionFind joined_where_touching(const std::vector<ReachingPolygon>& polygons,
                                              const Progress& progress);

inline constexpr std::uint32_t k_no_change = ~0U;

/// Left-over pieces of both parts, A's first. It points into what it is made of.
class LeftOvers {
 public:
  LeftOvers(const OverlaySide& a, const OverlaySide& b, const OverlayTolerance& tolerance,
            const Overlay& of_a, const Overlay& of_b);

  [[nodiscard]] std::size_t count() const { return all_.size(); }
  [[nodiscard]] std::size_t of_a() const { return split_; }
  [[nodiscard]] const LeftOver& operator[](std::size_t k) const { return *all_[k]; }
  [[nodiscard]] bool is_certain(std::size_t k) const { return all_[k]->explained == 0.0; }
  [[nodiscard]] bool is_of_a(std::size_t k) const { return k < split_; }
  [[nodiscard]] const OverlaySide& a() const { return a_; }
  [[nodiscard]] const OverlaySide& b() const { return b_; }
  [[nodiscard]] const OverlaySide& side(std::size_t k) const { return is_of_a(k) ? a_ : b_; }
  [[nodiscard]] const OverlayTolerance& tolerance() const { return tolerance_; }

  /// Those that are certainly left over, joined where they touch.
  [[nodiscard]] UnionFind joined(const Progress& progress) const;
  /// Gives what is explained, but touches a place on the same part, to that place.
  void add_explained(std::vector<std::uint32_t>& place_of, const Progress& progress) const;
  /// What is explained by being beside other surface alone: a rim, as wide as the tolerance, of what is not.
  [[nodiscard]] bool is_rim(std::size_t k) const;

 private:
  [[nodiscard]] std::vector<ReachingPolygon> polygons() const;
  void join_faces(const OverlaySide& side, std::size_t first, std::size_t last, UnionFind& sets) const;

  const OverlaySide& a_;
  const OverlaySide& b_;
  OverlayTolerance tolerance_;
  std::vector<const LeftOver*> all_;
  std::size_t split_;
};

struct PlaceVolumes {
  std::vector<MeasuredVolume> of_place;
  std::vector<bool> joined;  // places that were several, of which not each encloses what came or went
  double elsewhere = 0.0;    // what tolerance or tessellation explain
};

/// Volumes that came, less those that went; with that elsewhere they add up to the difference of the bodies,
/// which must be closed. `place_of` has the place of each left-over, below `places`, or k_no_change; places
/// that enclose nothing by themselves are joined with their nearest ones in it, and one of them is left over
/// without surface. Throws Cancelled.
[[nodiscard]] PlaceVolumes volumes_of_places(const LeftOvers& left, std::uint32_t places,
                                             std::vector<std::uint32_t>& place_of, const Progress& progress);

}  // namespace moldlight
