#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction.hpp"

namespace moldlight {
namespace {

glm::dvec3 off_z(double deg, const glm::dvec3& toward) {
  return glm::normalize(glm::dvec3(0, 0, 1) + std::tan(glm::radians(deg)) * glm::normalize(toward));
}

TEST(DirectionWords, AnAxisHasItsName) {
  EXPECT_EQ(direction_words({0, 0, 1}), "z");
  EXPECT_EQ(direction_words({0, -1, 0}), "-y");
  EXPECT_EQ(direction_words({1, 0, 0}), "x");
  EXPECT_EQ(direction_words(off_z(1e-8, {1, 0, 0})), "z") << "rounding";
}

TEST(DirectionWords, BesideAnAxisTheAngleIsTold) {
  EXPECT_EQ(direction_words(off_z(0.22, {1, 0, 0})), "0.22° off z (towards +x)");
  EXPECT_EQ(direction_words(-off_z(4.4, {1, 0, 0})), "4.4° off -z (towards -x)");
  EXPECT_EQ(direction_words(off_z(0.00013, {0, -1, 0})), "0.00013° off z (towards -y)");
  EXPECT_EQ(direction_words(off_z(3.0, {1, 1, 0})), "3.0° off z (towards +x+y)");
}

TEST(DirectionWords, ElsewhereTheVectorIsTold) {
  EXPECT_EQ(direction_words({-1e-6, 0.6, -0.8}), "0.000, 0.600, -0.800");
  EXPECT_EQ(direction_words(glm::normalize(glm::dvec3(1, 1, 1))), "0.577, 0.577, 0.577");
}

TEST(DirectionWords, TheNearestAxisIsOnTheSideOfTheDirection) {
  const NearestAxis nearest = nearest_axis(glm::normalize(glm::dvec3(0.1, -1.0, 0.2)));
  EXPECT_EQ(nearest.axis, glm::dvec3(0, -1, 0));
  EXPECT_EQ(nearest.name, "-y");
  EXPECT_NEAR(nearest.angle_deg, glm::degrees(std::atan(std::hypot(0.1, 0.2))), 1e-9);
  EXPECT_FALSE(nearest.is_met());
  EXPECT_EQ(nearest_axis(glm::normalize(glm::dvec3(1, 1, 1))).name, "z") << "of axes alike";
}

}  // namespace
}  // namespace moldlight
