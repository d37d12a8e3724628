#include "parting/line_figures.hpp"

#include "parting/loops.hpp"

namespace moldlight {

LineFigures line_figures(const PartModel& model, const Query& query, const Progress& progress) {
  const PartingLine line = parting_line(assign_sides(model, query, {}, progress));
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
