#include "sweep/proving.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include <tbb/task_arena.h>

#include "base/error.hpp"
#include "mold/surface_samples.hpp"
#include "sweep/arena_threads.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight {

namespace {

// Better directions that a proof leads to are followed, and it begins anew, so many times at most.
constexpr int k_most_proof_rounds = 3;
constexpr std::size_t k_most_open_tried = 16, k_most_caps_measured = 200;

/// Longest side of the pieces that a proof by area begins with, unit frame, and how many there may be.
constexpr double k_longest_piece = 0.1;
constexpr std::size_t k_most_pieces = 400'000;
/// Points that show a proof by area where to look.
constexpr int k_guides = 20'000;
constexpr double k_level_95 = 2.0;  // standard errors

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
  Prover(const Descent& descent, const SweepSettings& settings, std::vector<Contender>& contenders)
      : clock_(descent.clock, settings.proof_limit_s),
        with_{.model = descent.model,
              .rating = descent.rating,
              .rays = descent.rays,
              .measurer = descent.measurer,
              .clock = clock_,
              .evaluated = descent.evaluated},
        settings_(settings),
        contenders_(contenders) {}

  /// Keeps the last proof that came to its end.
  void prove_best(std::optional<SweepProof>& proof);
  void prove_all_free(std::optional<SweepProof>& proof) const;

 private:
  [[nodiscard]] std::vector<SurfaceElement> points(const ProofPart& part, int count) const;
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
  const Descent with_;
  const SweepSettings& settings_;
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

std::vector<SurfaceElement> Prover::points(const ProofPart& part, int count) const {
  const PartModel& model = with_.model;
  return sample_elements(part, sample_surface_evenly(model.part.mesh, model.geometry, model.frame,
                                                     static_cast<std::uint64_t>(count)));
}

/// With the settings' scoring samples, tau and lateral tolerance.
SweepProof Prover::prove_above(double bound, ProofGrade grade) const {
  const auto start = std::chrono::steady_clock::now();
  const PartModel& model = with_.model;
  const MethodSettings& method = settings_.method;
  const double diagonal = model.frame.diagonal, total = model.geometry.total_area;
  ProofTask task{
      .query = {.tau_deg = method.tau_deg, .lateral = lateral_tolerance(method, diagonal) / diagonal},
      .bound = bound,
      .stop = [this] { return clock_.stopped(); },
      .progress = [this](double open) { clock_.report(sweep_stage::k_proving, 1.0 - open); }};
  tbb::task_arena arena(arena_threads(ScoringPool::threads(settings_.jobs)));
  DirectionProof found = arena.execute([&] {
    const ProofPart part{.mesh = model.part.mesh,
                         .geometry = model.geometry,
                         .adjacency = model.adjacency,
                         .positions = model.exact(clock_.until_cancelled()).positions(),
                         .rays = model.rays()};
    if (grade == ProofGrade::samples)
      return prove_directions(part, points(part, settings_.scoring_samples), task);
    return prove_directions(
        part, surface_pieces(part, k_longest_piece, k_most_pieces, points(part, k_guides)), task);
  });
  SweepProof proof;
  proof.grade = grade;
  proof.bound = bound;
  proof.proved_share = std::min(found.proved_share, 1.0);
  if (grade == ProofGrade::samples && total > 0.0) {
    const double share = std::clamp(bound / total, 0.0, 1.0);
    proof.bound_error = k_level_95 * total * std::sqrt(share * (1.0 - share) / settings_.scoring_samples);
  }
  for (const DirectionCap& cap : open_caps(found.cells)) proof.open.push_back({cap});
  proof.looked_at = found.looked_at;
  proof.complete = found.complete;
  proof.cells = std::move(found.cells);
  proof.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return proof;
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

void prove_sweep(const Descent& descent, const SweepSettings& settings, std::vector<Contender>& contenders,
                 SweepResult& result) {
  if (!least_undercut(contenders) || descent.clock.stopped()) return;
  Prover prover(descent, settings, contenders);
  try {
    if (settings.prove_pct) prover.prove_best(result.proof);
    if (settings.all_free_pct) prover.prove_all_free(result.all_free);
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
