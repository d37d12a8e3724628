// What forms each CAD face of a part: one label, or several with the borders between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "classify/part_model.hpp"
#include "io/mesh_writer.hpp"
#include "io/step_labels.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

struct CadLabels {
  StepLabels labels;
  std::vector<double> other_areas;  // of each CAD face what is not under its own label
  double moved_area = 0.0;          // of specks, which went to the label around them
};

/// `of_piece` has the group of each piece. A patch of a face that is narrower on average than `width`, or
/// smaller than its square, is a speck where another label is beside it on the face. The part has CAD faces;
/// areas and lengths are in its unit.
[[nodiscard]] CadLabels cad_labels(const PartModel& model, const SplitMesh& split,
                                   std::span<const MeshGroup> groups, std::vector<std::uint32_t> of_piece,
                                   double width);

}  // namespace moldlight
