// The cap's mouth looks up (+z).
#include <cmath>
#include <numbers>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp_Ax1.hxx>
#include <gp_Circ.hxx>

#include "demo_parts.hpp"
#include "modelling.hpp"

namespace moldlight::demo {
namespace {

constexpr double k_outer_radius = 16.0, k_inner_radius = 13.6, k_height = 14.0;
constexpr double k_degree = std::numbers::pi / 180.0;

/// A third of a turn of thread: a round bead along the inner wall that climbs by tilting its plane, with
/// round ends.
std::vector<TopoDS_Shape> thread_bead(double from_deg, double z) {
  constexpr double k_bead = 1.0, k_turn_deg = 100.0, k_tilt_deg = 3.0;
  const double radius = k_inner_radius + 0.15;
  const auto placed = [&](const TopoDS_Shape& shape) {
    const double a = from_deg * k_degree, tilt = k_tilt_deg * k_degree;
    // The plane of the bead leans about the radius at the bead's middle.
    const double middle = a + 0.5 * k_turn_deg * k_degree;
    const gp_Vec lean(std::sin(tilt) * std::sin(middle), -std::sin(tilt) * std::cos(middle), std::cos(tilt));
    return moved(shape, gp_Pnt(0, 0, z), gp_Dir(lean), gp_Dir(std::cos(a), std::sin(a), 0.0));
  };
  const gp_Pnt start(radius, 0, 0);
  const gp_Pnt end(radius * std::cos(k_turn_deg * k_degree), radius * std::sin(k_turn_deg * k_degree), 0);
  const auto edge = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(start, gp_Dir(0, 1, 0)), k_bead)).Edge();
  const auto section = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire()).Face();
  const gp_Ax1 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  return {placed(BRepPrimAPI_MakeRevol(section, axis, k_turn_deg * k_degree).Shape()),
          placed(BRepPrimAPI_MakeSphere(start, k_bead).Shape()),
          placed(BRepPrimAPI_MakeSphere(end, k_bead).Shape())};
}

}  // namespace

TopoDS_Shape bottle_cap() {
  TopoDS_Shape body = rounded(pin(0, 0, 0, k_height, k_outer_radius, 0.5), 1.5, edges_at_height(0.0));
  std::vector<TopoDS_Shape> knurls;
  constexpr int k_knurls = 48;
  for (int i = 0; i < k_knurls; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / k_knurls;
    const double radius = k_outer_radius + 0.45;
    knurls.push_back(pin(radius * std::cos(angle), radius * std::sin(angle), 2.2, k_height + 1.0, 0.75, 0.0));
  }
  body = cut(body, knurls);
  const TopoDS_Shape hollow =
      rounded(pin(0, 0, 1.8, k_height + 1.0, k_inner_radius, 0.5), 0.8, edges_at_height(1.8));
  body = cut(body, {hollow});

  // A sealing ring on the inside of the top.
  std::vector<TopoDS_Shape> added = {cut(pin(0, 0, 1.0, 4.6, 11.0, -2.0), {pin(0, 0, 0.5, 5.0, 9.6, 2.0)})};
  for (const double from_deg : {10.0, 130.0, 250.0}) {
    for (const TopoDS_Shape& bead : thread_bead(from_deg, 9.2)) added.push_back(bead);
  }
  return fused(body, added);
}

}  // namespace moldlight::demo
