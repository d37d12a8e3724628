// Steel to cut and to add by formulas: what came and what went, each for itself, and who has the steel.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "compare/comparison.hpp"
#include "compare/mold_change.hpp"
#include "mesh/health.hpp"
#include "support/boxes.hpp"
#include "support/curved_solids.hpp"
#include "unit/compare/revisions.hpp"

namespace moldlight {
namespace {

struct Steel {
  SurfaceChange change;
  std::vector<PlaceSteel> places;
  LineChange line;

  /// Less what is to add.
  [[nodiscard]] double cut_less_add() const {
    double sum = 0.0;
    for (const PlaceSteel& place : places)
      sum += (place.cut ? place.cut->volume.volume : 0.0) - (place.add ? place.add->volume.volume : 0.0);
    return sum;
  }
};

Steel steel_of(const TriangleMesh& a, const TriangleMesh& b) {
  Laid pair = laid(a, b);
  const OverlaySide side_a(pair.a, pair.a_result), side_b(pair.b, pair.b_result);
  const glm::dvec3 up(0, 0, 1);
  const Query query{up, pair.a_result.settings};
  const Assignment of_a = assign_sides(*pair.a, query, {}, Progress()),
                   of_b = assign_sides(*pair.b, query, {}, Progress());
  Steel steel{.change = pair.change, .places = {}, .line = {}};
  steel.places = find_steel({side_a, of_a}, {side_b, of_b}, pair.change, Progress());
  steel.line = find_line_change(parting_line(of_a), parting_line(of_b), 1e-3, pair.a->frame.diagonal);
  return steel;
}

double exact(double value) { return 1e-9 * std::abs(value); }

/// Where regions are sampled there is no line that steel could move at, and the comparison says so.
TEST(SteelChange, IsNotAskedForWhereRegionsAreSampled) {
  const auto model_of = [](double rib) {
    Part part;
    part.mesh = plate_mesh({.rib = rib});
    part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
    part.effort = 1e-9;
    return prepare_part(std::move(part), Progress());
  };
  const Comparison found = compare_revisions(
      model_of(2.0), model_of(3.0),
      {.choice = CompareDirection::given, .direction = {}, .method = {}, .settings = {}}, Progress());
  ASSERT_GT(found.a.result.uncertainty.sampled_facets, 0U);
  EXPECT_FALSE(found.mold);
  EXPECT_EQ(std::ranges::count(
                found.remarks,
                "Whether A's mold survives is not known, since too many facets of a part cross others"),
            1);
  EXPECT_EQ(found.surface.places.size(), 1U);
}

/// A has no side action; those of B's mold form the bore of the tube.
TEST(SteelChange, OfABodyOfItsOwnIsNamedByItsOwnMold) {
  const auto model_of = [](TriangleMesh mesh) {
    Part part;
    part.mesh = std::move(mesh);
    part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
    return prepare_part(std::move(part), Progress());
  };
  const TriangleMesh box = test::box_mesh({0, 0, 0}, {20, 20, 20});
  const TriangleMesh tube = test::tube_mesh(
      {.centres = {{60, 0, 0}, {60, 0, 20}}, .radius = 8.0, .inner_radius = 4.0, .normal = {1, 0, 0}});
  const Comparison found = compare_revisions(
      model_of(box), model_of(test::joined(box, tube)),
      {.choice = CompareDirection::given, .direction = glm::dvec3(1, 0, 0), .method = {}, .settings = {}},
      Progress());
  ASSERT_TRUE(found.a.plan->actions.empty());
  ASSERT_FALSE(found.b.plan->actions.empty());
  ASSERT_TRUE(found.mold && found.mold->places.size() == 1U && found.mold->places.front().cut);
  const SteelChange& cut = *found.mold->places.front().cut;
  for (const OwnedArea& one : cut.of) EXPECT_TRUE(one.owner.of_b);
  EXPECT_NE(steel_of_text(found, cut).find(action_title(*found.b.plan, 0)), std::string::npos)
      << steel_of_text(found, cut);
}

TEST(SteelChange, CutsWhereARibGrows) {
  const TriangleMesh a = plate_mesh({.rib = 2.0}), b = plate_mesh({.rib = 3.0});
  const Steel steel = steel_of(a, b);
  ASSERT_EQ(steel.places.size(), 1U);
  const PlaceSteel& place = steel.places.front();
  ASSERT_TRUE(place.cut);
  EXPECT_FALSE(place.add);
  const double came = 1.0 * 6.0 * k_rib_height;
  EXPECT_NEAR(place.cut->volume.volume, came, exact(came));
  EXPECT_LT(place.cut->volume.error, 1e-6 * came);
  EXPECT_NEAR(place.cut->depth, k_rib_height, 1e-9);
  EXPECT_NEAR(glm::distance(place.cut->centre, glm::dvec3(2.5, 7.0, k_plate_high.z + 0.5 * k_rib_height)),
              0.0, 1e-2);
  // The end wall, the top and both flanks of what came.
  EXPECT_NEAR(place.cut->area, 6.0 * k_rib_height + 6.0 + 2.0 * k_rib_height, 0.1);
  ASSERT_EQ(place.cut->of.size(), 1U);
  EXPECT_EQ(place.cut->of.front().owner.side, MoldSide::core);
  EXPECT_TRUE(steel.line.added.empty());
  EXPECT_TRUE(steel.line.gone.empty());
}

TEST(SteelChange, AddsWhereItShrinksByAsMuch) {
  const TriangleMesh a = plate_mesh({.rib = 2.0}), b = plate_mesh({.rib = 3.0});
  const Steel forth = steel_of(a, b), back = steel_of(b, a);
  ASSERT_EQ(back.places.size(), 1U);
  EXPECT_FALSE(back.places.front().cut);
  ASSERT_TRUE(back.places.front().add);
  const SteelChange &cut = *forth.places.front().cut, &add = *back.places.front().add;
  EXPECT_NEAR(add.volume.volume, cut.volume.volume, exact(cut.volume.volume));
  EXPECT_NEAR(glm::distance(add.centre, cut.centre), 0.0, 1e-9);
  EXPECT_EQ(add.of.front().owner.side, cut.of.front().owner.side);
  EXPECT_FALSE(cut.of.front().owner.of_b);
  EXPECT_TRUE(add.of.front().owner.of_b);
  EXPECT_NEAR(add.depth, cut.depth, 1e-9);
}

TEST(SteelChange, AddsToThePinOfAHoleThatGrows) {
  const TriangleMesh a = plate_mesh({.hole_radius = 3.0}), b = plate_mesh({.hole_radius = 3.5});
  const Steel steel = steel_of(a, b);
  ASSERT_EQ(steel.places.size(), 1U);
  ASSERT_TRUE(steel.places.front().add);
  EXPECT_FALSE(steel.places.front().cut);
  const double ring =
      (polygon_area(regular_polygon(48, 3.5)) - polygon_area(regular_polygon(48, 3.0))) * k_plate_high.z;
  EXPECT_NEAR(steel.places.front().add->volume.volume, ring, exact(signed_volume(a)));
  EXPECT_NEAR(steel.cut_less_add(), signed_volume(b) - signed_volume(a), exact(signed_volume(a)));
  EXPECT_FALSE(steel.line.added.empty()) << "its shut-off is wider by a half";
  EXPECT_NEAR(steel.line.added.front().farthest, 0.5, 1e-2);
}

/// Area that two convex polygons have in common.
double common_area(Loop2 clipped, const Loop2& by) {
  const auto left = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  for (std::size_t k = 0; k < by.size(); ++k) {
    const glm::dvec2 &a = by[k], &b = by[(k + 1) % by.size()];
    Loop2 next;
    for (std::size_t i = 0; i < clipped.size(); ++i) {
      const glm::dvec2 &p = clipped[i], &q = clipped[(i + 1) % clipped.size()];
      const double at_p = left(a, b, p), at_q = left(a, b, q);
      if (at_p >= 0.0) next.push_back(p);
      if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0))
        next.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    clipped = next;
  }
  return polygon_area(clipped);
}

TEST(SteelChange, OfAMovedBossIsBothByAsMuch) {
  const PlateWithBoss before{.draft_deg = 0.0};
  PlateWithBoss after = before;
  after.boss += glm::dvec2(0.7, 0.4);
  const TriangleMesh a = plate_mesh(before), b = plate_mesh(after);
  const Steel steel = steel_of(a, b);
  ASSERT_EQ(steel.places.size(), 1U);
  const PlaceSteel& place = steel.places.front();
  ASSERT_TRUE(place.cut);
  ASSERT_TRUE(place.add);
  const Loop2 foot = placed(regular_polygon(48, before.radius), before.boss);
  const double crescent =
      (polygon_area(foot) - common_area(foot, placed(regular_polygon(48, after.radius), after.boss))) *
      before.height;
  EXPECT_NEAR(place.cut->volume.volume, crescent, 2e-5 * crescent);
  EXPECT_NEAR(place.add->volume.volume, crescent, 2e-5 * crescent);
  EXPECT_LE(std::abs(place.cut->volume.volume - crescent), place.cut->volume.error + exact(crescent));
  EXPECT_NEAR(steel.cut_less_add(), 0.0, exact(signed_volume(a)));
  EXPECT_GT(place.cut->centre.x, before.boss.x);
  EXPECT_LT(place.add->centre.x, before.boss.x);
  EXPECT_NEAR(place.cut->depth, before.height, 1e-6);
}

TEST(SteelChange, KnowsTheHalves) {
  // A foot below the plate is the cavity's.
  const auto with_foot = [](double height) {
    SolidBuilder solid;
    solid.box(k_plate_low, k_plate_high, {4});
    const Loop2 foot = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
    Loop2 reversed = foot;
    std::reverse(reversed.begin(), reversed.end());
    solid.walls(at_height(foot, -height), at_height(foot, 0.0));
    solid.face(at_height(reversed, -height));
    solid.face(box_face(k_plate_low, k_plate_high, 4), {at_height(reversed, 0.0)});
    return solid.mesh();
  };
  const Steel steel = steel_of(with_foot(3.0), with_foot(5.0));
  ASSERT_EQ(steel.places.size(), 1U);
  ASSERT_TRUE(steel.places.front().cut);
  EXPECT_EQ(steel.places.front().cut->of.front().owner.side, MoldSide::cavity);
  EXPECT_NEAR(steel.places.front().cut->volume.volume, 72.0, exact(1e4));
  EXPECT_NEAR(steel.places.front().cut->depth, 2.0, 1e-9);
}

TEST(SteelChange, OfAnotherTessellationIsNone) {
  const TriangleMesh a = plate_mesh({.rib = 2.0}), b = plate_mesh({.sides = 37, .turn_deg = 3.0, .rib = 3.0});
  const Steel steel = steel_of(a, b);
  ASSERT_EQ(steel.places.size(), 1U) << "the boss is as it was";
  ASSERT_TRUE(steel.places.front().cut);
  EXPECT_FALSE(steel.places.front().add);
  EXPECT_NEAR(steel.places.front().cut->volume.volume, 36.0, 1e-6);
}

TEST(SteelChange, OfAScaledPartAddsUp) {
  const TriangleMesh a = plate_mesh({.hole_radius = 3.0, .rib = 2.0});
  for (const double factor : {1.01, 1.0 / 1.01}) {
    const TriangleMesh b = test::scaled(a, factor);
    const Steel steel = steel_of(a, b);
    const double elsewhere = steel.change.volume_elsewhere;
    EXPECT_NEAR(steel.cut_less_add() + elsewhere, signed_volume(b) - signed_volume(a),
                exact(signed_volume(a)));
  }
}

TEST(SteelChange, IsTheSameForAnyNumberOfThreads) {
  PlateWithBoss moved;
  moved.boss += glm::dvec2(0.7, 0.4);
  const TriangleMesh a = plate_mesh({}), b = plate_mesh(moved);
  const Steel all = steel_of(a, b);
  tbb::task_arena one(1);
  const Steel alone = one.execute([&] { return steel_of(a, b); });
  ASSERT_EQ(all.places.size(), alone.places.size());
  EXPECT_EQ(all.places[0].cut->volume.volume, alone.places[0].cut->volume.volume);
  EXPECT_EQ(all.places[0].add->centre, alone.places[0].add->centre);
}

}  // namespace
}  // namespace moldlight
