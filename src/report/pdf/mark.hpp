// Samples of colours on the pages of a document.
#pragma once

#include "picture/canvas.hpp"
#include "report/report.hpp"

namespace moldlight::report {

/// A box in the mark's colour, striped where it is hatched.
void draw_box(Canvas& canvas, const Mark& mark, const Box& box);
/// The same, a square that stands beside text.
void draw_mark(Canvas& canvas, const Mark& mark, const glm::dvec2& corner, double size_pt);

}  // namespace moldlight::report
