// The histogram of normals, and candidates that need no search: coordinate axes, principal axes, planes, the
// uniform set, the user's own.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/symmetric_eigen.hpp"
#include "sweep/candidates/candidate.hpp"
#include "sweep/candidates/candidate_sources.hpp"

namespace moldlight {

namespace {

constexpr double k_cells_per_unit = 573.0;  // a tenth of a degree

std::uint64_t cell_key(const glm::dvec3& normal) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = key << 12 | static_cast<std::uint64_t>(std::lround((normal[axis] + 1.0) * k_cells_per_unit));
  }
  return key;
}

constexpr double k_least_plane_share = 0.005;
constexpr double k_plane_spread_deg = 0.1;   // normals of one plane
constexpr double k_least_moment_gap = 1e-3;  // of the greatest moment

}  // namespace

std::vector<NormalCell> normal_histogram(const FacetGeometry& geometry) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> facets;
  facets.reserve(geometry.areas.size());
  for (std::uint32_t facet = 0; facet < geometry.areas.size(); ++facet) {
    if (geometry.areas[facet] > 0.0)
      facets.emplace_back(cell_key(half_sphere(geometry.normals[facet])), facet);
  }
  std::sort(facets.begin(), facets.end());

  std::vector<NormalCell> cells;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (i == 0 || facets[i].first != facets[i - 1].first) cells.emplace_back();
    const std::uint32_t facet = facets[i].second;
    cells.back().normal += geometry.areas[facet] * half_sphere(geometry.normals[facet]);
    cells.back().area += geometry.areas[facet];
  }
  for (NormalCell& cell : cells) cell.normal = half_sphere(glm::normalize(cell.normal));
  std::ranges::stable_sort(cells, std::greater{}, &NormalCell::area);
  return cells;
}

NormalCell mean_normal(const std::vector<NormalCell>& cells, const glm::dvec3& normal, double radius_deg) {
  const double least_cosine = std::cos(glm::radians(radius_deg));
  NormalCell mean;
  for (const NormalCell& cell : cells) {
    const double cosine = glm::dot(cell.normal, normal);
    if (std::abs(cosine) < least_cosine) continue;
    mean.normal += cosine < 0.0 ? -cell.area * cell.normal : cell.area * cell.normal;
    mean.area += cell.area;
  }
  mean.normal = mean.area > 0.0 ? half_sphere(glm::normalize(mean.normal)) : normal;
  return mean;
}

std::vector<Candidate> coordinate_axis_candidates() {
  std::vector<Candidate> candidates;
  for (const int axis : {0, 1, 2}) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    candidates.push_back(
        {direction, {{CandidateKind::axis, fmt::format("{}-axis of the file", "xyz"[axis]), 0.0}}});
  }
  return candidates;
}

std::vector<Candidate> principal_axis_candidates(const TriangleMesh& mesh, const FacetGeometry& geometry) {
  if (geometry.total_area <= 0.0) return {};
  glm::dvec3 centroid(0.0);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    for (int corner = 0; corner < 3; ++corner)
      centroid += geometry.areas[facet] / 3.0 * mesh.corner(facet, corner);
  }
  centroid /= geometry.total_area;

  // Second moment of a triangle: A/12 (sum over corners of p p^T + 9 m m^T), m its centroid.
  glm::dmat3 moments(0.0);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    glm::dvec3 sum(0.0);
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 p = mesh.corner(facet, corner) - centroid;
      moments += geometry.areas[facet] / 12.0 * glm::outerProduct(p, p);
      sum += p;
    }
    moments += geometry.areas[facet] / 12.0 * glm::outerProduct(sum, sum);
  }

  const SymmetricEigen<3> eigen = symmetric_eigen<3>(moments);
  const double gap = k_least_moment_gap * eigen.values[2];
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool apart_from_lower = i == 0 || eigen.values[i] - eigen.values[i - 1] > gap;
    const bool apart_from_upper = i == 2 || eigen.values[i + 1] - eigen.values[i] > gap;
    if (!apart_from_lower || !apart_from_upper) continue;
    static constexpr const char* k_reasons[] = {"thinnest principal axis", "middle principal axis",
                                                "longest principal axis"};
    candidates.push_back({half_sphere(eigen.vectors[i]), {{CandidateKind::principal, k_reasons[i], 0.0}}});
  }
  return candidates;
}

std::vector<Candidate> plane_candidates(const std::vector<NormalCell>& cells, double total_area,
                                        std::size_t most) {
  std::vector<Candidate> candidates;
  for (const NormalCell& cell : cells) {
    if (candidates.size() == most) break;
    // A plane on a border of cells is in up to eight of them.
    if (8.0 * cell.area < k_least_plane_share * total_area) break;
    const NormalCell plane = mean_normal(cells, cell.normal, k_plane_spread_deg);
    const double share = plane.area / total_area;
    if (share < k_least_plane_share) continue;
    const bool known = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
      return line_angle_deg(candidate.direction, plane.normal) < 2.0 * k_plane_spread_deg;
    });
    if (known) continue;
    candidates.push_back(
        {plane.normal,
         {{CandidateKind::plane, fmt::format("normal of planes, {:.1f} % of the surface", 100.0 * share),
           share}}});
  }
  return candidates;
}

std::vector<glm::dvec3> fibonacci_half_sphere(std::size_t count) {
  std::vector<glm::dvec3> directions;
  directions.reserve(count);
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1.0 - (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double radius = std::sqrt(1.0 - z * z), angle = golden_angle * static_cast<double>(i);
    directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return directions;
}

std::vector<Candidate> uniform_candidates(std::size_t count) {
  std::vector<Candidate> candidates;
  candidates.reserve(count);
  for (const glm::dvec3& direction : fibonacci_half_sphere(count)) {
    candidates.push_back(
        {direction, {{CandidateKind::uniform, fmt::format("one of {} even directions", count), 0.0}}});
  }
  return candidates;
}

std::vector<Candidate> user_candidates(std::span<const glm::dvec3> directions) {
  std::vector<Candidate> candidates;
  for (const glm::dvec3& direction : directions) {
    candidates.push_back({unit_direction(direction), {{CandidateKind::user, "given by the user", 0.0}}});
  }
  return candidates;
}

}  // namespace moldlight
