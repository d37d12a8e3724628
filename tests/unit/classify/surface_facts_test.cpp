// What is measured between two places.
#include "classify/surface_facts.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace moldlight {
namespace {

TEST(Measured, TellsTheWayAlongAndAcrossTheDirection) {
  const MeasuredPair pair =
      measured({{1, 2, 3}, {0, 0, 1}}, {{4, 6, 15}, glm::normalize(glm::dvec3(1, 0, 1))}, {0, 0, -1});
  EXPECT_DOUBLE_EQ(pair.distance, 13.0);
  EXPECT_DOUBLE_EQ(pair.along, 12.0);
  EXPECT_DOUBLE_EQ(pair.across, 5.0);
  EXPECT_NEAR(pair.angle_deg, 45.0, 1e-12);
  EXPECT_FALSE(pair.between_planes);
}

TEST(Measured, KnowsParallelPlanes) {
  for (const double sense : {1.0, -1.0}) {
    const MeasuredPair pair = measured({{0, 0, 0}, {0, 1, 0}}, {{5, 2.5, 9}, {0, sense, 0}}, {0, 0, 1});
    EXPECT_NEAR(pair.angle_deg, sense > 0.0 ? 0.0 : 180.0, 1e-12);
    ASSERT_TRUE(pair.between_planes);
    EXPECT_DOUBLE_EQ(*pair.between_planes, 2.5);
  }
}

}  // namespace
}  // namespace moldlight
