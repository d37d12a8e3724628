#include "parting/halves_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "parting/mold_figures.hpp"

namespace moldlight {

namespace {

/// "Core half 123 mm³ · Cavity half 120 mm³".
std::string figures_line(const FigureStyle& style, const std::vector<FoundFigure>& figures,
                         bool of_surfaces) {
  std::string line;
  for (const FoundFigure& figure : figures) {
    if (!style.is_shown(figure) || figure.key.starts_with("surface") != of_surfaces) continue;
    const std::string unit = style.unit(figure.kind);
    line += fmt::format("{}{} {}{}{}", line.empty() ? "" : " · ", figure.title, grouped(style.text(figure)),
                        unit.empty() ? "" : " ", unit);
  }
  return with_minus(line);
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
  const std::vector<FoundFigure> figures = found_figures(halves_figures(), said.halves);
  std::vector<HalvesLine> lines = {{figures_line(style, figures, false)},
                                   {figures_line(style, figures, true)}};
  for (const std::string& fault : half_faults(said.model, said.halves))
    lines.push_back({sentence_of(fault), true});
  for (const std::string& missed : missed_lines(said.model, said.halves)) lines.push_back({missed, true});
  if (const std::string unfilled = unfilled_text(said.model, said.settings, said.halves); !unfilled.empty()) {
    lines.push_back({"No files: " + unfilled, true});
  } else if (said.by_action != nullptr) {
    const auto moved = std::ranges::count_if(
        *said.by_action, [](const InsertActions& insert) { return !insert.actions.empty(); });
    if (moved > 0)
      lines.push_back({fmt::format("{} insert{} with side actions", moved, moved == 1 ? " goes" : "s go")});
  }
  return lines;
}

}  // namespace moldlight
