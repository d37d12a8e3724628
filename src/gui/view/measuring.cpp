#include "gui/view/measuring.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight::gui {

namespace {

constexpr double k_parallel_deg = 0.5;

}  // namespace

MeasuredPlace measured_place(const PartModel& model, const PickedPoint& point) {
  return {glm::dvec3(point.position) * model.frame.diagonal + model.frame.center,
          model.geometry.normals[point.facet]};
}

void Measuring::add(const MeasuredPlace& place) {
  if (places.size() == 2) places.clear();
  places.push_back(place);
}

MeasuredPair measured(const MeasuredPlace& a, const MeasuredPlace& b, const glm::dvec3& direction) {
  const glm::dvec3 way = b.at - a.at;
  MeasuredPair pair;
  pair.distance = glm::length(way);
  pair.along = std::abs(glm::dot(way, direction));
  pair.across = glm::length(glm::cross(way, direction));
  pair.angle_deg =
      glm::degrees(std::atan2(glm::length(glm::cross(a.normal, b.normal)), glm::dot(a.normal, b.normal)));
  if (std::min(pair.angle_deg, 180.0 - pair.angle_deg) < k_parallel_deg)
    pair.between_planes = std::abs(glm::dot(way, a.normal));
  return pair;
}

}  // namespace moldlight::gui
