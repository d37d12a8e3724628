// Shapes in which everything crosses everything: the work on them stays in proportion to their facets, and
// the areas are those of exact regions within what is said of their error.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/weld.hpp"
#include "mold/exact/projected_part.hpp"
#include "support/boxes.hpp"
#include "support/exact_model.hpp"
#include "support/process.hpp"
#include "support/random.hpp"

namespace moldlight {
namespace {

constexpr glm::dvec3 k_along{0.13, 0.55, 0.83};

/// Facets as large as the part, anywhere in it.
TriangleMesh loose_facets(std::size_t count) {
  test::Random random(7);
  std::vector<glm::dvec3> corners;
  for (std::size_t k = 0; k < 3 * count; ++k) corners.push_back(random.in_cube(1.0));
  return weld_corners(corners);
}

double worst_area(const ExactAreas& a, const ExactAreas& b) {
  return test::largest_difference(a.areas, b.areas);
}

/// Areas of a part whose exact regions may take `effort` times the usual work.
ExactAreas areas_with(const TriangleMesh& mesh, double effort) {
  const FacetGeometry geometry = facet_geometry(mesh);
  const UnitFrame frame = unit_frame(bounds(mesh));
  const ExactPart part(mesh, geometry, frame, Progress(), effort);
  return exact_areas(part, {.direction = glm::normalize(k_along), .lateral = 1.0 / 2048.0}, Progress());
}

TEST(WorkBudget, LooseFacetsAreSampledWithinTheirError) {
  const TriangleMesh mesh = loose_facets(150);
  const ExactAreas exact = areas_with(mesh, 1000.0), sampled = areas_with(mesh, 0.1);
  EXPECT_EQ(exact.sampled_facets, 0u);
  EXPECT_EQ(exact.sampling_error, 0.0);
  EXPECT_GT(sampled.sampled_facets, 0u);
  EXPECT_GT(sampled.sampling_error, 0.0);
  EXPECT_LT(sampled.sampling_error, 0.02 * facet_geometry(mesh).total_area);
  EXPECT_LE(worst_area(exact, sampled), 2.0 * sampled.sampling_error);
  EXPECT_NEAR(exact.areas.total(), sampled.areas.total(), 1e-9 * exact.areas.total());
}

TEST(WorkBudget, PiecesAreThoseOfTheAreas) {
  const TriangleMesh mesh = loose_facets(700);
  const test::ExactModel model(mesh);
  const ExactAreas areas = model.areas(glm::normalize(k_along), model.default_settings());
  ASSERT_GT(areas.sampled_facets, 0u);
  const ExactSplit split = model.split(glm::normalize(k_along), model.default_settings());
  EXPECT_EQ(split.areas.areas.values, areas.areas.values);
  EXPECT_EQ(split.areas.sampling_error, areas.sampling_error);
  const FacetGeometry pieces = facet_geometry(piece_mesh(split.mesh));
  EXPECT_NEAR(pieces.total_area, model.geometry().total_area, 1e-9 * pieces.total_area);
}

/// Flat spikes round an axis, whose foots are all over one another there.
TriangleMesh star_prism(VertexIndex corners) {
  TriangleMesh mesh;
  for (const double height : {0.0, 1.0}) {
    for (VertexIndex k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / corners, radius = k % 2 == 0 ? 0.001 : 1.0;
      mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  }
  mesh.vertices.insert(mesh.vertices.end(), {{0, 0, 0}, {0, 0, 1}});
  for (VertexIndex k = 0; k < corners; ++k) {
    const VertexIndex next = (k + 1) % corners, up = corners + k, next_up = corners + next;
    for (const auto& facet : {std::array{k, next, up}, std::array{next, next_up, up},
                              std::array{2 * corners, next, k}, std::array{2 * corners + 1, up, next_up}})
      mesh.facets.push_back(facet);
  }
  return mesh;
}

/// Where a point of each facet is as much as can be looked at, one stands for it, and the error says so.
TEST(WorkBudget, CrowdedFacetsGetOnePointEach) {
  const test::ExactModel model(star_prism(6000));
  const ProjectedPart projected(model.part(), glm::normalize(k_along), Progress());
  EXPECT_TRUE(projected.work_on(0).sampled);
  EXPECT_LT(projected.lattice_lines(), 3U);
  const ExactAreas areas = model.areas(glm::normalize(k_along), model.default_settings());
  EXPECT_EQ(areas.sampled_facets, model.mesh().facets.size());
  EXPECT_TRUE(areas.mostly_sampled());
  EXPECT_NEAR(areas.areas.total(), model.geometry().total_area, 1e-9 * areas.areas.total());
  EXPECT_GT(areas.sampling_error, 0.0);
}

/// Bodies that coincide are looked at once: pair by pair they would be past any budget.
TEST(WorkBudget, EqualFacetsAreLookedAtOnce) {
  constexpr std::size_t k_copies = 2000;
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {3, 2, 1});
  TriangleMesh mesh = box;
  for (std::size_t copy = 1; copy < k_copies; ++copy)
    mesh.facets.insert(mesh.facets.end(), box.facets.begin(), box.facets.end());
  const ExactAreas many = areas_with(mesh, 1.0), one = areas_with(box, 1.0);
  EXPECT_EQ(many.sampled_facets, 0u);
  for (const Region region : k_regions)
    EXPECT_NEAR(many.areas[region], k_copies * one.areas[region], 1e-9 * many.areas.total());
}

}  // namespace
}  // namespace moldlight
