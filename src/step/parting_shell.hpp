// A surface beside the part as a shell: plane faces that share their edges, and cones where these are pieces
// of one.
#pragma once

#include <TopoDS_Shell.hxx>

#include "io/step_labels.hpp"

namespace moldlight::step {

/// Throws std::runtime_error where its edges are too short.
[[nodiscard]] TopoDS_Shell shell_of(const StepSurface& surface);

}  // namespace moldlight::step
