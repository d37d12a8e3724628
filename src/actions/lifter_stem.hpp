// The stem that carries a lifter: a square bar from above what it forms out of its half.
#pragma once

#include <span>

#include "actions/side_action.hpp"

namespace moldlight {

/// Lengths are in the part's unit.
struct StemQuestion {
  const PartModel& model;
  const SideAction& action;               // a lifter
  glm::dvec3 side{0, 0, 1};               // unit: the half's, along which it leaves
  double section = 4.0;                   // > 0, of each side of the square
  double head = 0.0;                      // how thick the lifter's head is along its way
  double lateral = 0.0;                   // tolerance
  std::span<const glm::dvec3> surface{};  // that the head forms, not empty
};

/// A closed, oriented box that stands on the head and nowhere in it. Of the places behind the surface that
/// touch the head it takes the nearest where the part is not in the way, closed, on the lifter's way and as
/// the part leaves; where there is none the nearest of all.
[[nodiscard]] TriangleMesh lifter_stem(const StemQuestion& question);

}  // namespace moldlight
