// A picture of a mold: the cavity half as it lies, the part with its inserts and its parting line over it,
// the core half turned over beside them.
#pragma once

#include "base/image.hpp"
#include "classify/still_picture.hpp"
#include "gl/context.hpp"
#include "parting/loops.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight {

/// What is drawn; without halves the part alone.
struct MoldScene {
  const PartModel& model;
  const Assignment& assignment;
  const PartingLine& line;
  const MoldHalves& halves;
};

/// The scene as one mesh in the mold's frame, with the colour of each facet as that of a region: cavity half
/// and core half as theirs, the part as what either forms, inserts and the line as an undercut.
struct MoldSceneMesh {
  TriangleMesh mesh;
  std::vector<Region> regions;  // one a facet
};
[[nodiscard]] MoldSceneMesh mold_scene_mesh(const MoldScene& scene);

/// `context` must be current. Throws UsageError, Error, Cancelled.
[[nodiscard]] Image mold_picture(const gl::Context& context, const MoldScene& scene, StillSettings settings,
                                 const Progress& progress);

}  // namespace moldlight
