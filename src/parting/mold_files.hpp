// The files of a mold's halves. What is written was tested as it is written, in single precision.
#pragma once

#include <string>
#include <vector>

#include "parting/mold_halves.hpp"

namespace moldlight {

/// A body as it goes to a file.
struct WrittenBody {
  std::string name;  // "core", "cavity", "insert_1"
  std::string file;  // path; empty where nothing was written
  TriangleMesh mesh;
  double volume = 0.0;
  bool closed = false;
  std::size_t crowded_edges = 0;  // in which it touches itself; the mesh has them apart
  double undercut = 0.0;  // of a half: what faces away from its pull, as a share of the block's rectangle
  double leaning = 0.0;   // of a half: what leans so by more than 0.01 degrees, as a share of its area
};

/// The bodies in the frame of the files, rounded to single precision and tested in it. In the part's own
/// frame where the direction is one of its axes and the coordinates keep what the halves need; else in the
/// mold's, the parting direction upward, about the part's centre.
struct WrittenMold {
  std::vector<WrittenBody> bodies;  // core, cavity, inserts
  bool part_frame = false;
  std::string refusal;                   // why they cannot be written; empty where they can
  std::optional<glm::dvec3> refused_at;  // in the part's coordinates
};
[[nodiscard]] WrittenMold written_mold(const MoldHalves& halves);

/// Where in the part's coordinates, without the shrinkage, a point of the files is.
[[nodiscard]] glm::dvec3 place_in_part(const MoldHalves& halves, const WrittenMold& mold,
                                       const glm::dvec3& at);

/// Writes each body to <folder>/<name>.stl, making the folder, and with `as_3mf` all of them to
/// <folder>/mold.3mf. Inserts of a former run that are no more go. Throws FileError.
void write_mold(const std::string& folder, bool as_3mf, const std::string& unit, WrittenMold& mold);

}  // namespace moldlight
