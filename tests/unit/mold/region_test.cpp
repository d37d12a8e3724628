#include "mold/region.hpp"

#include <gtest/gtest.h>

namespace moldlight {
namespace {

TEST(Region, FollowsFromAccessibility) {
  EXPECT_EQ(region_of(true, false), Region::core);
  EXPECT_EQ(region_of(false, true), Region::cavity);
  EXPECT_EQ(region_of(true, true), Region::both);
  EXPECT_EQ(region_of(false, false), Region::undercut);
}

TEST(Region, ColoursDifferInEveryPalette) {
  for (const Palette palette : {Palette::paper, Palette::colour_blind_safe}) {
    for (const Region a : k_regions) {
      for (const Region b : k_regions) {
        if (a == b) continue;
        const Colour ca = region_colour(a, palette), cb = region_colour(b, palette);
        EXPECT_GT(std::abs(ca.r - cb.r) + std::abs(ca.g - cb.g) + std::abs(ca.b - cb.b), 60);
      }
    }
  }
}

}  // namespace
}  // namespace moldlight
