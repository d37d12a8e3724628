#include "support/proof_checks.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "mold/draft.hpp"

namespace moldlight::test {

namespace {

/// A cell of the given generation, anywhere.
SphereCell random_cell(int generation, Random& random) {
  SphereCell cell = half_sphere_cells()[random.below(4)];
  for (int k = 0; k < generation; ++k) cell = cell.quarters()[random.below(4)];
  return cell;
}

/// Off the border by more than rounding to single precision moves a ray's start: one that begins on an edge
/// may begin behind the wall that stands on it.
glm::dvec3 random_point(const SurfaceElement& element, Random& random) {
  constexpr double k_off = 1e-6;
  if (element.is_point) return element.corners[0];
  double u = random.between(0.0, 1.0), v = random.between(0.0, 1.0);
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const auto& [a, b, c] = element.corners;
  // What each weight is at least: the share of k_off in the corner's height over the opposite side.
  const double twice_area = glm::length(glm::cross(b - a, c - a));
  const glm::dvec3 least =
      k_off / twice_area * glm::dvec3(glm::distance(b, c), glm::distance(c, a), glm::distance(a, b));
  const double rest = 1.0 - least.x - least.y - least.z;
  if (!(rest > 0.0)) return (a + b + c) / 3.0;
  const glm::dvec3 weights = least + rest * glm::dvec3(1.0 - u - v, u, v);
  return weights.x * a + weights.y * b + weights.z * c;
}

/// By single rays, of which only those count that meet what faces them.
bool undercut_by_rays(const ProofModel& model, FacetIndex facet, const glm::dvec3& point,
                      const glm::dvec3& direction) {
  const ProofQuery query = model.query();
  const glm::dvec3& normal = model.part().geometry.normals[facet];
  const auto blocked = [&](const glm::dvec3& from, const glm::dvec3& along) {
    return model.part().rays.first_hit(glm::vec3(from), glm::vec3(along), true).has_value();
  };
  switch (facet_class(normal, direction, query.tau_deg)) {
    case FacetClass::up:
      return blocked(point, direction);
    case FacetClass::down:
      return blocked(point, -direction);
    case FacetClass::near_vertical:
      break;
  }
  const glm::dvec3 beside(
      lateral_point(glm::vec3(point), normal, {.direction = direction, .lateral = query.lateral}));
  return blocked(beside, direction) && blocked(beside, -direction);
}

/// Along the direction alone.
bool blocked_by_rays(const ProofModel& model, FacetIndex facet, const glm::dvec3& point,
                     const glm::dvec3& direction) {
  const ProofQuery query = model.query();
  const glm::dvec3& normal = model.part().geometry.normals[facet];
  const FacetClass facing = facet_class(normal, direction, query.tau_deg);
  if (facing == FacetClass::down) return true;
  const glm::vec3 start =
      facing == FacetClass::up
          ? glm::vec3(point)
          : lateral_point(glm::vec3(point), normal, {.direction = direction, .lateral = query.lateral});
  return model.part().rays.first_hit(start, glm::vec3(direction), true).has_value();
}

}  // namespace

RaysChecked check_blocked_along(const ProofModel& model, std::span<const SurfaceElement> elements,
                                std::size_t wanted, std::uint32_t seed) {
  CertainUndercut tester(model.part(), model.query());
  Random random(seed);
  RaysChecked checked;
  for (std::size_t tried = 0; checked.certain < wanted && tried < 40 * wanted; ++tried) {
    SphereCell cell = random_cell(2 + static_cast<int>(random.below(7)), random);
    const auto& [a, b, c] = cell.corners();
    if (random.chance(0.5)) cell = SphereCell({-c, -b, -a});
    const SurfaceElement& element = elements[random.below(elements.size())];
    if (glm::dot(model.part().geometry.normals[element.facet], cell.centre()) < -std::sin(cell.radius_rad()))
      continue;
    if (!tester.blocked_along(element, cell)) continue;
    ++checked.certain;
    const glm::dvec3 point = random_point(element, random);
    if (!blocked_by_rays(model, element.facet, point, random_direction(cell, random))) ++checked.wrong;
  }
  return checked;
}

RaysChecked check_certain(const ProofModel& model, std::span<const SurfaceElement> elements,
                          std::size_t wanted, std::size_t directions, std::uint32_t seed) {
  CertainUndercut tester(model.part(), model.query());
  Random random(seed);
  RaysChecked checked;
  for (std::size_t tried = 0; checked.certain < wanted && tried < 40 * wanted; ++tried) {
    const SphereCell cell = random_cell(2 + static_cast<int>(random.below(7)), random);
    const SurfaceElement& element = elements[random.below(elements.size())];
    if (tester.ask(element, cell).certain_area <= 0.0) continue;
    for (std::size_t k = 0; k < directions; ++k) {
      const glm::dvec3 point = random_point(element, random);
      ++checked.certain;
      if (!undercut_by_rays(model, element.facet, point, random_direction(cell, random))) ++checked.wrong;
    }
  }
  return checked;
}

}  // namespace moldlight::test
