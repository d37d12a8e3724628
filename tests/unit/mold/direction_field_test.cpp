// The interpolated map of directions and its colours.
#include "mold/direction_field.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction_field.hpp"

namespace moldlight {
namespace {

TEST(EqualAreaMap, GoesThereAndBack) {
  for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0.36, -0.48, 0.8),
                                      glm::normalize(glm::dvec3(1, 2, -0.5))}) {
    EXPECT_LT(glm::distance(equal_area_direction(equal_area_point(direction)), direction), 1e-12);
  }
  EXPECT_NEAR(glm::length(equal_area_point({0.6, 0.8, 0.0})), 1.0, 1e-12);
  // A cap's share of the half-sphere's area is its share of the disc's.
  const double z = 0.7;
  const double radius = glm::length(equal_area_point({std::sqrt(1.0 - z * z), 0.0, z}));
  EXPECT_NEAR(radius * radius, 1.0 - z, 1e-12);
}

TEST(DirectionField, TakesTheValuesOfItsDirections) {
  DirectionField field(10.0);
  EXPECT_TRUE(field.empty());
  EXPECT_EQ(field.at({0, 0, 1}).cover, 0.0);
  field.add({0, 0, 1}, 4.0);
  field.add({1, 0, 0}, 12.0);
  EXPECT_FALSE(field.empty());
  EXPECT_NEAR(field.at({0, 0, 1}).value, 4.0, 0.01);
  EXPECT_NEAR(field.at({1, 0, 0}).value, 12.0, 0.01);
  EXPECT_NEAR(field.at({0, 0, 1}).cover, 1.0, 1e-9);
  EXPECT_EQ(field.at(glm::normalize(glm::dvec3(0, 1, 1))).cover, 0.0);
  const double between = field.at(glm::normalize(glm::dvec3(1, 0, 1))).value;
  EXPECT_NEAR(between, 8.0, 0.2);
}

TEST(DirectionField, CountsOppositesAsOneAcrossTheRim) {
  DirectionField field(20.0);
  field.add(glm::normalize(glm::dvec3(0.2, 0.9, -0.05)), 3.0);
  field.add(glm::normalize(glm::dvec3(0.9, -0.3, 0.3)), 7.0);
  for (const glm::dvec3& direction :
       {glm::dvec3(0.2, 0.9, -0.05), glm::dvec3(0.25, 0.9, 0.02), glm::dvec3(0.8, -0.3, 0.3)}) {
    const glm::dvec3 unit = glm::normalize(direction);
    EXPECT_NEAR(field.at(unit).value, field.at(-unit).value, 1e-9);
    EXPECT_GT(field.at(unit).cover, 0.9);
  }
}

TEST(UndercutScale, IsTheSquareRootAndDarkens) {
  EXPECT_EQ(undercut_scale(5.0, 0.0), 0.0);
  for (const double area : {0.0, 0.3, 17.0}) {
    const double place = undercut_scale(area, 17.0);
    EXPECT_NEAR(place * place * 17.0, area, 1e-12);
  }
  const auto lightness = [](const Colour& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  for (int k = 0; k < 40; ++k) {
    EXPECT_GT(lightness(undercut_scale_colour(k / 40.0)), lightness(undercut_scale_colour((k + 1) / 40.0)))
        << k;
  }
}

}  // namespace
}  // namespace moldlight
