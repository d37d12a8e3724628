// Slides that are straight pins: cut out of block and halves, so that they pass through other holes, and
// through steel of the halves that stands in gaps of what they form.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/bar_cut.hpp"
#include "parting/plain_mold.hpp"

namespace moldlight {

/// What holds a slide's forming surface, a pin for each hole that is apart from the others, seen along its
/// way: the convex outline of that, without skins on walls beside it, from its far end, in the part's wall or
/// a little in the steel behind it, out of the block; with steps a bar for each, which touch. `inserts`:
/// bodies that it forms something of; `formed`: corners of what it forms. In the frame of the plain mold.
/// None where one is no straight pin, or the part stands in its way.
struct PinWish {
  std::vector<const TriangleMesh*> inserts;
  std::vector<glm::dvec3> formed;
  bool beside = false;      // whether the inserts have more beside that, along the way
  glm::dvec3 way{1, 0, 0};  // unit
  double land = 0.0;
  double fit = 1.0;      // of the usual width around what it forms
  bool stepped = false;  // whether it may have steps, narrower from one to the next
};
[[nodiscard]] std::vector<BarRoom> pin_rooms(const TriangleMesh& part, const PinWish& wish);

/// Cuts the pins of an action out of halves, as one slide, and takes what they form from their inserts. Why
/// that cannot be; empty where it was done.
[[nodiscard]] std::string put_pins(const PlainMold& plain, std::size_t action, std::span<const BarRoom> rooms,
                                   MoldHalves& halves, const Progress& progress);

}  // namespace moldlight
