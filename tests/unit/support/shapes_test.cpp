#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "support/brute_force.hpp"
#include "support/mesh_edits.hpp"

namespace moldlight::test {
namespace {

/// The formula of each shape against rays; most facets lie in one region, so the samples' errors are small.
void expect_rays_agree(const ShapeSettings& settings) {
  for (const Shape& shape : all_shapes(settings)) {
    const double total = facet_geometry(shape.mesh).total_area;
    EXPECT_NEAR(shape.expected.total(), total, 1e-9 * total) << shape.name;
    const BruteForceAreas found = brute_force_areas(shape.mesh, shape.direction, settings, 6000, 1);
    for (const Region region : k_regions) {
      EXPECT_NEAR(found.areas[region], shape.expected[region], 2.5 * found.two_errors[region] + 1e-7 * total)
          << shape.name << ' ' << region_name(region) << " tau " << settings.tau_deg << " delta "
          << settings.lateral_tolerance;
    }
  }
}

TEST(Shapes, FormulasAgreeWithRays) { expect_rays_agree({}); }

TEST(Shapes, FormulasAgreeWithRaysAtOtherSettings) {
  expect_rays_agree({.tau_deg = 2.3, .lateral_tolerance = 0.37});
}

TEST(Shapes, AreClosedManifoldsWithVolume) {
  for (const Shape& shape : all_shapes({})) {
    const HealthReport report = health_report(shape.mesh, facet_geometry(shape.mesh));
    EXPECT_TRUE(report.closed) << shape.name;
    EXPECT_TRUE(health_warnings(report).empty()) << shape.name << ": " << health_warnings(report).front();
    EXPECT_GT(report.volume, 0.0) << shape.name;
    EXPECT_GT(report.facets, 200u) << shape.name;
    EXPECT_NEAR(glm::length(shape.direction), 1.0, 1e-12) << shape.name;
  }
}

TEST(Shapes, SettingsMatter) {
  const Shape usual = frustum_under_tau({}), coarse = frustum_under_tau({.lateral_tolerance = 0.3});
  EXPECT_GT(coarse.expected[Region::both], 2.0 * usual.expected[Region::both]);
}

TEST(MeshEdits, SubdividedMeshHasTheWantedFacetsAndTheSameSurface) {
  const Shape shape = spool({});
  for (const std::size_t target : {1000u, 1001u, 30'000u}) {
    const TriangleMesh mesh = subdivided(shape.mesh, target);
    EXPECT_EQ(mesh.facets.size(), target / 2 * 2);
    const HealthReport report = health_report(mesh, facet_geometry(mesh));
    EXPECT_TRUE(report.closed);
    EXPECT_EQ(report.nonmanifold_edges, 0u);
    EXPECT_EQ(report.degenerate_facets, 0u);
    EXPECT_NEAR(report.volume, signed_volume(shape.mesh), 1e-9 * report.volume);
    EXPECT_NEAR(report.area, shape.expected.total(), 1e-9 * report.area);
  }
}

TEST(MeshEdits, PermutedMeshIsTheSameSurfaceInAnotherOrder) {
  const TriangleMesh mesh = cup_with_side_hole({}).mesh, other = permuted(mesh, 3);
  EXPECT_NE(mesh.facets, other.facets);
  const HealthReport a = health_report(mesh, facet_geometry(mesh)),
                     b = health_report(other, facet_geometry(other));
  EXPECT_TRUE(b.closed);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_NEAR(a.volume, b.volume, 1e-9 * a.volume);
}

TEST(MeshEdits, RotationsKeepLengthAndDiffer) {
  const TriangleMesh mesh = box_shape({}).mesh;
  const TriangleMesh once = rotated(mesh, random_rotation(1)), twice = rotated(mesh, random_rotation(2));
  EXPECT_NEAR(glm::length(once.vertices[1] - once.vertices[0]),
              glm::length(mesh.vertices[1] - mesh.vertices[0]), 1e-12);
  EXPECT_GT(glm::length(once.vertices[5] - twice.vertices[5]), 1.0);
  EXPECT_EQ(bounds(translated(scaled(mesh, 2.0), {1, 2, 3})).min, glm::dvec3(1, 2, 3));
}

}  // namespace
}  // namespace moldlight::test
