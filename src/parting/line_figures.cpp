#include "parting/line_figures.hpp"

#include "parting/loops.hpp"

namespace moldlight {

LineFigures line_figures(const PartModel& model, const Query& query, const Progress& progress) {
  const PartingLine line = parting_line(assign_sides(model, query, {}, progress));
  LineFigures figures{.length = line.length, .climb = 0.0};
  for (const PartingLoop& loop : line.loops)
    figures.climb += loop.kind == LoopKind::action ? 0.0 : loop.climb();
  return figures;
}

}  // namespace moldlight
