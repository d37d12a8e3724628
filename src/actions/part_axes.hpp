// Where a part points across a parting direction: axes that turn with it and are mirrored with it, and an
// order of places by them.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/part_model.hpp"

namespace moldlight {

/// Orthonormal; z is the parting direction. Left-handed for parts of one hand, so that a part and its mirror
/// image have the same places. Lengths are the part's.
struct PartAxes {
  glm::dvec3 centre{0.0};  // of the surface
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  double step = 1e-6;              // places that differ by less are the same
  bool by_walls = false;           // enough of the surface says so
  std::vector<glm::dvec3> across;  // x and y in both senses, and where other upright walls face, the most
                                   // of them first
};

/// x is where most of the upright walls face, or stand along. Where they face all round, the file's own axes
/// take that part.
[[nodiscard]] PartAxes part_axes(const PartModel& model, const glm::dvec3& direction);

/// In the order of height, then along x, then along y.
struct PlaceKey {
  std::int64_t height = 0, x = 0, y = 0;
  auto operator<=>(const PlaceKey&) const = default;
};
[[nodiscard]] PlaceKey place_key(const PartAxes& axes, const glm::dvec3& place);
/// Of a direction (unit).
[[nodiscard]] PlaceKey direction_key(const PartAxes& axes, const glm::dvec3& direction);

}  // namespace moldlight
