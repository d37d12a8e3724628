// Exact areas of solids whose regions are known otherwise: shapes with formulas, piles of boxes, convex
// bodies that shade each other.
#include <algorithm>
#include <cmath>
#include <cstdio>
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

namespace moldlight {
namespace {

constexpr double k_in_double = 1e-9;  // of the part's area
constexpr double k_from_stl = 2e-7;   // coordinates rounded to single precision
constexpr std::uint32_t k_solids = 200;

/// The worst error of many cases, as a share of each one's area.
struct Worst {
  double error = 0.0;
  std::string name;
  void add(double found, const std::string& of) {
    if (found < error) return;
    error = found;
    name = of;
  }
  void print(const char* what) const { std::printf("%s: worst %.2e (%s)\n", what, error, name.c_str()); }
};

double error_of(const ExactAreas& found, const RegionValues& expected) {
  return test::largest_difference(found.areas, expected) / expected.total();
}

class ExactShapes : public testing::TestWithParam<test::ShapeSettings> {};

TEST_P(ExactShapes, HaveTheAreasOfTheirFormulas) {
  Worst worst;
  for (const test::Shape& shape : test::all_shapes(GetParam())) {
    const ExactAreas found = test::exact_areas_of(shape.mesh, shape.direction, shape.settings);
    const double error = error_of(found, shape.expected);
    EXPECT_LE(error, k_in_double) << shape.name;
    worst.add(error, shape.name);
  }
  worst.print("shapes");
}

INSTANTIATE_TEST_SUITE_P(Tolerances, ExactShapes,
                         testing::Values(test::ShapeSettings{.tau_deg = 1.0, .lateral_tolerance = 0.02},
                                         test::ShapeSettings{.tau_deg = 2.0, .lateral_tolerance = 0.1},
                                         test::ShapeSettings{.tau_deg = 0.3, .lateral_tolerance = 0.4},
                                         test::ShapeSettings{.tau_deg = 3.0, .lateral_tolerance = 0.001}));

/// Rounding moves the border of a shadow by itself over |n . d|: how near to upright a leaning face may stand
/// for areas from STL to be compared.
constexpr double k_least_sine = 0.02;

/// Turns the pile and the direction at random; areas in double and after rounding.
void expect_pile_areas(const test::BoxPile& pile, std::uint32_t seed, const glm::dvec3& direction,
                       const test::ShapeSettings& settings, const RegionValues& expected, Worst& in_double,
                       Worst& from_stl) {
  const glm::dquat rotation = test::random_rotation(9000 + seed);
  const TriangleMesh mesh = test::permuted(test::rotated(test::pile_mesh(pile, seed), rotation), seed);
  const glm::dvec3 turned = rotation * direction;
  const std::string name = "seed " + std::to_string(seed);
  const double error = error_of(test::exact_areas_of(mesh, turned, settings), expected);
  EXPECT_LE(error, k_in_double) << name;
  in_double.add(error, name);
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] != 0.0 && std::abs(direction[axis]) < k_least_sine) return;
  }
  const double rounded =
      error_of(test::exact_areas_of(test::rounded_to_float(mesh), turned, settings), expected);
  EXPECT_LE(rounded, k_from_stl) << name;
  from_stl.add(rounded, name);
}

TEST(ExactPiles, AlongAnAxisHaveTheAreasOfTheirColumns) {
  Worst in_double, from_stl;
  for (std::uint32_t seed = 0; seed < k_solids; ++seed) {
    const test::BoxPile pile = test::random_pile(seed);
    const test::ShapeSettings settings{.tau_deg = 1.0,
                                       .lateral_tolerance = test::clear_lateral_tolerance(pile, seed)};
    const int axis = static_cast<int>(seed % 3);
    const bool along_plus = seed / 3 % 2 == 0;
    glm::dvec3 direction(0.0);
    direction[axis] = along_plus ? 1.0 : -1.0;
    expect_pile_areas(pile, seed, direction, settings,
                      test::column_areas(pile, axis, along_plus, settings.lateral_tolerance), in_double,
                      from_stl);
  }
  in_double.print("piles along an axis, in double");
  from_stl.print("piles along an axis, from STL");
}

