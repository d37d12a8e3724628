// Short names for the solid modelling that the demo parts need: drafted blocks, pins, prisms, Boolean
// operations.
#pragma once

#include <functional>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace moldlight::demo {

/// A rectangle about (x, y), corners rounded by `radius` (0: sharp).
struct Rectangle {
  double x = 0.0, y = 0.0;
  double width = 0.0, depth = 0.0;
  double radius = 0.0;
};

/// The rectangle larger by `by` on every side.
Rectangle grown(Rectangle rectangle, double by);

/// From `rectangle` at z0 to z1; walls lean outward by `draft_deg` on the way (negative: inward).
TopoDS_Shape drafted_block(const Rectangle& rectangle, double z0, double z1, double draft_deg);

/// Round pin along z from `radius` at z0 to z1, draft as above.
TopoDS_Shape pin(double x, double y, double z0, double z1, double radius, double draft_deg);

/// Planar polygon, extruded.
TopoDS_Shape prism(const std::vector<gp_Pnt>& polygon, const gp_Vec& by);
TopoDS_Shape prism(const TopoDS_Wire& outline, const gp_Vec& by);

/// The shape with its origin at `origin`, its z-axis along `z` and its x-axis along `x`.
TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Pnt& origin, const gp_Dir& z, const gp_Dir& x);

TopoDS_Shape fused(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& tools);
TopoDS_Shape cut(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& tools);

/// Rounds the edges that `choose` takes, given the edge's ends and middle.
using EdgeChoice = std::function<bool(const gp_Pnt& first, const gp_Pnt& middle, const gp_Pnt& last)>;
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, const EdgeChoice& choose);

/// All points of the edge lie at this height.
EdgeChoice edges_at_height(double z);

}  // namespace moldlight::demo
