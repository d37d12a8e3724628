// Exact regions of bodies that touch, overlap and cross each other.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/box_pile.hpp"
#include "support/boxes.hpp"
#include "support/convex_shadows.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "unit/mold/sane_regions.hpp"

namespace moldlight {
namespace {

test::ConvexBody box_body(const glm::dvec3& low, const glm::dvec3& high) {
  return test::box_mesh(low, high).vertices;
}

std::vector<test::PlanarFace> box_faces(const glm::dvec3& low, const glm::dvec3& high) {
  std::vector<test::PlanarFace> faces;
  for (int face = 0; face < 6; ++face) {
    glm::dvec3 normal(0.0);
    normal[face / 2] = face % 2 == 0 ? -1.0 : 1.0;
    faces.push_back({test::box_face(low, high, face), normal});
  }
  return faces;
}

struct TwoBoxes {
  const char* name;
  glm::dvec3 low_a, high_a, low_b, high_b;
};

/// Boxes that touch, overlap, lie in each other and share planes.
const TwoBoxes k_pairs[] = {
    {"apart", {0, 0, 0}, {2, 2, 1}, {0.5, 0.5, 2}, {1.5, 1.2, 3}},
    {"on each other", {0, 0, 0}, {3, 3, 1}, {1, 1, 1}, {2, 2.5, 2}},
    {"on each other, in line on one side", {0, 0, 0}, {3, 3, 1}, {1, 1, 1}, {3, 2, 2}},
    {"alike on each other", {0, 0, 0}, {3, 3, 1}, {0, 0, 1}, {3, 3, 2}},
    {"side by side", {0, 0, 0}, {2, 2, 2}, {2, 0, 0}, {4, 2, 2}},
    {"side by side, one higher", {0, 0, 0}, {2, 2, 2}, {2, 0.5, -1}, {4, 1.5, 3}},
    {"touching along an edge", {0, 0, 0}, {2, 2, 2}, {2, 0, 2}, {4, 2, 4}},
    {"touching in a corner", {0, 0, 0}, {2, 2, 2}, {2, 2, 2}, {3, 3, 3}},
    {"overlapping", {0, 0, 0}, {3, 3, 3}, {1.3, 1.1, 1.7}, {4.2, 2.3, 4.4}},
    {"overlapping, tops in one plane", {0, 0, 0}, {3, 3, 3}, {1, 1, 1}, {4, 2, 3}},
    {"overlapping, sides in one plane", {0, 0, 0}, {3, 3, 3}, {1, 0, 2}, {2, 2, 4}},
    {"overlapping, three planes in common", {0, 0, 0}, {3, 3, 3}, {0, 0, 0}, {2, 1, 4}},
    {"alike in one place", {0, 0, 0}, {3, 2, 1}, {0, 0, 0}, {3, 2, 1}},
    {"crossing", {0, 0, 0}, {5, 1, 1}, {1.7, -2, -0.5}, {2.9, 3, 0.6}},
    {"one in the other", {0, 0, 0}, {5, 5, 5}, {1, 2, 1}, {2, 3, 4}},
};

TEST(ExactCrossingBodies, BoxesThatTouchOrOverlapHideEachOther) {
  for (const TwoBoxes& pair : k_pairs) {
    const TriangleMesh mesh =
        test::joined(test::box_mesh(pair.low_a, pair.high_a), test::box_mesh(pair.low_b, pair.high_b));
    std::vector<test::PlanarFace> faces = box_faces(pair.low_a, pair.high_a);
    for (const test::PlanarFace& face : box_faces(pair.low_b, pair.high_b)) faces.push_back(face);
    const std::vector<test::ConvexBody> bodies = {box_body(pair.low_a, pair.high_a),
                                                  box_body(pair.low_b, pair.high_b)};
    const test::ExactModel model(mesh);
    for (const glm::dvec3& direction : test::five_directions()) {
      const RegionValues expected = test::face_areas(faces, bodies, direction, k_settings);
      const ExactAreas found = model.areas(direction, k_settings);
      EXPECT_LE(test::largest_difference(found.areas, expected), 1e-9 * expected.total())
          << pair.name << " along " << direction.x << ' ' << direction.y << ' ' << direction.z << ": core "
          << found.areas[Region::core] << " for " << expected[Region::core] << ", cavity "
          << found.areas[Region::cavity] << " for " << expected[Region::cavity] << ", both "
          << found.areas[Region::both] << " for " << expected[Region::both];
    }
    expect_sane(mesh, k_settings, pair.name);
  }
}

TEST(ExactCrossingBodies, ManyBoxesThatCrossHaveTheAreasOfTheirShadows) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    TriangleMesh mesh;
    std::vector<test::PlanarFace> faces;
    std::vector<test::ConvexBody> bodies;
    for (std::size_t i = 0; i < 2 + seed % 5; ++i) {
      const glm::dvec3 a = random.in_cube(2.0), b = a + glm::dvec3(0.3) + glm::abs(random.in_cube(3.0));
      mesh = test::joined(mesh, test::box_mesh(a, b));
      bodies.push_back(box_body(a, b));
      for (const test::PlanarFace& face : box_faces(a, b)) faces.push_back(face);
    }
    const glm::dquat rotation = test::random_rotation(seed);
    const glm::dvec3 direction =
        seed % 2 == 0 ? test::five_directions()[seed % 3] : glm::normalize(random.in_cube(1.0));
    const RegionValues expected = test::face_areas(faces, bodies, direction, k_settings);
    const test::ExactModel model(test::rotated(mesh, rotation));
    const ExactAreas found = model.areas(rotation * direction, k_settings);
    EXPECT_LE(test::largest_difference(found.areas, expected), 1e-9 * expected.total()) << seed;
    const double shadow = test::shadow_area(bodies, direction);
    EXPECT_NEAR(found.projected_core, shadow, 1e-9 * expected.total()) << seed;
    EXPECT_NEAR(found.projected_cavity, shadow, 1e-9 * expected.total()) << seed;
    test::expect_sound_split(model, model.split(rotation * direction, k_settings), "crossing boxes");
  }
}