TEST(ExactPiles, ThatTouchAlongEdgesHaveThemToo) {
  Worst in_double, from_stl;
  for (std::uint32_t seed = 1000; seed < 1060; ++seed) {
    const test::BoxPile pile = test::random_pile(seed, true);
    const test::ShapeSettings settings{.tau_deg = 1.0,
                                       .lateral_tolerance = test::clear_lateral_tolerance(pile, seed)};
    const int axis = static_cast<int>(seed % 3);
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    expect_pile_areas(pile, seed, direction, settings,
                      test::column_areas(pile, axis, true, settings.lateral_tolerance), in_double, from_stl);
  }
  in_double.print("piles that touch, in double");
  from_stl.print("piles that touch, from STL");
}

TEST(ExactPiles, AlongAnyDirectionHaveTheAreasOfTheirShadows) {
  Worst in_double, from_stl;
  for (std::uint32_t seed = 2000; seed < 2000 + k_solids; ++seed) {
    const test::BoxPile pile = test::random_pile(seed);
    test::Random random(seed);
    // Walls at any angle; some that stand upright beside others that lean; some that lean by less than tau.
    test::ShapeSettings settings{.tau_deg = seed % 4 == 3 ? 40.0 : 1.0,
                                 .lateral_tolerance = test::clear_lateral_tolerance(pile, seed)};
    glm::dvec3 direction = glm::normalize(random.in_cube(1.0));
    if (seed % 4 == 1) direction[static_cast<int>(random.below(3))] = 0.0;
    if (seed % 4 == 2) {
      direction = glm::dvec3(0.0);
      for (int axis = 0; axis < 2; ++axis) direction[axis] = random.between(0.002, 0.015);
      direction.z = seed % 8 == 2 ? 1.0 : -1.0;
    }
    direction = glm::normalize(direction);
    expect_pile_areas(pile, seed, direction, settings,
                      test::face_areas(test::pile_faces(pile), test::pile_bodies(pile), direction, settings),
                      in_double, from_stl);
  }
  in_double.print("piles along any direction, in double");
  from_stl.print("piles along any direction, from STL");
}

/// Tetrahedra and turned boxes, near each other but apart.
struct Cluster {
  std::vector<test::ConvexBody> bodies;
  std::vector<test::PlanarFace> faces;
  TriangleMesh mesh;
};

void add_facet(Cluster& cluster, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  cluster.faces.push_back({{a, b, c}, glm::normalize(glm::cross(b - a, c - a))});
}

