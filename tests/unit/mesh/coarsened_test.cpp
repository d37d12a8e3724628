// Fewer facets of the same shape.
#include "mesh/coarsened.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <string_view>
#include <tuple>

#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "support/boxes.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

HealthReport health_of(const TriangleMesh& mesh) { return health_report(mesh, facet_geometry(mesh)); }

TEST(Coarsened, PlanesLoseTheirFacetsAtNoCost) {
  for (const test::Shape& shape : {test::cup_with_side_hole({}), test::box_shape({}), test::t_slot({})}) {
    const TriangleMesh fine = test::refined(shape, 4000).mesh;
    const TriangleMesh coarse = coarsened(fine, fine.facets.size() / 8, Progress());
    EXPECT_LE(coarse.facets.size(), fine.facets.size() / 8) << shape.name;
    const HealthReport before = health_of(fine), after = health_of(coarse);
    EXPECT_TRUE(after.closed) << shape.name;
    EXPECT_EQ(after.degenerate_facets, 0U) << shape.name;
    EXPECT_NEAR(after.volume, before.volume, 1e-9 * before.volume) << shape.name;
    EXPECT_NEAR(after.area, before.area, 1e-9 * before.area) << shape.name;
  }
}

TEST(Coarsened, RoundShapesKeepTheirsNearlyAndTheirVerticesWhereTheyAre) {
  const TriangleMesh fine = test::hollow_sphere({}).mesh;
  const TriangleMesh coarse = coarsened(fine, fine.facets.size() / 4, Progress());
  EXPECT_LE(coarse.facets.size(), fine.facets.size() / 4);
  EXPECT_GT(coarse.facets.size(), fine.facets.size() / 5);
  EXPECT_TRUE(health_of(coarse).closed);
  EXPECT_NEAR(health_of(coarse).volume, health_of(fine).volume, 0.07 * health_of(fine).volume);
  const auto in_order = [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  const std::set<glm::dvec3, decltype(in_order)> known(fine.vertices.begin(), fine.vertices.end());
  EXPECT_TRUE(std::ranges::all_of(coarse.vertices, [&](const auto& at) { return known.contains(at); }));
}

TEST(Coarsened, NothingBecomesFewerThanItCanBe) {
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
  EXPECT_EQ(coarsened(box, 12, Progress()).facets, box.facets) << "as it is";
  const TriangleMesh least = coarsened(box, 1, Progress());
  EXPECT_GE(least.facets.size(), 4U);
  EXPECT_TRUE(health_of(least).closed);
}

TEST(Coarsened, BordersAndEdgesOfThreeFacetsStay) {
  // Without its last facets it is open; with one of them twice more, three meet at its edges.
  TriangleMesh mesh = test::refined(test::box_shape({}), 2000).mesh;
  mesh.facets.resize(mesh.facets.size() - 40);
  const auto twice = mesh.facets.front();
  mesh.facets.push_back(twice);
  const HealthReport before = health_of(mesh);
  ASSERT_GT(before.open_edges, 0U);
  ASSERT_GT(before.nonmanifold_edges, 0U);
  const TriangleMesh coarse = coarsened(mesh, mesh.facets.size() / 4, Progress());
  EXPECT_LE(coarse.facets.size(), mesh.facets.size() / 4);
  const HealthReport after = health_of(coarse);
  EXPECT_EQ(after.open_edges, before.open_edges);
  EXPECT_EQ(after.nonmanifold_edges, before.nonmanifold_edges);
  EXPECT_NEAR(after.area, before.area, 1e-9 * before.area);
}

TEST(Coarsened, TellsHowFarItIsAndCanBeCancelledThere) {
  const TriangleMesh fine = test::refined(test::ring({}), 20'000).mesh;
  for (const double until : {0.0, 0.5, 2.0}) {
    double last = -1.0;
    std::unique_ptr<Progress> progress;
    progress = std::make_unique<Progress>([&](std::string_view, double fraction) {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1.0);
      last = fraction;
      if (fraction >= until) progress->cancel();
    });
    if (until < 1.0) {
      EXPECT_THROW(static_cast<void>(coarsened(fine, 2000, *progress)), Cancelled);
      EXPECT_LT(last, until + 0.2);
    } else {
      EXPECT_LE(coarsened(fine, 2000, *progress).facets.size(), 2000U);
      EXPECT_GT(last, 0.8);
    }
  }
}

}  // namespace
}  // namespace moldlight
