// Exact regions of meshes that are no proper solids, and of directions and tolerances at their limits.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "support/box_pile.hpp"
#include "support/boxes.hpp"
#include "support/convex_shadows.hpp"
#include "support/exact_model.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"
#include "support/split_checks.hpp"

namespace moldlight {
namespace {

constexpr test::ShapeSettings k_settings{.tau_deg = 1.0, .lateral_tolerance = 0.02};

std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> all = test::five_directions();
  all.push_back(glm::normalize(glm::dvec3(1, 1, 0)));  // along diagonals of boxes
  all.push_back(glm::normalize(glm::dvec3(1, 1, 1)));
  all.push_back(glm::normalize(glm::dvec3(1e-9, 0, 1)));
  all.push_back(glm::normalize(glm::dvec3(1e-4, -1e-5, -1)));
  return all;
}

/// Whatever the mesh: areas that make up the whole, and a sound split with the same areas.
void expect_sane(const TriangleMesh& mesh, const test::ShapeSettings& settings, const std::string& name) {
  const test::ExactModel model(mesh);
  const double total = model.geometry().total_area;
  std::size_t number = 0;
  for (const glm::dvec3& direction : directions()) {
    const std::string of = name + ", direction " + std::to_string(number++);
    const ExactAreas areas = model.areas(direction, settings);
    ASSERT_EQ(areas.facet_fractions.size(), mesh.facets.size()) << of;
    for (std::size_t facet = 0; facet < mesh.facets.size(); ++facet) {
      double sum = 0.0;
      for (const double share : areas.facet_fractions[facet]) {
        EXPECT_TRUE(share >= 0.0 && share <= 1.0 + 1e-12) << of << ", facet " << facet;
        sum += share;
      }
      if (model.geometry().areas[facet] == 0.0) {
        EXPECT_EQ(sum, 0.0) << of;
      } else {
        EXPECT_TRUE(std::abs(sum - 1.0) < 1e-12 || model.geometry().areas[facet] < 1e-12 * total)
            << of << ", facet " << facet << " of area " << model.geometry().areas[facet];
      }
    }
    EXPECT_NEAR(areas.areas.total(), total, 1e-10 * total) << of;
    for (const double projected : {areas.projected_core, areas.projected_cavity, areas.near_vertical_area})
      EXPECT_TRUE(projected >= 0.0 && projected <= total * (1.0 + 1e-12)) << of << ": " << projected;
    const ExactSplit split = model.split(direction, settings);
    EXPECT_EQ(split.areas.areas.values, areas.areas.values) << of;
    test::expect_sound_split(model, split, of);
    test::expect_whole_borders(split.mesh, of);
    if (settings.lateral_tolerance == 0.0) continue;  // rays along walls tell nothing
    const test::RayVerdicts verdicts = test::ray_verdicts(model, split.mesh, direction, settings, 100, 1);
    EXPECT_TRUE(verdicts.wrong.empty())
        << of << ": " << verdicts.wrong.size() << " of " << verdicts.pieces << ", " << verdicts.wrong.front();
  }
}

TriangleMesh small_box() { return test::box_mesh({0, 0, 0}, {3, 2, 1}); }

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

TEST(ExactBadInput, BoxesThatTouchOrOverlapHideEachOther) {
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

TEST(ExactBadInput, ManyBoxesThatCrossHaveTheAreasOfTheirShadows) {
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

TEST(ExactBadInput, PilesThatCrossHaveTheAreasOfTheirShadows) {
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

TEST(ExactBadInput, BodiesThatCrossAlongAnEdgeHideEachOther) {
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

TEST(ExactBadInput, ABodyThatEntersAlongAnEdgeHidesTheFacetBehindIt) {
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

TEST(ExactBadInput, TetrahedraOnALatticeHaveTheAreasOfTheirShadows) {
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

TEST(ExactBadInput, OpenBoxesThatTouchHideEachOther) {
  const test::ExactModel model([] {
    TriangleMesh lower = test::box_mesh({0, 0, 0}, {3, 3, 1});
    lower.facets.erase(lower.facets.begin());
    return test::joined(lower, test::box_mesh({1, 1, 1}, {2, 2.5, 2}));
  }());
  ASSERT_FALSE(model.part().closed());
  EXPECT_NEAR(model.areas({0, 0, 1}, k_settings).areas[Region::undercut], 2.0 * 1.5, 1e-12);
}

TEST(ExactBadInput, FacetsWithoutAreaChangeNothing) {
  const TriangleMesh box = small_box();
  TriangleMesh mesh = box;
  mesh.facets.push_back({0, 0, 1});
  mesh.facets.push_back({2, 2, 2});
  // A vertex in the middle of an edge of two facets: one of them is cut there, a facet without area closes
  // the seam to the other.
  const auto [a, b, c] = mesh.facets[0];
  const auto middle = static_cast<VertexIndex>(mesh.vertices.size());
  mesh.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
  mesh.facets[0] = {a, middle, c};
  mesh.facets.push_back({middle, b, c});
  mesh.facets.push_back({a, b, middle});
  expect_sane(mesh, k_settings, "facets without area");
  for (const glm::dvec3& direction : directions()) {
    const ExactAreas with = test::exact_areas_of(mesh, direction, k_settings);
    const ExactAreas without = test::exact_areas_of(box, direction, k_settings);
    EXPECT_LE(test::largest_difference(with.areas, without.areas), 1e-12 * without.areas.total());
    EXPECT_NEAR(with.projected_core, without.projected_core, 1e-12);
  }
}

TEST(ExactBadInput, NeedlesChangeNothing) {
  // The same seam with the vertex off the edge by roundings of single precision.
  const TriangleMesh box = small_box();
  for (const double off : {1e-15, 1e-12, 1e-9, 1e-7}) {
    TriangleMesh mesh = box;
    const auto [a, b, c] = mesh.facets[0];
    const auto middle = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.push_back(0.43 * mesh.vertices[a] + 0.57 * mesh.vertices[b] + glm::dvec3(off, -off, off));
    mesh.facets[0] = {a, middle, c};
    mesh.facets.push_back({middle, b, c});
    mesh.facets.push_back({a, b, middle});
    expect_sane(mesh, k_settings, "needle");
    for (const glm::dvec3& direction : test::five_directions()) {
      const ExactAreas with = test::exact_areas_of(mesh, direction, k_settings);
      const ExactAreas without = test::exact_areas_of(box, direction, k_settings);
      EXPECT_LE(test::largest_difference(with.areas, without.areas), 10.0 * off + 1e-12) << off;
    }
  }
}

TEST(ExactBadInput, DuplicateFacetsCountTwice) {
  const TriangleMesh box = test::subdivided(small_box(), 40);
  const test::ExactModel model(box);
  for (FacetIndex facet = 0; facet < 40; facet += 7) {
    TriangleMesh twice = box;
    twice.facets.push_back(box.facets[facet]);
    expect_sane(twice, k_settings, "duplicate");
    for (const glm::dvec3& direction : test::five_directions()) {
      RegionValues expected = model.areas(direction, k_settings).areas;
      for (const Region region : k_regions) {
        expected[region] +=
            model.areas(direction, k_settings).facet_fractions[facet][static_cast<std::size_t>(region)] *
            model.geometry().areas[facet];
      }
      EXPECT_LE(test::largest_difference(test::exact_areas_of(twice, direction, k_settings).areas, expected),
                1e-10 * expected.total());
    }
  }
}

TEST(ExactBadInput, VerticesInTheMiddleOfEdgesChangeNothing) {
  // Facets cut on one side of their edges only: closed to the eye, open edges by number.
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const test::BoxPile pile = test::random_pile(seed);
    const TriangleMesh mesh = test::pile_mesh(pile, seed);
    test::Random random(seed);
    TriangleMesh cut;
    cut.vertices = mesh.vertices;
    for (const auto& facet : mesh.facets) {
      if (random.chance(0.5)) {
        cut.facets.push_back(facet);
        continue;
      }
      const std::size_t side = random.below(3);
      const VertexIndex a = facet[side], b = facet[(side + 1) % 3], c = facet[(side + 2) % 3];
      const auto middle = static_cast<VertexIndex>(cut.vertices.size());
      cut.vertices.push_back(mesh.vertices[a] +
                             random.between(0.2, 0.8) * (mesh.vertices[b] - mesh.vertices[a]));
      cut.facets.push_back({a, middle, c});
      cut.facets.push_back({middle, b, c});
    }
    const test::ShapeSettings settings{.tau_deg = 1.0,
                                       .lateral_tolerance = test::clear_lateral_tolerance(pile, seed)};
    const test::ExactModel closed(mesh), seams(cut);
    for (const glm::dvec3& direction : test::five_directions()) {
      const ExactAreas expected = closed.areas(direction, settings), found = seams.areas(direction, settings);
      EXPECT_LE(test::largest_difference(found.areas, expected.areas), 1e-9 * expected.areas.total()) << seed;
      test::expect_sound_split(seams, seams.split(direction, settings), "seams");
    }
  }
}

TEST(ExactBadInput, OpenAndTurnedMeshesAreSane) {
  test::Random random(5);
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    TriangleMesh mesh = test::pile_mesh(test::random_pile(seed), seed);
    if (seed % 3 != 1) {
      for (std::size_t i = 0; i < 1 + mesh.facets.size() / 10; ++i)
        mesh.facets.erase(mesh.facets.begin() +
                          static_cast<std::ptrdiff_t>(random.below(mesh.facets.size())));
    }
    if (seed % 3 != 0) {
      for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
        if (random.chance(0.5)) test::reverse_facet(mesh, facet);
      }
    }
    expect_sane(mesh, {.tau_deg = 1.0, .lateral_tolerance = 0.1}, "open or turned " + std::to_string(seed));
  }
}

TEST(ExactBadInput, FacetsThrownTogetherAreSane) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    test::Random random(seed);
    TriangleMesh mesh;
    for (int vertex = 0; vertex < 40; ++vertex) {
      glm::dvec3 point = random.in_cube(1.0);
      if (seed % 2 == 1) point = glm::round(3.0 * point);  // many in one plane, line or place
      mesh.vertices.push_back(point);
    }
    for (int facet = 0; facet < 36; ++facet) {
      mesh.facets.push_back({static_cast<VertexIndex>(random.below(40)),
                             static_cast<VertexIndex>(random.below(40)),
                             static_cast<VertexIndex>(random.below(40))});
    }
    expect_sane(mesh, k_settings, "thrown together " + std::to_string(seed));
  }
}

TEST(ExactBadInput, ManyFacetsRoundOneEdgeAreMeasuredWithoutListsOfEachOther) {
  constexpr int k_facets = 2000;
  TriangleMesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}};
  for (int i = 0; i < k_facets; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / k_facets;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    mesh.facets.push_back({0, 1, static_cast<VertexIndex>(i + 2)});
  }
  const test::ExactModel model(mesh);
  EXPECT_EQ(model.part().in_front(), nullptr);
  EXPECT_NE(test::ExactModel(small_box()).part().in_front(), nullptr);
  // Along the edge all facets are upright, and nothing is above or below any of them.
  const ExactAreas areas = model.areas({0, 0, 1}, k_settings);
  EXPECT_NEAR(areas.areas[Region::both], 0.5 * k_facets, 1e-9 * k_facets);
}

