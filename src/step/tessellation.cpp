#include "step/tessellation.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>

#include "mesh/face_colour.hpp"

namespace moldlight::step {

namespace {

/// Adds the triangles of a face; false where it could not be cut.
bool add_face(const TopoDS_Face& face, std::uint32_t number, double mm, StepResult& result) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
  if (triangulation.IsNull() || triangulation->NbTriangles() == 0) return false;
  const gp_Trsf& transform = location.Transformation();
  const auto base = static_cast<std::uint32_t>(result.vertices.size());
  for (Standard_Integer i = 1; i <= triangulation->NbNodes(); ++i) {
    const gp_Pnt node = triangulation->Node(i).Transformed(transform);
    result.vertices.push_back({node.X() / mm, node.Y() / mm, node.Z() / mm});
  }
  const bool turn = (face.Orientation() == TopAbs_REVERSED) != transform.IsNegative();
  for (Standard_Integer i = 1; i <= triangulation->NbTriangles(); ++i) {
    Standard_Integer a = 0, b = 0, c = 0;
    triangulation->Triangle(i).Get(a, b, c);
    if (turn) std::swap(b, c);
    result.facets.push_back({base + static_cast<std::uint32_t>(a - 1),
                             base + static_cast<std::uint32_t>(b - 1),
                             base + static_cast<std::uint32_t>(c - 1)});
    result.faces.push_back(number);
  }
  return true;
}

}  // namespace

double diagonal_mm(const CadPart& part) {
  Bnd_Box box;
  for (const CadBody& body : part.bodies) BRepBndLib::Add(body.shape, box, Standard_False);
  if (box.IsVoid()) throw std::runtime_error("holds no face; export the part as a solid");
  if (box.IsOpen()) throw std::runtime_error("holds no bounded shape; export the part as a solid");
  return std::sqrt(box.SquareExtent());
}

void cut_into_triangles(const CadPart& part, const TessellationSettings& settings) {
  const double deflection = settings.linear_deflection > 0.0 ? settings.linear_deflection * part.unit.mm
                                                             : settings.linear_share * diagonal_mm(part);
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const CadBody& body : part.bodies) builder.Add(all, body.shape);
  // One thread, so that the same file gives the same facets.
  const BRepMesh_IncrementalMesh mesher(all, deflection, Standard_False,
                                        settings.angular_deflection_deg * std::numbers::pi / 180.0,
                                        Standard_False);
}

StepResult tessellate(const CadPart& part, const TessellationSettings& settings) {
  cut_into_triangles(part, settings);
  StepResult result;
  result.unit = part.unit.name;
  result.warnings = part.warnings;
  std::uint32_t face = 0;
  std::size_t uncut = 0;
  for (const CadBody& body : part.bodies) {
    const std::size_t first = result.facets.size();
    for (TopExp_Explorer walk(body.shape, TopAbs_FACE); walk.More(); walk.Next(), ++face) {
      const TopoDS_Face one = TopoDS::Face(walk.Current());
      if (!add_face(one, face, part.unit.mm, result)) ++uncut;
      if (!part.colours.empty()) {
        const auto colour = part.colours.find(one.TShape().get());
        result.face_colours.push_back(colour == part.colours.end() ? k_no_colour : colour->second);
      }
      if (result.facets.size() > settings.max_facets) {
        throw std::runtime_error("gives more facets than the limit of " +
                                 std::to_string(settings.max_facets) +
                                 "; raise the limit (--max-facets) or the deflection");
      }
    }
    if (result.facets.size() > first) result.bodies.push_back({body.name, result.facets.size() - first});
  }
  if (uncut > 0) {
    result.warnings.push_back(std::to_string(uncut) + " of " + std::to_string(face) +
                              " CAD faces could not be cut into triangles; the surface is open there");
  }
  if (result.facets.empty())
    throw std::runtime_error("holds no face that can be cut into triangles; export the part again");
  return result;
}

}  // namespace moldlight::step
