// The cap's mouth looks up (+z).
#include <cmath>
#include <numbers>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>

#include "demo_parts.hpp"
#include "modelling.hpp"

namespace moldlight::demo {
namespace {

constexpr double k_outer_radius = 16.0, k_height = 14.0;
/// The wall under the thread stands in as far as the thread does: a core that is unscrewed passes it.
constexpr double k_root_radius = 13.6, k_seat_radius = 12.8, k_seat_height = 6.0;
constexpr double k_pitch = 2.2, k_turns = 2.2, k_bead = 0.75;
constexpr double k_bead_radius = k_root_radius + 0.05;  // of its middle line, about the cap's axis

/// A right-handed round bead along the inner wall. It rises out of the seat, on which no core stands in its
/// way, and has a round end.
std::vector<TopoDS_Shape> thread() {
  const double from_z = k_seat_height - k_bead - 0.2, climb = k_pitch * k_turns;
  const double turned = 2.0 * std::numbers::pi * k_turns;
  const Handle(Geom_CylindricalSurface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), k_bead_radius);
  const auto line = GCE2d_MakeSegment(gp_Pnt2d(0.0, from_z), gp_Pnt2d(turned, from_z + climb)).Value();
  const auto helix = BRepBuilderAPI_MakeEdge(line, cylinder).Edge();
  BRepLib::BuildCurves3d(helix);
  const gp_Pnt start(k_bead_radius, 0, from_z);
  const gp_Pnt end(k_bead_radius * std::cos(turned), k_bead_radius * std::sin(turned), from_z + climb);
  const gp_Dir along(0.0, 2.0 * std::numbers::pi * k_bead_radius, k_pitch);
  const auto section = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(start, along), k_bead)).Edge();
  BRepOffsetAPI_MakePipeShell pipe(BRepBuilderAPI_MakeWire(helix).Wire());
  pipe.SetMode(gp_Dir(0, 0, 1));
  pipe.Add(BRepBuilderAPI_MakeWire(section).Wire());
  pipe.Build();
  pipe.MakeSolid();
  return {pipe.Shape(), BRepPrimAPI_MakeSphere(end, k_bead).Shape()};
}

}  // namespace

TopoDS_Shape bottle_cap() {
  TopoDS_Shape body = rounded(pin(0, 0, 0, k_height, k_outer_radius, 0.5), 1.5, edges_at_height(0.0));
  std::vector<TopoDS_Shape> knurls;
  constexpr int k_knurls = 48;
  for (int i = 0; i < k_knurls; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / k_knurls;
    // They end below the rim, so that the half of the closed end forms them and the halves meet at the rim.
    const auto at = [&](double radius, double beside) {
      const double x = std::cos(angle), y = std::sin(angle);
      return gp_Pnt(radius * x - beside * y, radius * y + beside * x, -1.0);
    };
    knurls.push_back(
        prism({at(k_outer_radius - 0.35, 0.0), at(k_outer_radius + 0.5, 0.9), at(k_outer_radius + 0.5, -0.9)},
              gp_Vec(0.0, 0.0, k_height - 1.0)));
  }
  body = cut(body, knurls);
  const TopoDS_Shape hollow =
      rounded(pin(0, 0, 1.8, k_seat_height + 1.0, k_seat_radius, 0.5), 0.8, edges_at_height(1.8));
  body = cut(body, {hollow, pin(0, 0, k_seat_height, k_height + 1.0, k_root_radius, 0.5)});

  // A sealing ring on the inside of the top.
  std::vector<TopoDS_Shape> added = thread();
  added.push_back(cut(pin(0, 0, 1.0, 4.6, 11.0, -2.0), {pin(0, 0, 0.5, 5.0, 9.6, 2.0)}));
  return fused(body, added);
}

}  // namespace moldlight::demo