TEST(ExactCrossingBodies, PilesThatCrossHaveTheAreasOfTheirShadows) {
  // With concave edges, which matter where surfaces cross.
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    test::Random random(seed);
    TriangleMesh mesh;
    std::vector<test::PlanarFace> faces;
    std::vector<test::ConvexBody> bodies;
    for (const std::uint32_t of : {seed, seed + 500}) {
      const test::BoxPile pile = test::random_pile(of);
      const glm::dvec3 offset = random.in_cube(2.0);
      mesh = test::joined(mesh, test::translated(test::pile_mesh(pile, of), offset));
      for (test::PlanarFace face : test::pile_faces(pile)) {
        for (glm::dvec3& corner : face.corners) corner += offset;
        faces.push_back(face);
      }
      for (test::ConvexBody body : test::pile_bodies(pile)) {
        for (glm::dvec3& corner : body) corner += offset;
        bodies.push_back(body);
      }
    }
    const glm::dvec3 direction =
        seed % 2 == 0 ? test::five_directions()[seed % 3] : glm::normalize(random.in_cube(1.0));
    const RegionValues expected = test::face_areas(faces, bodies, direction, k_settings);
    const test::ExactModel model(mesh);
    const ExactAreas found = model.areas(direction, k_settings);
    EXPECT_LE(test::largest_difference(found.areas, expected), 1e-9 * expected.total()) << seed;
    EXPECT_NEAR(found.projected_core, test::shadow_area(bodies, direction), 1e-9 * expected.total()) << seed;
  }
}

TEST(ExactCrossingBodies, BodiesThatCrossAlongAnEdgeHideEachOther) {
  // Prisms sunk in a block up to their widest edges, which lie in its top: facets above and below cross it
  // there.
  for (const int sides : {4, 6, 8}) {
    const test::Loop2 section = test::regular_polygon(sides, 1.0);
    test::SolidBuilder builder;
    test::Loop2 profile;
    for (const glm::dvec2& point : section) profile.emplace_back(point.x + 3.0, point.y + 2.0);
    for (glm::dvec2& point : profile) {
      if (std::abs(point.y - 2.0) < 1e-9) point.y = 2.0;
    }
    builder.extrude(profile, {}, 4.0);
    const TriangleMesh prism = builder.mesh();
    const glm::dvec3 low(0, 1, 0), high(6, 3, 2);
    std::vector<test::PlanarFace> faces = box_faces(low, high);
    const FacetGeometry geometry = facet_geometry(prism);
    for (FacetIndex facet = 0; facet < prism.facets.size(); ++facet) {
      faces.push_back({{prism.corner(facet, 0), prism.corner(facet, 1), prism.corner(facet, 2)},
                       geometry.normals[facet]});
    }
    const std::vector<test::ConvexBody> bodies = {box_body(low, high), prism.vertices};
    const test::ExactModel model(test::joined(test::box_mesh(low, high), prism));
    for (const glm::dvec3& direction : directions()) {
      const RegionValues expected = test::face_areas(faces, bodies, direction, k_settings);
      const ExactAreas found = model.areas(direction, k_settings);
      EXPECT_LE(test::largest_difference(found.areas, expected), 1e-7 * expected.total())
          << sides << " sides along " << direction.x << ' ' << direction.y << ' ' << direction.z << ": core "
          << found.areas[Region::core] << " for " << expected[Region::core] << ", cavity "
          << found.areas[Region::cavity] << " for " << expected[Region::cavity];
    }
  }
}

