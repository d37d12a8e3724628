#include "proof/certain_undercut.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr double k_wider_rad = 1e-9;

glm::dvec3 middle(const glm::dvec3& a, const glm::dvec3& b) { return glm::normalize(a + b); }

constexpr double k_shrink = 1e-5;
/// Of a draft angle against tau.
constexpr double k_rounding = 1e-9;

/// The corners of the part of a convex cone in which normal . u >= 0, in their order.
std::vector<glm::dvec3> clipped(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
  std::vector<glm::dvec3> kept;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const glm::dvec3 &from = corners[k], &to = corners[(k + 1) % corners.size()];
    const double a = glm::dot(normal, from), b = glm::dot(normal, to);
    if (a >= 0.0) kept.push_back(from);
    if ((a >= 0.0) != (b >= 0.0)) kept.push_back(glm::normalize(from + (a / (a - b)) * (to - from)));
  }
  return kept;
}

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

CertainUndercut::CertainUndercut(const ProofPart& part, const ProofQuery& query)
    : part_(part), tau_rad_(glm::radians(query.tau_deg)), lateral_(query.lateral), cone_(part) {}

bool CertainUndercut::keep(const ConeAnswer& cone, ElementAnswer& answer) const {
  answer.hidden_at_centre = answer.hidden_at_centre && cone.hit;
  answer.distance = std::max(answer.distance, cone.distance);
  return cone.blocked;
}

bool CertainUndercut::blocked(const Start& start, const SphereCell& cell, double sense,
                              ElementAnswer& answer) {
  std::array<glm::dvec3, 3> directions;
  // The opposite of a triangle runs the other way round.
  for (std::size_t k = 0; k < 3; ++k) directions[k] = sense * cell.corners()[sense > 0.0 ? k : 2 - k];
  return keep(cone_.ask({.points = {start.corners.data(), start.count},
                         .radius = start.radius,
                         .directions = directions,
                         .centre = sense * cell.centre()}),
              answer);
}

/// Along those directions alone that rise over the facet by tau: they lie on one side of the plane through
/// the level direction across the cell's middle that rises by tau along that middle.
bool CertainUndercut::blocked_above(const Start& start, const SphereCell& cell, double sense,
                                    const glm::dvec3& normal, ElementAnswer& answer) {
  const glm::dvec3 middle = sense * cell.centre();
  const glm::dvec3 level = middle - glm::dot(middle, normal) * normal;
  const double length = glm::length(level);
  if (length < 1e-6) return false;
  const glm::dvec3 rising = std::cos(tau_rad_) * normal - std::sin(tau_rad_) / length * level;
  std::array<glm::dvec3, 3> directions;
  for (std::size_t k = 0; k < 3; ++k) directions[k] = sense * cell.corners()[sense > 0.0 ? k : 2 - k];
  const std::vector<glm::dvec3> kept = clipped(directions, rising);
  if (kept.size() < 3) return true;  // none of them rises so much
  glm::dvec3 centre(0.0);
  for (const glm::dvec3& direction : kept) centre += direction;
  return keep(cone_.ask({.points = {start.corners.data(), start.count},
                         .radius = start.radius,
                         .directions = kept,
                         .centre = glm::normalize(centre)}),
              answer);
}

CertainUndercut::Start CertainUndercut::own_start(const SurfaceElement& element) const {
  Start own{element.corners, element.is_point ? 1U : 3U, 0.0};
  if (element.is_point) return own;
  const glm::dvec3 middle = element.middle();
  for (glm::dvec3& corner : own.corners) corner += k_shrink * (middle - corner);
  return own;
}

CertainUndercut::Start CertainUndercut::start_beside(const Start& own, const glm::dvec3& normal) const {
  Start beside = own;
  for (glm::dvec3& corner : beside.corners) corner += lateral_ * normal;
  beside.radius = 2.0 * lateral_ * std::sin(0.5 * tau_rad_);
  return beside;
}

ElementAnswer CertainUndercut::ask(const SurfaceElement& element, const SphereCell& cell) {
  ElementAnswer answer{.hidden_at_centre = true};
  const glm::dvec3& normal = part_.geometry.normals[element.facet];
  const double draft_rad = std::asin(std::clamp(glm::dot(normal, cell.centre()), -1.0, 1.0));
  const double reach_rad = cell.radius_rad() + k_rounding;
  const Start own = own_start(element);
  const double area = element.area * (element.is_point ? 1.0 : (1.0 - k_shrink) * (1.0 - k_shrink));
  bool certain = false;
  if (std::abs(draft_rad) - reach_rad >= tau_rad_) {
    certain = blocked(own, cell, draft_rad > 0.0 ? 1.0 : -1.0, answer);
  } else {
    const Start beside = start_beside(own, normal);
    const bool above = blocked(beside, cell, 1.0, answer);
    if (!above && !answer.hidden_at_centre) return answer;
    // Also where nothing is certain any more: both sides say whether the middle is hidden.
    const bool below = blocked(beside, cell, -1.0, answer);
    certain = above && below;
    if (certain && draft_rad + reach_rad >= tau_rad_) certain = blocked_above(own, cell, 1.0, normal, answer);
    if (certain && draft_rad - reach_rad <= -tau_rad_)
      certain = blocked_above(own, cell, -1.0, normal, answer);
  }
  if (certain) answer.certain_area = area;
  return answer;
}

bool CertainUndercut::blocked_along(const SurfaceElement& element, const SphereCell& cell) {
  ElementAnswer unused;
  const glm::dvec3& normal = part_.geometry.normals[element.facet];
  const double draft_rad = std::asin(std::clamp(glm::dot(normal, cell.centre()), -1.0, 1.0));
  const double reach_rad = cell.radius_rad() + k_rounding;
  if (draft_rad + reach_rad <= -tau_rad_) return true;
  const Start own = own_start(element);
  if (draft_rad - reach_rad >= tau_rad_) return blocked(own, cell, 1.0, unused);
  if (!blocked(start_beside(own, normal), cell, 1.0, unused)) return false;
  return draft_rad + reach_rad < tau_rad_ || blocked_above(own, cell, 1.0, normal, unused);
}

}  // namespace moldlight
