#include "actions/pull_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "actions/release.hpp"
#include "mold/round_wall.hpp"

namespace moldlight {

namespace {

constexpr double k_same_deg = 0.01;       // the rounding of files turns walls and axes by less
constexpr std::size_t k_most_planes = 8;  // of an undercut, the largest
constexpr std::size_t k_most_walls = 4;   // round ones looked for
constexpr double k_plane_cosine = 0.99999, k_smooth_wall = 0.7;

/// Facets of an undercut by the plane they lie in, and the area there.
struct Plane {
  glm::dvec3 normal{0.0};
  double area = 0.0;
  FacetIndex facet = 0;
};

/// The largest first; of those that rounding alone distinguishes the one that faces up more, and so on.
void put_in_order(const PartAxes& axes, std::vector<Plane>& planes) {
  constexpr double k_steps = 1e4;  // of the logarithm of an area
  std::ranges::stable_sort(planes, std::greater(), [&](const Plane& plane) {
    return std::pair(std::llround(k_steps * std::log(std::max(plane.area, 1e-300))),
                     direction_key(axes, plane.normal));
  });
}

std::vector<Plane> planes_of(const PulledSurface& surface, const Undercut& undercut) {
  const auto& [model, split, axes] = surface;
  std::map<FacetIndex, double> areas;
  for (const std::uint32_t piece : undercut.pieces) {
    const auto& corners = split.pieces[piece].corners;
    const glm::dvec3& a = split.vertices[corners[0]];
    areas[split.pieces[piece].facet] +=
        0.5 * glm::length(glm::cross(split.vertices[corners[1]] - a, split.vertices[corners[2]] - a));
  }
  std::vector<Plane> facets;
  for (const auto& [facet, area] : areas) facets.push_back({model.geometry.normals[facet], area, facet});
  put_in_order(axes, facets);
  constexpr std::size_t k_most_facets = 4000;  // the small rest adds no plane worth a look
  facets.resize(std::min(facets.size(), k_most_facets));
  std::vector<Plane> planes;
  for (const Plane& facet : facets) {
    const auto same = std::ranges::find_if(
        planes, [&](const Plane& plane) { return glm::dot(plane.normal, facet.normal) > k_plane_cosine; });
    if (same != planes.end()) {
      same->area += facet.area;
    } else if (planes.size() < 16 * k_most_planes) {
      planes.push_back(facet);
    }
  }
  put_in_order(axes, planes);
  return planes;
}

/// Whether a round wall faces its axis around a facet, as that of a hole does: the facets beside it, across a
/// bend, lie in front of it.
bool is_hollow(const PartModel& model, FacetIndex facet) {
  const TriangleMesh& mesh = model.part.mesh;
  const glm::dvec3& normal = model.geometry.normals[facet];
  const auto ahead = [&](FacetIndex beside) {
    double most = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double its = glm::dot(mesh.corner(beside, k) - mesh.corner(facet, 0), normal);
      most = std::abs(its) > std::abs(most) ? its : most;
    }
    return most;
  };
  double sum = 0.0;
  for (const FacetIndex beside : model.adjacency.across[facet]) {
    if (beside == k_no_facet || glm::dot(model.geometry.normals[beside], normal) < k_smooth_wall) continue;
    sum += ahead(beside);
    for (const FacetIndex next : model.adjacency.across[beside]) {
      if (next != k_no_facet && glm::dot(model.geometry.normals[next], normal) > k_smooth_wall)
        sum += ahead(next);
    }
  }
  return sum > 0.0;
}

/// Collects directions, each once.
class Collector {
 public:
  Collector(const glm::dvec3& direction, double incline_deg)
      : direction_(direction), incline_deg_(incline_deg) {}

