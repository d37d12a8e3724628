// What pictures need of a part, made without GL.
#include "render/view_geometry.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "render/view_colours.hpp"
#include "render/view_geometry.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

TEST(Octahedral, KeepsDirectionsToAHundredthOfADegree) {
  for (int k = 0; k < 2000; ++k) {
    const float z = 1.0F - 2.0F * (static_cast<float>(k) + 0.5F) / 2000.0F;
    const float angle = 2.4F * static_cast<float>(k), radius = std::sqrt(1.0F - z * z);
    const glm::vec3 unit(radius * std::cos(angle), radius * std::sin(angle), z);
    EXPECT_LT(glm::distance(from_octahedral(octahedral(unit)), unit), 1.5e-4F);
  }
  for (const glm::vec3& axis : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0)}) {
    EXPECT_LT(glm::distance(from_octahedral(octahedral(axis)), axis), 1e-4F);
  }
}

struct Made {
  explicit Made(const TriangleMesh& mesh)
      : geometry(facet_geometry(mesh)),
        adjacency(build_adjacency(mesh)),
        frame(unit_frame(bounds(mesh))),
        edges(bent_edges(mesh, geometry, adjacency)),
        view(view_geometry(mesh, geometry, adjacency, frame)) {}
  FacetGeometry geometry;
  Adjacency adjacency;
  UnitFrame frame;
  BentEdges edges;
  ViewGeometry view;
};

TEST(ViewGeometry, BoxHasItsEdgesItsCornersAndIsClosed) {
  const test::Shape box = test::box_shape({});
  const Made made(box.mesh);
  EXPECT_TRUE(made.view.closed);
  EXPECT_EQ(made.view.feature_edges.size(), 12U);
  EXPECT_EQ(made.view.extremes.size(), 8U);
  EXPECT_EQ(made.view.facets.size(), box.mesh.facets.size());
  TriangleMesh open = box.mesh;
  open.facets.pop_back();
  EXPECT_FALSE(Made(open).view.closed);
}

TEST(ViewGeometry, ContourEdgesAreWhereUpMeetsDown) {
  const test::Shape box = test::box_shape({});
  const Made made(box.mesh);
  std::vector<FacetClass> classes;
  for (const glm::dvec3& normal : made.geometry.normals)
    classes.push_back(facet_class(normal, {0, 0, 1}, 1.0));
  EXPECT_EQ(contour_edges(box.mesh, made.edges.convex, classes, made.frame).size(), 8U);
  EXPECT_TRUE(contour_edges(box.mesh, made.edges.concave, classes, made.frame).empty());
}

TEST(ViewArrow, StandsClearOfThePart) {
  const Made made(test::cup({}).mesh);
  for (const glm::dvec3& toward : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(0.6, 0.0, 0.8)}) {
    const ViewArrow arrow = parting_arrow(made.view.extremes, toward, 0.0);
    double top = -1.0;
    for (const ViewVertex& vertex : made.view.vertices)
      top = std::max(top, glm::dot(glm::dvec3(vertex.position), toward));
    EXPECT_GT(glm::dot(arrow.tail, toward), top);
    EXPECT_LT(glm::dot(arrow.tail, toward), top + 0.1);
    EXPECT_NEAR(glm::distance(parting_arrow(made.view.extremes, toward, 0.6).tip, arrow.tip), 0.3, 1e-12);
  }
}

TEST(DraftScale, HasTheNearVerticalBandInTheMiddle) {
  for (const double tau : {0.0, 1.0, 8.0}) {
    const DraftScale scale = draft_scale(tau, Palette::paper);
    EXPECT_DOUBLE_EQ(scale.limits_deg[3], tau);
    for (std::size_t i = 1; i < scale.limits_deg.size(); ++i) {
      EXPECT_LE(scale.limits_deg[i - 1], scale.limits_deg[i]);
    }
  }
}

}  // namespace
}  // namespace moldlight
