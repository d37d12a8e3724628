// Writing solids for printing and machining: binary STL, and 3MF with several solids in one file.
#pragma once

#include <span>
#include <string>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Coordinates in single precision, normals left to readers; the file is replaced whole or not at all. Throws
/// FileError.
void write_solid_stl(const std::string& path, const TriangleMesh& mesh, const std::string& unit);

struct NamedSolid {
  std::string name;
  const TriangleMesh* mesh = nullptr;
};
/// An object a solid, each once; in millimetres where `unit` ("mm", "in", …) is none that 3MF knows. Throws
/// FileError.
void write_solids_3mf(const std::string& path, std::span<const NamedSolid> solids, const std::string& unit);

}  // namespace moldlight
