// Exact regions of meshes that are no proper solids, and of directions and tolerances at their limits.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/exact_rays.hpp"
#include "support/box_pile.hpp"
#include "support/boxes.hpp"
#include "support/convex_shadows.hpp"
#include "support/exact_model.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"
#include "support/split_checks.hpp"
#include "unit/mold/sane_regions.hpp"

namespace moldlight {
namespace {

constexpr test::ShapeSettings k_settings{.tau_deg = 1.0, .lateral_tolerance = 0.02};

TriangleMesh small_box() { return test::box_mesh({0, 0, 0}, {3, 2, 1}); }

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
  EXPECT_FALSE(model.part().knows_in_front());
  EXPECT_TRUE(test::ExactModel(small_box()).part().knows_in_front());
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

TEST(ExactBadInput, RaysWithoutAPlaceMeetNothing) {
  const TriangleMesh box = small_box();
  const ExactRays rays(box, unit_positions(box, unit_frame(bounds(box))));
  const glm::vec3 nowhere(std::numeric_limits<float>::quiet_NaN()), far(1e30F), up(0, 0, 1), inside(0.0F);
  EXPECT_TRUE(rays.first_hit(inside, up, false));
  for (const glm::vec3& bad : {nowhere, far}) {
    EXPECT_FALSE(rays.first_hit(bad, up, false));
    EXPECT_FALSE(rays.first_hit(inside, bad, true));
    EXPECT_FALSE(rays.surface_point_blocked(bad, up, up));
    EXPECT_FALSE(rays.surface_point_blocked(inside, bad, up));
    std::array<std::uint8_t, 2> answers{};
    rays.blocked(std::array{bad, inside}, up, answers);
    EXPECT_EQ(answers, (std::array<std::uint8_t, 2>{0, 1}));
  }
}

}  // namespace
}  // namespace moldlight
