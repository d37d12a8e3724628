// Slides that are straight pins: cut out of block and halves, so that they pass through other holes, and
// through steel of the halves that stands in gaps of what they form.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/bar_cut.hpp"
#include "parting/plain_mold.hpp"

namespace moldlight {

/// What holds a slide's forming surface, seen along its way: the convex outline of that, without skins on
/// walls beside it, from its far end, in the part's wall or a little in the steel behind it, out of the
/// block. `inserts`: bodies that it forms something of; `formed`: corners of what it forms. In the frame of
/// the plain mold. Nothing where that is no straight pin, or the part stands in its way.
struct PinWish {
  std::vector<const TriangleMesh*> inserts;
  std::vector<glm::dvec3> formed;
  bool beside = false;      // whether the inserts have more beside that, along the way
  glm::dvec3 way{1, 0, 0};  // unit
  double land = 0.0;
};
[[nodiscard]] std::optional<BarRoom> pin_room(const TriangleMesh& part, const PinWish& wish);

/// Cuts a pin out of halves, and takes what it forms from their inserts. Why that cannot be; empty where it
/// was done.
[[nodiscard]] std::string put_pin(const PlainMold& plain, std::size_t action, const BarRoom& room,
                                  MoldHalves& halves, const Progress& progress);

}  // namespace moldlight
