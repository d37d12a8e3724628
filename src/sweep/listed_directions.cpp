#include "sweep/listed_directions.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "mold/measure.hpp"
#include "sweep/axis_beside.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/tilt_margin.hpp"

namespace moldlight {

namespace {

SweepCandidate listed_candidate(const SweepTools& tools, const Contender& contender,
                                const std::optional<TiltMargin>& tilt) {
  SweepCandidate listed;
  listed.candidate = contender.candidate;
  listed.measured = contender.measured != nullptr;
  listed.tilt = tilt;
  listed.actions = contender.actions;
  listed.beside = contender.beside;
  listed.cost = contender.cost;
  Classification& classification = listed.classification;
  if (listed.measured) {
    classification = contender.measured->classification;
    listed.undercuts = contender.measured->undercuts;
    listed.line = contender.measured->parting;
  } else {
    classification = tools.rating.classification(contender.candidate.direction, contender.score);
    classification.near_vertical_area =
        near_vertical_area(tools.model.geometry, classification.direction, tools.settings.method.tau_deg);
    classification.warnings = tools.model.warnings;
  }
  DirectionFacts facts = tools.rating.facts(classification, contender.measured.get());
  facts.tilt = tilt;
  if (contender.actions) facts.actions = &*contender.actions;
  listed.figures = find_figures(facts);
  return listed;
}

/// Gives them their ranks, and every tie group of more than one direction its letter, in order.
void number(std::vector<SweepCandidate>& candidates) {
  for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k].rank = k + 1;
  char letter = 'a';
  for (std::size_t first = 0, end = 0; first < candidates.size(); first = end) {
    while (end < candidates.size() && candidates[end].tie_group == candidates[first].tie_group) ++end;
    if (end - first < 2) continue;
    for (std::size_t k = first; k < end; ++k) candidates[k].tie = letter;
    letter = letter == 'z' ? 'a' : static_cast<char>(letter + 1);
  }
}

/// Of every measured contender what is not known yet, as far as there is time.
void complete(SweepTools& tools, std::vector<Contender>& listed) {
  for (Contender& contender : listed) {
    if (!contender.measured) continue;
    const auto measured = std::make_shared<MeasuredDirection>(*contender.measured);
    if (contender.actions) measured->undercuts = contender.actions->undercuts;
    try {
      if (!tools.clock.stopped()) tools.measurer.complete(*measured, tools.clock.until_cancelled());
    } catch (const Cancelled&) {
    }
    contender.figures.undercuts = static_cast<double>(measured->undercuts.value_or(UndercutTotals{}).count);
    contender.measured = measured;
  }
}

}  // namespace

std::vector<SweepCandidate> listed_by_objective(SweepTools& tools, std::vector<Contender> listed) {
  complete(tools, listed);
  const bool all_measured =
      std::ranges::all_of(listed, [](const Contender& c) { return c.measured != nullptr; });
  std::vector<RankedFigures> figures;
  for (const Contender& contender : listed) {
    figures.push_back(all_measured || !contender.measured
                          ? contender.figures
                          : tools.rating.measured(contender.candidate, *contender.measured, {}, false));
  }
  // Ties are decided by what is known of all.
  if (!std::ranges::all_of(listed, [](const Contender& c) { return c.actions.has_value(); })) {
    for (RankedFigures& each : figures) each.actions = each.travel = 0.0;
  }
  if (!std::ranges::all_of(listed, [](const Contender& c) { return c.measured && c.measured->undercuts; })) {
    for (RankedFigures& each : figures) each.undercuts = 0.0;
  }
  const Ranking ranking = tools.rating.rank(figures);
  const std::vector<std::optional<TiltMargin>> tilts = tilt_margins(tools, listed);
  std::vector<SweepCandidate> candidates;
  for (const std::size_t i : ranking.order) {
    SweepCandidate& candidate = candidates.emplace_back(listed_candidate(tools, listed[i], tilts[i]));
    candidate.tie_group = ranking.tie_group[i] + 1;
    candidate.pareto = ranking.pareto[i];
  }
  number(candidates);
  return candidates;
}

std::vector<SweepCandidate> listed_as_molds(SweepTools& tools, MoldRanking::Listed listed, bool with_tilts) {
  complete(tools, listed.contenders);
  std::vector<RankedFigures> figures;
  for (const Contender& contender : listed.contenders) figures.push_back(contender.figures);
  const Ranking pareto = tools.rating.rank(figures);
  const std::vector<std::optional<TiltMargin>> tilts =
      with_tilts ? tilt_margins(tools, listed.contenders)
                 : std::vector<std::optional<TiltMargin>>(listed.contenders.size());
  std::vector<SweepCandidate> candidates;
  for (std::size_t k = 0; k < listed.contenders.size(); ++k) {
    const std::size_t group = k == 0 ? 1 : candidates.back().tie_group + (listed.ties[k] ? 0 : 1);
    SweepCandidate& candidate =
        candidates.emplace_back(listed_candidate(tools, listed.contenders[k], tilts[k]));
    candidate.tie_group = group;
    candidate.pareto = pareto.pareto[k];
    candidate.rank_reasons = std::move(listed.reasons[k]);
  }
  number(candidates);
  return candidates;
}

void measure_axes(SweepTools& tools, std::span<const Candidate> axes, std::span<SweepCandidate> candidates) {
  std::vector<ScoringTask> tasks;
  std::vector<SweepCandidate*> leaning;
  for (SweepCandidate& candidate : candidates) {
    if (!candidate.measured) continue;
    candidate.axis = axis_beside(axes, candidate.candidate.direction, tools.settings.method.tau_deg);
    if (!candidate.axis) continue;
    leaning.push_back(&candidate);
    tasks.push_back({candidate.axis->direction});
  }
  auto measured =
      tools.measurer.measure(tasks, {}, tools.clock.until_cancelled(), [&] { return tools.clock.stopped(); });
  for (std::size_t k = 0; k < leaning.size(); ++k) {
    if (measured[k]) {
      leaning[k]->axis->classification = std::move(measured[k]->classification);
    } else {
      leaning[k]->axis.reset();
    }
  }
}

}  // namespace moldlight
