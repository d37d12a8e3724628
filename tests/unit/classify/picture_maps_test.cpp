// Maps of a direction that moves: coarser, with the same lengths.
#include "classify/picture_maps.hpp"

#include <gtest/gtest.h>

#include "classify/classifier.hpp"

namespace moldlight {
namespace {

TEST(MovingMethod, KeepTheLengthsOfTheFullOnes) {
  constexpr double k_diagonal = 73.0;
  MethodSettings full;
  full.resolution = 4096;
  full.kernel = 7;
  const MethodSettings live = moving_method(full, k_diagonal);
  EXPECT_EQ(live.resolution, 1024);
  const MapSettings fine = map_settings(full, k_diagonal), coarse = map_settings(live, k_diagonal);
  EXPECT_DOUBLE_EQ(coarse.lateral, fine.lateral);
  EXPECT_DOUBLE_EQ(coarse.edge_thickness / coarse.resolution, fine.edge_thickness / fine.resolution);
}

TEST(MovingMethod, LookBesideWallsByTheirOwnTexelsAtLeast) {
  MethodSettings full;
  EXPECT_DOUBLE_EQ(moving_method(full, 10.0).tolerance, 0.71 * 10.0 / 1024.0);
  full.tolerance = 0.25;
  EXPECT_EQ(moving_method(full, 10.0).tolerance, 0.25);
  full.tolerance = 0.0;
  full.kernel_shape = KernelShape::symmetric;
  EXPECT_EQ(moving_method(full, 10.0).kernel, full.kernel);
  EXPECT_EQ(moving_method(full, 10.0).tolerance, 0.0) << "a symmetric kernel is made of texels";
}

}  // namespace
}  // namespace moldlight
