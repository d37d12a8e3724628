// A foot with a screw hole and an open ring for a cable along y.
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

#include "demo_parts.hpp"
#include "modelling.hpp"

namespace moldlight::demo {

TopoDS_Shape cable_clip() {
  constexpr double k_width = 14.0, k_ring_x = 13.0, k_ring_z = 10.5, k_outer = 9.0, k_inner = 6.6;
  const auto along_y = [](double x, double z, double radius, double y0, double y1) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y0, z), gp_Dir(0, 1, 0)), radius, y1 - y0).Shape();
  };
  const auto upright = [](const gp_Pnt& point, const gp_Pnt&, const gp_Pnt& last) {
    return std::abs(point.X() - last.X()) + std::abs(point.Y() - last.Y()) < 1e-6 && point.X() < -10.0;
  };
  TopoDS_Shape foot = prism({gp_Pnt(-22, 0, 0), gp_Pnt(16, 0, 0), gp_Pnt(16, 0, 4), gp_Pnt(-22, 0, 4)},
                            gp_Vec(0, k_width, 0));
  foot = rounded(foot, 5.0, upright);
  foot = rounded(foot, 0.8, edges_at_height(4.0));
  // The ring's mouth opens to the upper right, with rounded lips.
  const TopoDS_Shape ring = along_y(k_ring_x, k_ring_z, k_outer, 0, k_width);
  const TopoDS_Shape mouth = prism({gp_Pnt(k_ring_x, -1, k_ring_z), gp_Pnt(k_ring_x + 6, -1, k_ring_z + 14),
                                    gp_Pnt(k_ring_x + 16, -1, k_ring_z + 6)},
                                   gp_Vec(0, k_width + 2, 0));
  TopoDS_Shape clip = fused(foot, {ring});
  clip = cut(clip, {along_y(k_ring_x, k_ring_z, k_inner, -1, k_width + 1), mouth});
  clip = rounded(clip, 0.9, [&](const gp_Pnt& first, const gp_Pnt& middle, const gp_Pnt& last) {
    return first.X() == last.X() && first.Y() != last.Y() && middle.X() > k_ring_x && middle.Z() > k_ring_z;
  });
  // Countersunk screw hole.
  return cut(clip, {pin(-12, 0.5 * k_width, -1, 5, 2.2, 0.0), pin(-12, 0.5 * k_width, 2.0, 5.0, 2.2, 45.0)});
}

}  // namespace moldlight::demo
