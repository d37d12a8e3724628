#include "pieces/left_surface.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "base/error.hpp"
#include "mesh/union_find.hpp"
#include "mold/direction.hpp"

namespace moldlight {

namespace {

/// The part of a polygon that lies in a triangle, both in the plane with this normal.
ConvexPolygon clipped_by(ConvexPolygon polygon, const std::array<glm::dvec3, 3>& triangle,
                         const glm::dvec3& normal) {
  for (std::size_t side = 0; side < 3 && polygon.size() >= 3; ++side) {
    const glm::dvec3& from = triangle[side];
    const glm::dvec3 out = glm::cross(triangle[(side + 1) % 3] - from, normal);
    const double length = glm::length(out);
    if (length > 0.0) polygon = parted(polygon, {out / length, glm::dot(out / length, from)}, 0.0).inside;
  }
  return polygon;
}

Bounds box_of(std::span<const glm::dvec3> points) {
  Bounds box;
  for (const glm::dvec3& point : points) box.add(point);
  return box;
}

bool are_apart(const Bounds& a, const Bounds& b) {
  return a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y ||
         a.max.z < b.min.z || b.max.z < a.min.z;
}

/// Polygons of less than this share of the part's area are rounding.
constexpr double k_least_share = 1e-14;
/// Lines whose regions are kept; each takes as much as the part.
constexpr std::size_t k_most_kept = 12;
/// Cuts of polygons that are tried: real parts ask for forty a facet at most.
constexpr std::size_t k_any_cuts = 10'000'000, k_cuts_a_facet = 500;

[[noreturn]] void refuse(const PartModel& model) {
  throw Error(model.part.file +
              ": too many of its facets cross others to find a mold of several pieces; raise --effort, or "
              "take one of its bodies (--body)");
}

}  // namespace

const LeftSurface::Line& LeftSurface::line_of(const glm::dvec3& direction, const Progress& progress) {
  const auto known = lines_.find(direction);
  if (known != lines_.end()) return known->second;
  ExactQuery query = query_;
  query.direction = direction;
  ExactSplit split = exact_split(model_.exact(progress), query, progress);
  if (!split.has_lines(model_.exact(progress).effort())) refuse(model_);
  Line line{.mesh = std::move(split.mesh), .first = {}};
  line.first.assign(model_.part.mesh.facets.size() + 1, 0);
  for (const SplitPiece& piece : line.mesh.pieces) ++line.first[piece.facet + 1];
  std::partial_sum(line.first.begin(), line.first.end(), line.first.begin());
  return lines_.emplace(direction, std::move(line)).first->second;
}

std::vector<LeftPolygon> LeftSurface::left_of(FacetIndex facet, std::span<const Pull> pulls) {
  std::vector<ConvexPolygon> left;
  bool begun = false;
  const glm::dvec3& normal = model_.geometry.normals[facet];
  std::vector<std::pair<std::array<glm::dvec3, 3>, Bounds>> blocked;
  for (const Pull& pull : pulls) {
    blocked.clear();
    const Line& line = *pull.line;
    for (std::size_t piece = line.first[facet]; piece < line.first[facet + 1]; ++piece) {
      const unsigned accessible = facts(line.mesh.pieces[piece].region).accessible;
      if ((pull.plus && (accessible & 1U) != 0) || (pull.minus && (accessible & 2U) != 0)) continue;
      const std::array<glm::dvec3, 3> corners = {line.mesh.corner(piece, 0), line.mesh.corner(piece, 1),
                                                 line.mesh.corner(piece, 2)};
      blocked.emplace_back(corners, box_of(corners));
    }
    if (blocked.empty()) return {};
    cuts_ += std::max(left.size(), std::size_t{1}) * blocked.size();
    std::vector<ConvexPolygon> next;
    if (!begun) {
      for (const auto& [triangle, box] : blocked) next.emplace_back(triangle.begin(), triangle.end());
    } else if (line.first[facet + 1] - line.first[facet] == 1) {
      continue;  // all of the facet is blocked
    }
    for (const ConvexPolygon& polygon : left) {
      const Bounds of_polygon = box_of(polygon);
      for (const auto& [triangle, box] : blocked) {
        if (are_apart(of_polygon, box)) continue;
        ConvexPolygon both = clipped_by(polygon, triangle, normal);
        if (both.size() >= 3) next.push_back(std::move(both));
      }
    }
    left = std::move(next);
    begun = true;
    if (left.empty()) return {};
  }
  std::vector<LeftPolygon> found;
  for (ConvexPolygon& polygon : left) {
    const double area = polygon_area(polygon);
    if (area > k_least_share * model_.geometry.total_area) found.push_back({facet, std::move(polygon), area});
  }
  return found;
}

std::vector<LeftPolygon> LeftSurface::left_by(std::span<const glm::dvec3> directions,
                                              const Progress& progress) {
  if (lines_.size() > k_most_kept) lines_.clear();
  std::vector<Pull> pulls;
  for (const glm::dvec3& direction : directions) {
    const glm::dvec3 line = half_sphere(direction);
    const Line* const known = &line_of(line, progress);
    auto pull = std::ranges::find(pulls, known, &Pull::line);
    if (pull == pulls.end()) pull = pulls.insert(pulls.end(), Pull{.line = known});
    (glm::dot(line, direction) > 0.0 ? pull->plus : pull->minus) = true;
  }
  const std::size_t facets = model_.part.mesh.facets.size();
  std::vector<std::vector<LeftPolygon>> of_facet(facets);
  const std::size_t most = static_cast<std::size_t>(
      model_.part.effort * static_cast<double>(std::max(k_any_cuts, k_cuts_a_facet * facets)));
  tbb::parallel_for(std::size_t{0}, facets, [&](std::size_t facet) {
    if (!progress.cancelled() && cuts_ <= most)
      of_facet[facet] = left_of(static_cast<FacetIndex>(facet), pulls);
  });
  if (progress.cancelled()) throw Cancelled();
  if (cuts_ > most) refuse(model_);
  std::vector<LeftPolygon> all;
  for (auto& polygons : of_facet) std::ranges::move(polygons, std::back_inserter(all));
  return all;
}

double area_of(std::span<const LeftPolygon> polygons) {
  double area = 0.0;
  for (const LeftPolygon& polygon : polygons) area += polygon.area;
  return area;
}

std::vector<LeftPlace> left_places(const PartModel& model, std::span<const LeftPolygon> polygons) {
  const std::size_t facets = model.part.mesh.facets.size();
  std::vector<std::uint8_t> has_some(facets, 0);
  for (const LeftPolygon& polygon : polygons) has_some[polygon.facet] = 1;
  UnionFind joined(facets);
  for (FacetIndex facet = 0; facet < facets; ++facet) {
    if (has_some[facet] == 0) continue;
    for (const FacetIndex other : model.adjacency.across[facet]) {
      if (other != k_no_facet && has_some[other] != 0) joined.join(facet, other);
    }
  }
  std::map<std::uint32_t, LeftPlace> places;
  for (const LeftPolygon& polygon : polygons) {
    LeftPlace& place = places[joined.find(polygon.facet)];
    place.polygons.push_back(static_cast<std::size_t>(&polygon - polygons.data()));
    for (const glm::dvec3& corner : polygon.corners) place.bounds.add(corner);
    place.area += polygon.area;
    place.centre += polygon.area * polygon_centre(polygon.corners);
  }
  std::vector<LeftPlace> found;
  for (auto& [first, place] : places) {
    place.centre /= place.area;
    found.push_back(place);
  }
  std::ranges::stable_sort(found, std::greater(), &LeftPlace::area);
  return found;
}

std::vector<SurfaceSample> left_samples(const PartModel& model, std::span<const LeftPolygon> polygons,
                                        std::size_t count) {
  std::vector<SurfaceSample> samples;
  const double step = area_of(polygons) / static_cast<double>(count);
  double passed = 0.0;
  for (const LeftPolygon& polygon : polygons) {
    const ConvexPolygon& corners = polygon.corners;
    for (std::size_t k = 2; k < corners.size(); ++k) {
      passed += 0.5 * glm::length(glm::cross(corners[k - 1] - corners[0], corners[k] - corners[0]));
      while (samples.size() < count && (static_cast<double>(samples.size()) + 0.5) * step < passed) {
        const glm::dvec3 at = triangle_place(samples.size()).in(corners[0], corners[k - 1], corners[k]);
        samples.push_back({model.frame.to_unit(at), polygon.facet});
      }
    }
  }
  return samples;
}

}  // namespace moldlight
