// Writing the part itself as STEP: its exact faces, split, named and coloured by what forms them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "io/read_options.hpp"
#include "io/step_labels.hpp"
#include "mesh/part.hpp"

namespace moldlight {

struct StepPartWritten {
  std::vector<std::uint32_t> failed_faces;  // could not be split, rising: under their own label as a whole
  std::vector<double> areas;                // mm², of the exact faces of each label
};
/// Writes by the program that has read the part and stays (ReadOptions::stays); this ends it. The file is
/// replaced whole or not at all. `options` are those that the part was read with, a part with CAD faces.
/// Throws FileError and Cancelled.
[[nodiscard]] StepPartWritten write_step_part(const std::string& path, const Part& part,
                                              const ReadOptions& options, const StepLabels& labels,
                                              const Progress& progress);

}  // namespace moldlight
