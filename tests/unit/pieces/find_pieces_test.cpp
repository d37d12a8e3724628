// Directions of solids whose least number is known.
#include "pieces/find_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "classify/classification.hpp"
#include "pieces/pieces_report.hpp"
#include "support/box_pile.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::model_of;

PiecesResult pieces_of(const TriangleMesh& mesh, const PiecesSettings& settings = {}) {
  return find_pieces(*model_of(mesh), {}, settings, Progress());
}

/// A cube of 30 with a blind hole, 6 wide and 9 deep, in the middle of each of these faces (0 … 5: -x, +x,
/// …).
TriangleMesh cube_with_holes(const std::vector<int>& faces) {
  constexpr double k_half = 15.0, k_hole = 3.0, k_depth = 9.0;
  test::SolidBuilder builder;
  builder.box(glm::dvec3(-k_half), glm::dvec3(k_half), faces);
  for (const int face : faces) {
    glm::dvec3 low(-k_hole), high(k_hole);
    const int axis = face / 2;
    const bool positive = face % 2 == 1;
    (positive ? low : high)[axis] = positive ? k_half - k_depth : -k_half + k_depth;
    (positive ? high : low)[axis] = positive ? k_half : -k_half;
    test::Loop rim = test::box_face(low, high, face);
    builder.face(test::box_face(glm::dvec3(-k_half), glm::dvec3(k_half), face), {rim});
    builder.box(low, high, {face}, true);
  }
  return builder.mesh();
}

/// A block with a slot that is wider below than at its mouth, closed at both ends.
TriangleMesh closed_t_slot() {
  test::SolidBuilder builder;
  const glm::dvec3 low(-20, -20, 0), high(20, 20, 20);
  const glm::dvec3 mouth_low(-3, -10, 12), mouth_high(3, 10, 20);
  const glm::dvec3 room_low(-10, -12, 4), room_high(10, 12, 12);
  builder.box(low, high, {5});
  builder.face(test::box_face(low, high, 5), {test::box_face(mouth_low, mouth_high, 5)});
  builder.box(mouth_low, mouth_high, {4, 5}, true);
  builder.box(room_low, room_high, {5}, true);
  test::Loop ceiling = test::box_face(room_low, room_high, 5);
  std::ranges::reverse(ceiling);
  builder.face(ceiling, {test::box_face(mouth_low, mouth_high, 4)});
  return builder.mesh();
}

bool has(const PiecesResult& result, const glm::dvec3& direction) {
  return std::ranges::any_of(result.directions, [&](const PieceDirection& one) {
    return glm::distance(one.direction, direction) < 1e-9;
  });
}

TEST(Pieces, AConvexPartNeedsTwo) {
  // The end of a bar is less than may be left.
  for (const TriangleMesh& mesh :
       {test::box_shape({}).mesh, test::frustum_over_tau({}).mesh, test::box_mesh({0, 0, 0}, {3, 300, 3})}) {
    const PiecesResult result = pieces_of(mesh);
    EXPECT_EQ(result.count(), 2U);
    EXPECT_TRUE(result.releases_all && result.optimal && result.proved());
    EXPECT_EQ(pieces_state(result), "two-piece");
  }
}

TEST(Pieces, ACubeNeedsADirectionForEachFaceWithABlindHole) {
  const std::vector<std::vector<int>> cubes = {{5},       {1, 5},       {0, 1},
                                               {1, 3, 5}, {0, 1, 4, 5}, {0, 1, 2, 3, 4, 5}};
  for (const std::vector<int>& faces : cubes) {
    const auto cube = model_of(cube_with_holes(faces));
    const PiecesResult result = find_pieces(*cube, {}, {}, Progress());
    EXPECT_EQ(result.count(), std::max<std::size_t>(2, faces.size()));
    EXPECT_TRUE(result.releases_all);
    constexpr std::array<std::string_view, 7> k_excluded = {"",           "", "",         " Two are",
                                                            " Three are", "", " Five are"};
    const std::string sentence = pieces_sentence(*cube, result);
    EXPECT_NE(sentence.find(k_excluded[result.count()]), std::string::npos) << sentence;
    EXPECT_EQ(result.lower_bound, result.count());
    for (const int face : faces) {
      glm::dvec3 direction(0.0);
      direction[face / 2] = face % 2 == 1 ? 1.0 : -1.0;
      EXPECT_TRUE(has(result, direction)) << "face " << face;
    }
  }
}

TEST(Pieces, AThroughHoleIsReleasedInEitherSense) {
  const test::Shape plate = test::plate_with_through_hole({});
  const PiecesResult result = pieces_of(plate.mesh);
  EXPECT_EQ(result.count(), 2U);
  EXPECT_TRUE(result.releases_all);
  PiecesSettings fixed;
  fixed.fixed = {-plate.direction};
  EXPECT_EQ(pieces_of(plate.mesh, fixed).count(), 2U);
}

