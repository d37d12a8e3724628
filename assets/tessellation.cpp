#include "tessellation.hpp"

#include <bit>
#include <numbers>
#include <vector>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "mesh/health.hpp"
#include "mesh/weld.hpp"

namespace moldlight::demo {
namespace {

void check_health(const TriangleMesh& mesh) {
  const HealthReport report = health_report(mesh, facet_geometry(mesh));
  if (report.closed && report.nonmanifold_edges == 0 && report.degenerate_facets == 0 && report.volume > 0.0)
    return;
  throw Error(fmt::format(
      "a bad mesh: {} open, {} non-manifold, {} inconsistent edges, {} degenerate facets, volume {}",
      report.open_edges, report.nonmanifold_edges, report.inconsistent_edges, report.degenerate_facets,
      report.volume));
}

void append_float(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(bits >> shift & 0xFF));
}

}  // namespace

TriangleMesh tessellated(const TopoDS_Shape& solid, const Tessellation& tessellation) {
  const double angle = tessellation.angle_deg * std::numbers::pi / 180.0;
  const BRepMesh_IncrementalMesh mesher(solid, tessellation.deflection_mm, false, angle, false);
  std::vector<glm::dvec3> corners;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    TopLoc_Location location;
    const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, location);
    if (facets.IsNull()) throw Error("a face could not be meshed");
    for (int i = 1; i <= facets->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      facets->Triangle(i).Get(a, b, c);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
      for (const int node : {a, b, c}) {
        const gp_Pnt point = facets->Node(node).Transformed(location.Transformation());
        // As the file will hold it, so that what is checked is what is written.
        corners.emplace_back(static_cast<float>(point.X()), static_cast<float>(point.Y()),
                             static_cast<float>(point.Z()));
      }
    }
  }
  TriangleMesh mesh = weld_corners(corners);
  check_health(mesh);
  return mesh;
}

void write_stl(const std::string& path, const TriangleMesh& mesh) {
  std::string bytes = "moldlight demo part, millimetres";
  bytes.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(mesh.facets.size());
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(count >> shift & 0xFF));
  const FacetGeometry geometry = facet_geometry(mesh);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    for (int axis = 0; axis < 3; ++axis) append_float(bytes, geometry.normals[facet][axis]);
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) append_float(bytes, mesh.corner(facet, corner)[axis]);
    }
    bytes.append(2, '\0');
  }
  write_file(path, bytes);
}

}  // namespace moldlight::demo
