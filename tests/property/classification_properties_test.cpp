// Properties of the classification, on generated cases: shapes of ours, turned, scaled, moved and reordered.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

constexpr int k_cases = 6;
// Two runs on different samples may each be off by their stated uncertainty; regions other than the undercut
// have no stated one and get as much again, and single precision its share.
double allowed(const Classification& a, const Classification& b) {
  return a.uncertainty.total + b.uncertainty.total + 2e-4 * a.total_area;
}

MethodSettings settings_for(const test::Shape& shape) {
  MethodSettings settings;
  settings.direction = shape.direction;
  settings.tau_deg = shape.settings.tau_deg;
  settings.tolerance = shape.settings.lateral_tolerance;
  settings.resolution = 1024;
  settings.samples = 300'000;
  return settings;
}

void expect_same_areas(const Classification& a, const Classification& b, const std::string& name) {
  for (const Region region : k_regions) {
    EXPECT_NEAR(a.areas[region], b.areas[region], allowed(a, b)) << name << ", " << region_name(region);
  }
}

/// A few shapes each time, another rotation of each.
std::vector<test::Shape> cases(std::uint32_t seed) {
  const std::vector<test::Shape> all = test::all_shapes({});
  std::vector<test::Shape> chosen;
  for (std::uint32_t i = 0; i < k_cases; ++i) {
    const std::size_t index = (seed * 7919U + i * 104729U) % all.size();
    chosen.push_back(test::turned(all[index], test::random_rotation(seed * 1000U + i)));
  }
  return chosen;
}

TEST(ClassificationProperties, PartAndDirectionTurnTogether) {
  for (const test::Shape& shape : cases(1)) {
    const test::Shape turned = test::turned(shape, test::random_rotation(77));
    expect_same_areas(test::classify_mesh(shape.mesh, settings_for(shape)),
                      test::classify_mesh(turned.mesh, settings_for(turned)), shape.name);
  }
}

TEST(ClassificationProperties, ReversedDirectionSwapsCoreAndCavity) {
  for (const test::Shape& shape : cases(2)) {
    MethodSettings settings = settings_for(shape);
    const Classification forward = test::classify_mesh(shape.mesh, settings);
    settings.direction = -settings.direction;
    Classification reversed = test::classify_mesh(shape.mesh, settings);
    std::swap(reversed.areas[Region::core], reversed.areas[Region::cavity]);
    expect_same_areas(forward, reversed, shape.name);
  }
}

TEST(ClassificationProperties, ScalingByAFactorScalesAreasByItsSquare) {
  for (const test::Shape& shape : cases(3)) {
    for (const double factor : {1e-3, 25.4, 1e4}) {
      MethodSettings settings = settings_for(shape);
      const Classification before = test::classify_mesh(shape.mesh, settings);
      settings.tolerance = *settings.tolerance * factor;
      Classification after = test::classify_mesh(test::scaled(shape.mesh, factor), settings);
      for (double& area : after.areas.values) area /= factor * factor;
      after.uncertainty.total /= factor * factor;
      expect_same_areas(before, after, shape.name);
    }
  }
}

TEST(ClassificationProperties, FarFromTheOriginNothingChanges) {
  for (const test::Shape& shape : cases(4)) {
    const MethodSettings settings = settings_for(shape);
    expect_same_areas(test::classify_mesh(shape.mesh, settings),
                      test::classify_mesh(test::translated(shape.mesh, {1e6, -2e6, 5e5}), settings),
                      shape.name);
  }
}

TEST(ClassificationProperties, OrderOfFacetsAndVerticesDoesNotMatter) {
  for (const test::Shape& shape : cases(5)) {
    const MethodSettings settings = settings_for(shape);
    expect_same_areas(test::classify_mesh(shape.mesh, settings),
                      test::classify_mesh(test::permuted(shape.mesh, 99), settings), shape.name);
  }
}

