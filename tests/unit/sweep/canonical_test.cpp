#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/solid_builder.hpp"
#include "sweep/candidates/candidate_sources.hpp"

namespace moldlight {
namespace {

std::vector<Candidate> canonical_of(const TriangleMesh& mesh) {
  return canonical_candidates(*test::model_of(mesh));
}

const Candidate* along(const std::vector<Candidate>& candidates, const glm::dvec3& direction,
                       double within_deg) {
  const auto found = std::ranges::find_if(candidates, [&](const Candidate& each) {
    return line_angle_deg(each.direction, direction) <= within_deg;
  });
  return found == candidates.end() ? nullptr : &*found;
}

glm::dquat about_x(double degrees) { return glm::angleAxis(glm::radians(degrees), glm::dvec3(1, 0, 0)); }

TEST(Canonical, AxesOfTheFileHaveTheirNamesAndTheSurfaceThatSpeaksForThem) {
  const std::vector<Candidate> found = canonical_of(test::box_mesh({0, 0, 0}, {20, 10, 5}));
  ASSERT_EQ(found.size(), 3U) << "planes are on the axes";
  EXPECT_EQ(along(found, {0, 0, 1}, 0.0)->canonical->name, "z");
  EXPECT_NEAR(along(found, {0, 0, 1}, 0.0)->canonical->share, 400.0 / 700.0, 1e-12);
  EXPECT_NEAR(along(found, {1, 0, 0}, 0.0)->canonical->share, 100.0 / 700.0, 1e-12);
}

TEST(Canonical, PlanesAreFoundInATurnedPart) {
  const glm::dquat rotation = test::random_rotation(5);
  const std::vector<Candidate> found =
      canonical_of(test::rotated(test::box_mesh({0, 0, 0}, {20, 10, 5}), rotation));
  ASSERT_EQ(found.size(), 6U) << "and the file's axes";
  const Candidate* largest = along(found, rotation * glm::dvec3(0, 0, 1), 1e-9);
  ASSERT_NE(largest, nullptr);
  EXPECT_EQ(largest->canonical->name, "normal of the largest plane, 57 % of the surface");
  const Candidate* smallest = along(found, rotation * glm::dvec3(1, 0, 0), 1e-9);
  ASSERT_NE(smallest, nullptr);
  EXPECT_EQ(smallest->canonical->name, "normal of planes, 14 % of the surface");
}

/// A bent pipe of radius 8, which may begin with a straight piece along y.
TriangleMesh bent_pipe(double straight) {
  test::TubeShape pipe{.centres = {}, .radius = 8.0, .inner_radius = 6.0, .normal = {0, 0, 1}, .sides = 48};
  if (straight > 0.0) pipe.centres.emplace_back(30.0, -straight, 0.0);
  constexpr int k_sections = 22;
  for (int k = 0; k <= k_sections; ++k) {
    const double angle = glm::radians(90.0 * k / k_sections);
    pipe.centres.emplace_back(30.0 * std::cos(angle), 30.0 * std::sin(angle), 0.0);
  }
  return test::tube_mesh(pipe);
}

TEST(Canonical, SlicesOfABendAreNoRoundWalls) {
  for (const Candidate& each : canonical_of(bent_pipe(0.0))) {
    const std::string name = each.canonical ? each.canonical->name : "";
    EXPECT_EQ(name.find("round walls"), std::string::npos) << name;
  }
  const std::vector<Candidate> found = canonical_of(bent_pipe(60.0));
  const Candidate* along_pipe = along(found, {0, 1, 0}, 0.01);
  ASSERT_NE(along_pipe, nullptr);
  EXPECT_GT(along_pipe->canonical->share, 0.4) << "a straight pipe that leads to a bend is one";
}

TEST(Canonical, RoundWallsAboutTheNormalOfPlanesAreNamedWithThem) {
  const glm::dquat rotation = test::random_rotation(5);
  test::SolidBuilder disc;
  disc.extrude(test::regular_polygon(96, 10.0), {}, 5.0);
  const std::vector<Candidate> found = canonical_of(test::rotated(disc.mesh(), rotation));
  const Candidate* axis = along(found, rotation * glm::dvec3(0, 1, 0), 1e-6);
  ASSERT_NE(axis, nullptr);
  EXPECT_EQ(axis->canonical->name,
            "normal of the largest plane and axis of round walls, 100 % of the surface");
}

/// How many of the file's axes are canonical.
std::size_t axes_in(const std::vector<Candidate>& candidates) {
  return static_cast<std::size_t>(std::ranges::count_if(candidates, [](const Candidate& each) {
    return each.kind() == CandidateKind::axis && each.canonical;
  }));
}

TEST(Canonical, AxesOfTheFileAreNoneOfATurnedPart) {
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {20, 10, 5});
  EXPECT_EQ(axes_in(canonical_of(test::rotated(box, test::random_rotation(5)))), 0U);
  const std::vector<Candidate> about_one = canonical_of(test::rotated(box, about_x(30.0)));
  EXPECT_EQ(axes_in(about_one), 1U);
  EXPECT_TRUE(along(about_one, {1, 0, 0}, 0.0)->canonical) << "it is turned about x";
  ASSERT_NE(along(about_one, {0, 0, 1}, 0.0), nullptr) << "still a candidate";
}

TEST(Canonical, AxesOfTheFileAreThoseOfAStraightPart) {
  const double lean = 10.0 * std::tan(glm::radians(1.0));
  test::SolidBuilder drafted;
  const test::Loop low = {{0, 0, 0}, {20, 0, 0}, {20, 12, 0}, {0, 12, 0}};
  const test::Loop high = {
      {lean, lean, 10}, {20 - lean, lean, 10}, {20 - lean, 12 - lean, 10}, {lean, 12 - lean, 10}};
  drafted.walls(low, high);
  drafted.face({low.rbegin(), low.rend()});
  drafted.face(high);
  const std::vector<Candidate> of_drafted = canonical_of(drafted.mesh());
  EXPECT_EQ(axes_in(of_drafted), 3U) << "walls with draft face along x and y";
  EXPECT_GT(along(of_drafted, {1, 0, 0}, 0.0)->canonical->share, 0.1);
  EXPECT_EQ(
      std::ranges::count_if(of_drafted, [](const Candidate& each) { return each.canonical.has_value(); }), 3)
      << "beside these a wall is none";
  test::SolidBuilder prism;
  const test::Loop2 hexagon = test::regular_polygon(6, 8.0);
  const test::Loop base = test::at_height(hexagon, 0.0), top = test::at_height(hexagon, 5.0);
  prism.walls(base, top);
  prism.face({base.rbegin(), base.rend()});
  prism.face(top);
  EXPECT_EQ(axes_in(canonical_of(prism.mesh())), 3U) << "nothing is at a right angle to its sides";
}

TEST(Canonical, NormalsWithinATenthOfADegreeAreOne) {
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {20, 10, 5});
  const auto with_another = [&](double degrees) {
    return canonical_of(
        test::joined(test::rotated(box, about_x(30.0)),
                     test::translated(test::rotated(box, about_x(30.0 + degrees)), {100, 0, 0})));
  };
  // About x nothing turns: its normal is the file's x in both.
  EXPECT_EQ(with_another(0.05).size(), 5U);
  EXPECT_EQ(with_another(0.3).size(), 7U);
}

