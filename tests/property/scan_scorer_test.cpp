// Scores by scan-converted maps against known areas, exact rays and reference areas of real parts.
#include "mold/sweep/scan_scorer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/sweep/ray_scorer.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/reference_areas.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

/// A part ready to be scored.
struct Scored {
  explicit Scored(std::shared_ptr<const PartModel> of_model)
      : model(std::move(of_model)),
        part(model->part.mesh, model->geometry, model->frame, model->edges.concave) {}

  [[nodiscard]] ScanScorer scorer(ScanScorerSettings settings, double lateral_tolerance) const {
    settings.lateral = lateral_tolerance / model->frame.diagonal;
    return ScanScorer({part, model->rays()}, settings);
  }
  [[nodiscard]] double total() const { return model->geometry.total_area; }

  std::shared_ptr<const PartModel> model;
  ScanPart part;
};

double worst_error(const DirectionScore& score, const RegionValues& expected) {
  double worst = 0.0;
  for (const Region region : k_regions)
    worst = std::max(worst, std::abs(score.areas[region] - expected[region]));
  return worst;
}

TEST(ScanScorer, MeetsKnownAreas) {
  const test::ShapeSettings settings{.tau_deg = 1.0, .lateral_tolerance = 0.02};
  double worst = 0.0;
  std::size_t shapes = 0, covered = 0;
  for (const test::Shape& shape : test::all_shapes(settings)) {
    const Scored scored(test::model_of(shape.mesh));
    const DirectionScore score = scored.scorer({.tau_deg = settings.tau_deg}, settings.lateral_tolerance)
                                     .score(glm::normalize(shape.direction));
    const double off = std::abs(score.undercut() - shape.expected[Region::undercut]) / scored.total();
    EXPECT_LE(worst_error(score, shape.expected), 0.006 * scored.total()) << shape.name;
    EXPECT_LE(off, 0.003) << shape.name;
    EXPECT_NEAR(score.areas.total(), scored.total(), 1e-5 * scored.total()) << shape.name;
    EXPECT_LE(score.undercut_bound, shape.expected[Region::undercut] + 1e-9) << shape.name;
    worst = std::max(worst, off);
    covered += off <= score.undercut_error / scored.total() + 2e-4 ? 1 : 0;
    ++shapes;
  }
  std::printf(
      "%zu shapes, worst undercut error %.4f %% of the area, %zu within the stated error and 0.02 %%\n",
      shapes, 100.0 * worst, covered);
  EXPECT_GE(static_cast<double>(covered), 0.9 * static_cast<double>(shapes));
}

TEST(ScanScorer, ErrorFallsWithResolutionAndSamples) {
  const test::ShapeSettings settings{.tau_deg = 1.0, .lateral_tolerance = 0.02};
  double coarse = 0.0, fine = 0.0;
  for (const test::Shape& shape : test::all_shapes(settings)) {
    const Scored scored(test::model_of(shape.mesh));
    const auto squared_error = [&](const ScanScorerSettings& how) {
      const double off =
          scored.scorer(how, settings.lateral_tolerance).score(glm::normalize(shape.direction)).undercut() -
          shape.expected[Region::undercut];
      return off * off / (scored.total() * scored.total());
    };
    coarse += squared_error({.resolution = 128, .samples = 2000});
    fine += squared_error({.resolution = 1024, .samples = 100'000});
  }
  EXPECT_LT(fine, 0.1 * coarse);
}

TEST(ScanScorer, SameBitsWhateverWasScoredBefore) {
  const Scored scored(test::model_of(test::subdivided(test::snap_hook({}).mesh, 5000)));
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.1, 0.02, 1.0));
  ScanScorer fresh = scored.scorer({.resolution = 256}, 0.02),
             used = scored.scorer({.resolution = 256}, 0.02);
  for (int i = 0; i < 150; ++i) {
    EXPECT_GE(used.score(glm::normalize(glm::dvec3(std::cos(i), std::sin(i), 0.3))).undercut(), 0.0);
  }
  const DirectionScore a = fresh.score(direction), b = used.score(direction);
  EXPECT_EQ(a.areas.values, b.areas.values);
  EXPECT_EQ(a.undercut_error, b.undercut_error);
  EXPECT_EQ(a.undercut_bound, b.undercut_bound);
  EXPECT_EQ(a.shadow_area, b.shadow_area);
}

TEST(ScanScorer, ReversedDirectionSwapsCoreAndCavity) {
  const Scored scored(test::model_of(test::subdivided(test::snap_hook({}).mesh, 5000)));
  ScanScorer scorer = scored.scorer({}, 0.02);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));
  const DirectionScore there = scorer.score(direction), back = scorer.score(-direction);
  const double bound = 0.002 * scored.total();
  EXPECT_NEAR(there.areas[Region::core], back.areas[Region::cavity], bound);
  EXPECT_NEAR(there.areas[Region::cavity], back.areas[Region::core], bound);
  EXPECT_NEAR(there.undercut(), back.undercut(), bound);
}

