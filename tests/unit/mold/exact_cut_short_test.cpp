// Exact regions cut short: cancelled, or given up once the undercut is above a limit.
#include <chrono>
#include <ctime>
#include <thread>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/box_pile.hpp"
#include "support/exact_model.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

constexpr test::ShapeSettings k_cut_settings{.tau_deg = 1.0, .lateral_tolerance = 0.02};

TriangleMesh large_pile() { return test::subdivided(test::pile_mesh(test::random_pile(3), 3), 200'000); }

TEST(ExactCancelling, AtAnyReportThrows) {
  const TriangleMesh mesh = test::subdivided(test::pile_mesh(test::random_pile(3), 3), 20'000);
  const test::ExactModel model(mesh);
  const FacetGeometry geometry = facet_geometry(mesh);
  const UnitFrame frame = unit_frame(bounds(mesh));
  const ExactQuery query = model.query({0.3, 0.4, 1.0}, k_cut_settings);
  // Reports of a whole run, and whether the run ends when it is cancelled at each but the last.
  const auto expect_cancelled = [](const auto& work) {
    int reports = 0;
    work(Progress([&](std::string_view, double) { ++reports; }));
    EXPECT_GE(reports, 2);
    for (int last = 1; last < reports; ++last) {
      int seen = 0;
      Progress* own = nullptr;
      Progress progress([&](std::string_view, double) {
        if (++seen == last) own->cancel();
      });
      own = &progress;
      EXPECT_THROW(work(progress), Cancelled) << last << " of " << reports;
    }
  };
  expect_cancelled([&](const Progress& progress) { (void)exact_areas(model.part(), query, progress); });
  expect_cancelled([&](const Progress& progress) { (void)exact_split(model.part(), query, progress); });
  expect_cancelled([&](const Progress& progress) { ExactPart(mesh, geometry, frame, progress); });
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW((void)exact_areas(model.part(), query, cancelled), Cancelled);
  EXPECT_THROW((void)exact_split(model.part(), query, cancelled), Cancelled);
  EXPECT_THROW(ExactPart(mesh, geometry, frame, cancelled), Cancelled);
}

TEST(ExactCancelling, InTheMiddleThrowsSoon) {
  const test::ExactModel model(large_pile());
  const ExactQuery query = model.query({0.3, 0.4, 1.0}, k_cut_settings);
  const std::clock_t began = std::clock();
  (void)exact_split(model.part(), query, Progress{});
  const std::clock_t whole = std::clock() - began, again = std::clock();
  Progress progress;
  std::jthread other([&] {
    while (std::clock() - again < whole / 4) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    progress.cancel();
  });
  EXPECT_THROW((void)exact_split(model.part(), query, progress), Cancelled);
  EXPECT_LT(std::clock() - again, whole + CLOCKS_PER_SEC) << "of the processor, somewhat over a quarter";
}

TEST(ExactAreasWithin, IsExactAreasToTheBitOrNothing) {
  for (const test::Shape& shape : {test::cup_with_side_hole({}), test::t_slot({}), test::v_notch({})}) {
    const test::ExactModel model(test::subdivided(shape.mesh, 500));
    const ExactQuery query = model.query(shape.direction, shape.settings);
    const ExactAreas whole = exact_areas(model.part(), query, Progress{});
    std::vector<FacetIndex> reversed(model.mesh().facets.size());
    for (FacetIndex facet = 0; facet < reversed.size(); ++facet)
      reversed[facet] = static_cast<FacetIndex>(reversed.size()) - 1 - facet;
    const double undercut = whole.areas[Region::undercut];
    for (const double limit : {undercut * (1.0 + 1e-9), 1e9}) {
      const auto found = exact_areas_within(model.part(), query, {.undercut = limit, .first = reversed}, {});
      ASSERT_TRUE(found) << shape.name;
      EXPECT_EQ(found->areas.values, whole.areas.values);
      EXPECT_EQ(found->facet_fractions, whole.facet_fractions);
      EXPECT_EQ(found->projected_core, whole.projected_core);
    }
    for (const double limit : {0.0, undercut * 0.5, undercut * (1.0 - 1e-6)}) {
      EXPECT_FALSE(exact_areas_within(model.part(), query, {.undercut = limit, .first = {}}, {}))
          << shape.name;
      EXPECT_FALSE(exact_areas_within(model.part(), query, {.undercut = limit, .first = reversed}, {}))
          << shape.name;
    }
  }
}

}  // namespace
}  // namespace moldlight
