// Edges on a face from points in the plane of its parameters: lines, arcs and isolines where the points are
// on one, else curves whose pieces run straight in the parameters.
#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt2d.hxx>

namespace moldlight::step {

/// The edges that lead from the first vertex, at the first of two points or more, to the last, in order, each
/// with its curve in the parameters of the face. Points that `tolerance`, a length, does without are left
/// out.
[[nodiscard]] std::vector<TopoDS_Edge> border_edges(const TopoDS_Face& face, const TopoDS_Vertex& first,
                                                    const TopoDS_Vertex& last,
                                                    const std::vector<gp_Pnt2d>& points, double tolerance);

}  // namespace moldlight::step