TEST(Canonical, ARoundWallHasAnAxisAndItsFacetsAreNoPlanes) {
  const glm::dquat rotation = test::random_rotation(8);
  test::SolidBuilder solid;
  const test::Loop2 circle = test::regular_polygon(48, 6.0);
  const test::Loop low = test::at_height(circle, 0.0), high = test::at_height(circle, 30.0);
  solid.walls(low, high);
  solid.face({low.rbegin(), low.rend()});
  solid.face(high);
  const std::vector<Candidate> found = canonical_of(test::rotated(solid.mesh(), rotation));
  EXPECT_EQ(found.size(), 4U);
  EXPECT_NE(along(found, rotation * glm::dvec3(0, 0, 1), 1e-6), nullptr);
}

TEST(Canonical, AreTheSameInWhateverOrderFacetsCome) {
  const TriangleMesh part = test::rotated(test::plate_with_holes(2, 3, 4.0), test::random_rotation(3));
  const std::vector<Candidate> one = canonical_of(part), other = canonical_of(test::permuted(part, 11));
  ASSERT_EQ(one.size(), other.size());
  for (const Candidate& each : one) {
    const Candidate* same = along(other, each.direction, 1e-9);
    ASSERT_NE(same, nullptr) << each.canonical->name;
    EXPECT_NEAR(same->canonical->share, each.canonical->share, 1e-12);
  }
}

TEST(Canonical, FreeFormHasItsPrincipalAxes) {
  TriangleMesh potato = test::torus_mesh(10.0, 4.0, 61, 37);
  test::Random random(4);
  for (glm::dvec3& vertex : potato.vertices)
    vertex = glm::dvec3(1.5, 1.0, 1.0) * vertex + random.in_cube(0.1);
  const std::vector<Candidate> found = canonical_of(test::rotated(potato, test::random_rotation(2)));
  EXPECT_TRUE(std::ranges::any_of(found, [](const Candidate& each) {
    return each.kind() == CandidateKind::principal;
  })) << found.back().canonical->name;
}

}  // namespace
}  // namespace moldlight
