// Region areas of our own shapes against their formulas, at default settings.
#include <cstdio>

#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

// Of the part's area: what rounding leaves of coordinates that were turned and of the formulas.
constexpr double k_bound = 1e-11;
constexpr double k_stated_bound = 1e-8;

class KnownAreas : public testing::TestWithParam<test::ShapeSettings> {};

TEST_P(KnownAreas, AreMet) {
  const std::vector<test::Shape> shapes = test::all_shapes(GetParam());
  ASSERT_GE(shapes.size(), 24U);
  double worst = 0.0, worst_stated = 0.0;
  for (const test::Shape& shape : shapes) {
    Query query;
    query.direction = shape.direction;
    query.method.tau_deg = shape.settings.tau_deg;
    query.method.tolerance = shape.settings.lateral_tolerance;
    const Classification result = test::classify_mesh(shape.mesh, query);
    const double off = test::worst_region_error(result, shape.expected);
    EXPECT_LE(off, k_bound) << shape.name;
    EXPECT_LE(off * result.total_area, result.uncertainty.total()) << shape.name;
    EXPECT_LE(result.uncertainty.total(), k_stated_bound * result.total_area) << shape.name;
    EXPECT_NEAR(result.areas.total(), result.total_area, 1e-12 * result.total_area) << shape.name;
    EXPECT_TRUE(result.identity.agrees()) << shape.name << " gap " << result.identity.gap;
    worst = std::max(worst, off);
    worst_stated = std::max(worst_stated, result.uncertainty.total() / result.total_area);
  }
  std::printf("%zu shapes; worst region off by %.1e of the area, stated %.1e at most\n", shapes.size(), worst,
              worst_stated);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, KnownAreas,
                         testing::Values(test::ShapeSettings{.tau_deg = 1.0, .lateral_tolerance = 0.02},
                                         test::ShapeSettings{.tau_deg = 2.0, .lateral_tolerance = 0.1}));

}  // namespace
}  // namespace moldlight
