// Slides and lifters as solids of the mold: with halves, part and inserts they fill the block, and they move
// out.
#include "parting/mold_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ranges>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/health.hpp"
#include "parting/halves/bodies.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/make_halves.hpp"
#include "parting/slide_blank.hpp"
#include "study/study.hpp"
#include "support/box_pile.hpp"
#include "support/boxes.hpp"
#include "support/mold_checks.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

Study study_of(const TriangleMesh& mesh, const MoldSettings& mold = {}) {
  Part part;
  part.unit = "mm";
  part.mesh = mesh;
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  Questions questions;
  questions.with_actions = true;
  questions.mold = mold;
  return Study(prepare_part(std::move(part), Progress()), questions);
}

/// The part and all pieces of a mold: a certified one, closed, with `count` pieces of a kind between its
/// halves and no others, that fill the block without overlap. Nothing where the number of pieces is another.
std::vector<TriangleMesh> certified_pieces(const TriangleMesh& part, const MoldPieces& pieces, PieceKind kind,
                                           std::size_t count) {
  const MoldHalves& halves = pieces.halves;
  const std::string why = pieces.unmade.empty() ? "" : pieces.unmade.front().why;
  EXPECT_EQ(halves.count(kind), count) << why;
  EXPECT_EQ(halves.inserts.size(), count) << why;
  EXPECT_EQ(halves.written.bodies.size(), 2 + count) << why;
  if (halves.count(kind) != count || halves.inserts.size() != count) return {};
  EXPECT_TRUE(halves.certified());
  EXPECT_LE(std::abs(halves.volume_gap), 1e-9);
  double volume = halves.part_volume;
  std::vector<TriangleMesh> bodies = {part};
  for (const WrittenBody& body : halves.written.bodies) {
    EXPECT_TRUE(body.closed) << body.name;
    EXPECT_EQ(body.nonmanifold_edges, 0U) << body.name;
    volume += body.volume;
    bodies.push_back(body.mesh);
  }
  EXPECT_NEAR(volume / halves.block_volume, 1.0, 1e-9);
  EXPECT_EQ(test::misplaced_points(bodies, 20000, 7), 0U);
  return bodies;
}

class SlidesOf : public ::testing::TestWithParam<test::Shape (*)(const test::ShapeSettings&)> {};

TEST_P(SlidesOf, FillTheBlockWithTheHalvesAndMoveOut) {
  const TriangleMesh mesh = GetParam()({}).mesh;
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const MoldHalves& halves = pieces.halves;
  const std::vector<TriangleMesh> bodies = certified_pieces(mesh, pieces, PieceKind::slide, 1);
  ASSERT_FALSE(bodies.empty());
  EXPECT_EQ(halves.inserts[0].name, "slide_1");
  EXPECT_EQ(halves.inserts[0].crossed_facets, 0U);
  // Out of the block's side, past the part; the other way the part holds it.
  const glm::dvec3 way = study.find<ActionPlan>(Progress()).actions[halves.inserts[0].action].direction;
  const double diagonal = study.model().frame.diagonal;
  EXPECT_LE(way_out(halves.written.bodies[2].mesh, mesh, way).blocked, diagonal / 2048.0);
  EXPECT_GT(way_out(halves.written.bodies[2].mesh, mesh, -way).blocked, 0.01 * diagonal);
}

INSTANTIATE_TEST_SUITE_P(MoldPieces, SlidesOf,
                         ::testing::Values(&test::cup_with_side_hole, &test::plate_with_side_pocket));

/// A block with a square bore along x and another along y that ends in its side.
TriangleMesh block_with_tee_bore() {
  const glm::dvec3 low(0, 0, 0), high(60, 40, 20);
  test::SolidBuilder solid;
  solid.box(low, high, {0, 1, 3});
  for (const int face : {0, 1})
    solid.face(test::box_face(low, high, face), {test::box_face({0, 10, 5}, {60, 20, 15}, face)});
  solid.face(test::box_face(low, high, 3), {test::box_face({25, 20, 5}, {35, 40, 15}, 3)});
  const test::Loop2 tee = {{0, 10}, {60, 10}, {60, 20}, {35, 20}, {35, 40}, {25, 40}, {25, 20}, {0, 20}};
  test::Loop ceiling = test::at_height(tee, 15.0);
  std::ranges::reverse(ceiling);
  solid.face(test::at_height(tee, 5.0));
  solid.face(ceiling);
  for (const std::size_t k : {0U, 2U, 3U, 5U, 6U}) {
    const glm::dvec2 &a = tee[k], &b = tee[(k + 1) % tee.size()];
    solid.face({{b.x, b.y, 5}, {a.x, a.y, 5}, {a.x, a.y, 15}, {b.x, b.y, 15}});
  }
  return solid.mesh();
}

