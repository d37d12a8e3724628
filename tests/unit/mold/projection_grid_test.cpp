#include "mold/exact/projection_grid.hpp"

#include <array>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace moldlight {
namespace {

/// How often a grid over so many segments, from anywhere to anywhere in a box so wide, names one of them.
std::size_t entries_of_long_segments(std::size_t count, double width) {
  test::Random random(11);
  const auto place = [&] { return glm::dvec2(random.in_cube(0.5)) * glm::dvec2(width, 1.0); };
  std::vector<std::array<glm::dvec2, 2>> segments(count);
  for (auto& [from, to] : segments) {
    from = place();
    to = place();
  }
  std::vector<std::uint32_t> all(count);
  std::iota(all.begin(), all.end(), 0U);
  ProjectionGrid grid;
  grid.fill({glm::dvec2(-0.5 * width, -0.5), glm::dvec2(0.5 * width, 0.5)}, 2.0 * static_cast<double>(count),
            all, [&](std::uint32_t k, glm::dvec2* corners) {
              corners[0] = segments[k][0];
              corners[1] = segments[k][1];
              return std::size_t{2};
            });
  return grid.count_items(std::array{glm::dvec2(-2, -2), glm::dvec2(4, -2), glm::dvec2(-2, 4)});
}

TEST(ProjectionGrid, OfItemsAsLongAsThePartTakesTheRoomOfFewCellsEach) {
  constexpr std::size_t k_few = 20, k_always = 250'000;
  EXPECT_LT(entries_of_long_segments(20'000, 1.0), 20'000 * k_few + k_always);
  EXPECT_GT(entries_of_long_segments(500, 1.0), 500 * k_few / 2);  // of a few no cell is larger
}

TEST(ProjectionGrid, OfASheetSeenEdgeOnIsFilledAtAll) {
  for (const double width : {1e-6, 1e-12, 0.0}) EXPECT_GT(entries_of_long_segments(20'000, width), 0U);
}

}  // namespace
}  // namespace moldlight