TEST(ClassificationProperties, AreasAddUpAndFractionsAreShares) {
  for (const test::Shape& shape : cases(6)) {
    const auto model = test::model_of(shape.mesh);
    const Classification result =
        Classifier(test::shared_context(), model).classify(settings_for(shape), Progress{});
    EXPECT_NEAR(result.areas.total(), result.total_area, 1e-9 * result.total_area);
    RegionValues summed;
    for (std::size_t facet = 0; facet < result.facet_fractions.size(); ++facet) {
      float sum = 0.0F;
      for (const Region region : k_regions) {
        const float share = result.facet_fractions[facet][static_cast<std::size_t>(region)];
        EXPECT_GE(share, 0.0F);
        sum += share;
        summed[region] += model->geometry.areas[facet] * static_cast<double>(share);
      }
      EXPECT_NEAR(sum, 1.0F, 1e-6F);
    }
    for (const Region region : k_regions) {
      EXPECT_NEAR(summed[region], result.areas[region], 1e-6 * result.total_area);
    }
  }
}

TEST(ClassificationProperties, TheIdentityHoldsOnClosedPartsForAnyDirection) {
  std::uint32_t seed = 0;
  for (const test::Shape& shape : cases(7)) {
    MethodSettings settings = settings_for(shape);
    settings.direction = test::random_rotation(500 + seed++) * glm::dvec3(0, 0, 1);
    const Classification result = test::classify_mesh(shape.mesh, settings);
    EXPECT_TRUE(result.projected.agrees())
        << shape.name << ": gap " << result.projected.gap << ", limit " << result.projected.gap_limit;
    EXPECT_LE(result.projected.gap_limit, 0.01 * result.total_area);
  }
}

TEST(ClassificationProperties, TheIdentityExposesAnOpenPart) {
  TriangleMesh open = test::box_mesh({0, 0, 0}, {20, 20, 10});
  MethodSettings settings;
  settings.direction = {0.1, 0.2, 1.0};
  settings.samples = 100'000;
  EXPECT_TRUE(test::classify_mesh(open, settings).projected.agrees());
  open.facets.pop_back();
  const Classification result = test::classify_mesh(open, settings);
  EXPECT_FALSE(result.projected.agrees());
  EXPECT_FALSE(result.warnings.empty());
}

TEST(ClassificationProperties, TheSameInputGivesTheSameBits) {
  for (const test::Shape& shape : cases(8)) {
    const Classification a = test::classify_mesh(shape.mesh, settings_for(shape));
    const Classification b = test::classify_mesh(shape.mesh, settings_for(shape));
    EXPECT_EQ(a.facet_fractions, b.facet_fractions) << shape.name;
    EXPECT_EQ(a.areas.values, b.areas.values) << shape.name;
    EXPECT_EQ(a.uncertainty.total, b.uncertainty.total) << shape.name;
    EXPECT_EQ(a.projected.surface, b.projected.surface) << shape.name;
  }
}

/// Standard error of the undercut area from independent samples, with `more` of either kind counted on top.
double undercut_error(const PartModel& model, const Classification& result, double more) {
  const SurfaceSamples samples = sample_surface(model.part.mesh, model.geometry, model.frame,
                                                static_cast<std::uint64_t>(result.settings.samples));
  double variance = 0.0;
  for (std::size_t facet = 0; facet < model.geometry.areas.size(); ++facet) {
    const auto count = static_cast<double>(samples.first[facet + 1] - samples.first[facet]);
    const double hits = count * result.facet_fractions[facet][static_cast<std::size_t>(Region::undercut)];
    const double share = (hits + more) / (count + 2.0 * more);
    variance += std::pow(model.geometry.areas[facet], 2.0) * share * (1.0 - share) / (count + 2.0 * more);
  }
  return std::sqrt(variance);
}

TEST(ClassificationProperties, TheSamplingUncertaintyIsTwoStandardErrors) {
  const test::Shape shape = test::cup_with_side_hole({});
  const auto model = test::model_of(shape.mesh);
  Classifier classifier(test::shared_context(), model);
  MethodSettings settings = settings_for(shape);
  settings.direction = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));  // many a facet is partly an undercut
  const Classification result = classifier.classify(settings, Progress{});
  const double least = undercut_error(*model, result, 0.0), most = undercut_error(*model, result, 1.0);
  ASSERT_GT(least, 0.0);
  ASSERT_LT(most, 1.5 * least) << "else the bounds say little";
  EXPECT_GE(result.uncertainty.sampling, 1.99 * least);
  EXPECT_LE(result.uncertainty.sampling, 2.01 * most);
  EXPECT_DOUBLE_EQ(
      result.uncertainty.total,
      std::hypot(result.uncertainty.sampling, result.uncertainty.audit) + result.uncertainty.unsettled);
}

}  // namespace
}  // namespace moldlight
