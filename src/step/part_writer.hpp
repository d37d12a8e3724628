// Writes the bodies of a part as STEP, each face named and coloured by its label.
#pragma once

#include "io/step_labels.hpp"
#include "step/cad_part.hpp"

namespace moldlight::step {

/// Faces that lie under several labels are split. The part has been cut into triangles. AP214, in
/// millimetres. Throws std::runtime_error.
[[nodiscard]] StepWritten write_labelled(const CadPart& part, const StepLabels& labels);

}  // namespace moldlight::step
