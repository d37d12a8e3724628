// Canonical directions: from planes and round walls, put together.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/faces.hpp"
#include "sweep/candidates/candidate_sources.hpp"

namespace moldlight {

namespace {

constexpr double k_group_deg = 0.1;               // lines of one group
constexpr double k_flat_deg = 0.05;               // normals of a plane from their mean
constexpr double k_on_file_deg = 0.05;            // a group that an axis of the file stands for
constexpr double k_least_canonical_share = 0.01;  // of the surface
constexpr double k_told_rounds = 0.1;             // of the group's surface
constexpr double k_drafted_deg = 3.0;             // walls lean by it; nor are two closer
constexpr std::size_t k_most = 12;
constexpr std::size_t k_most_groups = 256;  // beyond them there is nothing large in free-form surfaces

/// A plane or a round wall.
struct Feature {
  glm::dvec3 line{0, 0, 1};  // unit
  double area = 0.0;
  bool round = false;
};

struct Group {
  glm::dvec3 head{0, 0, 1};                   // line of its largest member
  glm::dvec3 of_planes{0.0}, of_rounds{0.0};  // lines on the head's side, by area
  double area = 0.0, weight = 0.0;            // its own, and what else speaks for it

  /// Normals of planes are known better than axes.
  [[nodiscard]] glm::dvec3 line() const {
    return half_sphere(glm::normalize(glm::length(of_planes) > 0.0 ? of_planes : of_rounds));
  }
  [[nodiscard]] bool round() const { return glm::length(of_planes) <= 0.0; }
};

/// Faces all of whose facets face the same way.
void add_planes(const PartModel& model, std::vector<Feature>& features) {
  const FacetGeometry& geometry = model.geometry;
  const Faces faces = smooth_faces(model.part.mesh, geometry, model.adjacency);
  const double least_cosine = std::cos(glm::radians(k_flat_deg));
  for (std::uint32_t face = 0; face < faces.count(); ++face) {
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const FacetIndex facet : faces.facets(face)) {
      sum += geometry.areas[facet] * geometry.normals[facet];
      area += geometry.areas[facet];
    }
    const double length = glm::length(sum);
    if (area > 0.0 && length >= least_cosine * area)
      features.push_back({.line = sum / length, .area = area, .round = false});
  }
}

std::vector<Group> grouped(std::vector<Feature> features) {
  std::ranges::stable_sort(features, std::greater{}, &Feature::area);
  std::vector<Group> groups;
  for (const Feature& feature : features) {
    auto group = std::ranges::find_if(
        groups, [&](const Group& each) { return line_angle_deg(each.head, feature.line) <= k_group_deg; });
    if (group == groups.end()) {
      if (groups.size() == k_most_groups) continue;
      group = groups.insert(groups.end(), Group{.head = feature.line});
    }
    const double sign = glm::dot(group->head, feature.line) < 0.0 ? -1.0 : 1.0;
    (feature.round ? group->of_rounds : group->of_planes) += sign * feature.area * feature.line;
    group->area += feature.area;
  }
  std::ranges::stable_sort(groups, std::greater{}, &Group::area);
  return groups;
}

bool are_perpendicular(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(line_angle_deg(a, b) - 90.0) <= k_group_deg;
}

/// Of planes across an axis and round walls about it. Opposite walls with draft, which lean to both sides of
/// it, speak for it, too, as far as the one is as large as the other.
double area_for(const glm::dvec3& axis, std::span<const Group> groups) {
  double area = 0.0;
  std::array<double, 2> beside{};
  std::optional<glm::dvec3> first;
  for (const Group& group : groups) {
    const glm::dvec3 line = group.line();
    const double angle_deg = line_angle_deg(axis, line);
    if (angle_deg <= k_on_file_deg) {
      area += group.area;
    } else if (angle_deg <= k_drafted_deg) {
      const glm::dvec3 off = (glm::dot(line, axis) < 0.0 ? -line : line) - axis;
      if (!first) first = off;
      beside[glm::dot(off, *first) < 0.0 ? 1 : 0] += group.area;
    }
  }
  return area + 2.0 * std::min(beside[0], beside[1]);
}

/// Axes of the file are none of a part that is turned in it: where it speaks for none of them, or for one
/// alone, about which its planes at a right angle are turned.
void drop_axes_of_the_file(std::span<Candidate> axes, std::span<const glm::dvec3> named) {
  const auto is_spoken_for = [](const Candidate& axis) {
    return axis.canonical && axis.canonical->share >= k_least_canonical_share;
  };
  const auto number = std::ranges::count_if(axes, is_spoken_for);
  const auto only = std::ranges::find_if(axes, is_spoken_for);
  const auto is_turned_about = [&](const glm::dvec3& axis) {
    return std::ranges::any_of(named, [&](const glm::dvec3& one) {
      return are_perpendicular(one, axis) && std::ranges::any_of(named, [&](const glm::dvec3& other) {
               return are_perpendicular(other, axis) && are_perpendicular(one, other);
             });
    });
  };
  if (number > 1 || (number == 1 && !is_turned_about(only->direction))) return;
  for (Candidate& axis : axes) {
    if (!is_spoken_for(axis)) axis.canonical.reset();
  }
}

Candidate canonical(const glm::dvec3& direction, CandidateKind kind, std::string name, double share,
                    std::string reason) {
  return {.direction = direction,
          .sources = {{kind, std::move(reason), share}},
          .canonical = Canonical{.name = std::move(name), .share = share}};
}

}  // namespace

