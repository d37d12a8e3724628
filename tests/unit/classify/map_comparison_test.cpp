#include "classify/map_comparison.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "mold/measure.hpp"

namespace moldlight {
namespace {

/// Two pieces of facet 7 with areas 3 and 1: core and undercut.
SplitMesh sample_split() {
  SplitMesh mesh;
  mesh.vertices = {{0, 0, 0}, {6, 0, 0}, {0, 1, 0}, {-2, 0, 0}};
  mesh.pieces = {{{0, 1, 2}, 7, Region::core}, {{0, 2, 3}, 7, Region::undercut}};
  return mesh;
}

constexpr std::uint8_t k_core = verdict::k_accessible_plus, k_cavity = verdict::k_accessible_minus;

PieceSamples sample_set() {
  return sample_pieces(sample_split(), {.center = {0, 0, 0}, .diagonal = 8.0}, 40);
}

TEST(MapComparison, SamplesPiecesOnTheirFacets) {
  const PieceSamples samples = sample_set();
  ASSERT_EQ(samples.samples.size(), 40U);
  EXPECT_EQ(samples.first, (std::array<std::size_t, 5>{0, 30, 30, 30, 40}));
  EXPECT_DOUBLE_EQ(samples.areas[Region::core], 3.0);
  EXPECT_DOUBLE_EQ(samples.areas[Region::undercut], 1.0);
  for (std::size_t i = 0; i < 40; ++i) {
    const SurfaceSample& sample = samples.samples[i];
    EXPECT_EQ(sample.facet, 7U);
    EXPECT_EQ(sample.position.x >= 0.0F, i < 30) << i;
    EXPECT_GE(sample.position.y, 0.0F) << i;
    // Inside its piece, in the unit frame: x / 6 + y = 1 / 8 and x / -2 + y = 1 / 8 are the slanting sides.
    const float slope = i < 30 ? 1.0F / 6.0F : -0.5F;
    EXPECT_LE(slope * sample.position.x + sample.position.y, 0.125F + 1e-6F) << i;
  }
}

/// A strip of `count` pieces that grow in size, every fifth one an undercut, and one piece of cavity without
/// area.
SplitMesh strip(int count) {
  SplitMesh mesh;
  for (int k = 0; k <= count; ++k) {
    mesh.vertices.emplace_back(0.01 * k * k, 0.0, 0.0);
    mesh.vertices.emplace_back(0.01 * k * k, 1.0, 0.0);
  }
  for (int k = 0; k < count; ++k) {
    const auto at = static_cast<VertexIndex>(2 * k);
    mesh.pieces.push_back(
        {{at, at + 2, at + 1}, static_cast<FacetIndex>(k), k % 5 == 0 ? Region::undercut : Region::both});
  }
  mesh.pieces.push_back({{0, 0, 1}, 0, Region::cavity});
  return mesh;
}

TEST(MapComparison, FewSamplesCoverManyPiecesInEqualStepsOfArea) {
  const SplitMesh mesh = strip(2000);
  const PieceSamples samples = sample_pieces(mesh, {.center = {0, 0, 0}, .diagonal = 1.0}, 100);
  const double total = samples.areas.total();
  EXPECT_NEAR(total, 0.5 * 0.01 * 2000.0 * 2000.0, 1e-6 * total);
  EXPECT_EQ(samples.areas[Region::cavity], 0.0);
  EXPECT_EQ(samples.first[1], 0U) << "nothing of the core";
  EXPECT_EQ(samples.first[2], 0U) << "no area of the cavity";
  EXPECT_EQ(samples.samples.size(), 101U);
  const std::size_t both = samples.first[3] - samples.first[2];
  EXPECT_EQ(both, static_cast<std::size_t>(std::ceil(100.0 * samples.areas[Region::both] / total)));
  // Half of each region's samples lie on the half of its area.
  const auto middle = [](const SurfaceSample& sample) {
    return sample.position.x < 0.01F * 1414.2F * 1414.2F;
  };
  const auto begin = samples.samples.begin();
  const auto at = [&](std::size_t k) { return begin + static_cast<std::ptrdiff_t>(samples.first[k]); };
  EXPECT_NEAR(static_cast<double>(std::count_if(at(2), at(3), middle)), 0.5 * static_cast<double>(both), 1.0);
  for (const SurfaceSample& sample : samples.samples) {
    const SplitPiece& piece = mesh.pieces[sample.facet];
    EXPECT_GE(sample.position.x, mesh.vertices[piece.corners[0]].x - 1e-2);
    EXPECT_LE(sample.position.x, mesh.vertices[piece.corners[1]].x + 1e-2);
  }
}

TEST(MapComparison, ARegionHoweverSmallHasSamples) {
  SplitMesh mesh = sample_split();
  mesh.vertices[3] = {-1e-6, 0, 0};
  const PieceSamples samples = sample_pieces(mesh, {.center = {0, 0, 0}, .diagonal = 8.0}, 40);
  EXPECT_EQ(samples.first, (std::array<std::size_t, 5>{0, 40, 40, 40, 44}));
}

TEST(MapComparison, AddsUpByExactRegionAndThatOfTheMaps) {
  std::vector<std::uint8_t> verdicts(40, k_core);
  for (std::size_t i = 24; i < 30; ++i) verdicts[i] = k_cavity;  // a fifth of the core
  for (std::size_t i = 35; i < 40; ++i) verdicts[i] = 0;         // half of the undercut is seen as such
  const MapComparison found = compare_maps(sample_set(), verdicts);
  EXPECT_DOUBLE_EQ(found.areas[0][Region::core], 2.4);
  EXPECT_DOUBLE_EQ(found.areas[0][Region::cavity], 0.6);
  EXPECT_DOUBLE_EQ(found.areas[3][Region::core], 0.5);
  EXPECT_DOUBLE_EQ(found.areas[3][Region::undercut], 0.5);
  EXPECT_DOUBLE_EQ(found.total(), 4.0);
  EXPECT_DOUBLE_EQ(found.differing(), 1.1);
  EXPECT_DOUBLE_EQ(found.excess(Region::undercut), -0.5);
  EXPECT_NEAR(found.excess(Region::core), -0.1, 1e-15);
  EXPECT_DOUBLE_EQ(found.excess(Region::cavity), 0.6);
  EXPECT_EQ(found.samples, 40U);
  EXPECT_DOUBLE_EQ(found.error, 2.0 * std::sqrt(9.0 * 0.2 * 0.8 / 29.0 + 1.0 * 0.5 * 0.5 / 9.0));
  EXPECT_EQ(comparison_text(found), "shadow maps: 27.50 % of the area differs, undercut 12.50 % too small");
}

TEST(MapComparison, SaysWhereNothingDiffers) {
  std::vector<std::uint8_t> verdicts(40, k_core);
  std::fill(verdicts.begin() + 30, verdicts.end(), std::uint8_t{0});
  const MapComparison same = compare_maps(sample_set(), verdicts);
  EXPECT_EQ(same.differing(), 0.0);
  EXPECT_EQ(same.error, 0.0);
  EXPECT_EQ(comparison_text(same), "shadow maps: 0.00 % of the area differs, undercut as large");
  verdicts[0] = 0;
  EXPECT_EQ(comparison_text(compare_maps(sample_set(), verdicts)),
            "shadow maps: 2.50 % of the area differs, undercut 2.50 % too large");
  EXPECT_EQ(comparison_text(compare_maps(sample_pieces(SplitMesh{}, {}, 40), {})),
            "shadow maps: 0.00 % of the area differs, undercut as large");
}

}  // namespace
}  // namespace moldlight