Cluster random_cluster(std::uint32_t seed) {
  test::Random random(seed);
  Cluster cluster;
  std::vector<glm::dvec3> centers;
  for (int tries = 0; tries < 400 && centers.size() < 3 + seed % 6; ++tries) {
    const glm::dvec3 center = random.in_cube(2.0);
    if (std::any_of(centers.begin(), centers.end(),
                    [&](const glm::dvec3& other) { return glm::distance(center, other) < 2.05; }))
      continue;
    centers.push_back(center);
    TriangleMesh body;
    if (random.chance(0.5)) {
      body = test::box_mesh(glm::dvec3(-0.55), glm::dvec3(0.4, random.between(0.0, 0.55), 0.55));
    } else {
      do {
        body = {{}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
        for (int corner = 0; corner < 4; ++corner)
          body.vertices.push_back(0.95 * glm::normalize(random.in_cube(1.0)));
      } while (glm::dot(glm::cross(body.vertices[1] - body.vertices[0], body.vertices[2] - body.vertices[0]),
                        body.vertices[3] - body.vertices[0]) < 0.1);
    }
    body = test::translated(
        test::rotated(body, test::random_rotation(seed * 50 + static_cast<std::uint32_t>(tries))), center);
    cluster.bodies.push_back(body.vertices);
    for (FacetIndex facet = 0; facet < body.facets.size(); ++facet)
      add_facet(cluster, body.corner(facet, 0), body.corner(facet, 1), body.corner(facet, 2));
    cluster.mesh = test::joined(cluster.mesh, body);
  }
  return cluster;
}

TEST(ExactClusters, OfConvexBodiesHaveTheAreasOfTheirShadows) {
  Worst worst;
  double undercut = 0.0, total = 0.0;
  for (std::uint32_t seed = 0; seed < k_solids; ++seed) {
    const Cluster cluster = random_cluster(seed);
    const glm::dvec3 direction = test::random_rotation(seed + 7) * glm::dvec3(0, 0, 1);
    test::Random random(seed + 1);
    const test::ShapeSettings settings{.tau_deg = seed % 3 == 0 ? 1.0 : random.between(5.0, 80.0),
                                       .lateral_tolerance = random.between(0.001, 0.4)};
    const RegionValues expected = test::face_areas(cluster.faces, cluster.bodies, direction, settings);
    const double error =
        error_of(test::exact_areas_of(test::permuted(cluster.mesh, seed), direction, settings), expected);
    EXPECT_LE(error, k_in_double) << seed;
    worst.add(error, "seed " + std::to_string(seed));
    undercut += expected[Region::undercut];
    total += expected.total();
  }
  worst.print("clusters");
  EXPECT_GE(undercut, 0.03 * total) << "else the bodies hardly shade each other";
}

TEST(ExactIdentity, ProjectedCoreAndCavityAreTheShadow) {
  Worst worst;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const test::BoxPile pile = test::random_pile(seed);
    const glm::dvec3 direction =
        seed % 2 == 0 ? test::random_rotation(seed) * glm::dvec3(0, 0, 1) : test::five_directions()[seed % 3];
    const double shadow = test::shadow_area(test::pile_bodies(pile), direction);
    const TriangleMesh mesh = test::pile_mesh(pile, seed);
    const test::ShapeSettings settings{.tau_deg = seed % 3 == 0 ? 30.0 : 1.0};
    const ExactAreas found = test::exact_areas_of(mesh, direction, settings);
    const double area = found.areas.total();
    const double error =
        std::max(std::abs(found.projected_core - shadow), std::abs(found.projected_cavity - shadow)) / area;
    EXPECT_LE(error, 1e-10) << seed;
    EXPECT_LE(found.projected_doubt, 1e-12 * area) << seed;
    worst.add(error, "seed " + std::to_string(seed));

    // Rounding tilts walls a little; by how much of the shadow that puts in doubt is said.
    const glm::dquat rotation = test::random_rotation(seed + 300);
    const ExactAreas rounded = test::exact_areas_of(test::rounded_to_float(test::rotated(mesh, rotation)),
                                                    rotation * direction, settings);
    EXPECT_NEAR(rounded.projected_core, rounded.projected_cavity, rounded.projected_doubt + 1e-10 * area)
        << seed;
    EXPECT_NEAR(rounded.projected_core, shadow, rounded.projected_doubt + 2e-7 * area) << seed;
    EXPECT_LE(rounded.projected_doubt, 1e-6 * area) << seed;
  }
  worst.print("shadows");
}

TEST(ExactIdentity, ALongThinBoxHasItsOwnShadow) {
  const test::ExactModel box(test::box_mesh({0, 0, 0}, {1, 1000, 1}));
  const auto shadow = [&](const glm::dvec3& direction, double expected) {
    const ExactAreas areas = box.areas(direction, box.default_settings());
    EXPECT_NEAR(areas.projected_core, expected, 1e-9);
    EXPECT_NEAR(areas.projected_cavity, expected, 1e-9);
  };
  shadow({1, 0, 0}, 1000.0);
  shadow({0, 1, 0}, 1.0);
  shadow({0, 0, 1}, 1000.0);
  shadow(glm::normalize(glm::dvec3(1, 1, 1)), 2001.0 / std::sqrt(3.0));
}

}  // namespace
}  // namespace moldlight
