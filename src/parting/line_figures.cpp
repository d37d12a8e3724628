#include "parting/line_figures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "mold/direction.hpp"
#include "parting/loops.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight {

namespace {

constexpr double k_steep_deg = 85.0;
/// A line that goes up and down a few times has this many times its climb.
constexpr double k_many_climbs = 4.0;
constexpr double k_small_draft_deg = 5.0;

/// "z = 12.4 mm"; "12.4 mm along 0.6, 0, 0.8" for a direction that is no axis.
std::string height_text(const FigureStyle& style, const glm::dvec3& direction, double height) {
  const int axis = axis_of(direction);
  if (axis < 0)
    return fmt::format("{} along {}", style.with_unit(FigureKind::length, height),
                       direction_words(direction));
  return fmt::format("{} = {}", "xyz"[axis], style.with_unit(FigureKind::length, height * direction[axis]));
}

}  // namespace

LineFigures line_figures(const PartingLine& line) {
  LineFigures figures{
      .length = line.length, .climb = 0.0, .outer_climb = line.outer_climb(), .steep_length = 0.0};
  for (const PartingLoop& loop : line.loops) {
    if (loop.kind == LoopKind::action) continue;
    figures.climb += loop.climb();
    figures.steep_length += loop.steep_length;
  }
  return figures;
}

std::string parting_verdict(const Assignment& assignment, const PartingLine& line, const PartModel& model) {
  const FigureStyle style(model);
  const double diagonal = model.frame.diagonal;
  const auto length = [&](double value) { return style.with_unit(FigureKind::length, value); };
  std::size_t outer = 0, shut_offs = 0, breaks = 0;
  double flatness = 0.0, up_and_down = 0.0, draft = 0.0;
  struct Steps {
    double steepest_deg = 0.0, length = 0.0;
  } of_outer, of_shut_offs;
  for (const PartingLoop& loop : line.loops) {
    if (loop.kind == LoopKind::action) continue;
    outer += loop.kind == LoopKind::outer ? 1 : 0;
    shut_offs += loop.kind == LoopKind::outer || loop.tiny ? 0 : 1;
    if (loop.kind == LoopKind::outer) {
      flatness = std::max(flatness, loop.flatness);
      up_and_down += loop.up_and_down;
      draft = std::max(draft, loop.steep_draft_deg);
    }
    breaks += loop.breaks;
    Steps& steps = loop.kind == LoopKind::outer ? of_outer : of_shut_offs;
    steps.steepest_deg = std::max(steps.steepest_deg, loop.steepest_deg);
    steps.length += loop.steep_length;
  }
  if (outer == 0) return "No parting line: core and cavity do not meet.";
  const double climb = line.outer_climb();
  std::string text = "Parting line: ", more;
  if (climb <= k_planar_share * diagonal) {
    text += "planar at " + height_text(style, assignment.direction,
                                       std::abs(line.outer_low) > 1e-6 * diagonal ? line.outer_low : 0.0);
  } else if (flatness <= k_planar_share * diagonal) {
    text += fmt::format("in an inclined plane, {} high", length(climb));
  } else {
    text += fmt::format("stepped, {} high", length(climb));
    if (up_and_down > k_many_climbs * climb) {
      more = fmt::format(" It climbs and descends {} in all", length(up_and_down));
      if (draft <= k_small_draft_deg)
        more += fmt::format(", on facets with at most {:.1f}° of draft", std::ceil(10.0 * draft) / 10.0);
      more += ".";
    }
  }
  const auto steps_text = [&](std::string_view before, const Steps& steps) {
    return steps.steepest_deg <= k_steep_deg
               ? std::string()
               : fmt::format("{}{} of steps of up to {:.0f}°", before, length(steps.length),
                             std::floor(steps.steepest_deg));
  };
  const std::string outer_steps = steps_text(", ", of_outer),
                    inner_steps = steps_text(" with ", of_shut_offs);
  text += outer_steps.empty() && inner_steps.empty()
              ? fmt::format(", no step steeper than {:.0f}°", k_steep_deg)
              : outer_steps;
  text += "." + more;
  text +=
      shut_offs == 0 ? " No shut-offs." : fmt::format(" {}{}.", plural(shut_offs, "shut-off"), inner_steps);
  if (line.smoothed_length > 1e-6 * diagonal || line.smoothed_climb > 1e-6 * diagonal)
    text +=
        fmt::format(" Smoothing made the line {} shorter and removed {} of climb.",
                    length(std::max(0.0, line.smoothed_length)), length(std::max(0.0, line.smoothed_climb)));
  const double action = assignment.area(MoldSide::action);
  if (action > 0.0)
    text += fmt::format(
        " Side actions form {} of the surface{}.", share_text(action, assignment.total_area),
        breaks == 0 ? "" : " and break the line " + (breaks == 1 ? "once" : plural(breaks, "time")));
  return text;
}

}  // namespace moldlight
