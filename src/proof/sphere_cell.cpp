#include "proof/sphere_cell.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr double k_wider_rad = 1e-9;

glm::dvec3 middle(const glm::dvec3& a, const glm::dvec3& b) { return glm::normalize(a + b); }

}  // namespace

SphereCell::SphereCell(const std::array<glm::dvec3, 3>& corners)
    : corners_(corners),
      centre_(glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]))),
      radius_rad_(0.0) {
  // By the sine of the half angle: an arc cosine has no digits for small ones.
  for (const glm::dvec3& corner : corners_)
    radius_rad_ = std::max(radius_rad_, 2.0 * std::asin(0.5 * glm::length(corner - centre_)) + k_wider_rad);
}

double SphereCell::radius_deg() const { return glm::degrees(radius_rad_); }

double SphereCell::share() const {
  // Van Oosterom & Strackee 1983.
  const auto& [a, b, c] = corners_;
  const double volume = glm::dot(a, glm::cross(b, c));
  const double angle = 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
  return angle / (2.0 * glm::pi<double>());
}

bool SphereCell::contains(const glm::dvec3& direction) const {
  constexpr double k_on_side = -1e-12;
  for (std::size_t k = 0; k < 3; ++k) {
    if (glm::dot(glm::cross(corners_[k], corners_[(k + 1) % 3]), direction) < k_on_side) return false;
  }
  return true;
}

std::array<SphereCell, 4> SphereCell::quarters() const {
  const auto& [a, b, c] = corners_;
  const glm::dvec3 ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
  return {SphereCell({a, ab, ca}), SphereCell({ab, b, bc}), SphereCell({ca, bc, c}),
          SphereCell({ab, bc, ca})};
}

std::array<SphereCell, 4> half_sphere_cells() {
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  return {SphereCell({x, y, z}), SphereCell({y, -x, z}), SphereCell({-x, -y, z}), SphereCell({-y, x, z})};
}

}  // namespace moldlight
