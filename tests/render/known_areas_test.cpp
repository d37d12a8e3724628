// Region areas of our own shapes against their formulas, at default settings.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

constexpr double k_region_bound = 0.005;    // of the part's area
constexpr double k_undercut_bound = 0.001;  // of the part's area
constexpr double k_least_covered = 0.95;    // share of shapes whose error the stated uncertainty covers
constexpr double k_rounding = 1e-6;         // of the part's area: single precision

class KnownAreas : public testing::TestWithParam<test::ShapeSettings> {};

TEST_P(KnownAreas, AreMet) {
  const std::vector<test::Shape> shapes = test::all_shapes(GetParam());
  ASSERT_GE(shapes.size(), 24U);
  std::size_t covered = 0;
  double worst_undercut = 0.0, worst_region = 0.0;
  std::string worst_name;
  for (const test::Shape& shape : shapes) {
    MethodSettings settings;
    settings.direction = shape.direction;
    settings.tau_deg = shape.settings.tau_deg;
    settings.tolerance = shape.settings.lateral_tolerance;
    const Classification result = test::classify_mesh(shape.mesh, settings);
    const double undercut_off = std::abs(result.areas[Region::undercut] - shape.expected[Region::undercut]);
    const double region_off = test::worst_region_error(result, shape.expected);
    EXPECT_LE(region_off, k_region_bound) << shape.name;
    EXPECT_LE(undercut_off, k_undercut_bound * result.total_area) << shape.name;
    EXPECT_NEAR(result.areas.total(), result.total_area, 1e-9 * result.total_area) << shape.name;
    EXPECT_TRUE(result.projected.agrees()) << shape.name << " gap " << result.projected.gap;
    covered += undercut_off <= result.uncertainty.total + k_rounding * result.total_area ? 1 : 0;
    worst_region = std::max(worst_region, region_off);
    if (undercut_off > worst_undercut * result.total_area) {
      worst_undercut = undercut_off / result.total_area;
      worst_name = shape.name;
    }
  }
  std::printf("%zu shapes, %zu covered; worst region %.4f %%, worst undercut %.4f %% (%s)\n", shapes.size(),
              covered, 100 * worst_region, 100 * worst_undercut, worst_name.c_str());
  EXPECT_GE(static_cast<double>(covered), k_least_covered * static_cast<double>(shapes.size()));
}

INSTANTIATE_TEST_SUITE_P(Tolerances, KnownAreas,
                         testing::Values(test::ShapeSettings{.tau_deg = 1.0, .lateral_tolerance = 0.02},
                                         test::ShapeSettings{.tau_deg = 2.0, .lateral_tolerance = 0.1}));

}  // namespace
}  // namespace moldlight