TEST(Pieces, WhatNothingReleasesIsLeftAndTold) {
  const auto hollow = model_of(test::hollow_sphere({}).mesh);
  const PiecesResult result = find_pieces(*hollow, {}, {}, Progress());
  EXPECT_EQ(result.count(), 2U);
  EXPECT_TRUE(result.enough);
  EXPECT_FALSE(result.releases_all);
  EXPECT_EQ(pieces_state(result), "left-over");
  const test::Shape shape = test::hollow_sphere({});
  EXPECT_NEAR(result.left_area, shape.expected[Region::undercut], 1e-6 * shape.expected.total());
  ASSERT_FALSE(result.places.empty());

  const PiecesResult slot = pieces_of(closed_t_slot());
  EXPECT_FALSE(slot.releases_all);
  // The ceilings, and of the walls and the floor what no ray through the mouth reaches.
  EXPECT_GE(slot.left_area, 20 * 24 - 6 * 20 - 1e-6);
  const double ceilings =
      std::accumulate(slot.places.begin(), slot.places.end(), 0.0, [](double sum, const LeftPlace& place) {
        return sum + (place.bounds.max.z > 11.9 ? place.area : 0.0);
      });
  EXPECT_GE(ceilings, 20 * 24 - 6 * 20 - 1e-6);
}

TEST(Pieces, MoreThanAreAllowedIsTold) {
  PiecesSettings settings;
  settings.most = 2;
  const PiecesResult result = pieces_of(cube_with_holes({1, 3, 5}), settings);
  EXPECT_EQ(result.count(), 2U);
  EXPECT_FALSE(result.enough);
  EXPECT_FALSE(result.optimal);
  EXPECT_EQ(pieces_state(result), "left-over");
  settings.fixed = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_THROW(static_cast<void>(pieces_of(cube_with_holes({5}), settings)), UsageError);
}

TEST(Pieces, FixedDirectionsComeFirst) {
  PiecesSettings settings;
  settings.fixed = {{0, -2, 0}};
  const PiecesResult result = pieces_of(cube_with_holes({1, 5}), settings);
  ASSERT_EQ(result.count(), 3U);
  EXPECT_NEAR(glm::distance(result.directions[0].direction, glm::dvec3(0, -1, 0)), 0.0, 1e-12);
}

TEST(Pieces, MoreCandidatesNeverRaiseTheNumber) {
  test::Random random(4);
  for (const TriangleMesh& mesh : {cube_with_holes({1, 3, 5}), test::cup_with_side_hole({}).mesh,
                                   test::pile_mesh(test::random_pile(3), 3)}) {
    PiecesSettings more;
    for (int k = 0; k < 60; ++k) more.proposed.push_back(random.in_cube(1.0));
    EXPECT_LE(pieces_of(mesh, more).count(), pieces_of(mesh).count());
  }
}

TEST(Pieces, TheNumberStaysWhenThePartIsTurnedMirroredOrMixed) {
  for (const TriangleMesh& mesh : {cube_with_holes({1, 3, 5}), test::cup_with_side_hole({}).mesh,
                                   test::block_with_crossing_hole({}).mesh}) {
    const std::size_t count = pieces_of(mesh).count();
    EXPECT_EQ(pieces_of(test::permuted(mesh, 7)).count(), count);
    EXPECT_EQ(pieces_of(test::mirrored(mesh)).count(), count);
    EXPECT_EQ(pieces_of(test::rotated(mesh, test::random_rotation(5))).count(), count);
    EXPECT_EQ(pieces_of(test::scaled(mesh, 0.25)).count(), count);
  }
}

TEST(Pieces, TwoOppositeOnesLeaveTheUndercutOfTheDirection) {
  PiecesSettings all;
  all.eps = 0.2;
  for (const test::Shape& shape : {test::cup_with_side_hole({}), test::snap_hook({}), test::ring({})}) {
    const auto model = model_of(shape.mesh);
    all.most = 2;
    all.fixed = {shape.direction, -shape.direction};
    const PiecesResult result = find_pieces(*model, {}, all, Progress());
    ASSERT_EQ(result.count(), 2U);
    const Classification exact = classify_exact(*model, {shape.direction, {}}, Progress());
    EXPECT_NEAR(result.left_area, exact.areas[Region::undercut], 1e-9 * exact.total_area) << shape.name;
  }
}

/// The fewest of the six axes by exact areas of all subsets.
std::size_t fewest_axes(const PartModel& model, double eps) {
  const ExactQuery query = exact_query(model, {});
  LeftSurface left(model, query);
  std::size_t fewest = 7;
  for (unsigned bits = 1; bits < 64; ++bits) {
    std::vector<glm::dvec3> directions;
    for (int k = 0; k < 6; ++k) {
      glm::dvec3 direction(0.0);
      direction[k / 2] = k % 2 == 0 ? 1.0 : -1.0;
      if ((bits >> k & 1U) != 0) directions.push_back(direction);
    }
    if (directions.size() < fewest &&
        area_of(left.left_by(directions, Progress())) <= eps * model.geometry.total_area)
      fewest = directions.size();
  }
  return fewest;
}

