#include "parting/halves_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "parting/mold_figures.hpp"

namespace moldlight {

namespace {

/// "Core half", "123 mm³".
HalvesLine figure_line(const FigureStyle& style, const FoundFigure& figure) {
  const std::string unit = style.unit(figure.kind);
  return {.text = std::string(figure.title),
          .figure = with_minus(grouped(style.text(figure)) + (unit.empty() ? "" : " " + unit))};
}

}  // namespace

std::string halves_refusal(const SaidHalves& said) {
  const WrittenMold& written = said.halves.written;
  const auto& place = said.halves.refused_at ? said.halves.refused_at : written.refused_at;
  return refusal_text(said.model, said.halves, written,
                      place && said.line != nullptr ? loop_near(*said.line, *place) : std::string());
}

std::vector<HalvesLine> halves_lines(const SaidHalves& said) {
  if (const std::string refusal = halves_refusal(said); !refusal.empty()) return {{refusal, true}};
  const FigureStyle style(said.model);
  std::vector<HalvesLine> lines;
  for (const FoundFigure& figure : found_figures(halves_figures(), said.halves))
    if (style.is_shown(figure)) lines.push_back(figure_line(style, figure));
  for (const std::string& fault : half_faults(said.model, said.halves))
    lines.push_back({sentence_of(fault), true});
  for (const std::string& missed : missed_lines(said.model, said.halves)) lines.push_back({missed, true});
  if (!unfilled_text(said.model, said.settings, said.halves).empty()) {
    lines.push_back({fmt::format("Neither half forms {} in {}. Fill undercuts to export the halves.",
                                 style.with_unit(FigureKind::volume, said.halves.insert_volume),
                                 plural(said.halves.inserts.size(), "place")),
                     true});
  } else if (said.by_action != nullptr) {
    const auto moved = std::ranges::count_if(
        *said.by_action, [](const InsertActions& insert) { return !insert.actions.empty(); });
    if (moved > 0)
      lines.push_back({fmt::format("{} insert{} with side actions", moved, moved == 1 ? " goes" : "s go")});
  }
  return lines;
}

}  // namespace moldlight
