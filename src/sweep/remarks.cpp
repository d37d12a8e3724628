// The remarks of a sweep.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "mold/direction.hpp"
#include "sweep/axis_beside.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight {

namespace {

/// "12.3 mm² (0.41 %)"
std::string area_text(const PartModel& model, double area) {
  return fmt::format("{} ({})", FigureStyle(model).with_unit(FigureKind::area, area),
                     share_text(area, model.geometry.total_area));
}

/// "12.3 mm² (0.41 %) more"; with another objective the one that ranks behind may have less.
std::string difference_text(const PartModel& model, const SweepCandidate& than,
                            const SweepCandidate& candidate) {
  const double difference = undercut_area(candidate) - undercut_area(than);
  return area_text(model, std::abs(difference)) + (difference < 0.0 ? " less" : " more");
}

std::string on_undercut(const PartModel& model, const SweepCandidate& best) {
  const double error = best.classification.uncertainty.total();
  if (undercut_area(best) <= error) return "The best direction has no undercut.";
  const std::string area = area_text(model, undercut_area(best));
  const auto count = figure_value(direction_figure("undercuts"), best);
  if (count == 0.0) return fmt::format("The best direction has no undercut but tiny ones, {}.", area);
  return fmt::format("The best direction leaves an undercut of {}{}.", area,
                     count ? fmt::format(" in {} {}", *count, *count == 1.0 ? "place" : "places") : "");
}

/// The first direction that does not tie with the best.
const SweepCandidate* runner_up(const std::vector<SweepCandidate>& candidates) {
  const auto next =
      std::ranges::find_if(candidates, [](const SweepCandidate& each) { return each.tie_group > 1; });
  return next == candidates.end() ? nullptr : &*next;
}

void remark_on_actions(const PartModel& model, const SweepResult& result, std::vector<std::string>& remarks) {
  const auto unknown = std::ranges::count_if(
      result.candidates, [](const SweepCandidate& candidate) { return !candidate.actions; });
  if (unknown > 0 && result.settings.rank == SweepRank::mold && result.complete) {
    remarks.push_back(fmt::format(
        "{} of the listed directions certainly need{} costlier side actions. These were not computed.",
        unknown, unknown == 1 ? "s" : ""));
  } else if (unknown > 0) {
    remarks.push_back(
        fmt::format("Ended early: side actions of {} of the {} listed directions were not found.", unknown,
                    result.candidates.size()));
  }
  const SweepCandidate& best = result.candidates.front();
  if (best.actions)
    remarks.push_back(fmt::format("Side actions of the best direction: {}.", side_actions_text(model, best)));
  if (result.with_actions > 0 && needs_actions(result.settings.objective)) {
    remarks.push_back(
        fmt::format("Side actions were found for the {} directions of least undercut.", result.with_actions));
  }
}

void remark_on_user(const PartModel& model, const SweepResult& result, std::vector<std::string>& remarks) {
  const SweepCandidate& best = result.candidates.front();
  for (const SweepCandidate& given : result.candidates) {
    if (!given.candidate.from_user()) continue;
    const std::string name =
        fmt::format("The given direction, {},", direction_words(given.candidate.direction));
    if (given.tie_group == 1) {
      const SweepCandidate* next = runner_up(result.candidates);
      remarks.push_back(
          name + (given.rank == 1 ? " is already best" : " ties with the best") +
          (next != nullptr ? fmt::format(". The next has {} undercut.", difference_text(model, given, *next))
                           : "."));
    } else {
      remarks.push_back(fmt::format("{} is number {}: {} undercut than the best.", name, given.rank,
                                    difference_text(model, best, given)));
    }
  }
}

std::string extent_of_open(const SweepProof& proof) {
  double widest = 0.0;
  for (const OpenCap& open : proof.open) widest = std::max(widest, open.cap.radius_deg);
  const std::size_t count = proof.open.size();
  return fmt::format("{} of {}{:.1f}°", plural(count, "cap"), count == 1 ? "" : "up to ", widest);
}

std::string grade_text(const PartModel& model, const SweepProof& proof) {
  if (proof.grade == ProofGrade::area) return "by area";
  return fmt::format("for the scoring samples, ± {}", area_text(model, proof.bound_error));
}

void remark_on_proof(const PartModel& model, const SweepResult& result, std::vector<std::string>& remarks) {
  if (const auto& proof = result.proof; proof && proof->bound <= 0.0) {
    remarks.push_back(fmt::format(
        "Proved: no direction is better than the best by more than {}, since the best has no more.",
        area_text(model, proof->epsilon)));
  } else if (proof) {
    const std::string open = proof->open.empty()
                                 ? "every direction"
                                 : fmt::format("every direction but {} ({:.3g} % of all)",
                                               extent_of_open(*proof), 100.0 * (1.0 - proof->proved_share));
    remarks.push_back(fmt::format("{}: {} has at least {} undercut; {}{}.",
                                  proof->holds ? "Proved" : "Not proved everywhere", open,
                                  area_text(model, proof->bound), grade_text(model, *proof),
                                  proof->open.empty() ? ""
                                  : proof->holds      ? ". The open directions lie around those listed"
                                                      : ". Better directions may be among the open ones"));
  }
  if (const auto& free = result.all_free) {
    remarks.push_back(
        free->open.empty()
            ? fmt::format("No direction has less than {} undercut; {}.", area_text(model, free->bound),
                          grade_text(model, *free))
            : fmt::format("All directions with less than {} undercut are within {} ({:.3g} % of all), the "
                          "largest about {}; {}{}.",
                          area_text(model, free->bound), extent_of_open(*free),
                          100.0 * (1.0 - free->proved_share),
                          direction_words(free->open.front().cap.direction), grade_text(model, *free),
                          free->complete ? "" : "; ended early"));
  }
}

}  // namespace

