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

/// "1 insert goes", "2 inserts go".
std::string goes_text(std::size_t inserts) {
  return plural(inserts, "insert") + (inserts == 1 ? " goes" : " go");
}

}  // namespace

std::string halves_refusal(const SaidHalves& said) {
  const WrittenMold& written = said.halves.written;
  const auto& place = said.halves.refused_at ? said.halves.refused_at : written.refused_at;
  std::string text =
      refusal_text(said.model, said.halves, written,
                   place && said.line != nullptr ? loop_near(*said.line, *place) : std::string());
  for (std::size_t flag = text.find(" (--"); flag != std::string::npos; flag = text.find(" (--", flag))
    text.erase(flag, text.find(')', flag) + 1 - flag);
  return sentence_of(text);
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
  if (said.by_action == nullptr) {
    if (!unfilled_text(said.model, said.settings, said.halves).empty())
      lines.push_back({fmt::format("Neither half forms {} in {}.",
                                   style.with_unit(FigureKind::volume, said.halves.insert_volume),
                                   plural(said.halves.inserts.size(), "place")),
                       true});
    return lines;
  }
  std::size_t moved = 0, loose = 0;
  for (std::size_t k = 0; k < said.by_action->size(); ++k) {
    if (said.halves.inserts[k].kind != PieceKind::insert) continue;
    ++((*said.by_action)[k].actions.empty() ? loose : moved);
  }
  if (moved > 0) lines.push_back({fmt::format("{} with side actions.", goes_text(moved))});
  if (loose > 0) lines.push_back({fmt::format("{} with no side action.", goes_text(loose)), true});
  return lines;
}

}  // namespace moldlight
