// Properties of the classification, on generated cases: shapes of ours, turned, scaled, moved and reordered.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "classify/classifier.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

constexpr int k_cases = 6;
// Turning, scaling and moving round the coordinates anew, in double: far from the origin a coordinate has
// ten digits after the part's size.
constexpr double k_area_rounding = 1e-9;  // of the part's area

Query query_for(const test::Shape& shape) {
  Query query;
  query.direction = shape.direction;
  query.method.tau_deg = shape.settings.tau_deg;
  query.method.tolerance = shape.settings.lateral_tolerance;
  return query;
}

void expect_same_areas(const Classification& a, const Classification& b, const std::string& name) {
  for (const Region region : k_regions) {
    EXPECT_NEAR(a.areas[region], b.areas[region], k_area_rounding * a.total_area)
        << name << ", " << region_name(region);
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
    expect_same_areas(test::classify_mesh(shape.mesh, query_for(shape)),
                      test::classify_mesh(turned.mesh, query_for(turned)), shape.name);
  }
}

TEST(ClassificationProperties, ReversedDirectionSwapsCoreAndCavity) {
  for (const test::Shape& shape : cases(2)) {
    Query query = query_for(shape);
    const Classification forward = test::classify_mesh(shape.mesh, query);
    query.direction = -query.direction.unit();
    Classification reversed = test::classify_mesh(shape.mesh, query);
    std::swap(reversed.areas[Region::core], reversed.areas[Region::cavity]);
    expect_same_areas(forward, reversed, shape.name);
  }
}

TEST(ClassificationProperties, ScalingByAFactorScalesAreasByItsSquare) {
  for (const test::Shape& shape : cases(3)) {
    for (const double factor : {1e-3, 25.4, 1e4}) {
      Query query = query_for(shape);
      const Classification before = test::classify_mesh(shape.mesh, query);
      query.method.tolerance = query.method.tolerance * factor;
      Classification after = test::classify_mesh(test::scaled(shape.mesh, factor), query);
      for (double& area : after.areas.values) area /= factor * factor;
      expect_same_areas(before, after, shape.name);
    }
  }
}

TEST(ClassificationProperties, FarFromTheOriginNothingChanges) {
  for (const test::Shape& shape : cases(4)) {
    const Query query = query_for(shape);
    expect_same_areas(test::classify_mesh(shape.mesh, query),
                      test::classify_mesh(test::translated(shape.mesh, {1e6, -2e6, 5e5}), query), shape.name);
  }
}

TEST(ClassificationProperties, OrderOfFacetsAndVerticesDoesNotMatter) {
  for (const test::Shape& shape : cases(5)) {
    const Query query = query_for(shape);
    expect_same_areas(test::classify_mesh(shape.mesh, query),
                      test::classify_mesh(test::permuted(shape.mesh, 99), query), shape.name);
  }
}

TEST(ClassificationProperties, AreasAddUpAndFractionsAreShares) {
  for (const test::Shape& shape : cases(6)) {
    const auto model = test::model_of(shape.mesh);
    const Classification result = classify_exact(*model, query_for(shape), Progress{});
    EXPECT_NEAR(result.areas.total(), result.total_area, 1e-9 * result.total_area);
    RegionValues summed;
    for (std::size_t facet = 0; facet < result.facet_fractions.size(); ++facet) {
      double sum = 0.0;
      for (const Region region : k_regions) {
        const double share = result.facet_fractions[facet][static_cast<std::size_t>(region)];
        EXPECT_GE(share, 0.0);
        sum += share;
        summed[region] += model->geometry.areas[facet] * share;
      }
      EXPECT_NEAR(sum, 1.0, 1e-12);
    }
    for (const Region region : k_regions) {
      EXPECT_NEAR(summed[region], result.areas[region], 1e-12 * result.total_area);
    }
  }
}

TEST(ClassificationProperties, TheShadowIsTheSameFromBothSidesOfAClosedPart) {
  std::uint32_t seed = 0;
  for (const test::Shape& shape : cases(7)) {
    Query query = query_for(shape);
    query.direction = test::random_rotation(500 + seed++) * glm::dvec3(0, 0, 1);
    const Classification result = test::classify_mesh(shape.mesh, query);
    EXPECT_TRUE(result.identity.agrees())
        << shape.name << ": gap " << result.identity.gap << ", limit " << result.identity.gap_limit;
    EXPECT_GT(result.identity.core, 0.01 * result.total_area);
    EXPECT_LE(result.identity.gap_limit, 1e-8 * result.total_area);
    EXPECT_EQ(result.uncertainty.mesh, 0.0);
  }
}

TEST(ClassificationProperties, TheShadowExposesAnOpenPart) {
  TriangleMesh open = test::box_mesh({0, 0, 0}, {20, 20, 10});
  Query query;
  query.direction = glm::dvec3(0.1, 0.2, 1.0);
  EXPECT_TRUE(test::classify_mesh(open, query).identity.agrees());
  open.facets.pop_back();
  const Classification result = test::classify_mesh(open, query);
  EXPECT_FALSE(result.identity.agrees());
  EXPECT_FALSE(result.warnings.empty());
  // Half of a side is missing; all that it could hide is in doubt.
  EXPECT_GE(result.uncertainty.mesh, 0.5 * 20 * 10);
  EXPECT_LE(result.uncertainty.mesh, result.total_area);
}

