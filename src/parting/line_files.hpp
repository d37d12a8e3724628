// Writing the parting line: for CAD (DXF, STEP), for the eye (SVG), for other programs (OBJ, CSV).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "io/mesh_writer.hpp"
#include "parting/loops.hpp"

namespace moldlight {

/// One loop of the line: closed, the first point is not repeated; in the part's coordinates.
struct WrittenLoop {
  std::string_view kind;  // "outer", "shut-off", "action", "seam"
  std::vector<glm::dvec3> points;
  bool open = false;  // ends at its last point; of a seam that is closed the first point is the last, too
};

struct WrittenLines {
  std::vector<WrittenLoop> loops;
  glm::dvec3 direction{0, 0, 1};  // unit
  std::string unit;               // "mm", …; may be empty
  std::string name;               // of the part
  std::string_view title = "parting line";
};

[[nodiscard]] WrittenLines lines_to_write(const PartModel& model, const Assignment& assignment,
                                          const PartingLine& line);

[[nodiscard]] std::span<const WrittenFormat<WrittenLines>> line_formats();

/// Throws UsageError where write_lines would for the extension: to be asked before long work.
void check_line_extension(const std::string& path);

/// Writes by the extension of `path`; the file is replaced whole or not at all:
/// .dxf   R12 in ASCII, a closed 3D polyline a loop, a layer a kind; R12 knows no unit, a comment names it;
/// .svg   the projection along the direction, in millimetres, coloured by height;
/// .obj   a polyline (`l`) a loop, in a group a kind;
/// .csv   `loop,kind,x,y,z`, a line a point;
/// .step  AP214, a set of polylines, a line a loop that ends where it begins.
/// Throws UsageError for another extension, FileError where it cannot be written.
void write_lines(const std::string& path, const WrittenLines& lines);

}  // namespace moldlight
