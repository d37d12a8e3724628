#include "sweep/proving.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include <tbb/task_arena.h>

#include "base/error.hpp"
#include "mold/direction.hpp"
#include "sweep/arena_threads.hpp"
#include "sweep/sweep_stages.hpp"

namespace moldlight {

namespace {

// Better directions that a proof leads to are followed, and it begins anew, so many times at most.
constexpr int k_most_proof_rounds = 3;
constexpr std::size_t k_most_open_tried = 16, k_most_caps_measured = 200;

std::optional<double> least_undercut(std::span<const Contender> contenders) {
  std::optional<double> least;
  for (const Contender& contender : contenders) {
    if (contender.measured && (!least || contender.figures.undercut < *least))
      least = contender.figures.undercut;
  }
  return least;
}

class Prover {
 public:
  Prover(const Proving& proving, std::vector<Contender>& contenders)
      : clock_(proving.polishing.clock, proving.settings.proof_limit_s),
        with_{.model = proving.polishing.model,
              .rating = proving.polishing.rating,
              .rays = proving.polishing.rays,
              .measurer = proving.polishing.measurer,
              .clock = clock_,
              .evaluated = proving.polishing.evaluated},
        settings_(proving.settings),
        jobs_(proving.jobs),
        contenders_(contenders) {}

  /// Keeps the last proof that came to its end.
  void prove_best(std::optional<SweepProof>& proof);
  void prove_all_free(std::optional<SweepProof>& proof) const;

 private:
  [[nodiscard]] SweepProof prove_above(double bound, ProofGrade grade) const;
  [[nodiscard]] bool found_better(const SweepProof& proof);
  [[nodiscard]] std::vector<Contender> looked_at(const SweepProof& proof) const;
  [[nodiscard]] std::vector<std::optional<MeasuredDirection>> measure(
      const std::vector<ScoringTask>& tasks) const {
    return with_.measurer.measure(tasks, {}, clock_.until_cancelled(), [this] { return clock_.stopped(); });
  }
  /// Area of so many per cent of the part's.
  [[nodiscard]] double area(double pct) const { return 0.01 * pct * with_.model.geometry.total_area; }

  const SweepClock clock_;  // all proofs together end by it
  const Polishing with_;
  const SweepSettings& settings_;
  const int jobs_;
  std::vector<Contender>& contenders_;
};

void Prover::prove_best(std::optional<SweepProof>& proof) {
  const auto prove_again = [&](ProofGrade grade) {
    const double epsilon = area(*settings_.prove_pct);
    proof = prove_above(std::max(0.0, *least_undercut(contenders_) - epsilon), grade);
    proof->epsilon = epsilon;
  };
  // By samples first, whatever the grade: it is soon known whether anything better was missed.
  prove_again(ProofGrade::samples);
  for (int round = 0; round < k_most_proof_rounds && proof->complete && found_better(*proof); ++round)
    prove_again(ProofGrade::samples);
  if (settings_.proof_grade == ProofGrade::area) prove_again(ProofGrade::area);
}

void Prover::prove_all_free(std::optional<SweepProof>& proof) const {
  proof = prove_above(area(*settings_.all_free_pct), settings_.proof_grade);
  proof->epsilon = proof->bound;
  std::vector<ScoringTask> tasks;
  for (const OpenCap& open : proof->open) {
    if (tasks.size() < k_most_caps_measured) tasks.push_back({open.cap.direction});
  }
  const auto measured = measure(tasks);
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (measured[k]) proof->open[k].undercut = measured[k]->classification.areas[Region::undercut];
  }
}

SweepProof Prover::prove_above(double bound, ProofGrade grade) const {
  const ProofRun run{.grade = grade,
                     .bound = bound,
                     .stop = [this] { return clock_.stopped(); },
                     .progress = [this](double open) { clock_.report(sweep_stage::k_proving, 1.0 - open); }};
  tbb::task_arena arena(arena_threads(jobs_));
  return arena.execute([&] { return prove(with_.model, settings_, run, clock_.until_cancelled()); });
}

/// Directions in the middle of what is open, where nothing was measured nearby, by their scores.
std::vector<Contender> Prover::looked_at(const SweepProof& proof) const {
  std::vector<Contender> found;
  for (const OpenCap& each : proof.open) {
    if (found.size() == k_most_open_tried || clock_.stopped()) break;
    const glm::dvec3& direction = each.cap.direction;
    const bool known = std::ranges::any_of(contenders_, [&](const Contender& contender) {
      return contender.measured &&
             line_angle_deg(contender.candidate.direction, direction) + each.cap.radius_deg <=
                 settings_.apart_deg;
    });
    if (known) continue;
    const auto scores = with_.rays.score(std::vector<ScoringTask>{{direction}}, {}, {});
    with_.evaluated(evaluated_direction(direction, CandidateKind::refined, *scores[0]));
    Candidate candidate{direction, {{CandidateKind::refined, "where the proof was open", 0.0}}};
    const RankedFigures figures = with_.rating.scored(candidate, *scores[0]);
    found.push_back({std::move(candidate), *scores[0], figures, {}});
  }
  return found;
}

/// Measures and keeps them, polished where that may help; says whether one has less undercut than all others.
bool Prover::found_better(const SweepProof& proof) {
  const double before = *least_undercut(contenders_);
  std::vector<Contender> open = looked_at(proof);
  std::vector<ScoringTask> tasks;
  for (const Contender& contender : open) tasks.push_back({contender.candidate.direction});
  auto measured = measure(tasks);
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (!measured[k]) continue;
    Contender& contender = open[k];
    contender.figures = with_.rating.measured(contender.candidate, *measured[k]);
    contender.measured = std::make_shared<const MeasuredDirection>(std::move(*measured[k]));
    if (contender.figures.undercut <= before + area(100.0 * k_polished_share)) {
      if (std::optional<Contender> better = polish(with_, contender)) contender = std::move(*better);
    }
    contenders_.push_back(std::move(contender));
  }
  return *least_undercut(contenders_) < before;
}

}  // namespace

void prove_sweep(const Proving& proving, std::vector<Contender>& contenders, SweepResult& result) {
  if (!least_undercut(contenders) || proving.polishing.clock.stopped()) return;
  Prover prover(proving, contenders);
  try {
    if (proving.settings.prove_pct) prover.prove_best(result.proof);
    if (proving.settings.all_free_pct) prover.prove_all_free(result.all_free);
  } catch (const Cancelled&) {
    return;
  }
}

void judge_proofs(SweepResult& result) {
  const auto is_listed = [&](const OpenCap& open) {
    return std::ranges::any_of(result.candidates, [&](const SweepCandidate& candidate) {
      return line_angle_deg(candidate.candidate.direction, open.cap.direction) + open.cap.radius_deg <=
             result.settings.apart_deg;
    });
  };
  for (std::optional<SweepProof>* proof : {&result.proof, &result.all_free}) {
    if (*proof) (*proof)->holds = (*proof)->complete && std::ranges::all_of((*proof)->open, is_listed);
  }
}

}  // namespace moldlight
