#include "gui/panels/sweep_columns.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "gui/draw/ui.hpp"
#include "gui/view/direction.hpp"
#include "session/figures.hpp"
#include "session/sweep/sweep_texts.hpp"

namespace moldlight::gui {

namespace {

std::string area(const AppState& state, double value) {
  return grouped(FigureColumn(state.model->geometry.total_area).text(value));
}

double share(const SweepCandidate& candidate) {
  const double total = candidate.classification.total_area;
  return total > 0.0 ? undercut_area(candidate) / total : 0.0;
}

std::string tilt_text(const AppState&, const SweepCandidate& candidate) {
  const auto& tilt = candidate.tilt;
  return tilt ? fmt::format("{}{:.1f}°", tilt->at_least() ? "≥" : "", tilt->deg) : "–";
}

std::string reason_of(const CandidateSource& source) {
  return source.reason.empty() ? std::string(candidate_kind_name(source.kind)) : source.reason;
}

using C = SweepCandidate;
using A = AppState;

constexpr std::array<SweepColumn, 11> k_columns = {{
    {.name = "", .help = "", .width = 56, .right = false, .text = nullptr, .key = nullptr},
    {.name = "#",
     .help = "Rank; = marks directions that tie within the uncertainty.",
     .width = 30,
     .right = false,
     .text = [](const A& state,
                const C& c) { return fmt::format("{}{}", c.rank, ties(*state.sweep.result, c) ? " =" : ""); },
     .key = [](const C& c) { return static_cast<double>(c.rank); }},
    {.name = "direction",
     .help = "",
     .width = 130,
     .right = false,
     .text = [](const A&, const C& c) { return with_minus(short_direction_text(c.candidate.direction)); },
     .key = nullptr},
    {.name = "undercut",
     .help = "Undercut area, as measured with the settings of the method.",
     .width = 58,
     .text = [](const A& state,
                const C& c) { return (c.measured ? "" : "≈") + area(state, undercut_area(c)); },
     .key = undercut_area},
    {.name = "±",
     .help = "How far the undercut area may be off, 95 % level.",
     .width = 60,
     .text = [](const A&, const C& c) { return uncertainty_text(c.classification); },
     .key = [](const C& c) { return c.classification.uncertainty.total(); }},
    {.name = "%",
     .help = "Undercut, per cent of the part's area.",
     .width = 42,
     .text = [](const A&, const C& c) { return fmt::format("{:.2f}", 100.0 * share(c)); },
     .key = share},
    {.name = "depth",
     .help = "Draw depth: the part's extent along the direction.",
     .width = 48,
     .text = [](const A& state,
                const C& c) { return FigureColumn(state.model->frame.diagonal * 10.0).text(c.draw_depth); },
     .key = [](const C& c) { return c.draw_depth; }},
    {.name = "shadow",
     .help = "Projected area, on which the clamp force acts.",
     .width = 64,
     .text = [](const A& state, const C& c) { return area(state, c.projected_area); },
     .key = [](const C& c) { return c.projected_area; }},
    {.name = "patches",
     .help = "Connected patches of undercut surface.",
     .width = 46,
     .text = [](const A&,
                const C& c) { return c.measured ? fmt::format("{}", c.patches) : std::string("–"); },
     .key = [](const C& c) { return c.measured ? static_cast<double>(c.patches) : -1.0; }},
    {.name = "tilt",
     .help = "Tilt margin: how far the pull may lean before the undercut grows.",
     .width = 44,
     .text = tilt_text,
     .key = [](const C& c) { return c.tilt ? c.tilt->deg : -1.0; }},
    {.name = "why",
     .help = "",
     .width = 0,
     .right = false,
     .text = [](const A&, const C& c) { return first_reason(c); },
     .key = nullptr},
}};

}  // namespace

std::span<const SweepColumn> sweep_columns() { return k_columns; }

bool SweepOrder::follow(std::shared_ptr<const SweepResult> result) {
  if (result_ == result) return false;
  result_ = std::move(result);
  sort();
  return true;
}

void SweepOrder::sort_by(std::size_t column) {
  descending_ = column_ == column && !descending_;
  column_ = column;
  sort();
}

void SweepOrder::sort() {
  const auto key = [&](std::size_t k) { return k_columns.at(column_).key(result_->candidates[k]); };
  rows_.resize(result_->candidates.size());
  std::iota(rows_.begin(), rows_.end(), std::size_t{0});
  std::stable_sort(rows_.begin(), rows_.end(), [&](std::size_t a, std::size_t b) {
    return descending_ ? key(a) > key(b) : key(a) < key(b);
  });
}

std::string uncertainty_text(const Classification& result) {
  return fmt::format("{:.2g}", result.uncertainty.total());
}

bool ties(const SweepResult& result, const SweepCandidate& candidate) {
  return std::any_of(result.candidates.begin(), result.candidates.end(), [&](const SweepCandidate& other) {
    return other.rank != candidate.rank && other.tie_group == candidate.tie_group;
  });
}

std::string first_reason(const SweepCandidate& candidate) {
  return candidate.candidate.sources.empty() ? std::string() : reason_of(candidate.candidate.sources.front());
}

std::string all_reasons(const SweepCandidate& candidate) {
  std::string text;
  for (const CandidateSource& source : candidate.candidate.sources) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", candidate_kind_name(source.kind),
                        reason_of(source));
  }
  return text;
}

}  // namespace moldlight::gui
