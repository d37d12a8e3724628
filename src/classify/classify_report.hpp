// The report on a classification for programs: JSON, tables and coloured meshes, the same from the command
// line and from the window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "classify/classification.hpp"
#include "classify/json.hpp"
#include "classify/part_model.hpp"
#include "io/mesh_writer.hpp"
#include "mold/measure.hpp"

namespace moldlight {

/// [x, y, z].
[[nodiscard]] Json point_json(const glm::dvec3& point);
[[nodiscard]] Json point_json(const std::optional<glm::dvec3>& point);  // null where there is none
/// {"min": [x, y, z], "max": [x, y, z]}.
[[nodiscard]] Json bounds_json(const Bounds& bounds);

/// What every report says of the part; the warnings are the caller's, as a run may add to the part's own.
[[nodiscard]] Json part_json(const PartModel& model, const std::vector<std::string>& warnings);

/// Schema `moldlight.classify/2`. Lengths and areas are in the part's unit, fractions in [0, 1], times in
/// milliseconds. For a STEP part `faces` lists the CAD faces, but not for a direction of a sweep.
[[nodiscard]] Json classify_json(const PartModel& model, const Classification& result);

/// Region areas of each face of part_faces() but what a repair added; empty for a direction of a sweep.
[[nodiscard]] std::vector<SourceAreas> face_areas(const PartModel& model, const Classification& result);

/// Of each piece: face, as in tables; body, from 1, as --body takes it; with a direction also draft_deg, the
/// draft angle of its facet, positive towards +d, and height, of its middle along +d from the file's origin.
[[nodiscard]] std::vector<FacetValues> split_values(const PartModel& model, const SplitMesh& split,
                                                    const std::optional<glm::dvec3>& direction);

/// The text of a JSON file: two spaces a level, numbers in the shortest form that reads back the same. Bytes
/// of file names that are no UTF-8 are replaced, and what a terminal would obey is escaped.
[[nodiscard]] std::string json_text(const Json& json);

/// Each is written if its path is not empty.
struct OutputPaths {
  std::string json;    // schema moldlight.classify/2
  std::string facets;  // CSV
  std::string faces;   // CSV, one row a CAD face or polygon of the file
  std::string mesh;    // one of mesh_formats(), coloured by region
  std::string split_folder;
  std::string borders;  // .obj or .csv, the lines between regions

  /// Whether a file is made of the split mesh, which the classification must have then.
  [[nodiscard]] bool need_split() const { return !(mesh + split_folder + borders).empty(); }
};

/// Throws FileError for the first that cannot be written. `palette`: of the mesh.
void write_outputs(const OutputPaths& paths, const PartModel& model, const Classification& result,
                   Palette palette = Palette::paper);

}  // namespace moldlight
