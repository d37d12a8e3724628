// Creases split vertices; below them the surface is smooth.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/adjacency.hpp"
#include "support/boxes.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

struct Creased {
  explicit Creased(TriangleMesh from, double crease_deg = k_crease_deg)
      : mesh(std::move(from)),
        geometry(facet_geometry(mesh)),
        adjacency(build_adjacency(mesh)),
        smooth(smooth_corners(mesh, geometry, adjacency, crease_deg)),
        edges(crease_edges(mesh, geometry, adjacency, crease_deg)) {}
  TriangleMesh mesh;
  FacetGeometry geometry;
  Adjacency adjacency;
  SmoothCorners smooth;
  std::vector<EdgeEnds> edges;
};

TEST(Creases, BoxHasTwelveAndSplitsEachCornerInThree) {
  const Creased box(test::box_mesh({0, 0, 0}, {1, 2, 3}));
  EXPECT_EQ(box.edges.size(), 12U);
  EXPECT_EQ(box.smooth.source.size(), 24U);
  for (FacetIndex facet = 0; facet < box.mesh.facets.size(); ++facet) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const VertexIndex split = box.smooth.of_facet[facet][corner];
      EXPECT_EQ(box.smooth.source[split], box.mesh.facets[facet][corner]);
      EXPECT_NEAR(glm::distance(glm::dvec3(box.smooth.normals[split]), box.geometry.normals[facet]), 0.0,
                  1e-6);
    }
  }
}

TEST(Creases, NothingIsCreasedBelowTheAngle) {
  const Creased box(test::box_mesh({0, 0, 0}, {1, 1, 1}), 91.0);
  EXPECT_TRUE(box.edges.empty());
  EXPECT_EQ(box.smooth.source.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 out = glm::normalize(box.mesh.vertices[box.smooth.source[i]] - glm::dvec3(0.5));
    EXPECT_GT(glm::dot(out, glm::dvec3(box.smooth.normals[i])), 0.9);
  }
}

TEST(Creases, OpenEdgesAreCreasesAndDegenerateFacetsAreNone) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.facets.pop_back();
  EXPECT_EQ(Creased(mesh).edges.size(), 13U + 0U) << "twelve, and the diagonal of the facet that is missing";
  mesh.facets.push_back({0, 0, 1});
  const Creased degenerate(mesh);
  EXPECT_EQ(degenerate.edges.size(), 13U);
  for (const glm::vec3& normal : degenerate.smooth.normals) EXPECT_NEAR(glm::length(normal), 1.0F, 1e-5F);
}

}  // namespace
}  // namespace moldlight
