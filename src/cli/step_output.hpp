// --step of classify, actions and mold: the part's own exact faces, split, named and coloured by what forms
// them.
#pragma once

#include <cstdint>
#include <vector>

#include "classify/json.hpp"
#include "cli/report_flags.hpp"
#include "io/mesh_writer.hpp"
#include "io/step_labels.hpp"
#include "mold/exact/split_mesh.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

void add_step_flag(CLI::App& command, StudyFlags& flags, const std::string& help);

struct StepContent {
  const SplitMesh& split;
  std::vector<MeshGroup> groups;
  std::vector<std::uint32_t> of_piece;  // its group
  std::vector<StepLine> lines = {};
  std::vector<StepSurface> surfaces = {};
};
/// Writes the file that --step names, and says on stderr which faces could not be split. Returns what the
/// report says of it. Throws FileError.
[[nodiscard]] Json write_step(const StudyFlags& flags, const Study& study, StepContent content,
                              Console& console, const Progress& progress);

}  // namespace moldlight::cli
