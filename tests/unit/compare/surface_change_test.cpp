// Revisions of a part by formulas: only what changed is reported, with its area.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "support/random.hpp"
#include "unit/compare/revisions.hpp"

namespace moldlight {
namespace {

/// Facets as large as the part, of which each is near to all.
TEST(SurfaceChange, TooMuchInOnePlaceIsRefused) {
  test::Random random(11);
  TriangleMesh soup;
  for (VertexIndex k = 0; k < 3 * 1500; ++k) {
    soup.vertices.push_back(random.in_cube(1.0));
    if (k % 3 == 2) soup.facets.push_back({k - 2, k - 1, k});
  }
  TriangleMesh other = soup;
  for (glm::dvec3& vertex : other.vertices) vertex.z *= 1.01;
  try {
    static_cast<void>(laid(soup, other));
    ADD_FAILURE() << "laid";
  } catch (const Error& error) {
    EXPECT_NE(std::string_view(error.what()).find("or raise --effort"), std::string_view::npos)
        << error.what();
  }
}

/// Needles as long as the part, of which each is hidden by nearly all in places.
TEST(SurfaceChange, InTooManyPiecesIsRefused) {
  test::Random random(12);
  TriangleMesh needles;
  for (VertexIndex k = 0; k < 3 * 3000; k += 3) {
    const glm::dvec3 from = random.in_cube(1.0), along = 2.0 * random.in_cube(1.0);
    for (const glm::dvec3& corner : {from, from + along, from + 0.5 * along + 1e-3 * random.in_cube(1.0)})
      needles.vertices.push_back(corner);
    needles.facets.push_back({k, k + 1, k + 2});
  }
  try {
    static_cast<void>(laid(needles, plate_mesh({})));
    ADD_FAILURE() << "laid";
  } catch (const Error& error) {
    EXPECT_NE(std::string_view(error.what()).find("pieces by what hides it"), std::string_view::npos)
        << error.what();
    EXPECT_NE(std::string_view(error.what()).find("or raise --effort"), std::string_view::npos);
  }
}

TEST(SurfaceChange, OfTheSamePartIsNone) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0});
  const Laid pair = laid(mesh, test::permuted(mesh, 7));
  EXPECT_FALSE(pair.change.any());
  EXPECT_TRUE(pair.change.of_a.left.empty());
  double shared = 0.0;
  for (const PieceShare& share : pair.change.of_a.shares) shared += share.area;
  EXPECT_NEAR(shared, pair.a->geometry.total_area, 1e-9 * shared);
}

TEST(SurfaceChange, TellsAHoleThatWasAdded) {
  const PlateWithBoss holed{.hole_radius = 3.0};
  const Laid pair = laid(plate_mesh({}), plate_mesh(holed));
  ASSERT_EQ(pair.change.places.size(), 1U);
  const Loop2 hole = regular_polygon(holed.sides, holed.hole_radius);
  const double thickness = k_plate_high.z - k_plate_low.z, area = polygon_area(hole);
  const ChangedPlace& place = pair.change.places.front();
  EXPECT_NEAR(place.gone.area, 2.0 * area, 2e-3 * area);
  EXPECT_NEAR(place.added.area, polygon_perimeter(hole) * thickness, 1e-3 * area);
  EXPECT_NEAR(place.volume.volume, -area * thickness, 1e-3 * area * thickness);
  EXPECT_NEAR(place.centre.x, holed.hole.x, 0.01);
  EXPECT_NEAR(place.centre.y, holed.hole.y, 0.01);
  EXPECT_NEAR(place.centre.z, 0.5 * thickness, 0.01);
  EXPECT_NEAR(place.bounds.max.x - place.bounds.min.x, 2.0 * holed.hole_radius, 0.01);
  EXPECT_TRUE(pair.change.regions.empty());
  EXPECT_LT(pair.change.gone.error, 0.02 * area);
  EXPECT_GT(pair.change.gone.error, 0.0);
}