TEST(MoldPieces, CrossingBoresAreTwoSlides) {
  const TriangleMesh mesh = block_with_tee_bore();
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const MoldHalves& halves = pieces.halves;
  const std::vector<TriangleMesh> bodies = certified_pieces(mesh, pieces, PieceKind::slide, 2);
  ASSERT_FALSE(bodies.empty());
  // Either may leave first.
  const double slack = study.model().frame.diagonal / 2048.0;
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(pieces.of_inserts[k].actions, (std::vector<std::size_t>{halves.inserts[k].action}));
    const glm::dvec3 way = study.find<ActionPlan>(Progress()).actions[halves.inserts[k].action].direction;
    for (std::size_t other = 0; other < bodies.size(); ++other) {
      if (other == 3 + k) continue;
      EXPECT_LE(way_out(bodies[3 + k], bodies[other], way).blocked, slack) << k << other;
    }
  }
}

/// An open box with a corner cut off at 45 degrees, and a square window in the wall there.
TriangleMesh box_with_corner_window() {
  const test::Loop2 outer = {{12, 0}, {60, 0}, {60, 60}, {0, 60}, {0, 12}},
                    inner = {{14, 3}, {57, 3}, {57, 57}, {3, 57}, {3, 14}};
  constexpr double k_floor = 3.0, k_rim = 25.0;
  test::SolidBuilder solid;
  test::Loop under = test::at_height(outer, 0.0);
  std::ranges::reverse(under);
  solid.face(under);
  solid.face(test::at_height(inner, k_floor));
  solid.face(test::at_height(outer, k_rim), {test::at_height(inner, k_rim)});
  // Across a wall from its middle, and up.
  const auto wall = [&](const test::Loop2& plan, std::size_t k, double low, bool inward) {
    const glm::dvec2 &a = plan[k], &b = plan[(k + 1) % plan.size()];
    test::Loop face = {{a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, k_rim}, {a.x, a.y, k_rim}};
    if (inward) std::ranges::reverse(face);
    return face;
  };
  const auto window = [](const test::Loop2& plan) {
    const glm::dvec2 middle = 0.5 * (plan.front() + plan.back()), along = glm::dvec2(3, -3);
    const auto at = [&](double side, double z) { return glm::dvec3(middle + side * along, z); };
    return test::Loop{at(-1, 10), at(1, 10), at(1, 16), at(-1, 16)};
  };
  for (std::size_t k = 0; k < outer.size(); ++k) {
    std::vector<test::Loop> outside, inside;
    if (k + 1 == outer.size()) {
      outside = {window(outer)};
      inside = {window(inner)};
    }
    solid.face(wall(outer, k, 0.0, false), outside);
    solid.face(wall(inner, k, k_floor, true), inside);
  }
  const test::Loop out = window(outer), in = window(inner);
  for (std::size_t k = 0; k < 4; ++k) solid.face({out[k], out[(k + 1) % 4], in[(k + 1) % 4], in[k]});
  return solid.mesh();
}

TEST(MoldPieces, ASlideMayLeaveAroundAnEdgeOfTheBlock) {
  const TriangleMesh mesh = box_with_corner_window();
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const MoldHalves& halves = pieces.halves;
  const std::vector<TriangleMesh> bodies = certified_pieces(mesh, pieces, PieceKind::slide, 1);
  ASSERT_FALSE(bodies.empty());
  // The edge is its own, up to where the halves meet.
  const glm::dvec2 low = halves.block_low * halves.scale * study.model().frame.diagonal;
  EXPECT_TRUE(std::ranges::any_of(halves.inserts[0].mesh.vertices, [&](const glm::dvec3& vertex) {
    return glm::distance(glm::dvec2(vertex), low) < 1e-6 && std::abs(vertex.z - 12.5) < 1e-6;
  }));
}