TEST(ExactBadInput, ASingleFacetIsSeenFromItsSide) {
  const TriangleMesh mesh = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  expect_sane(mesh, k_settings, "one facet");
  const test::ExactModel model(mesh);
  EXPECT_DOUBLE_EQ(model.areas({0, 0, 1}, k_settings).areas[Region::core], 2.0);
  EXPECT_DOUBLE_EQ(model.areas({0, 0, -1}, k_settings).areas[Region::cavity], 2.0);
  EXPECT_DOUBLE_EQ(model.areas({1, 0, 0}, k_settings).areas[Region::both], 2.0);
}

TEST(ExactBadInput, ThinPartsHaveTheirAreas) {
  struct Thin {
    glm::dvec3 size;
    double lateral;
  };
  for (const Thin& thin :
       {Thin{{1e4, 1, 1}, 0.3}, Thin{{1, 1e4, 1}, 2.0}, Thin{{1e4, 1e4, 1}, 0.01}, Thin{{1, 1, 1e4}, 5.0}}) {
    const TriangleMesh mesh = test::subdivided(test::box_mesh({0, 0, 0}, thin.size), 60);
    const test::ShapeSettings settings{.tau_deg = 1.0, .lateral_tolerance = thin.lateral};
    expect_sane(mesh, settings, "thin");
    const test::ExactModel model(mesh);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 direction(0.0);
      direction[axis] = 1.0;
      const double face = thin.size[(axis + 1) % 3] * thin.size[(axis + 2) % 3];
      const ExactAreas found = model.areas(direction, settings);
      const double total = model.geometry().total_area;
      EXPECT_NEAR(found.areas[Region::core], face, 1e-9 * total);
      EXPECT_NEAR(found.areas[Region::cavity], face, 1e-9 * total);
      EXPECT_NEAR(found.areas[Region::both], total - 2.0 * face, 1e-9 * total);
      EXPECT_NEAR(found.projected_core, face, 1e-9 * total);
    }
  }
}

