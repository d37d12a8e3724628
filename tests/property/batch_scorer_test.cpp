// Scores by batches of maps on the GL against exact rays, and alone against together.
#include "sweep/batch_scorer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "classify/classifier.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"
#include "sweep/ray_scorer.hpp"

namespace moldlight {
namespace {

constexpr double k_lateral = 1.0 / 2048.0;

std::vector<ScoringTask> tasks(int slanted) {
  std::vector<ScoringTask> tasks = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  for (int i = 0; i < slanted; ++i) {
    const double z = (i + 0.5) / slanted, around = 2.4 * i, r = std::sqrt(1.0 - z * z);
    tasks.push_back({glm::normalize(glm::dvec3(r * std::cos(around), r * std::sin(around), z))});
  }
  return tasks;
}

SurfaceSamples samples_of(const PartModel& model, std::uint64_t count) {
  return sample_surface_evenly(model.part.mesh, model.geometry, model.frame, count);
}

BatchScorerSettings settings_of(int resolution) {
  return {.map = {.resolution = resolution, .lateral = k_lateral}};
}

TEST(BatchScorer, SameBitsAloneAndTogether) {
  const auto model = test::model_of(test::subdivided(test::snap_hook({}).mesh, 5000));
  const SurfaceSamples samples = samples_of(*model, 10'000);
  BatchScorer together({model, samples}, settings_of(128)), alone({model, samples}, settings_of(128));
  const std::vector<ScoringTask> all = tasks(9);
  ASSERT_GE(together.batch_size(), all.size());
  const std::vector<DirectionScore> scores = together.score(all);
  ASSERT_EQ(scores.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const DirectionScore score = alone.score({&all[i], 1}).front();
    EXPECT_EQ(score.areas.values, scores[i].areas.values) << i;
    EXPECT_EQ(score.undercut_error, scores[i].undercut_error) << i;
    EXPECT_EQ(score.shadow_area, scores[i].shadow_area) << i;
  }
}

/// Scores and their errors against exact rays from many samples.
void expect_true_within_error(const std::string& path) {
  const auto model = load_part(path, {}, {});
  const SurfaceSamples samples = samples_of(*model, 10'000), many = samples_of(*model, 300'007);
  BatchScorer scorer({model, samples}, settings_of(512));
  RayScorer rays({model->rays(), model->geometry, many}, 1.0, k_lateral);
  const double total = model->geometry.total_area;
  double worst = 0.0, widest = 0.0;
  for (const ScoringTask& task : tasks(9)) {
    const DirectionScore score = scorer.score({&task, 1}).front(), exact = rays.score({&task, 1}).front();
    const double off = std::abs(score.undercut() - exact.undercut());
    EXPECT_LE(off, score.undercut_error + 2e-4 * total) << path;
    EXPECT_NEAR(score.areas.total(), total, 1e-9 * total) << path;
    worst = std::max(worst, off);
    widest = std::max(widest, score.undercut_error);
  }
  EXPECT_LE(worst, 0.006 * total) << path;
  std::printf("%s: undercut off by %.3f %% at worst, stated ± %.3f %% at worst\n", path.c_str(),
              100.0 * worst / total, 100.0 * widest / total);
}

TEST(BatchScorer, MeetsExactRaysOnShippedParts) {
  for (const char* part : {"bottle_cap.stl", "cable_clip.stl", "enclosure_lid.stl", "tilted_bracket.stl"})
    expect_true_within_error((test::asset_folder() / "parts" / part).string());
}

TEST(BatchScorer, MeetsExactRaysOnRealParts) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no folder of real parts";
  for (const char* part : {"lego_brick_2x4.stl", "m5_base26_main.stl", "so101_base.stl",
                           "trimesh_featuretype.stl", "odri_hip_cover_64k.stl"})
    expect_true_within_error((*shared / "parts" / part).string());
}

}  // namespace
}  // namespace moldlight
