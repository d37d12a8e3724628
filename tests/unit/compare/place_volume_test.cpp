// Volumes of places add up to what the bodies differ by, and each is that of what was done there.
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "unit/compare/revisions.hpp"

namespace moldlight {
namespace {

double difference(const TriangleMesh& a, const TriangleMesh& b) {
  return signed_volume(b) - signed_volume(a);
}

double sum(const SurfaceChange& change) {
  double all = change.volume_elsewhere;
  for (const ChangedPlace& place : change.places) all += place.volume.volume;
  return all;
}

/// All that is above a height, by as much: walls that lean become steeper.
TriangleMesh raised(TriangleMesh mesh, double above, double by) {
  for (glm::dvec3& vertex : mesh.vertices)
    if (vertex.z > above) vertex.z += by;
  return mesh;
}

/// A plate with a frame on it that leaves a hole's room free, and the hole.
TriangleMesh framed_plate(double frame_height, double hole_radius) {
  SolidBuilder solid;
  const double top = 4.0;
  const Loop2 outer = {{-18, -10}, {18, -10}, {18, 10}, {-18, 10}},
              inner = {{-14, -6}, {14, -6}, {14, 6}, {-14, 6}};
  Loop2 reversed = inner;
  std::reverse(reversed.begin(), reversed.end());
  solid.walls(at_height(outer, top), at_height(outer, top + frame_height));
  solid.walls(at_height(reversed, top), at_height(reversed, top + frame_height));
  solid.face(at_height(outer, top + frame_height), {at_height(inner, top + frame_height)});
  solid.box({-20, -12, 0}, {20, 12, top}, {4, 5});
  solid.face(box_face({-20, -12, 0}, {20, 12, top}, 5), {at_height(outer, top)});
  std::vector<test::Loop> in_top, in_bottom;
  if (hole_radius > 0.0) {
    Loop2 hole = placed(regular_polygon(24, hole_radius), {3.0, 1.0});
    in_top = {at_height(hole, top)};
    in_bottom = {at_height(hole, 0.0)};
    std::reverse(hole.begin(), hole.end());
    solid.walls(at_height(hole, 0.0), at_height(hole, top));
  }
  solid.face(at_height(inner, top), in_top);
  solid.face(box_face({-20, -12, 0}, {20, 12, top}, 4), in_bottom);
  return solid.mesh();
}

TEST(PlaceVolume, OfARaisedBossIsTheDifferenceOfTheBodies) {
  const TriangleMesh a = plate_mesh({}), b = raised(a, k_plate_high.z, 1.0);
  const Laid pair = laid(a, b);
  ASSERT_EQ(pair.change.places.size(), 1U);
  const double came = difference(a, b);
  const ChangedPlace& place = pair.change.places.front();
  EXPECT_NEAR(sum(pair.change), came, 1e-9 * came);
  EXPECT_NEAR(place.volume.volume, came, 1e-3 * came);
  EXPECT_LE(std::abs(place.volume.volume - came), place.volume.error + 1e-9 * came);
  EXPECT_LT(place.volume.error, 0.05 * came);
}

TEST(PlaceVolume, OfAScaledPartAddUp) {
  const TriangleMesh a = plate_mesh({.hole_radius = 3.0, .rib = 2.0}), b = test::scaled(a, 1.01);
  const Laid pair = laid(a, b);
  EXPECT_FALSE(pair.change.places.empty());
  EXPECT_NEAR(sum(pair.change), difference(a, b), 1e-9 * signed_volume(a));
}

TEST(PlaceVolume, OfPlacesApartAreEachItsOwn) {
  const TriangleMesh a = plate_mesh({.rib = 2.0}), b = plate_mesh({.hole_radius = 3.0});
  const Laid pair = laid(a, b);
  ASSERT_EQ(pair.change.places.size(), 2U);
  const double rib = 2.0 * 6.0 * k_rib_height, hole = polygon_area(regular_polygon(48, 3.0)) * 4.0;
  for (const ChangedPlace& place : pair.change.places) {
    EXPECT_NEAR(place.volume.volume, place.centre.x < 5.0 ? -rib : -hole, 1e-9 * signed_volume(a));
    EXPECT_FALSE(place.joined);
  }
  EXPECT_NEAR(sum(pair.change), difference(a, b), 1e-9 * signed_volume(a));
}

TEST(PlaceVolume, OfAPlaceWithinTheBoxOfAnotherIsItsOwn) {
  const TriangleMesh a = framed_plate(3.0, 0.0), b = framed_plate(5.0, 2.0);
  const Laid pair = laid(a, b);
  ASSERT_EQ(pair.change.places.size(), 2U);
  const double frame = 2.0 * (36.0 * 20.0 - 28.0 * 12.0), hole = polygon_area(regular_polygon(24, 2.0)) * 4.0;
  for (const ChangedPlace& place : pair.change.places) {
    const bool is_frame = place.bounds.max.x > 10.0;
    EXPECT_NEAR(place.volume.volume, is_frame ? frame : -hole, 1e-9 * signed_volume(a));
    EXPECT_LT(place.volume.error, 1e-6);
  }
}

TEST(PlaceVolume, OfAMovedBossIsNone) {
  PlateWithBoss moved;
  moved.boss += glm::dvec2(0.7, 0.4);
  const TriangleMesh a = plate_mesh({}), b = plate_mesh(moved);
  const Laid pair = laid(a, b);
  ASSERT_EQ(pair.change.places.size(), 1U);
  EXPECT_NEAR(sum(pair.change), 0.0, 1e-9 * signed_volume(a));
  EXPECT_LE(std::abs(pair.change.places.front().volume.volume),
            pair.change.places.front().volume.error + 1e-9 * signed_volume(a));
}

/// A hollow body that is gone whole: its two shells enclose nothing of what went each by itself.
TEST(PlaceVolume, OfShellsThatAreNotClosedByThemselvesIsOne) {
  const auto with_hollow = [](bool hollow) {
    SolidBuilder solid;
    solid.box({0, 0, 0}, {10, 10, 10});
    if (hollow) {
      solid.box({20, 0, 0}, {30, 10, 10});
      solid.box({23, 3, 3}, {27, 7, 7}, {}, true);
    }
    return solid.mesh();
  };
  const Laid pair = laid(with_hollow(true), with_hollow(false));
  ASSERT_EQ(pair.change.places.size(), 1U);
  EXPECT_TRUE(pair.change.places.front().joined);
  EXPECT_NEAR(pair.change.places.front().volume.volume, -(1000.0 - 64.0), 1e-6);
}

TEST(PlaceVolume, LeavesOutWhatTheTessellationsDifferByElsewhere) {
  const TriangleMesh a = plate_mesh({.rib = 2.0}), b = plate_mesh({.sides = 37, .turn_deg = 3.0});
  const Laid pair = laid(a, b);
  ASSERT_EQ(pair.change.places.size(), 1U);
  EXPECT_NEAR(pair.change.places.front().volume.volume, -2.0 * 6.0 * k_rib_height, 1e-6);
  EXPECT_NE(pair.change.volume_elsewhere, 0.0);
  EXPECT_NEAR(sum(pair.change), difference(a, b), 1e-9 * signed_volume(a));
}

TEST(PlaceVolume, OfOpenPartsIsNotKnown) {
  TriangleMesh open = plate_mesh({});
  open.facets.pop_back();
  EXPECT_FALSE(laid(open, plate_mesh({.rib = 2.0})).change.closed);
}

}  // namespace
}  // namespace moldlight
