// Areas of faces against those that are known.
#include "step/face_area.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <gtest/gtest.h>

namespace moldlight::step {
namespace {

constexpr double k_pi = std::numbers::pi;

double area_of_all(const TopoDS_Shape& shape) {
  double area = 0.0;
  for (TopExp_Explorer walk(shape, TopAbs_FACE); walk.More(); walk.Next())
    area += area_of(TopoDS::Face(walk.Current()));
  return area;
}

/// Along a wave with joints.
TopoDS_Edge wave() {
  TColgp_Array1OfPnt points(1, 7);
  for (int k = 1; k <= 7; ++k) points(k) = gp_Pnt(10.0 * k, k % 2 == 0 ? 6.0 : -3.0, 0.0);
  return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points, 3, 3).Curve());
}

TEST(FaceArea, OfRoundBodiesIsWhatIsKnown) {
  const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(12.0).Shape(),
                     torus = BRepPrimAPI_MakeTorus(20.0, 6.0).Shape(),
                     cylinder = BRepPrimAPI_MakeCylinder(5.0, 30.0, 1.25).Shape(),
                     cone = BRepPrimAPI_MakeCone(10.0, 4.0, 8.0).Shape();
  const std::vector<std::pair<TopoDS_Shape, double>> known = {
      {sphere, 4.0 * k_pi * 144.0},
      {torus, 4.0 * k_pi * k_pi * 20.0 * 6.0},
      {cylinder, 1.25 * 5.0 * 30.0 + 1.25 * 25.0 + 2.0 * 5.0 * 30.0},
      {cone, k_pi * (10.0 + 4.0) * 10.0 + k_pi * (100.0 + 16.0)}};
  for (const auto& [shape, area] : known) {
    EXPECT_NEAR(area_of_all(shape), area, 1e-9 * area);
    EXPECT_NEAR(area_of_all(shape.Reversed()), area, 1e-9 * area);
    gp_Trsf away;
    away.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.7);
    EXPECT_NEAR(area_of_all(shape.Moved(away)), area, 1e-9 * area);
    // The same as surfaces of splines.
    EXPECT_NEAR(area_of_all(BRepBuilderAPI_NurbsConvert(shape, Standard_True).Shape()), area, 1e-8 * area);
  }
}

TEST(FaceArea, OfAWallAlongASplineIsLengthTimesHeight) {
  const TopoDS_Edge edge = wave();
  const double length = GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge), 1e-10);
  const TopoDS_Shape wall = BRepPrimAPI_MakePrism(edge, gp_Vec(0, 0, 15)).Shape();
  EXPECT_NEAR(area_of_all(wall), 15.0 * length, 1e-8 * 15.0 * length);
}

}  // namespace
}  // namespace moldlight::step
