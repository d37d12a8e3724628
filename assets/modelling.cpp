#include "modelling.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>

#include "base/error.hpp"

namespace moldlight::demo {
namespace {

double tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

TopoDS_Wire outline(const Rectangle& r, double z) {
  const double x0 = r.x - 0.5 * r.width, x1 = r.x + 0.5 * r.width, y0 = r.y - 0.5 * r.depth,
               y1 = r.y + 0.5 * r.depth;
  if (r.radius <= 0.0) {
    return BRepBuilderAPI_MakePolygon(gp_Pnt(x0, y0, z), gp_Pnt(x1, y0, z), gp_Pnt(x1, y1, z),
                                      gp_Pnt(x0, y1, z), true)
        .Wire();
  }
  BRepBuilderAPI_MakeWire wire;
  const double corners[4][2] = {{x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}};
  const double along[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  gp_Pnt from(x0 + r.radius, y0, z);
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    const auto at = [&](double back, double on) {
      return gp_Pnt(corners[i][0] - back * along[i][0] + on * along[next][0],
                    corners[i][1] - back * along[i][1] + on * along[next][1], z);
    };
    const gp_Pnt begin = at(r.radius, 0.0), end = at(0.0, r.radius);
    const double diagonal = r.radius * (1.0 - std::numbers::sqrt2 / 2.0);
    if (from.Distance(begin) > 1e-9) wire.Add(BRepBuilderAPI_MakeEdge(from, begin).Edge());
    wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(begin, at(diagonal, diagonal), end).Value()).Edge());
    from = end;
  }
  return wire.Wire();
}

template <typename Operation>
TopoDS_Shape combined(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& tools, const char* what) {
  TopTools_ListOfShape arguments, others;
  arguments.Append(a);
  for (const TopoDS_Shape& tool : tools) others.Append(tool);
  Operation operation;
  operation.SetArguments(arguments);
  operation.SetTools(others);
  operation.Build();
  if (!operation.IsDone() || operation.HasErrors())
    throw Error(std::string("the modeller failed to ") + what);
  ShapeUpgrade_UnifySameDomain unify(operation.Shape());
  unify.Build();
  return unify.Shape();
}

}  // namespace

Rectangle grown(Rectangle rectangle, double by) {
  rectangle.width += 2.0 * by;
  rectangle.depth += 2.0 * by;
  if (rectangle.radius > 0.0) rectangle.radius += by;
  return rectangle;
}

TopoDS_Shape drafted_block(const Rectangle& rectangle, double z0, double z1, double draft_deg) {
  BRepOffsetAPI_ThruSections loft(true, true);
  loft.AddWire(outline(rectangle, z0));
  loft.AddWire(outline(grown(rectangle, (z1 - z0) * tangent(draft_deg)), z1));
  loft.Build();
  return loft.Shape();
}

TopoDS_Shape pin(double x, double y, double z0, double z1, double radius, double draft_deg) {
  const gp_Ax2 axis(gp_Pnt(x, y, z0), gp_Dir(0, 0, 1));
  if (draft_deg == 0.0) return BRepPrimAPI_MakeCylinder(axis, radius, z1 - z0).Shape();
  return BRepPrimAPI_MakeCone(axis, radius, radius + (z1 - z0) * tangent(draft_deg), z1 - z0).Shape();
}

TopoDS_Shape prism(const std::vector<gp_Pnt>& polygon, const gp_Vec& by) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& point : polygon) wire.Add(point);
  wire.Close();
  return prism(wire.Wire(), by);
}

TopoDS_Shape prism(const TopoDS_Wire& outline_wire, const gp_Vec& by) {
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline_wire, true).Face(), by).Shape();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Pnt& origin, const gp_Dir& z, const gp_Dir& x) {
  gp_Trsf placing;
  placing.SetTransformation(gp_Ax3(origin, z, x), gp_Ax3());
  return BRepBuilderAPI_Transform(shape, placing, true).Shape();
}

TopoDS_Shape fused(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& tools) {
  return combined<BRepAlgoAPI_Fuse>(a, tools, "join solids");
}

TopoDS_Shape cut(const TopoDS_Shape& a, const std::vector<TopoDS_Shape>& tools) {
  return combined<BRepAlgoAPI_Cut>(a, tools, "cut solids");
}

TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius, const EdgeChoice& choose) {
  BRepFilletAPI_MakeFillet fillet(shape);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  int chosen = 0;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    const BRepAdaptor_Curve curve(edge);
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    if (!choose(curve.Value(first), curve.Value(0.5 * (first + last)), curve.Value(last))) continue;
    fillet.Add(radius, edge);
    ++chosen;
  }
  if (chosen == 0) throw Error("no edge to round was found");
  fillet.Build();
  if (!fillet.IsDone()) throw Error("the modeller failed to round edges");
  return fillet.Shape();
}

EdgeChoice edges_at_height(double z) {
  return [z](const gp_Pnt& first, const gp_Pnt& middle, const gp_Pnt& last) {
    return std::abs(first.Z() - z) + std::abs(middle.Z() - z) + std::abs(last.Z() - z) < 1e-6;
  };
}

}  // namespace moldlight::demo