TEST(ExactBadInput, TolerancesOfZeroAreSane) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const TriangleMesh mesh = test::pile_mesh(test::random_pile(seed), seed);
    expect_sane(mesh, {.tau_deg = 0.0, .lateral_tolerance = 0.1}, "tau 0");
    expect_sane(mesh, {.tau_deg = 1.0, .lateral_tolerance = 0.0}, "lateral 0");
    expect_sane(mesh, {.tau_deg = 0.0, .lateral_tolerance = 0.0}, "both 0");
    expect_sane(mesh, {.tau_deg = 89.9, .lateral_tolerance = 0.1}, "tau 89.9");
    expect_sane(mesh, {.tau_deg = 1.0, .lateral_tolerance = 100.0}, "lateral past the part");
  }
}

TEST(ExactBadInput, LateralToleranceOfAGapIsSane) {
  // The points tested lie in the opposite wall.
  TriangleMesh mesh =
      test::joined(test::box_mesh({0, 0, 0}, {1, 2, 2}), test::box_mesh({1.5, 0, -1}, {3, 2, 3}));
  mesh = test::joined(mesh, test::box_mesh({0, 2.5, 0}, {1, 3, 2}));
  expect_sane(mesh, {.tau_deg = 1.0, .lateral_tolerance = 0.5}, "gap");
  expect_sane(mesh, {.tau_deg = 1.0, .lateral_tolerance = 1.5}, "box");
}

