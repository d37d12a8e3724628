// Where sections lie.
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "render/view_geometry.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

class Planes : public ::testing::Test {
 protected:
  [[nodiscard]] CutPlane plane(Section section, double at, const glm::dvec3& direction = {0, 0, 1}) {
    LookSettings look;
    look.section = section;
    look.section_at = at;
    look.section_turn_deg = turn_deg;
    const auto found = planes.plane(look, direction);
    EXPECT_TRUE(found);
    return found.value_or(CutPlane{});
  }
  /// Where the plane meets the line through the origin along its normal, in the box's own unit.
  [[nodiscard]] double place(const CutPlane& cut) const {
    return cut.offset * frame.diagonal + glm::dot(frame.center, cut.normal);
  }

  TriangleMesh mesh = test::box_mesh({10, 20, 30}, {13, 24, 35});
  UnitFrame frame = unit_frame(bounds(mesh));
  SectionPlanes planes{mesh, frame};
  double turn_deg = 0.0;
};

TEST_F(Planes, LieAcrossTheAxesOrTheDirection) {
  EXPECT_FALSE(planes.plane({}, {0, 0, 1}));
  const auto expect = [&](const CutPlane& cut, const glm::dvec3& normal, double at) {
    EXPECT_NEAR(glm::distance(cut.normal, normal), 0.0, 1e-12);
    EXPECT_NEAR(place(cut), at, 1e-9);
  };
  expect(plane(Section::x, 0.5), {1, 0, 0}, 11.5);
  expect(plane(Section::y, 0.25), {0, -1, 0}, -23.0);
  expect(plane(Section::z, 1.0), {0, 0, 1}, 35.0);
  expect(plane(Section::across, 0.0), {0, 0, 1}, 30.0);
  expect(plane(Section::across, 0.0, {0, -1, 0}), {0, -1, 0}, -24.0);
  EXPECT_NEAR(plane(Section::y, 0.1).extent * frame.diagonal, 4.0, 1e-9);
}

TEST_F(Planes, HaveTheirArrowsBesideThoseOfTheDirection) {
  for (const Section section : {Section::across, Section::z, Section::x, Section::along}) {
    const CutPlane cut = plane(section, 0.8);
    EXPECT_NEAR(glm::dot(cut.foot, cut.normal), cut.offset, 1e-12);
    const bool level = std::abs(cut.normal.z) > 0.5;
    EXPECT_NEAR(glm::length(glm::dvec2(cut.foot)), level ? 0.12 : std::abs(cut.offset), 1e-12);
  }
}

TEST_F(Planes, AlongTheDirectionTurnAboutIt) {
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.5, 2.0));
  const glm::dvec3 start = plane(Section::along, 0.5, direction).normal;
  for (const double turn : {0.0, 30.0, 90.0, 200.0}) {
    turn_deg = turn;
    const CutPlane cut = plane(Section::along, 0.5, direction);
    EXPECT_NEAR(glm::length(cut.normal), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(cut.normal, direction), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(cut.normal, start), std::cos(glm::radians(turn)), 1e-12);
    EXPECT_NEAR(cut.offset, 0.0, 1e-12) << "through the middle of a box";
  }
}

}  // namespace
}  // namespace moldlight
