#include "mold/surface_samples.hpp"

#include <algorithm>
#include <cmath>

namespace moldlight {

namespace {

constexpr std::uint64_t k_least_samples_per_facet = 4;
// 1/p and 1/p^2 of the plastic number p (p^3 = p + 1), as fractions of 2^64: integer steps keep every sample
// exact.
constexpr std::uint64_t k_step_u = 0xC13FA9A902A6328FULL;
constexpr std::uint64_t k_step_v = 0x91E10DA5C79E7B1DULL;

/// Scatters consecutive numbers over 64 bits (a bijection).
std::uint64_t scatter(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

double fraction(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

SurfaceSample sample_at(const TriangleMesh& mesh, FacetIndex facet, const UnitFrame& frame,
                        std::uint64_t number) {
  return {frame.to_unit(
              triangle_place(number).in(mesh.corner(facet, 0), mesh.corner(facet, 1), mesh.corner(facet, 2))),
          facet};
}

}  // namespace

glm::dvec2 square_place(std::uint64_t index) {
  return {fraction(index * k_step_u), fraction(index * k_step_v)};
}

TrianglePlace triangle_place(std::uint64_t index) {
  const glm::dvec2 place = square_place(index);
  const double u = place.x, v = place.y;
  return u + v > 1.0 ? TrianglePlace{1.0 - u, 1.0 - v} : TrianglePlace{u, v};
}

SurfaceSamples sample_surface(const TriangleMesh& mesh, const FacetGeometry& geometry, const UnitFrame& frame,
                              std::uint64_t wanted) {
  SurfaceSamples set;
  set.first.reserve(mesh.facets.size() + 1);
  set.first.push_back(0);
  const double density = geometry.total_area > 0.0 ? static_cast<double>(wanted) / geometry.total_area : 0.0;
  for (const double area : geometry.areas) {
    const auto share = static_cast<std::uint64_t>(std::llround(area * density));
    set.first.push_back(set.first.back() + (area > 0.0 ? std::max(share, k_least_samples_per_facet) : 0));
  }
  set.samples.reserve(set.first.back());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const std::uint64_t start = scatter(facet);
    for (std::uint64_t i = set.first[facet]; i < set.first[facet + 1]; ++i) {
      set.samples.push_back(sample_at(mesh, facet, frame, start + (i - set.first[facet])));
    }
  }
  return set;
}

SurfaceSamples sample_surface_evenly(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                     const UnitFrame& frame, std::uint64_t count) {
  SurfaceSamples set;
  set.first.reserve(mesh.facets.size() + 1);
  set.first.push_back(0);
  set.samples.reserve(count);
  double area_before = 0.0;
  const double step = geometry.total_area / static_cast<double>(std::max<std::uint64_t>(count, 1));
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const double area = geometry.areas[facet];
    while (set.samples.size() < count &&
           (static_cast<double>(set.samples.size()) + 0.5) * step < area_before + area) {
      set.samples.push_back(sample_at(mesh, facet, frame, set.samples.size()));
    }
    area_before += area;
    set.first.push_back(set.samples.size());
  }
  return set;
}

}  // namespace moldlight
