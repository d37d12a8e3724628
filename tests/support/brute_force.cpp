#include "support/brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mold/draft.hpp"

namespace moldlight::test {
namespace {

/// Distance along the ray to the triangle, or a negative number.
double ray_distance(const TriangleMesh& mesh, FacetIndex facet, const glm::dvec3& from,
                    const glm::dvec3& along) {
  const glm::dvec3& a = mesh.corner(facet, 0);
  const glm::dvec3 ab = mesh.corner(facet, 1) - a, ac = mesh.corner(facet, 2) - a;
  const glm::dvec3 p = glm::cross(along, ac);
  const double determinant = glm::dot(ab, p);
  if (std::abs(determinant) < 1e-12 * glm::length(ab) * glm::length(ac))
    return -1.0;  // runs in the facet's plane
  const glm::dvec3 s = from - a;
  const double u = glm::dot(s, p) / determinant;
  if (u < 0.0 || u > 1.0) return -1.0;
  const glm::dvec3 q = glm::cross(s, ab);
  const double v = glm::dot(along, q) / determinant;
  if (v < 0.0 || u + v > 1.0) return -1.0;
  return glm::dot(ac, q) / determinant;
}

bool is_free(const TriangleMesh& mesh, FacetIndex own, const glm::dvec3& from, const glm::dvec3& along) {
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (facet != own && ray_distance(mesh, facet, from, along) > 1e-9) return false;
  }
  return true;
}

}  // namespace

Region brute_force_region(const TriangleMesh& mesh, FacetIndex facet, const glm::dvec3& point,
                          const glm::dvec3& normal, const glm::dvec3& direction,
                          const ShapeSettings& settings) {
  switch (facet_class(normal, direction, settings.tau_deg)) {
    case FacetClass::up:
      return region_of(is_free(mesh, facet, point, direction), false);
    case FacetClass::down:
      return region_of(false, is_free(mesh, facet, point, -direction));
    case FacetClass::near_vertical:
      break;
  }
  const glm::dvec3 outward = glm::normalize(normal - glm::dot(normal, direction) * direction);
  const glm::dvec3 from = point + settings.lateral_tolerance * outward;
  return region_of(is_free(mesh, k_no_facet, from, direction), is_free(mesh, k_no_facet, from, -direction));
}

BruteForceAreas brute_force_areas(const TriangleMesh& mesh, const glm::dvec3& direction,
                                  const ShapeSettings& settings, std::size_t samples, std::uint32_t seed) {
  const FacetGeometry geometry = facet_geometry(mesh);
  std::mt19937 random(seed);
  const auto fraction = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  BruteForceAreas result;
  RegionValues variance;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    // A grid of n x n cells over the unit square, each with one point, folded onto the triangle.
    const double share = geometry.areas[facet] / geometry.total_area * static_cast<double>(samples);
    const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(share))));
    const double weight = geometry.areas[facet] / (n * n);
    RegionValues hits;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        double u = (i + fraction()) / n, v = (j + fraction()) / n;
        if (u + v > 1.0) {
          u = 1.0 - u;
          v = 1.0 - v;
        }
        const glm::dvec3& a = mesh.corner(facet, 0);
        const glm::dvec3 point = a + u * (mesh.corner(facet, 1) - a) + v * (mesh.corner(facet, 2) - a);
        const Region region =
            brute_force_region(mesh, facet, point, geometry.normals[facet], direction, settings);
        result.areas[region] += weight;
        hits[region] += 1.0;
      }
    }
    for (const Region region : k_regions) {
      const double p = hits[region] / (n * n);
      variance[region] += p * (1.0 - p) * geometry.areas[facet] * geometry.areas[facet] / (n * n);
    }
  }
  for (const Region region : k_regions) result.two_errors[region] = 2.0 * std::sqrt(variance[region]);
  return result;
}

}  // namespace moldlight::test
