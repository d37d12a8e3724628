// STEP, through the program moldlight-step, which lies beside moldlight and is built with OpenCASCADE.
#pragma once

#include "io/read_context.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// Solids are the bodies; facet_source holds CAD face numbers from 0; lengths are in the file's unit. Throws
/// FileError also where this build has no STEP support, and where the file breaks the reading program.
[[nodiscard]] Part read_step(const ReadContext& context);

/// The part in a StepResult as bytes, which are not trusted. Throws FileError.
[[nodiscard]] Part part_of_step_result(const ReadContext& context, std::string_view bytes);

}  // namespace moldlight