// The boss of 4 x 4 is sunk into the block by 1: its bottom and a strip of its sides lie in the material.
TEST(ClassificationProperties, WhatOverlapsIsInDoubt) {
  const TriangleMesh block = test::box_mesh({0, 0, 0}, {20, 20, 10}),
                     boss = test::box_mesh({8, 8, 9}, {12, 12, 15});
  Query query;
  const Classification result = test::classify_mesh(test::joined(block, boss), query);
  EXPECT_TRUE(result.identity.agrees());
  EXPECT_NEAR(result.areas[Region::undercut], 4 * 4 + 4 * 4 * 1 + 4 * 4, 1e-9 * result.total_area);
  EXPECT_NEAR(result.uncertainty.mesh, result.areas[Region::undercut], 1e-9 * result.total_area);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_NE(result.warnings.front().find("overlap"), std::string::npos);
}

TEST(ClassificationProperties, TheShadowOfAThinBoxIsExact) {
  for (const glm::dvec3& direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1)}) {
    Query query;
    query.direction = direction;
    const Classification result = test::classify_mesh(test::box_mesh({0, 0, 0}, {1, 1000, 1}), query);
    EXPECT_DOUBLE_EQ(result.shadow_area, 1000.0);
    EXPECT_TRUE(result.identity.agrees());
    EXPECT_EQ(result.areas[Region::undercut], 0.0);
    EXPECT_NEAR(result.projected_undercut, 0.0, result.identity.gap_limit);
  }
}

TEST(ClassificationProperties, TheToleranceIsALengthWhateverTheMaps) {
  Query query;
  for (const int resolution : {64, 512, 2048, 8192}) {
    query.method.resolution = resolution;
    EXPECT_DOUBLE_EQ(lateral_tolerance(query.method, 100.0), 100.0 / 2048.0) << resolution;
  }
  query.method.resolution = 512;
  query.method.kernel = 5;
  EXPECT_DOUBLE_EQ(lateral_tolerance(query.method, 100.0), 100.0 / 2048.0) << "the kernel is the maps' own";
  EXPECT_DOUBLE_EQ(map_settings(query.method, 100.0).lateral, 2.0 / 512.0);
  query.method.tolerance = 0.25;
  EXPECT_EQ(lateral_tolerance(query.method, 100.0), 0.25);
  EXPECT_DOUBLE_EQ(map_settings(query.method, 100.0).lateral, 2.0 / 512.0);
  query.method.couple_kernel = true;
  EXPECT_DOUBLE_EQ(lateral_tolerance(query.method, 100.0), 2.0 * 100.0 / 512.0) << "unless it is coupled";
  query.method.kernel = 1;
  EXPECT_EQ(lateral_tolerance(query.method, 100.0), 0.0);
  query.method.couple_kernel = false;
  query.method.readout = Readout::samples;
  EXPECT_EQ(lateral_tolerance(query.method, 100.0), 0.0) << "where the maps are the answer, it is theirs";
}

TEST(ClassificationProperties, TheSameInputGivesTheSameBits) {
  for (const test::Shape& shape : cases(8)) {
    const Classification a = test::classify_mesh(shape.mesh, query_for(shape));
    const Classification b = test::classify_mesh(shape.mesh, query_for(shape));
    EXPECT_EQ(a.facet_fractions, b.facet_fractions) << shape.name;
    EXPECT_EQ(a.areas.values, b.areas.values) << shape.name;
    EXPECT_EQ(a.uncertainty.total(), b.uncertainty.total()) << shape.name;
    EXPECT_EQ(a.identity.core, b.identity.core) << shape.name;
  }
}

TEST(ClassificationProperties, OtherReadoutsSayHowFarTheyAreOffExactRegions) {
  const test::Shape shape = test::cup_with_side_hole({});
  Query query = query_for(shape);
  query.direction = glm::dvec3(0.3, 0.2, 1.0);  // many a facet is partly an undercut
  query.method.resolution = 256;
  query.method.samples = 20'000;
  const Classification exact = test::classify_mesh(shape.mesh, query);
  for (const Readout readout : {Readout::samples, Readout::facet_id}) {
    query.method.readout = readout;
    const Classification other = test::classify_mesh(shape.mesh, query);
    const double off = std::abs(other.areas[Region::undercut] - exact.areas[Region::undercut]);
    EXPECT_EQ(other.uncertainty.readout, off);
    EXPECT_GT(off, 0.0);
    EXPECT_LT(off, 0.2 * exact.total_area);
    EXPECT_EQ(other.identity.core, exact.identity.core);
    EXPECT_NEAR(other.areas.total(), other.total_area, 1e-9 * other.total_area);
  }
}

}  // namespace
}  // namespace moldlight
