#include "render/section_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr double k_aside = 0.12;  // unit frame

/// Across the direction: the coordinate axis that lies most across it, turned about it.
glm::dvec3 across(const glm::dvec3& direction, double turn_deg) {
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                          : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  const glm::dvec3 start = glm::normalize(axis - glm::dot(axis, direction) * direction);
  const double turn = glm::radians(turn_deg);
  return std::cos(turn) * start + std::sin(turn) * glm::cross(direction, start);
}

}  // namespace

std::optional<CutPlane> SectionPlanes::plane(const LookSettings& look, const glm::dvec3& direction) {
  if (look.section == Section::off) return std::nullopt;
  // Of an axis the side goes that the usual view shows.
  const glm::dvec3 normal = look.section == Section::across  ? direction
                            : look.section == Section::along ? across(direction, look.section_turn_deg)
                            : look.section == Section::x     ? glm::dvec3(1, 0, 0)
                            : look.section == Section::y     ? glm::dvec3(0, -1, 0)
                                                             : glm::dvec3(0, 0, 1);
  if (normal != normal_) {
    normal_ = normal;
    least_ = std::numeric_limits<double>::infinity();
    greatest_ = -least_;
    for (const glm::dvec3& vertex : mesh_->vertices) {
      const double height = glm::dot(vertex - frame_->center, normal) / frame_->diagonal;
      least_ = std::min(least_, height);
      greatest_ = std::max(greatest_, height);
    }
  }
  const double extent = greatest_ - least_;
  const double offset = least_ + look.section_at * extent;
  // Beside the direction's own arrow.
  const glm::dvec3 aside =
      std::abs(glm::dot(normal, direction)) > 0.9 ? k_aside * across(normal, 45.0) : glm::dvec3(0.0);
  return CutPlane{.normal = normal, .offset = offset, .extent = extent, .foot = offset * normal + aside};
}

}  // namespace moldlight