TEST(SurfaceChange, TellsARibThatIsGone) {
  const Laid pair = laid(plate_mesh({.rib = 2.0}), plate_mesh({}));
  ASSERT_EQ(pair.change.places.size(), 1U);
  const ChangedPlace& place = pair.change.places.front();
  EXPECT_NEAR(place.gone.area, 2.0 * 6.0 + 2.0 * (2.0 + 6.0) * k_rib_height, 0.01);
  EXPECT_NEAR(place.added.area, 2.0 * 6.0, 0.01);
  EXPECT_NEAR(place.volume.volume, -2.0 * 6.0 * k_rib_height, 0.01);
}

TEST(SurfaceChange, TellsABossThatMovedByATenth) {
  PlateWithBoss moved;
  moved.boss.x += 0.1;
  const Laid pair = laid(plate_mesh({}), plate_mesh(moved));
  ASSERT_EQ(pair.change.places.size(), 1U);
  const ChangedPlace& place = pair.change.places.front();
  EXPECT_NEAR(place.volume.volume, 0.0, 0.02);
  EXPECT_NEAR(place.gone.area, place.added.area, 0.2);
  // The wall but for where it moves along itself, and two crescents.
  const PlateWithBoss boss;
  const double wall = 3.14159 * (boss.radius + top_radius(boss)) * boss.height;
  EXPECT_GT(place.added.area, 0.8 * wall);
  EXPECT_LT(place.added.area, wall + 2.0);
  EXPECT_LT(place.bounds.max.x, 0.0) << "nothing of the rest of the plate";
}

TEST(SurfaceChange, TellsAnotherDraft) {
  const Laid pair = laid(plate_mesh({}), plate_mesh({.draft_deg = 3.0}));
  ASSERT_EQ(pair.change.places.size(), 1U);
  const PlateWithBoss before, after{.draft_deg = 3.0};
  const double wall = 3.14159 * (before.radius + top_radius(before)) * before.height;
  const double ring = polygon_area(regular_polygon(48, top_radius(before))) -
                      polygon_area(regular_polygon(48, top_radius(after)));
  const ChangedPlace& place = pair.change.places.front();
  EXPECT_NEAR(place.gone.area, wall + ring, place.gone.error);
  EXPECT_LT(place.gone.error, 0.2 * wall);
  EXPECT_LT(place.volume.volume, 0.0);
}

TEST(SurfaceChange, OfAnotherTessellationIsNone) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0});
  for (const TriangleMesh& other :
       {test::subdivided(mesh, 5000), plate_mesh({.sides = 32, .turn_deg = 3.0, .hole_radius = 3.0}),
        plate_mesh({.sides = 71, .hole_radius = 3.0}), plate_mesh({.sides = 13, .hole_radius = 3.0})}) {
    EXPECT_FALSE(laid(mesh, other).change.any());
    EXPECT_FALSE(laid(other, mesh).change.any());
    EXPECT_FALSE(laid(mesh, other, {1, 0, 0.3}).change.any());
  }
}

/// The part itself stays; a roof over the plate hides some of it.
TEST(SurfaceChange, TellsSurfaceThatIsNowHidden) {
  const auto with_roof = [](double overhang) {
    SolidBuilder solid;
    solid.extrude(
        {{0, 0}, {30, 0}, {30, 4}, {4, 4}, {4, 12}, {6 + overhang, 12}, {6 + overhang, 14}, {0, 14}}, {},
        20.0);
    return solid.mesh();
  };
  const Laid pair = laid(with_roof(2.0), with_roof(8.0));
  ASSERT_EQ(pair.change.places.size(), 1U);
  double undercut = 0.0;
  for (const ChangedRegion& region : pair.change.regions) {
    if (region.to == Region::undercut) undercut += region.area;
  }
  EXPECT_NEAR(undercut, 6.0 * 20.0, 0.5);
}

TEST(SurfaceChange, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh a = plate_mesh({}), b = plate_mesh({.draft_deg = 3.0, .hole_radius = 3.0});
  Laid one, four;
  tbb::task_arena(1).execute([&] { one = laid(a, b); });
  tbb::task_arena(4).execute([&] { four = laid(a, b); });
  ASSERT_EQ(one.change.places.size(), four.change.places.size());
  for (std::size_t k = 0; k < one.change.places.size(); ++k) {
    EXPECT_EQ(one.change.places[k].gone.area, four.change.places[k].gone.area);
    EXPECT_EQ(one.change.places[k].volume.volume, four.change.places[k].volume.volume);
  }
}

}  // namespace
}  // namespace moldlight
