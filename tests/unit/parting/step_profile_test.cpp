// Parting surfaces of steps, against outlines of known levels.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "parting/halves/find_steps.hpp"
#include "parting/make_halves.hpp"
#include "support/classify_mesh.hpp"
#include "support/solid_builder.hpp"
#include "unit/parting/certified_halves.hpp"

namespace moldlight {
namespace {

constexpr double k_width = 0.3;

struct Stretch {
  double from, to;
  HeightRange range;
};

/// Around a rectangle of this width, its long sides divided into stretches of their own heights.
std::vector<RimSegment> outline(const std::vector<Stretch>& near, const std::vector<Stretch>& far) {
  std::vector<RimSegment> rims;
  for (const Stretch& s : near) rims.push_back({{glm::dvec2(s.to, 0.0), {s.from, 0.0}}, {s.range, s.range}});
  for (const Stretch& s : far)
    rims.push_back({{glm::dvec2(s.from, k_width), {s.to, k_width}}, {s.range, s.range}});
  rims.push_back({{glm::dvec2(near.front().from, 0.0), {far.front().from, k_width}},
                  {near.front().range, near.front().range}});
  rims.push_back(
      {{glm::dvec2(far.back().to, k_width), {near.back().to, 0.0}}, {near.back().range, near.back().range}});
  return rims;
}

void expect_met(const StepProfile& profile, const std::vector<RimSegment>& rims) {
  for (const RimSegment& rim : rims) {
    for (int k = 0; k <= 20; ++k) {
      const double z = profile.at(glm::mix(rim.ends[0], rim.ends[1], k / 20.0));
      EXPECT_GE(z, rim.ranges[0].low - 2e-5);
      EXPECT_LE(z, rim.ranges[0].high + 2e-5);
    }
  }
  EXPECT_EQ(profile.missed_share(rims), 0.0);
}

/// At a wall between two levels the surface may have any height of both.
const std::vector<Stretch> k_one_step = {
    {0.0, 0.4, {0.0, 0.02}}, {0.4, 0.46, {0.0, 0.12}}, {0.46, 0.9, {0.1, 0.12}}};

TEST(StepProfile, OfAStepIsTwoLevelsAndARamp) {
  const auto rims = outline(k_one_step, k_one_step);
  auto profile = find_steps(rims, 0.01, {});
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->bends(), 2U);
  expect_met(*profile, rims);
  EXPECT_NEAR(profile->at({0.2, 0.1}), 0.01, 1e-12);
  EXPECT_NEAR(profile->at({0.7, 5.0}), 0.1, 1e-12);
  EXPECT_NEAR(profile->rise(), 0.09, 1e-12);
  EXPECT_EQ(profile->creases({-1, -1}, {2, 2}).size(), 2U);
}

TEST(StepProfile, IsNoneWhereRampsWouldBeTooSteep) {
  EXPECT_TRUE(find_steps(outline(k_one_step, k_one_step), 0.01, {.slope = 1.6}));
  EXPECT_FALSE(find_steps(outline(k_one_step, k_one_step), 0.01, {.slope = 1.4}));
}

TEST(StepProfile, ComesToOneLevelAroundThePart) {
  const auto rims = outline(k_one_step, k_one_step);
  auto profile = find_steps(rims, 0.01, {});
  ASSERT_TRUE(profile);
  const ShelfShape shape{.ramp = 0.5, .land = 0.02};
  profile->level_around(rims, shape);
  expect_met(*profile, rims);
  const double base = profile->base();
  EXPECT_NEAR(base, 0.1, 1e-12);  // the longer level
  const std::vector<glm::dvec2> corners = profile->level_corners();
  ASSERT_EQ(corners.size(), 4U);
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (const glm::dvec2& corner : corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  EXPECT_NEAR(low.x, -0.02 - 0.09 / 0.5, 1e-12);
  EXPECT_NEAR(high.y, k_width + 0.02 + 0.09 / 0.5, 1e-12);
  for (int k = 0; k <= 50; ++k) {
    const double share = k / 50.0;
    for (const glm::dvec2& at : {glm::dvec2(glm::mix(low.x, high.x, share), low.y),
                                 {glm::mix(low.x, high.x, share), high.y},
                                 {low.x, glm::mix(low.y, high.y, share)},
                                 {high.x, glm::mix(low.y, high.y, share)}})
      EXPECT_NEAR(profile->at(at), base, 1e-12);
  }
  // Where it bends there are creases: between them it is straight.
  const auto creases = profile->creases(low - 0.1, high + 0.1);
  const auto near_crease = [&](const glm::dvec2& at) {
    return std::ranges::any_of(creases, [&](const auto& line) {
      const glm::dvec2 way = line[1] - line[0];
      const double share = std::clamp(glm::dot(at - line[0], way) / glm::dot(way, way), 0.0, 1.0);
      return glm::distance(at, glm::mix(line[0], line[1], share)) < 0.006;
    });
  };
  int straight = 0;
  for (double x = low.x; x < high.x; x += 0.013) {
    for (double y = low.y; y < high.y; y += 0.013) {
      if (near_crease({x, y})) continue;
      ++straight;
      for (const glm::dvec2& step : {glm::dvec2(0.004, 0.0), {0.0, 0.004}})
        EXPECT_NEAR(profile->at(glm::dvec2(x, y) + step) + profile->at(glm::dvec2(x, y) - step),
                    2.0 * profile->at({x, y}), 1e-12);
    }
  }
  EXPECT_GT(straight, 1000);
}

TEST(StepProfile, IsPartedWhereBothSidesStepElsewhere) {
  std::vector<Stretch> later = {{0.0, 0.6, {0.0, 0.02}}, {0.6, 0.66, {0.0, 0.12}}, {0.66, 0.9, {0.1, 0.12}}};
  const auto rims = outline(k_one_step, later);
  const auto profile = find_steps(rims, 0.01, {});
  ASSERT_TRUE(profile);
  EXPECT_EQ(profile->bends(), 4U);
  expect_met(*profile, rims);
  EXPECT_NEAR(profile->at({0.55, -1.0}), 0.1, 1e-12);
  EXPECT_NEAR(profile->at({0.55, 1.0}), 0.01, 1e-12);
  // Before and behind the part both are the same.
  for (const double x : {-0.5, 1.5}) EXPECT_EQ(profile->at({x, -1.0}), profile->at({x, 1.0}));
}

TEST(StepProfile, IsNoneWhereFewPlanesDoNot) {
  std::vector<Stretch> teeth;
  for (int k = 0; k < 9; ++k) {
    const double z = k % 2 == 0 ? 0.0 : 0.3;
    teeth.push_back({0.1 * k, 0.1 * (k + 1), {z, z + 0.01}});
  }
  EXPECT_FALSE(find_steps(outline(teeth, teeth), 0.0, {}));
  EXPECT_FALSE(find_steps({}, 0.0, {}));
}

TEST(StepProfile, DoesNotDependOnTheOrderOfTheOutline) {
  auto rims = outline(k_one_step, k_one_step);
  const auto profile = find_steps(rims, 0.01, {});
  std::ranges::reverse(rims);
  const auto other = find_steps(rims, 0.01, {});
  ASSERT_TRUE(profile && other);
  for (double x = -0.2; x < 1.2; x += 0.05) EXPECT_EQ(profile->at({x, 0.3}), other->at({x, 0.3}));
}

/// A staircase of plates, as bent from sheet, however it lies in the plane.
TEST(StepProfile, GivesHalvesOfFewPlanes) {
  test::SolidBuilder builder;
  const std::vector<glm::dvec2> side = {{0, 0},    {40, 0},  {40, 17}, {80, 17}, {80, 31}, {110, 31},
                                        {110, 34}, {77, 34}, {77, 20}, {37, 20}, {37, 3},  {0, 3}};
  const auto at = [&](std::size_t k, double y) { return glm::dvec3(side[k].x, y, side[k].y); };
  test::Loop front, back;
  for (std::size_t k = 0; k < side.size(); ++k) {
    front.push_back(at(k, 0.0));
    back.push_back(at(side.size() - 1 - k, 20.0));
    const std::size_t next = (k + 1) % side.size();
    builder.face({at(next, 0.0), at(k, 0.0), at(k, 20.0), at(next, 20.0)});
  }
  builder.face(front);
  builder.face(back);
  MoldSettings settings;
  settings.slope_deg = 80.0;
  for (const double turn_deg : {0.0, 90.0, 37.0}) {
    TriangleMesh mesh = builder.mesh();
    const double c = std::cos(glm::radians(turn_deg)), s = std::sin(glm::radians(turn_deg));
    for (glm::dvec3& v : mesh.vertices) v = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
    const MoldHalves halves = make_halves(*test::model_of(mesh), {0, 0, 1}, {17.0}, settings, Progress{});
    test::expect_certified(halves, "staircase", &mesh);
    EXPECT_LE(halves.contact_area, 1e-6) << turn_deg;
    EXPECT_LE(halves.surface.faces, 14U) << turn_deg;
    EXPECT_NEAR(halves.surface.rim_high, halves.surface.rim_low, 1e-9);
    EXPECT_NEAR(halves.surface.steepest_deg, glm::degrees(std::atan(14.0 / 3.0)), 0.1);
  }
}

}  // namespace
}  // namespace moldlight
