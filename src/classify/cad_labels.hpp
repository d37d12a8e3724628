// What forms each CAD face of a part: one label, or several with the borders between them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "io/mesh_writer.hpp"
#include "io/step_labels.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

struct CadLabels {
  StepLabels labels;
  std::vector<double> areas;        // of the facets of each label
  std::vector<double> other_areas;  // of each CAD face what is not under its own label
  double moved_area = 0.0;          // of specks, which went to the label around them
};

struct CadLabelSettings {
  double speck_width = 0.0;  // a patch of a face that is narrower on average, or smaller than its square, is
                             // a speck where another label is beside it on the face
  glm::dvec3 direction{};  // unit, with tau: where facets of a bent face turn from one class to another, the
  double tau_deg = 0.0;    // border is a contour of the face itself
};

/// `of_piece` has the group of each piece. The part has CAD faces; areas and lengths are in its unit.
[[nodiscard]] CadLabels cad_labels(const PartModel& model, const SplitMesh& split,
                                   std::span<const MeshGroup> groups, std::vector<std::uint32_t> of_piece,
                                   const CadLabelSettings& settings);

}  // namespace moldlight