/// A section in x and z, counter-clockwise, drawn out along y.
TriangleMesh drawn_along_y(const test::Loop2& section, double from_y, double to_y) {
  test::SolidBuilder builder;
  builder.extrude(section, {}, to_y - from_y);
  TriangleMesh mesh = builder.mesh();
  for (glm::dvec3& corner : mesh.vertices) corner = {corner.x, to_y - corner.z, corner.y};
  return mesh;
}

TEST(ExactCrossingBodies, ABodyThatEntersAlongAnEdgeHidesTheFacetBehindIt) {
  // The slanting face of a wedge comes out of a block's top along an edge between two facets of it, with
  // nothing of the wedge's outline near: one of the two lies in the wedge, the other under the open sky.
  const glm::dvec3 low(0, 0, 0), high(4, 2, 2);
  const TriangleMesh block = drawn_along_y({{0, 0}, {2, 0}, {4, 0}, {4, 2}, {2, 2}, {0, 2}}, 0.0, 2.0);
  const TriangleMesh wedge = drawn_along_y({{1.5, 1}, {3.5, 1}, {3.5, 3}, {2.5, 3}}, -1.0, 3.0);
  ASSERT_TRUE(std::ranges::count(block.vertices, glm::dvec3(2, 2, 2)) == 1);
  std::vector<test::PlanarFace> faces = box_faces(low, high);
  const FacetGeometry geometry = facet_geometry(wedge);
  for (FacetIndex facet = 0; facet < wedge.facets.size(); ++facet) {
    faces.push_back(
        {{wedge.corner(facet, 0), wedge.corner(facet, 1), wedge.corner(facet, 2)}, geometry.normals[facet]});
  }
  const std::vector<test::ConvexBody> bodies = {box_body(low, high), wedge.vertices};
  const TriangleMesh both = test::joined(block, wedge);
  for (const TriangleMesh& mesh : {both, test::cut_in_four(test::cut_in_four(both))}) {
    const test::ExactModel model(mesh);
    for (const glm::dvec3& direction : directions()) {
      const RegionValues expected = test::face_areas(faces, bodies, direction, k_settings);
      EXPECT_LE(test::largest_difference(model.areas(direction, k_settings).areas, expected),
                1e-9 * expected.total())
          << mesh.facets.size() << " facets along " << direction.x << ' ' << direction.y << ' '
          << direction.z;
    }
  }
}

TEST(ExactCrossingBodies, TetrahedraOnALatticeHaveTheAreasOfTheirShadows) {
  // Corners, edges and planes in common, in every way there is.
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    test::Random random(seed);
    TriangleMesh mesh;
    std::vector<test::PlanarFace> faces;
    std::vector<test::ConvexBody> bodies;
    for (std::size_t body = 0; body < 2 + seed % 4; ++body) {
      TriangleMesh solid{{{}, {}, {}, {}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
      const auto& at = solid.vertices;
      do {
        for (glm::dvec3& corner : solid.vertices) {
          for (int axis = 0; axis < 3; ++axis) corner[axis] = static_cast<double>(random.below(3 + seed % 3));
        }
      } while (glm::dot(glm::cross(at[1] - at[0], at[2] - at[0]), at[3] - at[0]) < 0.5);
      mesh = test::joined(mesh, solid);
      bodies.push_back(solid.vertices);
      const FacetGeometry geometry = facet_geometry(solid);
      for (FacetIndex facet = 0; facet < 4; ++facet) {
        faces.push_back({{solid.corner(facet, 0), solid.corner(facet, 1), solid.corner(facet, 2)},
                         geometry.normals[facet]});
      }
    }
    const test::ExactModel model(mesh);
    for (const glm::dvec3& along : {glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0), glm::dvec3(1, 0, 2),
                                    glm::dvec3(2, 1, -1), glm::dvec3(0.36, 0.48, 0.8)}) {
      const glm::dvec3 direction = glm::normalize(along);
      const RegionValues expected = test::face_areas(faces, bodies, direction, k_settings);
      const ExactAreas found = model.areas(direction, k_settings);
      EXPECT_LE(test::largest_difference(found.areas, expected), 1e-9 * expected.total())
          << "seed " << seed << " along " << along.x << ' ' << along.y << ' ' << along.z;
    }
    test::expect_sound_split(model, model.split({1, 0, 2}, k_settings), "lattice");
  }
}

TEST(ExactCrossingBodies, OpenBoxesThatTouchHideEachOther) {
  const test::ExactModel model([] {
    TriangleMesh lower = test::box_mesh({0, 0, 0}, {3, 3, 1});
    lower.facets.erase(lower.facets.begin());
    return test::joined(lower, test::box_mesh({1, 1, 1}, {2, 2.5, 2}));
  }());
  ASSERT_FALSE(model.part().closed());
  EXPECT_NEAR(model.areas({0, 0, 1}, k_settings).areas[Region::undercut], 2.0 * 1.5, 1e-12);
}

}  // namespace
}  // namespace moldlight