/// A plate with three ears and holes of 20 sides through all of them.
TriangleMesh hinge_leaf(const std::vector<double>& at = {15.0}, double radius = 4.0) {
  const test::Loop2 comb = {{0, 0},   {60, 0},  {60, 5}, {58, 5}, {58, 24}, {50, 24}, {50, 5}, {34, 5},
                            {34, 24}, {26, 24}, {26, 5}, {10, 5}, {10, 24}, {2, 24},  {2, 5},  {0, 5}};
  constexpr double k_depth = 30.0;
  test::SolidBuilder solid;
  test::Loop front, back;
  for (const glm::dvec2& p : comb) {
    front.emplace_back(p.x, 0.0, p.y);
    back.insert(back.begin(), {p.x, k_depth, p.y});
  }
  solid.face(front);
  solid.face(back);
  const test::Loop2 circle = test::regular_polygon(20, radius, 4.0);
  const auto hole = [&](double x, double y) {
    test::Loop loop;
    for (const glm::dvec2& p : circle) loop.emplace_back(x, y + p.x, 15.0 + p.y);
    return loop;
  };
  for (std::size_t k = 0; k < comb.size(); ++k) {
    const glm::dvec2 &a = comb[k], &b = comb[(k + 1) % comb.size()];
    std::vector<test::Loop> holes;
    for (const double y : at)
      if (a.x == b.x && std::max(a.y, b.y) > 20.0) holes.push_back(hole(a.x, y));
    solid.face({{a.x, 0, a.y}, {a.x, k_depth, a.y}, {b.x, k_depth, b.y}, {b.x, 0, b.y}}, holes);
  }
  for (const double x : {2.0, 26.0, 50.0}) {
    for (const double y : at) {
      const test::Loop left = hole(x, y), right = hole(x + 8.0, y);
      for (std::size_t k = 0; k < left.size(); ++k) {
        const std::size_t next = (k + 1) % left.size();
        solid.face({right[k], right[next], left[next], left[k]});
      }
    }
  }
  return solid.mesh();
}

TEST(MoldPieces, PinsPassThroughTheSteelInTheGapsOfAHinge) {
  const TriangleMesh mesh = hinge_leaf();
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const MoldHalves& halves = pieces.halves;
  const std::vector<TriangleMesh> bodies = certified_pieces(mesh, pieces, PieceKind::slide, 2);
  ASSERT_FALSE(bodies.empty());
  EXPECT_TRUE(pieces.unmade.empty());
  // Each is one body and leaves past all others; one ends in a gap, where the other way steel holds it.
  const double diagonal = study.model().frame.diagonal;
  std::size_t held = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const TriangleMesh& slide = bodies[3 + k];
    EXPECT_EQ(connected_bodies(slide.vertices.size(), slide.facets).size(), 1U);
    const glm::dvec3 way = study.find<ActionPlan>(Progress()).actions[halves.inserts[k].action].direction;
    double against = 0.0;
    for (std::size_t other = 0; other < bodies.size(); ++other) {
      if (other == 3 + k) continue;
      EXPECT_LE(way_out(slide, bodies[other], way, INFINITY, 2e-4 * diagonal).blocked, diagonal / 2048.0)
          << k << other;
      if (other == 1 || other == 2) against = std::max(against, way_out(slide, bodies[other], -way).blocked);
    }
    held += against > 0.01 * diagonal ? 1 : 0;
  }
  EXPECT_GE(held, 1U);
}

/// Holes side by side are those of one slide, a pin each.
/// Two lugs on a base, a hole through both that is wider in the first.
TriangleMesh lugs_with_a_stepped_hole() {
  test::BoxPile pile;
  pile.planes = {{{0, 6, 8, 12, 14, 20}, {0, 4, 10, 14}, {0, 4, 8, 10, 14, 16, 20}}};
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int z = 0; z < 6; ++z) {
        const bool wide = y == 0 && x > 0 && x < 4 && z > 1 && z < 5, narrow = x == 2 && z == 3;
        pile.filled.push_back(z == 0 || (y != 1 && !wide && !narrow) ? 1 : 0);
      }
    }
  }
  return test::pile_mesh(pile, 5);
}

TEST(MoldPieces, APinMayHaveSteps) {
  const TriangleMesh mesh = lugs_with_a_stepped_hole();
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const std::vector<TriangleMesh> bodies = certified_pieces(mesh, pieces, PieceKind::slide, 1);
  ASSERT_FALSE(bodies.empty());
  const double slack = study.model().frame.diagonal / 2048.0;
  for (const std::size_t still : {0U, 1U, 2U})
    EXPECT_LE(way_out(bodies[3], bodies[still], {0, -1, 0}, INFINITY, slack).blocked, slack) << still;
  // Through the hole in either lug, and the steel between them.
  EXPECT_GT(pieces.halves.inserts[0].volume, 8.0 * 8.0 * 4.0 + 4.0 * 4.0 * 10.0);
}

