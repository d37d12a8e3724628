// From a solid to the mesh of a file: closed, manifold, in float coordinates; and the binary STL.
#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

#include "mesh/triangle_mesh.hpp"

namespace moldlight::demo {

/// How far facets may be from the solid: millimetres, and degrees between neighbouring facets.
struct Tessellation {
  double deflection_mm = 0.0;
  double angle_deg = 0.0;
};

/// Throws Error when the mesh is not closed, manifold, outward and free of degenerate facets.
TriangleMesh tessellated(const TopoDS_Shape& solid, const Tessellation& tessellation);

void write_stl(const std::string& path, const TriangleMesh& mesh);

}  // namespace moldlight::demo
