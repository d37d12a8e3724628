// The files that a classification is written to, the same from the command line and from the window.
#pragma once

#include <string>

#include "classify/classification.hpp"
#include "classify/part_model.hpp"

namespace moldlight {

/// Each is written if its path is not empty.
struct OutputPaths {
  std::string json;    // schema moldlight.classify/2
  std::string facets;  // CSV
  std::string faces;   // CSV, one row a CAD face or polygon of the file
  std::string mesh;    // .ply, .obj or .stl, coloured by region
  std::string split_folder;
  std::string borders;  // .obj or .csv, the lines between regions

  /// Whether a file is made of the split mesh, which the classification must have then.
  [[nodiscard]] bool need_split() const { return !(mesh + split_folder + borders).empty(); }
};

/// Throws FileError for the first that cannot be written. `palette`: of the mesh.
void write_outputs(const OutputPaths& paths, const PartModel& model, const Classification& result,
                   Palette palette = Palette::paper);

}  // namespace moldlight