/// A block with a blind bore, and a groove across above it: the slide's land and draft reach into it.
TriangleMesh block_with_bore_under_a_groove() {
  test::BoxPile pile;
  pile.planes = {{{0, 10, 20, 30}, {0, 2, 50, 54, 60}, {0, 5, 15, 17, 20}}};
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) {
        const bool bore = x == 1 && y > 0 && z == 1, groove = y == 2 && z == 3;
        pile.filled.push_back(bore || groove ? 0 : 1);
      }
    }
  }
  return test::pile_mesh(pile, 5);
}

TEST(MoldPieces, ASlideDoesNotComeOutOfThePartBesideItsBore) {
  const TriangleMesh mesh = block_with_bore_under_a_groove();
  MoldSettings mold;
  mold.parting_height = 10.0;
  Study study = study_of(mesh, mold);
  EXPECT_FALSE(certified_pieces(mesh, study.find<MoldPieces>(Progress()), PieceKind::slide, 1).empty());
}

TEST(MoldPieces, PinsOfHolesThatAreApartAreOneSlide) {
  const TriangleMesh mesh = hinge_leaf({8.0, 22.0}, 3.0);
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const std::vector<TriangleMesh> bodies = certified_pieces(mesh, pieces, PieceKind::slide, 2);
  ASSERT_FALSE(bodies.empty());
  EXPECT_TRUE(pieces.unmade.empty());
  std::size_t most = 0;
  for (const std::size_t k : {3, 4})
    most = std::max(most, connected_bodies(bodies[k].vertices.size(), bodies[k].facets).size());
  EXPECT_EQ(most, 2U);
}

/// An open box with catches inside its wall at y = 0, each 8 wide and 1.5 deep; and a post with one, behind
/// which there is room.
TriangleMesh box_with_catches(const std::vector<double>& at, bool post) {
  const glm::dvec3 low(0, 0, 0), high(80, 60, 25), void_low(2, 2, 2), void_high(78, 58, 25);
  test::SolidBuilder solid;
  solid.box(low, high, {5});
  solid.face(test::box_face(low, high, 5), {test::box_face(void_low, void_high, 5)});
  std::vector<int> open = {5, 2};
  if (post) open.push_back(4);
  solid.box(void_low, void_high, open, true);
  const auto add_ends = [&](const std::vector<glm::dvec2>& profile, double from, double to) {
    test::Loop left, right;
    for (const glm::dvec2& p : profile) {
      left.insert(left.begin(), {from, p.x, p.y});
      right.push_back({to, p.x, p.y});
    }
    solid.face(left);
    solid.face(right);
    // All sides but the one from the last corner to the first.
    for (std::size_t k = 0; k + 1 < profile.size(); ++k)
      solid.face({{to, profile[k].x, profile[k].y},
                  {from, profile[k].x, profile[k].y},
                  {from, profile[k + 1].x, profile[k + 1].y},
                  {to, profile[k + 1].x, profile[k + 1].y}});
  };
  std::vector<test::Loop> roots;
  for (const double x : at) {
    add_ends({{2, 15}, {3.5, 16.5}, {3.5, 17.5}, {2, 20}}, x, x + 8.0);
    roots.push_back({{x, 2, 15}, {x + 8, 2, 15}, {x + 8, 2, 20}, {x, 2, 20}});
  }
  solid.face({{2, 2, 2}, {2, 2, 25}, {78, 2, 25}, {78, 2, 2}}, roots);
  if (post) {
    add_ends({{32, 2}, {32, 20}, {30, 20}, {28, 17}, {28, 16}, {30, 16}, {30, 2}}, 36.0, 44.0);
    solid.face({{2, 2, 2}, {78, 2, 2}, {78, 58, 2}, {2, 58, 2}},
               {{{36, 30, 2}, {44, 30, 2}, {44, 32, 2}, {36, 32, 2}}});
  }
  return solid.mesh();
}