TEST(ScanScorer, AgreesWithExactRaysInManyDirections) {
  for (const test::Shape& shape :
       {test::snap_hook({}), test::block_with_crossing_hole({}), test::spool({})}) {
    const Scored scored(test::model_of(test::subdivided(shape.mesh, 8000)));
    const PartModel& model = *scored.model;
    const SurfaceSamples samples =
        sample_surface_evenly(model.part.mesh, model.geometry, model.frame, 200'000);
    RayScorer rays({model.rays(), model.geometry, samples}, 1.0, 0.02 / model.frame.diagonal);
    ScanScorer maps = scored.scorer({}, 0.02);
    for (int i = 0; i < 20; ++i) {
      const double z = (i + 0.5) / 20.0, around = 2.4 * i, r = std::sqrt(1.0 - z * z);
      const glm::dvec3 direction(r * std::cos(around), r * std::sin(around), z);
      const DirectionScore by_maps = maps.score(direction), by_rays = rays.score(direction);
      EXPECT_LE(worst_error(by_maps, by_rays.areas), 0.003 * scored.total())
          << shape.name << " direction " << i;
      EXPECT_NEAR(by_maps.shadow_area, by_rays.shadow_area, 0.003 * scored.total()) << shape.name;
      EXPECT_LE(by_maps.undercut_bound, by_rays.undercut() + 1e-3 * scored.total()) << shape.name;
    }
  }
}

TEST(ScanScorer, GivesUpOnlyAboveTheLimit) {
  const Scored scored(test::model_of(test::subdivided(test::spool({}).mesh, 5000)));
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.3, 0.4));
  ScanScorer scorer = scored.scorer({}, 0.02);
  const DirectionScore whole = scorer.score(direction);
  ASSERT_FALSE(whole.given_up);
  ASSERT_GT(whole.undercut(), 0.05 * scored.total());
  scorer.give_up_above(1.01 * whole.undercut());
  EXPECT_FALSE(scorer.score(direction).given_up);
  scorer.give_up_above(0.5 * whole.undercut());
  const DirectionScore early = scorer.score(direction);
  EXPECT_TRUE(early.given_up);
  EXPECT_GT(early.undercut(), 0.5 * whole.undercut());
  EXPECT_GE(early.pessimistic(), whole.undercut());
}

TEST(ScanScorer, MapsAloneAreHonestAboutTheirDoubts) {
  const test::Shape shape = test::narrow_ledge({.tau_deg = 1.0, .lateral_tolerance = 0.1});
  const Scored scored(test::model_of(test::subdivided(shape.mesh, 2000)));
  const DirectionScore score =
      scored.scorer({.settle_by_rays = false}, 0.1).score(glm::normalize(shape.direction));
  EXPECT_GT(score.undercut_error, 0.0);
  EXPECT_LE(std::abs(score.undercut() - shape.expected[Region::undercut]), score.undercut_error);
}

/// Errors over the reference rows, in shares of the parts' areas.
struct Errors {
  double root_mean_square = 0.0, worst = 0.0, worst_region = 0.0;
  std::size_t rows = 0, covered = 0;
};

Errors reference_errors(const std::filesystem::path& shared, const ScanScorerSettings& how) {
  Errors errors;
  std::unique_ptr<Scored> scored;
  std::string loaded;
  for (const test::ReferenceRow& row : test::read_reference_areas(shared / "reference" / "areas.csv")) {
    if (row.part != loaded) {
      scored = std::make_unique<Scored>(
          load_part((shared / "parts" / row.part).string(), ReadOptions{}, Progress{}));
      loaded = row.part;
    }
    ScanScorerSettings settings = how;
    settings.tau_deg = row.tau_deg;
    const DirectionScore score =
        scored->scorer(settings, row.lateral_tolerance).score(map_frame(row.direction).z);
    const double off = std::abs(score.undercut() - row.areas[Region::undercut]);
    EXPECT_LE(score.undercut_bound, row.areas[Region::undercut]) << row.part;
    errors.covered += off <= score.undercut_error + 3.0 * row.undercut_error + 1e-4 * row.total ? 1 : 0;
    errors.root_mean_square += off * off / (row.total * row.total);
    errors.worst = std::max(errors.worst, off / row.total - 3.0 * row.undercut_error / row.total);
    errors.worst_region = std::max(errors.worst_region, worst_error(score, row.areas) / row.total);
    ++errors.rows;
  }
  errors.root_mean_square = std::sqrt(errors.root_mean_square / static_cast<double>(errors.rows));
  std::printf(
      "%d texels, %.0f samples: undercut off by %.4f %% (root mean square), %.4f %% at worst; regions %.3f "
      "%% at "
      "worst; %zu of %zu rows within the stated error\n",
      how.resolution, how.samples, 100.0 * errors.root_mean_square, 100.0 * errors.worst,
      100.0 * errors.worst_region, errors.covered, errors.rows);
  return errors;
}

TEST(ScanScorer, MeetsReferenceAreas) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no folder of real parts";
  const Errors scoring = reference_errors(*shared, {});
  EXPECT_LE(scoring.root_mean_square, 0.0004);
  EXPECT_LE(scoring.worst, 0.0015);
  EXPECT_GE(static_cast<double>(scoring.covered), 0.95 * static_cast<double>(scoring.rows));
  // The bars of a classification.
  const Errors final_figures = reference_errors(*shared, {.resolution = 2048, .samples = 200'000});
  EXPECT_LE(final_figures.worst_region, 0.005);
  EXPECT_LE(final_figures.worst, 0.001);
  EXPECT_GE(static_cast<double>(final_figures.covered), 0.95 * static_cast<double>(final_figures.rows));
}

}  // namespace
}  // namespace moldlight