TEST(Pieces, PilesOfBoxesNeedNoMoreThanTheBestSubsetOfAxes) {
  std::size_t released = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    const auto model = model_of(test::pile_mesh(test::random_pile(seed), seed));
    const PiecesResult result = find_pieces(*model, {}, {}, Progress());
    const std::size_t axes = fewest_axes(*model, 0.005);
    if (axes > 6) continue;
    ++released;
    EXPECT_TRUE(result.releases_all) << "seed " << seed;
    EXPECT_LE(result.count(), axes) << "seed " << seed;
    EXPECT_LE(result.lower_bound, result.count()) << "seed " << seed;
  }
  EXPECT_GT(released, 0U);
}

TEST(Pieces, SurfaceIsFormedByDirectionsThatReleaseIt) {
  for (const TriangleMesh& mesh : {cube_with_holes({1, 3, 5}), test::cup_with_side_hole({}).mesh}) {
    const auto model = model_of(mesh);
    const PiecesResult result = find_pieces(*model, {}, {}, Progress());
    const double whole = model->geometry.total_area;
    double formed = 0.0;
    std::vector<glm::dvec3> directions;
    for (const PieceDirection& one : result.directions) {
      formed += one.area;
      directions.push_back(one.direction);
    }
    EXPECT_NEAR(formed + result.left_area, whole, 2e-4 * whole);
    LeftSurface left(*model, result.query);
    const SplitMesh& split = result.formed.mesh;
    for (std::uint32_t k = 0; k < directions.size(); ++k) {
      // What it forms and what it leaves are apart, but for specks.
      double sum = area_of(left.left_by({&directions[k], 1}, Progress()));
      for (std::size_t piece = 0; piece < split.pieces.size(); ++piece) {
        if (result.formed.formed_by[piece] != k) continue;
        sum += 0.5 * glm::length(glm::cross(split.corner(piece, 1) - split.corner(piece, 0),
                                            split.corner(piece, 2) - split.corner(piece, 0)));
      }
      EXPECT_LE(sum, whole * 1.001);
    }
    double length = 0.0;
    for (const PieceSeam& seam : result.formed.seams) {
      EXPECT_LT(seam.a, seam.b);
      EXPECT_LT(seam.b, directions.size());
      EXPECT_EQ(seam.closed, seam.points.size() > 2 && seam.points.front() == seam.points.back());
      EXPECT_TRUE(seam.crease_share >= 0.0 && seam.crease_share <= 1.0 + 1e-9);
      length += seam.length;
    }
    EXPECT_GT(length, 0.0);
  }
}

TEST(Pieces, ABoxHasOneSeamOnItsEdges) {
  const PiecesResult result = pieces_of(test::box_shape({}).mesh);
  ASSERT_EQ(result.formed.seams.size(), 1U);
  EXPECT_TRUE(result.formed.seams[0].closed);
  EXPECT_NEAR(result.formed.seams[0].crease_share, 1.0, 1e-9);
  ASSERT_TRUE(result.enclosed_air);
  EXPECT_EQ(*result.enclosed_air, 0.0);
}

/// Of four directions one forms all but the face that looks away from it, the smallest of the box: no seam
/// can be shorter. Beside a piece that is settled already a seam costs as much as elsewhere.
TEST(Pieces, OfManyDirectionsThoseFormABoxThatHaveTheShortestSeam) {
  const auto model = model_of(test::box_shape({}).mesh);
  std::array<glm::dvec3, 4> directions = {glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(-1, -1, -1)),
                                          glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)};
  const FormedSurface formed = form_surface(*model, exact_query(*model, {}), directions, Progress());
  double length = 0.0;
  for (const PieceSeam& seam : formed.seams) length += seam.length;
  EXPECT_NEAR(length, 2.0 * (24.3 + 12.1), 1e-9);
  EXPECT_EQ(formed.patches.size(), 2U);
  // Halves form what they can, however long their seam.
  directions[1] = glm::dvec3(0, 0, -1);
  const FormedSurface by_halves = form_surface(*model, exact_query(*model, {}), directions, Progress());
  EXPECT_LT(std::ranges::max(by_halves.formed_by), 2U);
}

/// Facets as large as the part that all cross each other.
TEST(Pieces, TooManyCrossingsAreRefused) {
  test::Random random(7);
  TriangleMesh soup;
  for (VertexIndex k = 0; k < 1200; ++k) {
    soup.vertices.push_back(random.in_cube(1.0));
    if (k % 3 == 2) soup.facets.push_back({k - 2, k - 1, k});
  }
  try {
    static_cast<void>(pieces_of(soup));
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string_view(error.what()).find("raise --effort"), std::string_view::npos) << error.what();
  }
}

TEST(Pieces, CanBeCancelled) {
  const auto model = model_of(cube_with_holes({1, 3, 5}));
  for (const std::string_view at : {"candidates", "choosing directions", "proving", "assigning"}) {
    Progress* watched = nullptr;
    Progress progress([&](std::string_view stage, double) {
      if (stage == at) watched->cancel();
    });
    watched = &progress;
    EXPECT_THROW(static_cast<void>(find_pieces(*model, {}, {}, progress)), Cancelled) << at;
  }
}

}  // namespace
}  // namespace moldlight
