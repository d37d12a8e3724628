// Made upright with pull along z, then turned.
#include "demo_parts.hpp"
#include "modelling.hpp"

namespace moldlight::demo {

TopoDS_Shape tilted_bracket() {
  TopoDS_Shape plate = drafted_block({.width = 60.0, .depth = 40.0, .radius = 6.0}, 0.0, 5.0, -1.0);
  plate = rounded(plate, 1.2, edges_at_height(5.0));
  const TopoDS_Shape wall =
      drafted_block({.x = -20.0, .width = 6.0, .depth = 34.0, .radius = 2.0}, 2.0, 34.0, -1.0);
  std::vector<TopoDS_Shape> added = {rounded(wall, 1.0, edges_at_height(34.0))};
  for (const double y : {-11.0, 0.0, 11.0}) {
    added.push_back(prism(
        {gp_Pnt(-20, y - 1.2, 3), gp_Pnt(12, y - 1.2, 3), gp_Pnt(12, y - 1.2, 6), gp_Pnt(-20, y - 1.2, 29)},
        gp_Vec(0, 2.4, 0)));
  }
  added.push_back(pin(20.0, 0.0, 2.0, 16.0, 6.0, -1.0));
  std::vector<TopoDS_Shape> removed = {pin(20.0, 0.0, -1.0, 17.0, 3.2, 0.0)};
  for (const double y : {-14.0, 14.0}) {
    removed.push_back(pin(22.0, y, -1.0, 6.0, 2.2, 0.0));
    removed.push_back(pin(22.0, y, 3.4, 6.0, 3.8, 1.0));
  }
  // Pockets from below save material.
  for (const double y : {-5.6, 5.6}) {
    removed.push_back(
        drafted_block({.x = -4.0, .y = y, .width = 22.0, .depth = 7.6, .radius = 2.0}, -0.5, 3.2, -1.5));
  }
  const TopoDS_Shape bracket = cut(fused(plate, added), removed);
  return moved(bracket, gp_Pnt(0, 0, 0), gp_Dir(0.48, -0.36, 0.8), gp_Dir(0.6, 0.8, 0.0));
}

}  // namespace moldlight::demo
