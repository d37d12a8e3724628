// From where a part is best looked at.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "classify/map_comparison.hpp"
#include "classify/still_picture.hpp"
#include "render/camera.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_view_samples = 4000;
/// Undercuts of less than this share of the part's surface are not worth a view of their own.
constexpr double k_least_share = 1e-6;
constexpr std::array k_elevations_deg = {24.0, 38.0, 56.0, -24.0, -42.0};
constexpr std::array k_azimuths_deg = {30.0, 55.0, 120.0, 145.0, 210.0, 235.0, 300.0, 325.0, 85.0, 265.0};

struct Spot {
  glm::vec3 position;  // unit frame
  glm::vec3 normal;
};

/// Spots spread evenly over the undercuts, or over everything where there are none.
void spread_spots(const PartModel& model, const SplitMesh& split, std::size_t samples,
                  std::vector<Spot>& spots) {
  double total = 0.0;
  for (const SplitPiece& piece : split.pieces)
    total += piece.region == Region::undercut ? piece_area(split, piece) : 0.0;
  const bool any = total > k_least_share * model.geometry.total_area;
  const double step = (any ? total : model.geometry.total_area) / static_cast<double>(samples);
  double sum = 0.0, next = 0.5 * step;
  for (const SplitPiece& piece : split.pieces) {
    if (any && piece.region != Region::undercut) continue;
    sum += piece_area(split, piece);
    for (; next < sum; next += step) {
      // The recurrence of triangle_place() from its middle on: of a round part many views are as good, and
      // the spots decide which is taken.
      const auto k = static_cast<double>(spots.size());
      TrianglePlace place{std::fmod(0.5 + 0.7548776662466927 * k, 1.0),
                          std::fmod(0.5 + 0.5698402909980532 * k, 1.0)};
      if (place.u + place.v > 1.0) place = {1.0 - place.u, 1.0 - place.v};
      const glm::dvec3 point = piece_point(split, piece, place);
      spots.push_back({model.frame.to_unit(point), glm::vec3(model.geometry.normals[piece.facet])});
    }
  }
}

/// Sum over the spots that are seen of how frontal they are.
double visible_amount(const PartModel& model, const std::vector<Spot>& spots, const glm::vec3& to_viewer) {
  double sum = 0.0;
  for (const Spot& spot : spots) {
    const float frontal = glm::dot(spot.normal, to_viewer);
    if (frontal < 0.05F || model.rays().surface_point_blocked(spot.position, spot.normal, to_viewer))
      continue;
    sum += std::sqrt(static_cast<double>(frontal));
  }
  return sum;
}

}  // namespace

glm::dquat revealing_orientation(const PartModel& model,
                                 std::span<const std::shared_ptr<const SplitMesh>> splits,
                                 const glm::dvec3& up) {
  std::vector<Spot> spots;
  for (const auto& split : splits) spread_spots(model, *split, k_view_samples / splits.size(), spots);
  const glm::dvec3 ahead = std::abs(up.x) > 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(ahead - glm::dot(ahead, up) * up), y = glm::cross(up, x);
  std::vector<glm::dvec3> views;
  for (const double elevation_deg : k_elevations_deg) {
    for (const double azimuth_deg : k_azimuths_deg) {
      const double elevation = glm::radians(elevation_deg), azimuth = glm::radians(azimuth_deg - 90.0);
      views.push_back(std::cos(elevation) * (std::cos(azimuth) * x + std::sin(azimuth) * y) +
                      std::sin(elevation) * up);
    }
  }
  std::vector<double> amounts(views.size());
  tbb::parallel_for(std::size_t{0}, views.size(), [&](std::size_t k) {
    // A little is given for a view from above and from the front, which show a part's shape best.
    const glm::dvec3& view = views[k];
    const double habit = 1.0 + 0.06 * (glm::dot(view, up) > 0.0 ? 1.0 : 0.0) - 0.03 * glm::dot(view, y);
    amounts[k] = habit * visible_amount(model, spots, glm::vec3(view));
  });
  const auto best = std::max_element(amounts.begin(), amounts.end());
  return looking_along(-views[static_cast<std::size_t>(best - amounts.begin())], up);
}

}  // namespace moldlight
