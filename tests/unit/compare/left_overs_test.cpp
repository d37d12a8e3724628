// Which rims of polygons touch, whether these are small or as long as the part.
#include "compare/left_overs.hpp"

#include <ctime>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace moldlight {
namespace {

/// Slivers of this length, in a cube of side 1.
std::vector<ConvexPolygon> slivers(std::size_t count, double length, test::Random& random) {
  std::vector<ConvexPolygon> polygons;
  for (std::size_t k = 0; k < count; ++k) {
    const glm::dvec3 from = random.in_cube(1.0), along = length * random.in_cube(1.0);
    polygons.push_back({from, from + along, from + 0.5 * along + 1e-6 * random.in_cube(1.0)});
  }
  return polygons;
}

std::vector<ReachingPolygon> reaching(const std::vector<ConvexPolygon>& polygons, double reach) {
  std::vector<ReachingPolygon> all;
  for (const ConvexPolygon& polygon : polygons) all.push_back({&polygon, reach});
  return all;
}

TEST(LeftOvers, AreJoinedAsPairByPair) {
  test::Random random(3);
  std::vector<ConvexPolygon> polygons = slivers(300, 1.0, random);
  for (const ConvexPolygon& small : slivers(700, 0.02, random)) polygons.push_back(small);
  polygons.emplace_back();
  for (const double reach : {0.0, 0.0005, 0.003}) {
    UnionFind joined = joined_where_touching(reaching(polygons, reach), Progress()),
              expected(polygons.size());
    for (std::uint32_t a = 0; a < polygons.size(); ++a)
      for (std::uint32_t b = a + 1; b < polygons.size(); ++b)
        if (rims_touch(polygons[a], polygons[b], 2.0 * reach)) expected.join(a, b);
    for (std::uint32_t k = 0; k < polygons.size(); ++k) ASSERT_EQ(joined.find(k), expected.find(k)) << reach;
  }
}

/// Boxes around needles as long as the part overlap nearly all.
TEST(LeftOvers, AsLongAsThePartAreJoinedNearlyAsSoonAsShortOnes) {
  const auto seconds = [](double length) {
    test::Random random(5);
    const std::vector<ConvexPolygon> polygons = slivers(10'000, length, random);
    const std::clock_t began = std::clock();
    static_cast<void>(joined_where_touching(reaching(polygons, 1e-4), Progress()));
    return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  };
  EXPECT_LT(seconds(1.0), 20.0 * seconds(0.02) + 0.5) << "of the processor";
}

}  // namespace
}  // namespace moldlight
