#include "sweep/sweep_proof.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "mold/direction.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

namespace {

/// Longest side of the pieces that a proof by area begins with, unit frame, and how many there may be.
constexpr double k_longest_piece = 0.1;
constexpr std::size_t k_most_pieces = 400'000;
/// Points that show a proof by area where to look.
constexpr int k_guides = 20'000;
constexpr double k_level_95 = 2.0;  // standard errors

std::vector<SurfaceElement> points_of(const PartModel& model, const ProofPart& part, int count) {
  return sample_elements(part, sample_surface_evenly(model.part.mesh, model.geometry, model.frame,
                                                     static_cast<std::uint64_t>(count)));
}

DirectionProof prove(const PartModel& model, const ProofPart& part, const ProofTask& task, ProofGrade grade,
                     int samples) {
  if (grade == ProofGrade::samples) return prove_directions(part, points_of(model, part, samples), task);
  return prove_directions(
      part, surface_pieces(part, k_longest_piece, k_most_pieces, points_of(model, part, k_guides)), task);
}

}  // namespace

std::optional<double> SweepProof::bound_at(const glm::dvec3& direction) const {
  const glm::dvec3 turned = half_sphere(direction);
  const auto cell = std::ranges::find_if(
      cells, [&](const ProofCell& each) { return each.proved && each.cell.contains(turned); });
  return cell == cells.end() ? std::nullopt : std::optional(std::max(cell->bound, bound));
}

SweepProof prove(const PartModel& model, const SweepSettings& settings, const ProofRun& run,
                 const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const ProofPart part{.mesh = model.part.mesh,
                       .geometry = model.geometry,
                       .adjacency = model.adjacency,
                       .positions = model.exact(progress).positions(),
                       .rays = model.rays()};
  ProofTask task;
  task.query = {.tau_deg = settings.method.tau_deg,
                .lateral = lateral_tolerance(settings.method, model.frame.diagonal) / model.frame.diagonal};
  task.bound = run.bound;
  task.stop = run.stop;
  task.progress = run.progress;
  DirectionProof found = prove(model, part, task, run.grade, settings.scoring_samples);
  SweepProof proof;
  proof.grade = run.grade;
  proof.bound = run.bound;
  const double total = model.geometry.total_area;
  if (run.grade == ProofGrade::samples && total > 0.0) {
    const double share = std::clamp(run.bound / total, 0.0, 1.0);
    proof.bound_error = k_level_95 * total * std::sqrt(share * (1.0 - share) / settings.scoring_samples);
  }
  proof.proved_share = std::min(found.proved_share, 1.0);
  for (const DirectionCap& cap : open_caps(found.cells)) proof.open.push_back({cap});
  proof.looked_at = found.looked_at;
  proof.complete = found.complete;
  proof.cells = std::move(found.cells);
  proof.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return proof;
}

}  // namespace moldlight
