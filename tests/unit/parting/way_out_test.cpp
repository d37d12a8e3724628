#include <gtest/gtest.h>

#include "parting/slide_blank.hpp"
#include "support/boxes.hpp"

namespace moldlight {
namespace {

/// A wall 2 ahead, and 0.02 of it beside the piece's side all along.
TEST(WayOut, IsMeasuredAsFarAsAPieceGoesAndBesideRims) {
  const TriangleMesh piece = test::box_mesh({0, 0, 0}, {1, 1, 1}),
                     wall = test::box_mesh({3, 0, 0}, {4, 1, 1}),
                     rim = test::box_mesh({1, 0.98, -1}, {4, 2, 2});
  EXPECT_NEAR(way_out(piece, wall, {1, 0, 0}).blocked, 1.0, 1e-9);
  EXPECT_EQ(way_out(piece, wall, {1, 0, 0}, 1.5).blocked, 0.0);
  EXPECT_NEAR(way_out(piece, wall, {1, 0, 0}, 2.25).blocked, 0.25, 1e-9);
  EXPECT_NEAR(way_out(piece, wall, {1, 0, 0}, 2.25).place.x, 3.0, 1e-9);
  EXPECT_EQ(way_out(piece, wall, {-1, 0, 0}, 2.25).blocked, 0.0);
  EXPECT_NEAR(way_out(piece, rim, {1, 0, 0}).blocked, 1.0, 1e-9);
  EXPECT_EQ(way_out(piece, rim, {1, 0, 0}, INFINITY, 0.03).blocked, 0.0);
  EXPECT_NEAR(way_out(piece, rim, {1, 0, 0}, INFINITY, 0.005).blocked, 1.0, 1e-9);
}

}  // namespace
}  // namespace moldlight
