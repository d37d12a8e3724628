#include "sweep/sweep_map.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

void SweepMap::add(const EvaluatedDirection& direction) {
  evaluated.push_back(direction);
  field.add(direction.direction, direction.undercut);
  worst = std::max(worst, direction.undercut);
}

const EvaluatedDirection* SweepMap::nearest(const glm::dvec3& direction, double reach_deg) const {
  const EvaluatedDirection* found = nullptr;
  double greatest = std::cos(glm::radians(reach_deg));
  for (const EvaluatedDirection& each : evaluated) {
    const double cosine = std::abs(glm::dot(each.direction, direction));
    if (cosine < greatest) continue;
    greatest = cosine;
    found = &each;
  }
  return found;
}

}  // namespace moldlight
