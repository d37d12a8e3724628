// Proofs against exact areas of random directions and of an even grid, and certain samples against rays. A
// few directions by default; MOLDLIGHT_PROOF_CHECKS=5000 asks that many a part, on the shared parts, too.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction.hpp"
#include "support/proof_checks.hpp"
#include "support/proof_model.hpp"
#include "support/shared_parts.hpp"
#include "sweep/candidates/candidate_sources.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

constexpr std::size_t k_proof_samples = 10'000, k_guides = 5'000;
constexpr std::size_t k_rays_per_direction = 100, k_grid_per_direction = 4;
constexpr double k_level_95 = 2.0;       // standard errors
constexpr double k_better_share = 5e-5;  // of the part's area: less better is rounding

/// Directions a part that are asked for.
std::size_t directions_wanted() {
  const char* const wanted = std::getenv("MOLDLIGHT_PROOF_CHECKS");
  return wanted ? std::stoul(wanted) : 25;
}

/// One part; with many checks the other shipped ones and shared ones that are closed, smallest first.
std::vector<std::filesystem::path> parts(std::size_t most) {
  const auto shipped = test::asset_folder() / "parts";
  std::vector<std::filesystem::path> found = {shipped / "tilted_bracket.stl"};
  if (directions_wanted() < 1000 || !test::shared_folder()) return found;
  for (const char* name : {"cable_clip.stl", "enclosure_lid.stl", "bottle_cap.stl"})
    found.push_back(shipped / name);
  for (const auto& entry : std::filesystem::directory_iterator(*test::shared_folder() / "parts")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".stl" && extension != ".obj" && extension != ".off") continue;
    if (entry.file_size() < 1'000'000) found.push_back(entry.path());
  }
  std::ranges::sort(found, {}, [](const auto& path) { return std::filesystem::file_size(path); });
  std::vector<std::filesystem::path> closed;
  for (const auto& path : found) {
    if (closed.size() < most && load_part(path.string(), {}, Progress{})->health.closed)
      closed.push_back(path);
  }
  return closed;
}

/// By samples and by area, for the same bound.
struct Proofs {
  DirectionProof samples, area;
  double sampling_error = 0.0;  // 95 % level
};

/// For a third of what directions have in the median, so that much is proved, much is open, and cells of
/// several sizes lie between.
Proofs prove_third_of_median(const test::ProofModel& model) {
  std::vector<double> undercuts;
  for (const glm::dvec3& direction : fibonacci_half_sphere(15))
    undercuts.push_back(model.undercut(direction));
  std::ranges::nth_element(undercuts, undercuts.begin() + 7);
  const double total = model.part().geometry.total_area, share = undercuts[7] / (3.0 * total);
  const ProofTask task{
      .query = model.query(), .bound = share * total, .finest_deg = 4.0, .finest_length = 0.02};
  return {.samples = prove_directions(model.part(), model.samples(k_proof_samples), task),
          .area = prove_directions(model.part(), model.pieces(k_guides), task),
          .sampling_error = k_level_95 * total * std::sqrt(share * (1.0 - share) / k_proof_samples)};
}

const ProofCell& cell_of(const DirectionProof& proof, const glm::dvec3& direction) {
  const glm::dvec3 turned = half_sphere(direction);
  return *std::ranges::find_if(proof.cells,
                               [&](const ProofCell& cell) { return cell.cell.contains(turned); });
}

/// How often exact areas were below what cells promise, and how near they came.
struct Compared {
  std::size_t directions = 0, below_area = 0, below_samples = 0;
  double closest = std::numeric_limits<double>::infinity();  // to the bound by area, share of the part

  /// The exact undercut, which it was compared by.
  double compare(const test::ProofModel& model, const Proofs& proofs, const glm::dvec3& direction) {
    const double undercut = model.undercut(direction);
    const ProofCell &by_area = cell_of(proofs.area, direction),
                    &by_samples = cell_of(proofs.samples, direction);
    ++directions;
    if (undercut < by_area.bound) ++below_area;
    if (undercut < by_samples.bound - proofs.sampling_error) ++below_samples;
    if (by_area.bound > 0.0)
      closest = std::min(closest, (undercut - by_area.bound) / model.part().geometry.total_area);
    return undercut;
  }
};

