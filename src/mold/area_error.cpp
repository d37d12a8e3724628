#include "mold/area_error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/health.hpp"
#include "mold/draft.hpp"

namespace moldlight {

namespace {

constexpr double k_least_share = 1e-5;  // of the part's area
constexpr double k_large_share = 1e-3;  // of the part's area
constexpr auto k_undercut = static_cast<std::size_t>(Region::undercut);

constexpr double k_unit_roundoff = 0x1p-53;
constexpr double k_border_error = 1e-12;  // e
constexpr double k_wall_crossing = 0.01;  // s of near-vertical facets

/// Model units.
double perimeter(const TriangleMesh& mesh, FacetIndex facet) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) sum += glm::distance(mesh.corner(facet, k), mesh.corner(facet, (k + 1) % 3));
  return sum;
}

double faulty_area(const TriangleMesh& mesh, const HealthReport& health) {
  double sum = 0.0;
  const auto add_chains = [&](EdgeDefect defect) {
    for (const EdgeChain& chain : defect_chains(mesh, defect)) {
      const glm::dvec3& origin = mesh.vertices[chain.vertices.front()];
      glm::dvec3 twice(0.0);
      for (std::size_t k = 1; k + 1 < chain.vertices.size(); ++k) {
        twice += glm::cross(mesh.vertices[chain.vertices[k]] - origin,
                            mesh.vertices[chain.vertices[k + 1]] - origin);
      }
      sum += 0.5 * glm::length(twice);
    }
  };
  if (health.open_edges > 0) add_chains(EdgeDefect::open);
  if (health.inconsistent_edges > 0) add_chains(EdgeDefect::inconsistent);
  return sum;
}

}  // namespace

FacetUndercuts facet_undercuts(const FacetFractions& facet_fractions, const FacetGeometry& geometry,
                               const Adjacency& adjacency) {
  const auto belongs = [&](FacetIndex facet) {
    const double share = facet_fractions[facet][k_undercut];
    return share >= 0.5 || share * geometry.areas[facet] >= k_large_share * geometry.total_area;
  };
  FacetUndercuts undercuts;
  undercuts.of_facet.assign(facet_fractions.size(), k_no_facet);
  std::vector<FacetIndex> queue;
  for (FacetIndex seed = 0; seed < facet_fractions.size(); ++seed) {
    if (undercuts.of_facet[seed] != k_no_facet || !belongs(seed)) continue;
    const auto undercut = static_cast<FacetIndex>(undercuts.areas.size());
    double area = 0.0;
    queue.assign(1, seed);
    undercuts.of_facet[seed] = undercut;
    while (!queue.empty()) {
      const FacetIndex facet = queue.back();
      queue.pop_back();
      area += geometry.areas[facet] * facet_fractions[facet][k_undercut];
      for (const FacetIndex next : adjacency.across[facet]) {
        if (next == k_no_facet || undercuts.of_facet[next] != k_no_facet || !belongs(next)) continue;
        undercuts.of_facet[next] = undercut;
        queue.push_back(next);
      }
    }
    undercuts.areas.push_back(area);
  }

  std::vector<FacetIndex> order(undercuts.areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{}, [&](FacetIndex k) { return undercuts.areas[k]; });
  std::vector<FacetIndex> number(order.size(), k_no_facet);
  std::vector<double> areas;
  for (const FacetIndex undercut : order) {
    if (undercuts.areas[undercut] < k_least_share * geometry.total_area) break;
    number[undercut] = static_cast<FacetIndex>(areas.size());
    areas.push_back(undercuts.areas[undercut]);
  }
  for (FacetIndex& undercut : undercuts.of_facet) {
    if (undercut != k_no_facet) undercut = number[undercut];
  }
  undercuts.areas = std::move(areas);
  undercuts.count = undercuts.areas.size();
  return undercuts;
}

PartErrors part_errors(const TriangleMesh& mesh, const FacetGeometry& geometry, const HealthReport& health,
                       const UnitFrame& frame) {
  PartErrors errors;
  errors.facets = static_cast<double>(mesh.facets.size()) * k_unit_roundoff * geometry.total_area;
  double borders = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const double around = perimeter(mesh, facet);
    errors.facets += 4.0 * k_unit_roundoff * around * around;
    borders += k_border_error * frame.diagonal * around;
  }
  errors.shadow_gap = errors.facets + borders;
  errors.faulty_area = faulty_area(mesh, health);
  return errors;
}

double rounding_bound(const ExactPart& part, const ExactQuery& query, const ExactAreas& areas,
                      const PartErrors& errors) {
  const double sine_of_tau = std::sin(glm::radians(query.tau_deg));
  double sum = errors.facets;
  for (FacetIndex facet = 0; facet < areas.facet_fractions.size(); ++facet) {
    if (std::ranges::any_of(areas.facet_fractions[facet], [](double share) { return share == 1.0; }))
      continue;
    const double sine = glm::dot(part.geometry().normals[facet], query.direction);
    const bool is_wall = facet_class(sine, sine_of_tau) == FacetClass::near_vertical;
    const double off = k_border_error * part.frame().diagonal * perimeter(part.mesh(), facet);
    sum += std::min(part.geometry().areas[facet], off / (is_wall ? k_wall_crossing : std::abs(sine)));
  }
  return sum;
}

double mesh_doubt(const ExactPart& part, const ExactAreas& areas, const Adjacency& adjacency,
                  const PartErrors& errors) {
  const double gap = std::abs(areas.projected_core - areas.projected_cavity);
  double doubt = errors.faulty_area + (gap > errors.shadow_gap + areas.projected_doubt ? gap : 0.0);
  if (part.any_crossings()) {
    const FacetUndercuts undercuts = facet_undercuts(areas.facet_fractions, part.geometry(), adjacency);
    std::vector<bool> is_crossed(undercuts.count, false);
    for (FacetIndex facet = 0; facet < undercuts.of_facet.size(); ++facet) {
      if (part.crossings(facet).empty()) continue;
      if (undercuts.of_facet[facet] != k_no_facet) {
        is_crossed[undercuts.of_facet[facet]] = true;
      } else {
        doubt += part.geometry().areas[facet] *
                 areas.facet_fractions[facet][static_cast<std::size_t>(Region::undercut)];
      }
    }
    for (std::size_t undercut = 0; undercut < undercuts.count; ++undercut) {
      if (is_crossed[undercut]) doubt += undercuts.areas[undercut];
    }
  }
  return std::min(doubt, part.geometry().total_area);
}

}  // namespace moldlight
