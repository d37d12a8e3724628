#include "parting/line_figures.hpp"

namespace moldlight {

LineFigures line_figures(const PartingLine& line) {
  LineFigures figures{.length = line.length,
                      .climb = 0.0,
                      .outer_climb = line.outer_high - line.outer_low,
                      .steep_length = 0.0};
  for (const PartingLoop& loop : line.loops) {
    if (loop.kind == LoopKind::action) continue;
    figures.climb += loop.climb();
    figures.steep_length += loop.steep_length;
  }
  return figures;
}

}  // namespace moldlight
