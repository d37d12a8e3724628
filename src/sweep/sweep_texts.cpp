#include "sweep/sweep_texts.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"

namespace moldlight {

std::string reasons_text(const Candidate& candidate, std::size_t most) {
  std::vector<const CandidateSource*> noted;
  for (const CandidateSource& source : candidate.sources) {
    const bool known =
        std::any_of(noted.begin(), noted.end(), [&](const auto* s) { return s->kind == source.kind; });
    if (!known) noted.push_back(&source);
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(noted.size(), most); ++i)
    text += (i > 0 ? "; " : "") + noted[i]->reason;
  if (noted.size() > most) text += fmt::format("; {} more", noted.size() - most);
  return text;
}

std::vector<std::string> shorter_reasons(const Candidate& candidate) {
  return {reasons_text(candidate, 3), reasons_text(candidate, 2), reasons_text(candidate, 1)};
}

std::string side_actions_text(const PartModel& model, const SweepCandidate& candidate) {
  if (!candidate.actions) return {};
  const double left = candidate.actions->totals.unreleased_area;
  if (left <= 0.0) return candidate.actions->text();
  const std::string area = FigureStyle(model).with_unit(FigureKind::area, left);
  if (candidate.actions->weight <= 0.0) return "nothing releases " + area;
  return fmt::format("{}; {} unreleased", candidate.actions->text(), area);
}

std::string mold_text(const PartModel& model, const SweepCandidate& candidate) {
  std::string text;
  if (candidate.actions)
    text = candidate.actions->weight > 0.0 || candidate.actions->totals.unreleased_area > 0.0
               ? side_actions_text(model, candidate)
               : "two-plate";
  if (!candidate.line) return text;
  const double climb = candidate.line->outer_climb;
  return text + (text.empty() ? "" : ", ") +
         (climb <= k_planar_share * model.frame.diagonal
              ? "planar parting line"
              : fmt::format("parting line climbs {:.3g} {}", climb, length_unit(model.part)));
}

double undercut_area(const SweepCandidate& candidate) {
  return candidate.classification.areas[Region::undercut];
}

std::string proof_text(const PartModel& model, const SweepProof& proof, const glm::dvec3& direction) {
  const auto bound = proof.bound_at(direction);
  if (!bound) return "open: not proved";
  return fmt::format("proved: at least {}{}", area_with_unit(model, *bound),
                     proof.grade == ProofGrade::samples
                         ? fmt::format(" ± {}", area_with_unit(model, proof.bound_error))
                         : "");
}

std::string proved_text(const PartModel& model, const SweepProof& proof) {
  if (proof.open.empty())
    return fmt::format("Proved: at least {} everywhere.", area_with_unit(model, proof.bound));
  return fmt::format("Proved outside of the rings: at least {}. Open: {:.2g} % of the directions.",
                     area_with_unit(model, proof.bound), 100.0 * (1.0 - proof.proved_share));
}

}  // namespace moldlight
