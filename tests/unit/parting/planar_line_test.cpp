#include "parting/planar_line.hpp"

#include <cmath>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "parting/make_halves.hpp"
#include "support/classify_mesh.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

/// A block from the origin with a tab on its +x wall between two heights.
TriangleMesh block_with_tab(const glm::dvec3& size, double low, double high) {
  const glm::dvec3 tab_low(size.x, 0.4 * size.y, low), tab_high(size.x + 3.0, 0.6 * size.y, high);
  test::SolidBuilder solid;
  solid.box({0, 0, 0}, size, {1});
  solid.face(test::box_face({0, 0, 0}, size, 1), {test::box_face(tab_low, {size.x, tab_high.y, high}, 1)});
  solid.box(tab_low, tab_high, {0});
  return solid.mesh();
}

MoldLine line_of(const TriangleMesh& mesh, double worth_pct) {
  MoldSettings settings;
  settings.planar_worth_pct = worth_pct;
  return find_mold_line(*test::model_of(mesh), {glm::dvec3(0, 0, 1), {}}, settings, Progress{});
}

double climb(const PartingLine& line) { return line.outer_high - line.outer_low; }

/// Both ends of the tab are as good: the line of a long post need not go to one of the post's.
TEST(PlanarLine, RunsRoundAPostAtItsTab) {
  const TriangleMesh post = block_with_tab({10, 10, 60}, 27, 33);
  const Assignment along_edges =
      assign_sides(*test::model_of(post), {glm::dvec3(0, 0, 1), {}}, {}, Progress{});
  EXPECT_GT(climb(parting_line(along_edges)), 26.0);
  for (const double worth_pct : {0.0, 50.0}) {
    const MoldLine found = line_of(post, worth_pct);
    EXPECT_LT(climb(found.line), 1e-9);
    EXPECT_NEAR(std::abs(found.line.outer_low - 30.0), 3.0, 1e-9);
    EXPECT_LT(found.assignment.energy, along_edges.energy);
    EXPECT_TRUE(found.line.euler.accounted());
    double area = 0.0;
    for (const MoldSide side : k_mold_sides) area += found.assignment.area(side);
    EXPECT_NEAR(area, 2600.0 + 6.0 * 3.0 * 2.0 + 2.0 * 3.0 * 2.0, 1e-9);
  }
}

/// A slide's pin may stand on the plane: the line is broken at both of its mouths, not stepped round them.
TEST(PlanarLine, RunsIntoAHoleThatASlideForms) {
  const glm::dvec3 size(10, 10, 60), tab_low(10, 4, 27), tab_high(13, 6, 33);
  const glm::dvec3 hole_low(3, 0, 24), hole_high(7, 10, 36);
  test::SolidBuilder solid;
  solid.box({0, 0, 0}, size, {1, 2, 3});
  solid.face(test::box_face({0, 0, 0}, size, 1), {test::box_face(tab_low, {10, 6, 33}, 1)});
  solid.box(tab_low, tab_high, {0});
  for (const int wall : {2, 3})
    solid.face(test::box_face({0, 0, 0}, size, wall), {test::box_face(hole_low, hole_high, wall)});
  solid.box(hole_low, hole_high, {2, 3}, true);
  const MoldLine found = line_of(solid.mesh(), 50.0);
  EXPECT_LT(climb(found.line), 1e-9);
  EXPECT_NEAR(std::abs(found.line.outer_low - 30.0), 3.0, 1e-9) << "at the tab";
  EXPECT_EQ(found.line.loops.front().breaks, 2U);
  EXPECT_GT(found.assignment.area(MoldSide::action), 0.0);
}

TEST(PlanarLine, LeavesAnEdgeForWhatItIsWorthAlone) {
  const TriangleMesh block = block_with_tab({40, 30, 30}, 20, 26);
  EXPECT_NEAR(climb(line_of(block, 0.0).line), 4.0, 1e-9) << "from the upper edge to the tab";
  EXPECT_NEAR(climb(line_of(block, 50.0).line), 4.0, 1e-9);
  const MoldLine planar = line_of(block, 200.0);
  EXPECT_LT(climb(planar.line), 1e-9);
  EXPECT_NEAR(std::abs(planar.line.outer_low - 23.0), 3.0, 1e-9);
}

/// Its corners are a little off the middle, so that a line along edges is higher on one side. A facet that
/// leans by 3 degrees beside the middle is a hair beyond it.
TEST(PlanarLine, OfARoundBarDoesNotStepFromCornerToCorner) {
  constexpr int k_corners = 62;
  constexpr double k_radius = 10.0, k_off_deg = 1.0;
  test::SolidBuilder solid;
  solid.extrude(test::regular_polygon(k_corners, k_radius, k_off_deg), {}, 20.0);
  const TriangleMesh bar = solid.mesh();
  const auto model = test::model_of(bar);
  const double off = 2.0 * k_radius * std::sin(glm::radians(k_off_deg));
  EXPECT_GT(climb(parting_line(assign_sides(*model, {glm::dvec3(0, 0, 1), {}}, {}, Progress{}))), 0.99 * off);

  const MoldLine found = line_of(bar, 50.0);
  EXPECT_LT(climb(found.line), 1e-9);
  EXPECT_NEAR(found.line.outer_low, 0.0, 1e-9) << "at the middle";
  EXPECT_GT(found.assignment.reverse_draft_area, 0.0);
  const MoldHalves halves = make_halves(*model, {0, 0, 1}, meeting_place(found), {}, Progress{});
  ASSERT_TRUE(halves.certified()) << halves.refusal;
  EXPECT_NEAR(halves.surface.shelf_share(), 1.0, 1e-12);
}

TEST(PlanarLine, StaysAtTheHeightThatIsGiven) {
  MoldSettings settings;
  settings.parting_height = 10.0;
  settings.planar_worth_pct = 1000.0;
  const auto model = test::model_of(block_with_tab({40, 30, 30}, 20, 26));
  EXPECT_NEAR(find_mold_line(*model, {glm::dvec3(0, 0, 1), {}}, settings, Progress{}).line.outer_low, 10.0,
              1e-9);
}

}  // namespace
}  // namespace moldlight
