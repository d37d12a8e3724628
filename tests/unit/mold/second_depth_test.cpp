// The scan converter by itself: what does not need another one to compare with.
#include "mold/second_depth.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "mesh/adjacency.hpp"
#include "support/boxes.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

/// A mesh with what scan conversion needs of it.
struct Prepared {
  explicit Prepared(TriangleMesh of_mesh)
      : mesh(std::move(of_mesh)),
        geometry(facet_geometry(mesh)),
        edges(bent_edges(mesh, geometry, build_adjacency(mesh))),
        positions(unit_positions(mesh, unit_frame(bounds(mesh)))) {}

  void draw(SecondDepthMaps& maps, const glm::dvec3& direction, double edge_thickness = 2.0) const {
    const MapFrame frame = map_frame(direction);
    std::vector<FacetClass> classes;
    for (const glm::dvec3& normal : geometry.normals) classes.push_back(facet_class(normal, frame.z, 1.0));
    maps.draw({mesh, positions, geometry.normals, edges.concave}, frame, classes, edge_thickness);
  }

  TriangleMesh mesh;
  FacetGeometry geometry;
  BentEdges edges;
  std::vector<glm::vec3> positions;
};

std::vector<glm::dvec3> directions() {
  return {{0, 0, 1}, {1, 0, 0}, {0.36, 0.48, 0.8}, {-0.7, 0.1, -0.2}, {0.001, 0.6, 0.0004}};
}

std::vector<std::uint32_t> entries(const SecondDepthMaps& maps) {
  std::vector<std::uint32_t> all = maps.facets(true);
  const std::vector<std::uint32_t> minus = maps.facets(false);
  all.insert(all.end(), minus.begin(), minus.end());
  return all;
}

TEST(SecondDepthAlone, AnyNumberOfThreadsGivesTheSameBitsWhateverWasDrawnBefore) {
  const Prepared prepared(test::subdivided(test::snap_hook({}).mesh, 30'000));
  SecondDepthMaps used(300);
  for (const glm::dvec3& direction : directions()) {
    SecondDepthMaps fresh(300);
    tbb::task_arena alone(1), many(7);
    alone.execute([&] { prepared.draw(fresh, direction); });
    many.execute([&] { prepared.draw(used, direction); });
    EXPECT_EQ(entries(fresh), entries(used));
    EXPECT_EQ(fresh.depths(true), used.depths(true));
    EXPECT_EQ(fresh.depths(false), used.depths(false));
  }
}

TEST(SecondDepthAlone, ConvexPartsCoverTheSameTexelsFromEitherSideAndLeaveNoGaps) {
  const Prepared box(test::subdivided(test::box_mesh({-3, -2, -1}, {3, 2, 1}), 20'000));
  for (const int resolution : {16, 100, 512, 1500}) {
    SecondDepthMaps maps(resolution);
    for (const glm::dvec3& direction : directions()) {
      box.draw(maps, direction, 0.0);
      double projected = 0.0;  // of a box of 6 x 4 x 2, whose diagonal is the root of 56
      for (std::size_t k = 0; k < box.mesh.facets.size(); ++k)
        projected += 0.5 * box.geometry.areas[k] / 56.0 *
                     std::abs(glm::dot(box.geometry.normals[k], glm::normalize(direction)));
      const std::vector<std::uint32_t> plus = maps.facets(true), minus = maps.facets(false);
      double covered = 0.0;
      for (std::size_t k = 0; k < plus.size(); ++k) {
        ASSERT_EQ(plus[k] == 0, minus[k] == 0) << k;
        covered += plus[k] != 0 ? 1.0 : 0.0;
      }
      EXPECT_NEAR(covered / resolution / resolution, projected, 0.8 / resolution);
    }
  }
}

TEST(SecondDepthAlone, DepthsAreThoseOfTheFacets) {
  const Prepared box(test::box_mesh({-3, -2, -1}, {3, 2, 1}));
  SecondDepthMaps maps(64);
  box.draw(maps, {0, 0, 1}, 0.0);
  const double half_height = 1.0 / std::sqrt(56.0);
  const std::vector<std::uint32_t> plus = maps.facets(true), minus = maps.facets(false);
  const std::vector<float> from_plus = maps.depths(true), from_minus = maps.depths(false);
  std::size_t covered = 0;
  for (std::size_t k = 0; k < plus.size(); ++k) {
    if (plus[k] == 0) {
      EXPECT_EQ(from_plus[k], 1.0F);
      continue;
    }
    ++covered;
    EXPECT_LT(box.geometry.normals[plus[k] - 1].z, 0.0) << "the +d light's second depth is the bottom";
    EXPECT_GT(box.geometry.normals[minus[k] - 1].z, 0.0);
    EXPECT_NEAR(from_plus[k], 0.5 + half_height, 1e-5);
    EXPECT_NEAR(from_minus[k], 0.5 + half_height, 1e-5);
  }
  EXPECT_GT(covered, 1000U);
}

TEST(SecondDepthAlone, DegenerateFacetsDoNoHarm) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {1, 1, 1});
  const Prepared whole(mesh);
  mesh.facets.push_back({0, 0, 1});
  mesh.facets.push_back({2, 2, 2});
  const Prepared poor(mesh);
  SecondDepthMaps a(64), b(64);
  whole.draw(a, {0.1, 0.2, 1});
  poor.draw(b, {0.1, 0.2, 1});
  EXPECT_EQ(entries(a), entries(b));
}

}  // namespace
}  // namespace moldlight