/// Driven out of the core they go sideways with the part, which is then taken off them.
void expect_lifters(const TriangleMesh& mesh, std::size_t count) {
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const MoldHalves& halves = pieces.halves;
  const std::vector<TriangleMesh> bodies = certified_pieces(mesh, pieces, PieceKind::lifter, count);
  ASSERT_FALSE(bodies.empty());
  const double slack = study.model().frame.diagonal / 2048.0;
  EXPECT_LE(way_out(bodies[1], mesh, {0, 0, 1}).blocked, slack);
  for (std::size_t k = 0; k < count; ++k) {
    const SideAction& action = study.find<ActionPlan>(Progress()).actions[halves.inserts[k].action];
    TriangleMesh lifter = bodies[3 + k];
    EXPECT_GT(way_out(lifter, mesh, {0, 0, 1}).blocked, 1.0);
    EXPECT_LE(way_out(lifter, mesh, action.direction, action.travel).blocked, slack);
    for (glm::dvec3& vertex : lifter.vertices) vertex += action.travel * action.direction;
    EXPECT_LE(way_out(lifter, mesh, {0, 0, 1}).blocked, slack);
    // Its room is open where it comes out of.
    const glm::dvec3 out =
        glm::normalize(action.travel * action.direction - glm::dvec3(0, 0, *action.stroke));
    EXPECT_LE(way_out(bodies[3 + k], bodies[1], out).blocked, slack);
  }
}

TEST(MoldPieces, ALifterIsABarThroughTheCore) {
  expect_lifters(box_with_catches({36.0}, false), 1);
  expect_lifters(box_with_catches({18.0, 54.0}, false), 2);
}

TEST(MoldPieces, ALifterLeavesWhatStandsBehindItsWallToTheCore) {
  expect_lifters(box_with_catches({}, true), 1);
}

/// With the travel of a plan that drives it through the wall across it stays an insert.
TEST(MoldPieces, ALifterWithThePartInItsWayIsNone) {
  Study study = study_of(box_with_catches({36.0}, false));
  const MoldLine& line = study.find<MoldLine>(Progress());
  const MoldHalves& plain = study.find<MoldHalves>(Progress());
  ActionPlan plan = study.find<ActionPlan>(Progress());
  ASSERT_EQ(plan.actions.size(), 1U);
  plan.actions[0].travel = 75.0;  // through it
  const MeetingPlace place = meeting_place(line);
  const MoldPieces pieces =
      make_pieces({study.model(), plain, plan, *study.find<SplitRegions>(Progress()).result.split, place,
                   study.questions().mold},
                  Progress());
  EXPECT_EQ(pieces.halves.count(PieceKind::lifter), 0U);
  EXPECT_EQ(pieces.halves.count(PieceKind::insert), 1U);
  ASSERT_EQ(pieces.unmade.size(), 1U);
  EXPECT_EQ(pieces.unmade[0].why.find("the part stands in its way, near "), 0U) << pieces.unmade[0].why;
}

TEST(MoldPieces, AreListedWithTheirOrderAndTravel) {
  Study study = study_of(test::plate_with_side_pocket({}).mesh);
  const auto json = mold_json(study, Progress());
  const auto& pieces = json["pieces"];
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0]["kind"], "core");
  EXPECT_EQ(pieces[0]["sequence"], 2);
  EXPECT_EQ(pieces[2]["name"], "slide_1");
  EXPECT_EQ(pieces[2]["kind"], "slide");
  EXPECT_EQ(pieces[2]["sequence"], 1);
  EXPECT_EQ(pieces[2]["crossings"], 0);
  EXPECT_TRUE(pieces[2]["closed"]);
  EXPECT_GT(pieces[2]["travel"].get<double>(), 3.0);
  EXPECT_GT(pieces[2]["thinnest"].get<double>(), 0.0);
  const auto made = json["made"].get<std::string>();
  EXPECT_EQ(made.find("no shut-off, planar parting surface, flat edge"), 0U) << made;
  EXPECT_NE(made.find(", 1 slide; block of "), std::string::npos) << made;
  EXPECT_EQ(json["transform"][3], (nlohmann::ordered_json{0.0, 0.0, 0.0, 1.0}));
}

