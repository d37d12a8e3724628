// The random piles and what is said of their regions: two exact ways and samples have to agree.
#include "support/box_pile.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "support/brute_force.hpp"
#include "support/convex_shadows.hpp"
#include "support/mesh_edits.hpp"

namespace moldlight {
namespace {

double filled_volume(const test::BoxPile& pile) {
  double volume = 0.0;
  for (const test::ConvexBody& body : test::pile_bodies(pile)) {
    const glm::dvec3 size = body.back() - body.front();
    volume += size.x * size.y * size.z;
  }
  return volume;
}

double area_of(const std::vector<test::PlanarFace>& faces) {
  double area = 0.0;
  for (const test::PlanarFace& face : faces) {
    area += glm::distance(face.corners[0], face.corners[1]) * glm::distance(face.corners[1], face.corners[2]);
  }
  return area;
}

TEST(BoxPile, MeshIsTheClosedSurfaceOfTheFilledCells) {
  std::size_t most_removed = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const bool edges_touch = seed % 2 == 1;
    const test::BoxPile pile = test::random_pile(seed, edges_touch);
    const TriangleMesh mesh = test::pile_mesh(pile, seed);
    const auto faces = test::pile_faces(pile);
    const HealthReport report = health_report(mesh, facet_geometry(mesh));
    EXPECT_TRUE(report.closed);
    EXPECT_TRUE(edges_touch || report.nonmanifold_edges == 0);
    EXPECT_EQ(report.degenerate_facets, 0U);
    EXPECT_EQ(report.vertices, mesh.vertices.size());
    EXPECT_NEAR(report.area, area_of(faces), 1e-12 * report.area);
    EXPECT_NEAR(report.volume, filled_volume(pile), 1e-12 * report.volume);
    most_removed = std::max(most_removed, 2 * faces.size() - mesh.facets.size());
  }
  EXPECT_GE(most_removed, 100U);
}

TEST(BoxPile, ColumnsAndPolygonsSayTheSame) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const test::BoxPile pile = test::random_pile(seed, seed % 4 == 3);
    const double lateral = test::clear_lateral_tolerance(pile, seed);
    const auto faces = test::pile_faces(pile);
    const int axis = static_cast<int>(seed % 3);
    glm::dvec3 direction(0.0);
    direction[axis] = seed % 2 == 0 ? 1.0 : -1.0;
    const RegionValues columns = test::column_areas(pile, axis, seed % 2 == 0, lateral);
    const RegionValues polygons = test::face_areas(faces, test::pile_bodies(pile), direction,
                                                   {.tau_deg = 1.0, .lateral_tolerance = lateral});
    for (const Region region : k_regions) {
      EXPECT_NEAR(columns[region], polygons[region], 1e-12 * area_of(faces)) << seed;
    }
  }
}

TEST(BoxPile, PolygonsAgreeWithSamplesAlongAnyDirection) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const test::BoxPile pile = test::random_pile(seed);
    test::ShapeSettings settings{.tau_deg = seed % 3 == 0 ? 35.0 : 1.0,
                                 .lateral_tolerance = test::clear_lateral_tolerance(pile, seed)};
    const glm::dvec3 direction = seed % 3 == 1 ? glm::normalize(glm::dvec3(0.3, 0.0, 1.0))
                                               : test::random_rotation(seed) * glm::dvec3(0, 0, 1);
    const auto faces = test::pile_faces(pile);
    const RegionValues exact = test::face_areas(faces, test::pile_bodies(pile), direction, settings);
    EXPECT_NEAR(exact.total(), area_of(faces), 1e-12 * area_of(faces));
    const test::BruteForceAreas sampled =
        test::brute_force_areas(test::pile_mesh(pile, seed), direction, settings, 20'000, seed);
    for (const Region region : k_regions) {
      EXPECT_NEAR(exact[region], sampled.areas[region],
                  2.0 * sampled.two_errors[region] + 1e-4 * area_of(faces))
          << seed << ' ' << region_name(region);
    }
  }
}

TEST(ConvexShadows, UnionCountsWhatIsCoveredTwiceOnce) {
  const test::Loop2 square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, beside = {{1, 1}, {3, 1}, {3, 3}, {1, 3}},
                    diamond = {{2, -1}, {3, 0}, {2, 1}, {1, 0}};
  EXPECT_DOUBLE_EQ(test::union_area({square}), 4.0);
  EXPECT_DOUBLE_EQ(test::union_area({square, square}), 4.0);
  EXPECT_DOUBLE_EQ(test::union_area({square, beside}), 7.0);
  EXPECT_DOUBLE_EQ(test::union_area({square, diamond}), 5.5);  // a quarter of the diamond is in the square
  EXPECT_DOUBLE_EQ(test::union_area({}), 0.0);
}

TEST(ConvexShadows, ABoxCastsItsHexagon) {
  const std::vector<test::ConvexBody> box = {
      {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0}, {0, 0, 3}, {1, 0, 3}, {0, 2, 3}, {1, 2, 3}}};
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));
  // |n . d| A over three of its faces.
  EXPECT_NEAR(test::shadow_area(box, direction), 6.0 * direction.x - 3.0 * direction.y + 2.0 * direction.z,
              1e-12);
}

}  // namespace
}  // namespace moldlight
