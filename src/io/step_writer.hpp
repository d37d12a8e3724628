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

/// Writes by the program moldlight-step; the file is replaced whole or not at all. `options` are those that
/// the part was read with, a part with CAD faces. Returns the CAD faces that could not be split, rising,
/// which are under their own label as a whole. Throws FileError, also where the part's file has changed
/// since, and Cancelled.
std::vector<std::uint32_t> write_step_part(const std::string& path, const Part& part,
                                           const ReadOptions& options, const StepLabels& labels,
                                           const Progress& progress);

}  // namespace moldlight