/// A tube of 60 sides, upright, 12 high, with radii of 4 and 8, and in one side an opening from 4 to 8 whose
/// edges have a corner in the middle: facets above and below of it lean a little.
TriangleMesh tube_with_side_opening() {
  constexpr std::uint32_t k_around = 60;
  TriangleMesh mesh;
  const auto vertex = [&](double radius, double turn_deg, double z) {
    const double turn = turn_deg / 180.0 * std::numbers::pi;
    mesh.vertices.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
    return static_cast<VertexIndex>(mesh.vertices.size() - 1);
  };
  const auto face = [&](std::vector<VertexIndex> corners, bool turned = false) {
    if (turned) std::ranges::reverse(corners);
    for (std::size_t k = 2; k < corners.size(); ++k)
      mesh.facets.push_back({corners[0], corners[k - 1], corners[k]});
  };
  std::array<std::vector<std::array<VertexIndex, 2>>, 2> rings;  // inner and outer: low and high of each side
  std::array<std::array<VertexIndex, 6>, 2> openings{};          // low: three the way around; high
  for (const std::size_t outer : {0U, 1U}) {
    const double radius = outer == 1 ? 8.0 : 4.0;
    const bool turned = outer == 0;
    for (std::uint32_t k = 0; k < k_around; ++k)
      rings[outer].push_back({vertex(radius, 6.0 * k - 3.0, 0.0), vertex(radius, 6.0 * k - 3.0, 12.0)});
    std::array<VertexIndex, 6>& o = openings[outer];
    for (std::size_t k = 0; k < 6; ++k)
      o[k] = vertex(radius, 3.0 * static_cast<double>(k % 3) - 3.0, k < 3 ? 4.0 : 8.0);
    const auto& ring = rings[outer];
    face({ring[0][0], ring[1][0], o[2], o[1], o[0]}, turned);
    face({ring[1][1], ring[0][1], o[3], o[4], o[5]}, turned);
    face({ring[2][0], ring[2][1], ring[1][1], o[5], o[2], ring[1][0]}, turned);
    face({ring[59][1], ring[59][0], ring[0][0], o[0], o[3], ring[0][1]}, turned);
    for (std::uint32_t k = 2; k < 59; ++k)
      face({ring[k][0], ring[k + 1][0], ring[k + 1][1], ring[k][1]}, turned);
  }
  const auto& [inner, outer] = rings;
  for (std::uint32_t k = 0; k < k_around; ++k) {
    const std::uint32_t n = (k + 1) % k_around;
    face({inner[k][1], outer[k][1], outer[n][1], inner[n][1]});
    face({inner[n][0], outer[n][0], outer[k][0], inner[k][0]});
  }
  const auto& [i, o] = openings;
  face({o[0], o[1], o[2], i[2], i[1], i[0]});
  face({i[3], i[4], i[5], o[5], o[4], o[3]});
  face({i[0], i[3], o[3], o[0]});
  face({o[2], o[5], i[5], i[2]});
  return mesh;
}

TEST(MoldPieces, ASlideInARoundWallIsASolid) {
  Study study = study_of(tube_with_side_opening());
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  EXPECT_TRUE(pieces.unmade.empty()) << pieces.unmade.front().why;
  ASSERT_EQ(pieces.halves.count(PieceKind::slide), 1U);
  EXPECT_EQ(pieces.halves.count(PieceKind::insert), 0U);
  EXPECT_TRUE(pieces.halves.certified());
  EXPECT_TRUE(pieces.halves.divided);
}

TEST(MoldPieces, ASlideWithThePartInItsWayIsNone) {
  Questions questions;
  questions.with_actions = true;
  const std::string clip = (test::asset_folder() / "parts" / "cable_clip.stl").string();
  Study study(load_part(clip, {.unit = "mm"}, Progress()), questions);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  // It stands between what the groove's slide forms; that of the clip's bore is clear.
  const std::vector<SideAction>& actions = study.find<ActionPlan>(Progress()).actions;
  ASSERT_EQ(pieces.unmade.size(), 1U);
  EXPECT_FALSE(pieces.unmade[0].why.empty());
  EXPECT_EQ(actions[pieces.unmade[0].action].feature, "groove");
  EXPECT_EQ(pieces.halves.count(PieceKind::slide), 1U);
  EXPECT_EQ(pieces.halves.inserts.size(), 2U);
}

TEST(MoldPieces, ThinnestIsTheLeastWayBetweenOppositeFaces) {
  EXPECT_NEAR(*thinnest_of(test::box_mesh({0, 0, 0}, {4, 3, 0.5})), 0.5, 1e-12);
}

}  // namespace
}  // namespace moldlight
