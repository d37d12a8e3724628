// Shelf, land and ramps against their definition.
#include "parting/halves/shelf_field.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "parting/make_halves.hpp"
#include "support/box_pile.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "unit/parting/certified_halves.hpp"

namespace moldlight {
namespace {

/// A square of one, the surface around it, each side between its own heights.
std::vector<RimSegment> square(const std::array<HeightRange, 4>& sides) {
  const std::array<glm::dvec2, 4> corners = {glm::dvec2(0, 0), {0, 1}, {1, 1}, {1, 0}};
  std::vector<RimSegment> rims;
  for (std::size_t k = 0; k < 4; ++k)
    rims.push_back({{corners[k], corners[(k + 1) % 4]}, {sides[k], sides[k]}});
  return rims;
}

TEST(ShelfLevel, MeetsMostOfTheOutline) {
  const std::vector<double> no_line(4, NAN);
  EXPECT_EQ(shelf_level(square({{{0, 2}, {1, 3}, {1.5, 4}, {0, 5}}}), no_line, 1.75), 1.75);
  EXPECT_EQ(shelf_level(square({{{0, 2}, {1, 3}, {1.5, 4}, {0, 5}}}), no_line, 9.0), 2.0);
  EXPECT_EQ(shelf_level(square({{{0, 2}, {1, 3}, {1.5, 4}, {7, 8}}}), no_line, 9.0), 2.0);
  // Of levels that meet as much, the line's.
  EXPECT_EQ(shelf_level(square({{{0, 2}, {0, 2}, {0, 2}, {0, 2}}}), {1.2, 1.2, 1.2, NAN}, 0.5), 1.2);
}

TEST(ShelfField, IsAPlaneWhereALevelMeetsAll) {
  const auto rims = square({{{0, 2}, {1, 3}, {1.5, 4}, {0, 5}}});
  EXPECT_TRUE(ShelfField(rims, {.height = 1.75}, {}).plane());
  EXPECT_FALSE(ShelfField(rims, {.height = 1.0}, {}).plane());
}

TEST(ShelfField, HasLandThenARampThenTheShelf) {
  const ShelfShape shape{.ramp = 0.5, .slope = 2.0, .land = 0.1};
  for (const double sign : {1.0, -1.0}) {
    // The side at x = 1 is 0.2 off the shelf.
    const HeightRange level{0, 0}, off{0.2 * sign, 0.2 * sign};
    const ShelfField field(square({level, level, off, level}), {}, shape);
    for (const auto& [beside, height] :
         {std::pair{0.0, 0.2}, {0.05, 0.2}, {0.1, 0.2}, {0.2, 0.15}, {0.4, 0.05}, {0.5, 0.0}, {0.7, 0.0}})
      EXPECT_NEAR(field.at({1.0 + beside, 0.5}), sign * height, 1e-12);
    // Beside the sides that are level it is held to them.
    EXPECT_NEAR(field.at({0.7, 0.0}), 0.0, 1e-12);
    EXPECT_NEAR(field.at({0.95, -0.05}), sign * 0.1, 1e-12);  // twice as steep as its way from there
    EXPECT_NEAR(field.at({-0.5, 0.5}), 0.0, 1e-12);
  }
}

TEST(ShelfField, IsNowhereSteeperThanAsked) {
  const ShelfShape shape{.ramp = 0.5, .slope = 2.0, .land = 0.1};
  const ShelfField field(square({HeightRange{0, 0}, {0.1, 0.3}, {0.4, 0.6}, {-0.5, -0.2}}), {}, shape);
  for (int k = 0; k < 400; ++k) {
    const double x = -0.5 + 0.005 * k;
    for (const double y : {-0.3, -0.02, 1.01, 1.2}) {
      EXPECT_LE(std::abs(field.at({x + 0.005, y}) - field.at({x, y})), 0.005 * (2.0 + 0.5) + 1e-12);
    }
  }
}

TEST(PartingSurface, HasAShelfAndAFlatEdge) {
  // A sheet that is level but for one side, which climbs by 17 degrees.
  const TriangleMesh sheet =
      test::sheet_mesh(96, 10.0, 0.5, [](double x, double) { return 0.3 * std::max(0.0, x - 4.0); });
  const MoldHalves halves = make_halves(*test::model_of(sheet), {0, 0, 1}, {.height = 0.2}, {}, Progress{});
  test::expect_certified(halves, "bent sheet", &sheet);
  EXPECT_NEAR(halves.surface.rim_high - halves.surface.rim_low, 0.0, 1e-9);
  EXPECT_GE(halves.surface.shelf_share(), 0.6);
  EXPECT_GE(halves.surface.shelf_height, -0.01);
  EXPECT_LE(halves.surface.shelf_height, 0.51);
  EXPECT_NEAR(halves.surface.high, 0.3 * 6.0, 0.1);
  EXPECT_NEAR(halves.contact_area, 0.0, 1e-9);
  // The ramp ends within the block.
  EXPECT_GE(halves.margin, (halves.surface.high - halves.surface.shelf_height) / std::tan(M_PI / 6.0) - 0.1);
}

/// A ledge around a corner of a plate is steeper than the surface may be. That costs the level surface around
/// the part nothing.
TEST(ShelfField, StaysLevelWhereTheOutlineIsTooSteep) {
  test::BoxPile pile{.planes = {{{0, 16, 20, 60}, {0, 30, 34, 40}, {0, 4, 12, 16}}}, .filled = {}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        const bool beside = i == 0 || j == 2;
        pile.filled.push_back(beside ? k == 2 : k == 0 || i == 1 || j == 1);
      }
    }
  }
  const TriangleMesh mesh = test::pile_mesh(pile, 1);
  const MoldHalves halves = make_halves(*test::model_of(mesh), {0, 0, 1}, {4.0}, {}, Progress{});
  test::expect_certified(halves, "ledge", &mesh);
  EXPECT_GT(halves.forced_deg, 60.0);
  EXPECT_GT(halves.surface.shelf_share(), 0.25);
}

}  // namespace
}  // namespace moldlight
