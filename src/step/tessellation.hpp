// Cuts the faces of a part into triangles that meet without gaps.
#pragma once

#include <cstdint>

#include "io/step_result.hpp"
#include "step/cad_part.hpp"

namespace moldlight::step {

struct TessellationSettings {
  double linear_deflection =
      0.0;  // largest distance from the CAD surface, in the file's unit; 0: from the share
  double linear_share = 0.0005;         // of the part's diagonal
  double angular_deflection_deg = 5.0;  // largest angle between neighbouring chords
  std::uint64_t max_facets = 0;
};

/// Throws std::runtime_error for a part without bounds.
[[nodiscard]] double diagonal_mm(const CadPart& part);
/// Gives each face its triangulation, the same for the same file.
void cut_into_triangles(const CadPart& part, const TessellationSettings& settings);
/// The same, and the facets: body by body, face by face. Throws std::runtime_error as read_step().
[[nodiscard]] StepResult tessellate(const CadPart& part, const TessellationSettings& settings);

}  // namespace moldlight::step