TEST(ExactBadInput, DirectionsAlongDiagonalsHaveTheirAreas) {
  const test::ExactModel cube(test::box_mesh({0, 0, 0}, {1, 1, 1}));
  const ExactAreas edge_on = cube.areas(glm::normalize(glm::dvec3(1, 1, 0)), k_settings);
  EXPECT_NEAR(edge_on.areas[Region::core], 2.0, 1e-12);
  EXPECT_NEAR(edge_on.areas[Region::cavity], 2.0, 1e-12);
  EXPECT_NEAR(edge_on.areas[Region::both], 2.0, 1e-12);
  EXPECT_NEAR(edge_on.projected_core, std::sqrt(2.0), 1e-12);
  const ExactAreas corner_on = cube.areas(glm::normalize(glm::dvec3(1, 1, 1)), k_settings);
  EXPECT_NEAR(corner_on.areas[Region::core], 3.0, 1e-12);
  EXPECT_NEAR(corner_on.areas[Region::cavity], 3.0, 1e-12);
  EXPECT_NEAR(corner_on.projected_cavity, std::sqrt(3.0), 1e-12);
}

TEST(ExactBadInput, FarFromTheOriginAreasStay) {
  const test::Shape shape = test::cup_with_side_hole({});
  const ExactAreas there =
      test::exact_areas_of(test::translated(shape.mesh, {1e6, -2e6, 5e5}), shape.direction, shape.settings);
  EXPECT_LE(test::largest_difference(there.areas, shape.expected), 1e-9 * shape.expected.total());
}

TEST(ExactBadInput, AMeshWithoutFacetsHasNoRegions) {
  for (const TriangleMesh& mesh : {TriangleMesh{}, TriangleMesh{{{0, 0, 0}, {1, 2, 3}}, {}}}) {
    const test::ExactModel model(mesh);
    const ExactSplit split = model.split({0, 0, 1}, k_settings);
    EXPECT_TRUE(split.areas.facet_fractions.empty());
    EXPECT_EQ(split.areas.areas.total(), 0.0);
    EXPECT_EQ(split.areas.projected_core, 0.0);
    EXPECT_TRUE(split.mesh.pieces.empty());
    EXPECT_EQ(split.mesh.vertices.size(), mesh.vertices.size());
    EXPECT_TRUE(region_borders(split.mesh).empty());
  }
}

TEST(ExactBadInput, OnlyFacetsWithoutAreaHaveNoRegions) {
  const TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 0, 1}, {2, 1, 0}}};
  const test::ExactModel model(mesh);
  const ExactSplit split = model.split({0, 0, 1}, k_settings);
  EXPECT_EQ(split.areas.areas.total(), 0.0);
  const TriangleMesh point = {{{1, 1, 1}}, {{0, 0, 0}}};
  EXPECT_EQ(test::exact_areas_of(point, {0, 0, 1}, k_settings).areas.total(), 0.0);
}

}  // namespace
}  // namespace moldlight
