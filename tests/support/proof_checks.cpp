#include "support/proof_checks.hpp"

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

glm::dvec3 random_point(const SurfaceElement& element, Random& random) {
  if (element.is_point) return element.corners[0];
  double u = random.between(0.0, 1.0), v = random.between(0.0, 1.0);
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const auto& [a, b, c] = element.corners;
  return a + u * (b - a) + v * (c - a);
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

}  // namespace

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