std::ostream& operator<<(std::ostream& out, const Compared& compared) {
  return out << compared.directions << " directions, below the bound by area " << compared.below_area
             << ", by samples " << compared.below_samples << ", closest " << 100.0 * compared.closest << " %";
}

TEST(ProofSoundness, ExactAreasOfRandomDirectionsAreNeverBelowTheBound) {
  std::size_t checked = 0;
  for (const auto& path : parts(20)) {
    const test::ProofModel model(load_part(path.string(), {}, Progress{}));
    const Proofs proofs = prove_third_of_median(model);
    test::Random random(17);
    Compared compared;
    for (std::size_t k = 0; k < directions_wanted(); ++k) {
      // Every other one in any cell, so that small cells, where it is close, have as many as large ones.
      const auto& cells = proofs.area.cells;
      const SphereCell cell =
          k % 2 == 0 ? cells[random.below(cells.size())].cell : half_sphere_cells()[random.below(4)];
      compared.compare(model, proofs, test::random_direction(cell, random));
    }
    checked += compared.directions;
    EXPECT_EQ(compared.below_area, 0U) << path;
    EXPECT_EQ(compared.below_samples, 0U) << path;
    std::cout << path.filename().string() << ": proved " << 100.0 * proofs.area.proved_share
              << " % by area in " << proofs.area.cells.size() << " cells, "
              << 100.0 * proofs.samples.proved_share << " % by samples; " << compared << std::endl;
  }
  EXPECT_GT(checked, 0U);
}

TEST(ProofSoundness, WhatIsCertainIsBlockedForRays) {
  std::size_t checked = 0;
  for (const auto& path : parts(20)) {
    const test::ProofModel model(load_part(path.string(), {}, Progress{}));
    const std::size_t wanted = k_rays_per_direction * directions_wanted();
    for (const auto& elements : {model.samples(k_proof_samples), model.pieces(0).pieces}) {
      const test::RaysChecked rays = test::check_certain(model, elements, wanted / 2, 8, 23);
      EXPECT_EQ(rays.wrong, 0U) << path << ", of " << rays.certain;
      std::cout << path.filename().string() << ": " << rays.certain << " rays, wrong " << rays.wrong
                << std::endl;
      checked += rays.certain;
    }
  }
  EXPECT_GT(checked, k_rays_per_direction * directions_wanted());
}

TEST(ProofSoundness, AnEvenGridIsNeverBelowTheBoundAndItsBestIsListed) {
  for (const auto& path : parts(10)) {
    const auto part = load_part(path.string(), {}, Progress{});
    const test::ProofModel model(part);
    const Proofs proofs = prove_third_of_median(model);
    SweepSettings settings;
    settings.prove_pct = 0.1;
    settings.proof_grade = ProofGrade::area;
    const SweepResult sweep = run_sweep(part, settings, Progress{}, {});
    ASSERT_TRUE(sweep.proof);
    Compared compared;
    double best = std::numeric_limits<double>::infinity();
    std::size_t below_sweep = 0;
    for (const glm::dvec3& direction : fibonacci_half_sphere(k_grid_per_direction * directions_wanted())) {
      const double undercut = compared.compare(model, proofs, direction);
      best = std::min(best, undercut);
      if (undercut < sweep.proof->bound_at(direction).value_or(0.0)) ++below_sweep;
    }
    EXPECT_EQ(compared.below_area, 0U) << path;
    EXPECT_EQ(compared.below_samples, 0U) << path;
    EXPECT_EQ(below_sweep, 0U) << path;
    const double listed = sweep.candidates.front().classification.areas[Region::undercut];
    const double total = model.part().geometry.total_area;
    EXPECT_GE(best, listed - k_better_share * total) << path;
    std::cout << path.filename().string() << ": " << compared << "; best " << 100.0 * best / total
              << " %, listed " << 100.0 * listed / total << " %" << std::endl;
  }
}

}  // namespace
}  // namespace moldlight
