#include "sweep/candidates/canonical.hpp"

#include <algorithm>

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
