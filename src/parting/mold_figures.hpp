// The figures of a parting line and of a mold's halves with their certificate, a row each.
#pragma once

#include "classify/figure_table.hpp"
#include "parting/assignment.hpp"
#include "parting/loops.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight {

/// Keys are relative to "/assignment", to "/loops/k", and to the report itself.
[[nodiscard]] std::span<const FigureRow<Assignment>> assignment_figures();
[[nodiscard]] std::span<const FigureRow<PartingLoop>> loop_figures();
/// Below "/euler".
[[nodiscard]] std::span<const FigureRow<EulerCheck>> euler_figures();
/// Of each body as it is written.
[[nodiscard]] std::span<const FigureRow<WrittenBody>> written_figures();
/// Of each half as it was made, below "/halves/core" and "/halves/cavity".
[[nodiscard]] std::span<const FigureRow<MoldBody>> half_figures();
/// Of halves that were made.
[[nodiscard]] std::span<const FigureRow<MoldHalves>> halves_figures();

}  // namespace moldlight
