#include "mesh/health.hpp"

#include <gtest/gtest.h>

#include "mesh/weld.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

HealthReport report_of(const TriangleMesh& mesh) { return health_report(mesh, facet_geometry(mesh)); }

TEST(Health, BoxIsHealthy) {
  const HealthReport report = report_of(test::box_mesh({100, 100, 100}, {101, 102, 103}));
  EXPECT_EQ(report.facets, 12u);
  EXPECT_EQ(report.vertices, 8u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.open_edges + report.nonmanifold_edges + report.inconsistent_edges, 0u);
  EXPECT_EQ(report.degenerate_facets + report.duplicate_facets, 0u);
  EXPECT_DOUBLE_EQ(report.area, 22.0);
  EXPECT_DOUBLE_EQ(report.volume, 6.0);
  EXPECT_EQ(report.bounds.min, glm::dvec3(100));
  EXPECT_EQ(report.bounds.max, glm::dvec3(101, 102, 103));
  EXPECT_TRUE(report.closed);
  EXPECT_TRUE(health_warnings(report).empty());
}

TEST(Health, BoxesThatShareAnEdgeAreClosed) {
  const HealthReport report = report_of(weld_vertices(
      test::joined(test::box_mesh({0, 0, 0}, {1, 1, 1}), test::box_mesh({1, 1, 0}, {2, 2, 1}))));
  EXPECT_EQ(report.nonmanifold_edges, 1u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(health_warnings(report).size(), 1u);
}

TEST(Health, OpenShellIsNotClosed) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.facets.resize(10);
  const HealthReport report = report_of(mesh);
  EXPECT_EQ(report.open_edges, 4u);
  EXPECT_EQ(report.vertices, 8u);
  EXPECT_FALSE(report.closed);
  EXPECT_EQ(health_warnings(report).size(), 1u);
}

TEST(Health, FlippedFacetIsInconsistent) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  test::reverse_facet(mesh, 3);
  const HealthReport report = report_of(mesh);
  EXPECT_EQ(report.inconsistent_edges, 3u);
  EXPECT_EQ(report.open_edges, 0u);
  EXPECT_FALSE(report.closed);
}

TEST(Health, DuplicatesCountInAnyCornerOrder) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  const auto original = mesh.facets[7];
  mesh.facets.push_back({original[1], original[2], original[0]});
  EXPECT_FALSE(report_of(mesh).closed);
  mesh.facets.push_back({original[1], original[0], original[2]});
  const HealthReport report = report_of(mesh);
  EXPECT_EQ(report.duplicate_facets, 2u);
  EXPECT_EQ(report.nonmanifold_edges, 3u);
  EXPECT_TRUE(report.closed) << "as many passes in each sense";
}

TEST(Health, FacetsWithoutAreaAreDegenerate) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.vertices.emplace_back(2, 2, 2);
  const auto last = static_cast<VertexIndex>(mesh.vertices.size() - 1);
  mesh.facets.push_back({0, 0, 1});
  mesh.facets.push_back({0, static_cast<VertexIndex>(last - 1), last});
  mesh.vertices[last] = mesh.vertices[0] + 2.0 * (mesh.vertices[last - 1] - mesh.vertices[0]);
  const HealthReport report = report_of(mesh);
  EXPECT_EQ(report.degenerate_facets, 2u);
  EXPECT_EQ(report.duplicate_facets, 0u);
}

TEST(Health, InsideOutPartHasNegativeVolume) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  for (FacetIndex facet = 0; facet < 12; ++facet) test::reverse_facet(mesh, facet);
  const HealthReport report = report_of(mesh);
  EXPECT_DOUBLE_EQ(report.volume, -1.0);
  EXPECT_TRUE(report.closed);
  EXPECT_EQ(health_warnings(report).size(), 1u);
}

TEST(Health, NothingIsNotClosed) {
  const HealthReport report = report_of(TriangleMesh{});
  EXPECT_FALSE(report.closed);
  EXPECT_EQ(report.area, 0.0);
  EXPECT_EQ(health_warnings(report).size(), 1u);
}

}  // namespace
}  // namespace moldlight
