// Sheets over a plane whose ends come to stand in columns.
#include "parting/halves/sheets.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace moldlight {
namespace {

/// A square of this half width about the origin, of two facets.
void add_square(Sheets& sheets, Sheet sheet, double half, double z) {
  const auto first = static_cast<SheetVertex>(sheets.vertices.size());
  for (const glm::dvec2& at : {glm::dvec2(-half, -half), {half, -half}, {half, half}, {-half, half}})
    sheets.vertices.emplace_back(at, z);
  sheets.column_of.resize(sheets.vertices.size(), k_no_plane_point);
  for (const std::array<SheetVertex, 3>& c : {std::array<SheetVertex, 3>{0, 1, 2}, {0, 2, 3}}) {
    const SheetVertex a = first + c[0], b = first + c[1], d = first + c[2];
    sheets.facets.push_back({sheet == Sheet::lower ? std::array{a, d, b} : std::array{a, b, d}, sheet});
  }
}

/// A block whose walls lean by rounding: they become upright, and it keeps its volume.
TEST(Sheets, KeepTheVolumeOfWallsThatBecomeUpright) {
  constexpr double k_lean = 4e-8;
  Sheets sheets;
  add_square(sheets, Sheet::upper, 0.5 + k_lean, 1.0);
  add_square(sheets, Sheet::lower, 0.5, 0.0);
  const double wide = 1.0 + 2.0 * k_lean, frustum = (wide * wide + wide + 1.0) / 3.0;
  ASSERT_FALSE(sheets.align_ends(1e-7).has_value());
  ASSERT_EQ(sheets.columns.size(), 4U);
  const double off = std::abs(sheets.volume() - frustum);
  EXPECT_GT(off, 1e-8) << "one of the outlines was taken for both";
  Sheets kept = sheets;
  kept.keep_volume(frustum, 1e-6);
  const double half_moved = 0.5 * sheets.moved[0];
  EXPECT_NEAR(kept.volume(), frustum, 1e-12);
  for (PlanePoint column = 0; column < 4; ++column)
    EXPECT_LE(glm::distance(kept.columns[column], sheets.columns[column]), half_moved + 1e-13);
  Sheets same = sheets;
  same.keep_volume(frustum, 0.1 * off);
  EXPECT_EQ(same.volume(), sheets.volume()) << "more than rounding is not made good";
}

}  // namespace
}  // namespace moldlight
