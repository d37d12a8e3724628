// A part as OpenCASCADE reads it from a file: the bodies with their exact surfaces.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "mesh/length_unit.hpp"
#include "step/entities.hpp"

namespace moldlight::step {

struct CadBody {
  TopoDS_Shape shape;  // a solid, or a shell or a face of none; in millimetres
  std::string name;
};

struct CadPart {
  std::vector<CadBody> bodies;  // solids in the order of the file, then shells, then faces; each has a face
  FaceColours colours;
  LengthUnit unit{"mm", 1.0};  // of the file
  double accuracy = 0.0;       // mm, that the file says its points have; 0: it says nothing
  std::vector<std::string> warnings;
};

/// Has OpenCASCADE read what it keeps in files and in the environment, so that it needs none later.
void prepare();

/// Throws std::runtime_error, whose text goes on from the file's name, for what cannot be read.
[[nodiscard]] CadPart read_step(std::istream& file);

/// OpenCASCADE takes an IGES file by name alone: fopen() of this one has to give it.
inline constexpr const char* k_iges_name = "/the part.iges";
/// The same of an IGES file. Faces that no solid has are sewn together.
[[nodiscard]] CadPart read_iges();

}  // namespace moldlight::step