std::vector<std::string> sweep_remarks(const PartModel& model, const SweepResult& result) {
  std::vector<std::string> remarks;
  if (result.candidates.empty()) return remarks;
  const SweepCandidate& best = result.candidates.front();
  const bool by_molds = result.settings.rank == SweepRank::mold;
  const auto ties = std::ranges::count(result.candidates, std::size_t{1}, &SweepCandidate::tie_group);
  const auto scored = std::ranges::count(result.candidates, false, &SweepCandidate::measured);
  if (scored > 0) {
    remarks.push_back(
        fmt::format("Ended early: {} of the {} listed directions were not measured, only scored.", scored,
                    result.candidates.size()));
  }
  remarks.push_back(on_undercut(model, best));
  if (seeks_actions(result.settings)) remark_on_actions(model, result, remarks);
  if (result.recommended) {
    const Recommendation& recommended = *result.recommended;
    remarks.push_back(fmt::format("{}: {}; {}.",
                                  recommended.provisional ? "Recommended so far" : "Recommended",
                                  recommended.name, recommended.why));
  }
  if (ties > 1) {
    remarks.push_back(fmt::format("{} directions tie for the best within their uncertainty.", ties));
  }
  remark_on_user(model, result, remarks);
  const SweepCandidate* next = runner_up(result.candidates);
  if (!by_molds && next != nullptr &&
      std::none_of(result.candidates.begin(), result.candidates.end(),
                   [](const auto& c) { return c.candidate.from_user(); })) {
    const std::string actions = side_actions_text(model, *next);
    remarks.push_back(fmt::format("The next, number {}, has {} undercut{}.", next->rank,
                                  difference_text(model, best, *next),
                                  actions.empty() ? "" : ", and its side actions are: " + actions));
  }
  const auto leaning = std::ranges::find_if(
      result.candidates, [](const SweepCandidate& candidate) { return candidate.axis.has_value(); });
  if (leaning != result.candidates.end())
    remarks.push_back(fmt::format("Number {} is {}.", leaning->rank, axis_beside_text(model, *leaning)));
  remark_on_proof(model, result, remarks);
  return remarks;
}

}  // namespace moldlight
