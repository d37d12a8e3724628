// The surface that none of several directions releases, by their exact regions.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "mesh/convex_polygon.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

/// A convex polygon of a facet, in the part's coordinates.
struct LeftPolygon {
  FacetIndex facet = 0;
  ConvexPolygon corners;  // three at least, wound as the facet
  double area = 0.0;      // model units squared
};

/// What of it hangs together over facets' edges.
struct LeftPlace {
  double area = 0.0;  // model units squared
  glm::dvec3 centre{0.0};
  Bounds bounds;
  std::vector<std::size_t> polygons;  // numbers of them
};

/// Finds the exact regions of a line when they are first asked for and keeps them for a while.
class LeftSurface {
 public:
  /// `model` must outlive it; of the query the direction does not count.
  LeftSurface(const PartModel& model, const ExactQuery& query) : model_(model), query_(query) {}

  /// In the order of the facets: what is left of each is cut, as convex polygons, by the pieces that each
  /// direction does not release. Directions are unit. Uses all cores of the calling thread's TBB arena; the
  /// same to the bit for any number of threads. Throws Cancelled, Error where facets that cross others ask
  /// for more work than the part's effort allows.
  [[nodiscard]] std::vector<LeftPolygon> left_by(std::span<const glm::dvec3> directions,
                                                 const Progress& progress);

 private:
  /// Pieces by facet.
  struct Line {
    SplitMesh mesh;
    std::vector<std::size_t> first;  // of each facet, and one past the last
  };
  struct DirectionOrder {
    bool operator()(const glm::dvec3& a, const glm::dvec3& b) const {
      return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    }
  };
  /// A line, and the senses in which it is pulled.
  struct Pull {
    const Line* line = nullptr;
    bool plus = false, minus = false;
  };
  [[nodiscard]] const Line& line_of(const glm::dvec3& direction, const Progress& progress);
  [[nodiscard]] std::vector<LeftPolygon> left_of(FacetIndex facet, std::span<const Pull> pulls);

  const PartModel& model_;
  ExactQuery query_;
  std::map<glm::dvec3, Line, DirectionOrder> lines_;
  std::atomic<std::size_t> cuts_ = 0;  // of polygons, tried so far: what the work grows with
};

[[nodiscard]] double area_of(std::span<const LeftPolygon> polygons);

/// The largest first.
[[nodiscard]] std::vector<LeftPlace> left_places(const PartModel& model,
                                                 std::span<const LeftPolygon> polygons);

/// So many samples of the polygons, each of the same area.
[[nodiscard]] std::vector<SurfaceSample> left_samples(const PartModel& model,
                                                      std::span<const LeftPolygon> polygons,
                                                      std::size_t count);

}  // namespace moldlight
