// Real parts with known pulls: the pull is among the candidates and among the best of a sweep, also for the
// part in any other position.
#include "support/known_pulls.hpp"

#include <iostream>

#include <gtest/gtest.h>

#include "io/part_formats.hpp"
#include "mesh/adjacency.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"
#include "sweep/candidates/find_candidates.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

using test::k_demo_pulls;
using test::k_shared_pulls;
using test::KnownPull;

constexpr std::uintmax_t k_most_bytes_for_sweep = 500'000;

/// Smallest angle to the pull of candidates that come from the part's shape alone.
double nearest_deg(const TriangleMesh& mesh, const glm::dvec3& pull) {
  const CandidateOptions shape_alone{.kinds = {CandidateKind::revolution, CandidateKind::plane,
                                               CandidateKind::perpendicular, CandidateKind::hull,
                                               CandidateKind::principal}};
  double nearest = 90.0;
  for (const Candidate& candidate : find_candidates(*test::model_of(mesh), shape_alone, Progress())) {
    nearest = std::min(nearest, line_angle_deg(candidate.direction, pull));
  }
  return nearest;
}

void expect_pull_found(const std::filesystem::path& file, const glm::dvec3& direction) {
  const Part part = read_part(file.string(), {}, Progress());
  const double upright = nearest_deg(part.mesh, direction);
  EXPECT_LT(upright, 0.05) << file;
  std::cout << file.filename().string() << ": " << upright;
  for (const std::uint32_t seed : {1u, 2u}) {
    const glm::dquat rotation = test::random_rotation(seed);
    const double turned = nearest_deg(test::rotated(part.mesh, rotation), rotation * direction);
    EXPECT_LT(turned, 0.05) << file << " turned by rotation " << seed;
    std::cout << ' ' << turned;
  }
  std::cout << " degrees\n";
}

/// A sweep of the turned part finds nothing worse than the pull; and the pull itself in the first tie group,
/// unless there is something better.
void expect_pull_is_best(const std::filesystem::path& file, const glm::dvec3& direction, std::uint32_t seed) {
  Part part = read_part(file.string(), {}, Progress());
  const glm::dquat rotation = test::random_rotation(seed);
  const auto model = test::model_of(test::rotated(std::move(part.mesh), rotation));
  SweepSettings settings;
  settings.directions = 100;
  settings.refine = 2;
  settings.rank = SweepRank::objective;
  settings.top = 4;
  const SweepResult result = run_sweep(model, settings, Progress{}, {});
  const Query query{rotation * direction, settings.method};
  const Classification pull = classify_exact(*model, query, Progress{});

  const Classification& best = result.candidates.front().classification;
  const double found = best.areas[Region::undercut], known = pull.areas[Region::undercut];
  const double slack = best.uncertainty.total() + pull.uncertainty.total();
  EXPECT_LE(found, known + slack) << file;
  double nearest = 90.0;
  for (const SweepCandidate& candidate : result.candidates) {
    if (candidate.tie_group > 1) break;
    nearest = std::min(nearest, line_angle_deg(candidate.classification.direction, query.direction.unit()));
  }
  if (known <= found + slack) {
    EXPECT_LT(nearest, 0.1) << file;
  }
  const double share = 100.0 / best.total_area;
  std::cout << file.filename().string() << ": undercut " << share * found << " %, at the pull "
            << share * known << " %, " << nearest << " degrees from it\n";
}

TEST(KnownPulls, OfTheDemoPartsAreBest) {
  for (const KnownPull& pull : k_demo_pulls) {
    expect_pull_is_best(test::asset_folder() / "parts" / pull.file, pull.direction, 5);
  }
}

TEST(KnownPulls, OfTheSharedPartsAreBest) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  std::size_t parts = 0;
  for (const KnownPull& pull : k_shared_pulls) {
    const auto file = *test::shared_folder() / "parts" / pull.file;
    // The others take half a minute more.
    if (std::filesystem::file_size(file) > k_most_bytes_for_sweep) continue;
    expect_pull_is_best(file, pull.direction, 6);
    ++parts;
  }
  std::cout << parts << " shared parts\n";
}

TEST(KnownPulls, OfTheDemoPartsAreCandidates) {
  for (const KnownPull& pull : k_demo_pulls) {
    expect_pull_found(test::asset_folder() / "parts" / pull.file, pull.direction);
  }
}

TEST(KnownPulls, OfTheSharedPartsAreCandidates) {
  if (!test::shared_folder()) GTEST_SKIP() << "no shared parts";
  for (const KnownPull& pull : k_shared_pulls) {
    expect_pull_found(*test::shared_folder() / "parts" / pull.file, pull.direction);
  }
}

}  // namespace
}  // namespace moldlight