  /// As it is and level, in both senses.
  void add_line(const glm::dvec3& line, PullSource source, bool of_hole = false) {
    const double length = glm::length(line);
    if (length < 1e-9) return;
    for (const double sense : {1.0, -1.0}) add(sense / length * line, source, of_hole);
  }
  void add(const glm::dvec3& pull, PullSource source, bool of_hole = false) {
    const glm::dvec3 level = pull - glm::dot(pull, direction_) * direction_;
    // In the plane, to rounding, or close to it by rounding of the file: the plane's own.
    if (glm::length(level) > 1e-3) put({glm::normalize(level), source, of_hole});
    const double angle_deg = std::abs(elevation_deg(pull, direction_));
    if (angle_deg > 0.01 && angle_deg <= incline_deg_) put({pull, source, of_hole});
  }
  [[nodiscard]] std::vector<PullCandidate> take() { return std::move(found_); }

 private:
  void put(const PullCandidate& candidate) {
    const double near = std::cos(glm::radians(k_same_deg));
    for (PullCandidate& known : found_) {
      if (glm::dot(known.direction, candidate.direction) < near) continue;
      known.source = std::min(known.source, candidate.source);
      known.of_hole = known.of_hole || candidate.of_hole;
      return;
    }
    found_.push_back(candidate);
  }

  glm::dvec3 direction_;
  double incline_deg_;
  std::vector<PullCandidate> found_;
};

}  // namespace

double elevation_deg(const glm::dvec3& pull, const glm::dvec3& direction) {
  return glm::degrees(std::asin(std::clamp(glm::dot(pull, direction), -1.0, 1.0)));
}

std::vector<PullCandidate> own_pulls(const PulledSurface& surface, const Undercut& undercut,
                                     const ActionSettings& settings) {
  const auto& [model, split, axes] = surface;
  Collector found(axes.z, settings.incline_deg);
  for (const glm::dvec3& given : settings.side_directions) found.add(glm::normalize(given), PullSource::wish);
  for (const glm::dvec3& across : axes.across) found.add(across, PullSource::part);
  std::vector<Plane> planes = planes_of(surface, undercut);
  std::size_t walls = 0;
  for (const Plane& plane : planes) {
    if (walls == k_most_walls) break;
    const auto wall = round_wall(model.geometry, model.adjacency, plane.facet);
    if (!wall) continue;
    // A rounded edge says less of how an undercut leaves than the walls of the part do.
    constexpr double k_least_wall = 0.3;  // of the undercut's area
    const bool exact = wall->area >= k_least_wall * undercut.area;
    found.add_line(wall->axis, exact ? PullSource::exact : PullSource::shape,
                   exact && is_hollow(model, plane.facet));
    ++walls;
  }
  glm::dvec3 mean(0.0);
  for (const Plane& plane : planes) mean += plane.area * plane.normal;
  if (glm::length(mean) > 1e-6 * undercut.area) found.add(glm::normalize(mean), PullSource::even);
  planes.resize(std::min(planes.size(), k_most_planes));
  for (std::size_t i = 0; i < planes.size(); ++i) {
    found.add(planes[i].normal, PullSource::shape);
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec3 edge = glm::cross(planes[i].normal, planes[j].normal);
      if (glm::length(edge) > 0.05) found.add_line(edge, PullSource::shape);
    }
  }
  std::vector<PullCandidate> pulls = found.take();
  std::ranges::stable_sort(pulls, [&](const PullCandidate& a, const PullCandidate& b) {
    if (a.source != b.source) return a.source < b.source;
    return direction_key(surface.axes, a.direction) > direction_key(surface.axes, b.direction);
  });
  return pulls;
}

std::vector<PullCandidate> pull_fan(const PartAxes& axes) {
  constexpr int k_count = 72;
  std::vector<PullCandidate> fan;
  for (int k = 0; k < k_count; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / k_count;
    fan.push_back({std::cos(turn) * axes.x + std::sin(turn) * axes.y, PullSource::even});
  }
  return fan;
}

std::vector<PullCandidate> pull_sphere(const PartAxes& axes) {
  constexpr int k_count = 200;
  constexpr double k_golden_angle = 2.399963229728653;
  std::vector<PullCandidate> pulls;
  for (int k = 0; k < k_count; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / k_count, radius = std::sqrt(1.0 - z * z);
    pulls.push_back(
        {radius * (std::cos(k_golden_angle * k) * axes.x + std::sin(k_golden_angle * k) * axes.y) +
             z * axes.z,
         PullSource::even});
  }
  return pulls;
}

}  // namespace moldlight