std::vector<Candidate> canonical_candidates(const PartModel& model) {
  const FacetGeometry& geometry = model.geometry;
  std::vector<Feature> features;
  add_planes(model, features);
  for (const CurvedPatch& patch : curved_patches(geometry, model.adjacency))
    features.push_back({.line = patch.axis, .area = patch.area, .round = true});
  std::vector<Group> groups = grouped(std::move(features));
  for (Group& group : groups) group.weight = area_for(group.line(), groups);
  std::ranges::stable_sort(groups, std::greater{}, &Group::weight);

  std::vector<Candidate> found = coordinate_axis_candidates();
  for (Candidate& axis : found) {
    axis.canonical = Canonical{.name = axis.direction.x > 0.0   ? "x"
                                       : axis.direction.y > 0.0 ? "y"
                                                                : "z",
                               .share = area_for(axis.direction, groups) / geometry.total_area};
  }
  const std::size_t axes = found.size();
  std::size_t number = axes;
  std::vector<glm::dvec3> named;
  for (const Group& group : groups) {
    const double share = group.weight / geometry.total_area;
    if (number == k_most || share < k_least_canonical_share) break;
    if (group.area / geometry.total_area < k_least_canonical_share) continue;
    const bool largest = named.empty();
    const glm::dvec3 line = named.emplace_back(group.line());
    if (std::ranges::any_of(std::span(found).first(axes), [&](const Candidate& axis) {
          return line_angle_deg(axis.direction, line) <= k_on_file_deg;
        }))
      continue;
    const std::string of_surface =
        fmt::format("{:.{}f} % of the surface", 100.0 * share, share < 0.095 ? 1 : 0);
    const bool has_rounds = glm::length(group.of_rounds) >= k_told_rounds * group.area;
    const std::string name = fmt::format("{}{}, {}",
                                         group.round() ? ""
                                         : largest     ? "normal of the largest plane"
                                                       : "normal of planes",
                                         group.round() ? "axis of round walls"
                                         : has_rounds  ? " and axis of round walls"
                                                       : "",
                                         of_surface);
    Candidate candidate =
        canonical(line, group.round() ? CandidateKind::revolution : CandidateKind::plane, name, share, name);
    const auto beside = [&](const Candidate& other) {
      return other.canonical && line_angle_deg(other.direction, line) <= k_drafted_deg;
    };
    // The heavier of two that lie beside each other stands for both.
    if (std::ranges::any_of(found, [&](const Candidate& other) {
          return beside(other) && other.canonical->share >= share;
        })) {
      candidate.canonical.reset();
    } else {
      for (Candidate& other : found) {
        if (beside(other)) other.canonical.reset();
      }
      ++number;
    }
    found.push_back(std::move(candidate));
  }
  if (!named.empty()) {
    drop_axes_of_the_file(std::span(found).first(axes), named);
    return found;
  }
  for (Candidate& principal : principal_axis_candidates(model.part.mesh, geometry)) {
    principal.canonical = Canonical{.name = principal.sources.front().reason, .share = 0.0};
    found.push_back(std::move(principal));
  }
  return found;
}

}  // namespace moldlight
