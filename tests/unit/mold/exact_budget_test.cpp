// Shapes in which everything crosses everything: the work on them stays in proportion to their facets, and
// the areas are those of exact regions within what is said of their error.
#include <gtest/gtest.h>

#include "mesh/weld.hpp"
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
