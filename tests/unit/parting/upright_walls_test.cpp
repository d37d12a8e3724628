#include "parting/upright_walls.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "classify/part_model.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "parting/make_halves.hpp"
#include "parting/planar_line.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr std::uint32_t k_sides = 24, k_twisted = 60;
constexpr double k_reach = 2.0 / 2048.0;

struct PrismShape {
  double top = 1.0;       // radius above; 1 below
  double rounding = 0.0;  // by which the points of its rings are off at most
  std::uint32_t sides = k_sides;
  double twist = 0.0;  // of the upper ring, sides
};

/// Height 1.
TriangleMesh prism(const PrismShape& shape) {
  const auto& [top, rounding, sides, twist] = shape;
  test::Random random(7);
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double turn = 2.0 * std::numbers::pi * (k + z * twist) / sides, radius = z > 0.0 ? top : 1.0;
      mesh.vertices.emplace_back(radius * std::cos(turn) + random.between(-rounding, rounding),
                                 radius * std::sin(turn) + random.between(-rounding, rounding), z);
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, 1.0);
  for (std::uint32_t k = 0; k < sides; ++k) {
    const std::uint32_t a = k, b = (k + 1) % sides;
    mesh.facets.push_back({a, b, sides + a});
    mesh.facets.push_back({b, sides + b, sides + a});
    mesh.facets.push_back({b, a, 2 * sides});
    mesh.facets.push_back({sides + a, sides + b, 2 * sides + 1});
  }
  return mesh;
}
/// The corners of its upper ring stand above the middles of the lower one's sides, so that every other facet
/// of the wall leans back from either half by 0.0014.
TriangleMesh twisted_prism(double top) { return prism({.top = top, .sides = k_twisted, .twist = 0.5}); }

SheetFrame frame_of(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  return {mold_frame({0, 0, 1}), box.center(), glm::distance(box.min, box.max)};
}

TEST(UprightWalls, StandExactlyUprightAndHardlyMove) {
  const TriangleMesh mesh = prism({.rounding = 2e-6});
  const auto part = with_upright_walls(mesh, frame_of(mesh), 0.0, Progress());
  ASSERT_TRUE(part);
  const TriangleMesh* upright = &part->mesh;
  ASSERT_EQ(upright->facets, mesh.facets);
  for (std::uint32_t k = 0; k < k_sides; ++k) {
    const glm::dvec3 &below = upright->vertices[k], &above = upright->vertices[k_sides + k];
    EXPECT_NEAR(below.x, above.x, 1e-14);
    EXPECT_NEAR(below.y, above.y, 1e-14);
  }
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    EXPECT_LT(glm::distance(mesh.vertices[k], upright->vertices[k]), 4e-6);
    EXPECT_EQ(mesh.vertices[k].z, upright->vertices[k].z);
  }
}

TEST(UprightWalls, WithDraftKeepIt) {
  const TriangleMesh drafted = prism({.top = 0.99}), upright = prism({});
  EXPECT_FALSE(with_upright_walls(drafted, frame_of(drafted), k_reach, Progress()));
  EXPECT_FALSE(with_upright_walls(upright, frame_of(upright), k_reach, Progress()));
  // Every other facet leans a little, but all to one side.
  const TriangleMesh twisted = prism({.top = 0.9985, .sides = 80, .twist = 0.5});
  EXPECT_FALSE(with_upright_walls(twisted, frame_of(twisted), k_reach, Progress()));
}

TEST(UprightWalls, AreDividedWhereFacetsOfARoundWallLeanBothWays) {
  const TriangleMesh mesh = twisted_prism(1.0);
  const auto part = with_upright_walls(mesh, frame_of(mesh), k_reach, Progress());
  ASSERT_TRUE(part);
  // Each corner of a ring divides the other ring's side.
  ASSERT_EQ(part->mesh.vertices.size(), mesh.vertices.size() + 2 * k_twisted);
  ASSERT_EQ(part->facet_of.size(), part->mesh.facets.size());
  const FacetGeometry own = facet_geometry(mesh), divided = facet_geometry(part->mesh);
  for (FacetIndex facet = 0; facet < part->mesh.facets.size(); ++facet) {
    const double lean = divided.normals[facet].z;
    EXPECT_TRUE(std::abs(lean) < 1e-12 || std::abs(lean) > 0.5) << facet;
    EXPECT_GT(glm::dot(divided.normals[facet], own.normals[part->facet_of[facet]]), 0.99) << facet;
  }
  // Closed, the prism over both rings' outlines together.
  EXPECT_NEAR(signed_volume(part->mesh), k_twisted * std::sin(std::numbers::pi / k_twisted), 1e-12);
}

/// Places of a mesh's corners on the round wall of radius 1, as seen along the direction, about that.
std::set<std::pair<long, long>> columns_of(const TriangleMesh& mesh, double low, double high) {
  std::set<std::pair<long, long>> columns;
  for (const glm::dvec3& vertex : mesh.vertices) {
    if (vertex.z < low || vertex.z > high || glm::length(glm::dvec2(vertex)) < 0.9) continue;
    columns.emplace(std::lround(1e6 * vertex.x), std::lround(1e6 * vertex.y));
  }
  return columns;
}

TEST(UprightWalls, InLineAreDividedAlike) {
  // Two columns, one above the other, whose corners do not stand above each other's.
  const TriangleMesh below = prism({.sides = k_twisted});
  const auto above = [&](double radius) {
    TriangleMesh mesh =
        test::rotated(below, glm::angleAxis(0.4 * 2.0 * std::numbers::pi / k_twisted, glm::dvec3(0, 0, 1)));
    for (glm::dvec3& vertex : mesh.vertices) vertex = {radius * vertex.x, radius * vertex.y, vertex.z + 2.0};
    return mesh;
  };
  const TriangleMesh both = test::joined(below, above(1.0));
  const auto part = with_upright_walls(both, frame_of(both), k_reach, Progress());
  ASSERT_TRUE(part);
  EXPECT_EQ(columns_of(part->mesh, 0.0, 1.0).size(), 2 * k_twisted);
  EXPECT_EQ(columns_of(part->mesh, 0.0, 1.0), columns_of(part->mesh, 2.0, 3.0));
  EXPECT_TRUE(defect_chains(part->mesh, EdgeDefect::open).empty());
  // A thicker one is no wall in line with it.
  const TriangleMesh apart = test::joined(below, above(1.0015));
  EXPECT_FALSE(with_upright_walls(apart, frame_of(apart), k_reach, Progress()));
}

TEST(UprightWalls, AreNotDividedWhereTheFacetsBesideWouldTurnOver) {
  // On a flange that is wider by less than what the wall's foot would bulge.
  TriangleMesh mesh = twisted_prism(1.0);
  const std::uint32_t foot = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const double z : {0.0, -0.5}) {
    for (std::uint32_t k = 0; k < k_twisted; ++k)
      mesh.vertices.push_back(glm::dvec3(1.0005, 1.0005, 0.0) * mesh.vertices[k] + glm::dvec3(0, 0, z));
  }
  mesh.vertices[2 * k_twisted].z = -0.5;  // the middle of the bottom
  for (std::uint32_t k = 0; k < k_twisted; ++k) {
    const std::uint32_t a = k, b = (k + 1) % k_twisted;
    auto& bottom = mesh.facets[4 * k + 2];
    bottom = {foot + k_twisted + b, foot + k_twisted + a, 2 * k_twisted};
    for (const auto& [p, q, r, s] :
         {std::array{a, foot + a, foot + b, b},
          std::array{foot + a, foot + k_twisted + a, foot + k_twisted + b, foot + b}}) {
      mesh.facets.push_back({p, q, r});
      mesh.facets.push_back({p, r, s});
    }
  }
  ASSERT_TRUE(health_report(mesh, facet_geometry(mesh)).closed);
  const auto part = with_upright_walls(mesh, frame_of(mesh), k_reach, Progress());
  const TriangleMesh& made = part ? part->mesh : mesh;
  const FacetGeometry own = facet_geometry(mesh), divided = facet_geometry(made);
  EXPECT_TRUE(health_report(made, divided).closed);
  for (FacetIndex facet = 0; facet < made.facets.size(); ++facet)
    EXPECT_GT(glm::dot(divided.normals[facet], own.normals[part ? part->facet_of[facet] : facet]), 0.0)
        << facet;
}

TEST(UprightWalls, LeaveWhatIsFartherOff) {
  const TriangleMesh mesh = twisted_prism(1.0);
  EXPECT_FALSE(with_upright_walls(mesh, frame_of(mesh), 4e-4, Progress()));
}

TEST(UprightWalls, ThatLeanByRoundingGetASurfaceOfOnePlane) {
  Part part;
  part.mesh = prism({.rounding = 2e-6});
  const auto model = prepare_part(std::move(part), Progress());
  const MoldHalves halves = make_halves(*model, {0, 0, 1}, {.height = 0.5, .line = nullptr}, {}, Progress());
  ASSERT_TRUE(halves.made()) << halves.refusal;
  EXPECT_NEAR(halves.surface.shelf_share(), 1.0, 1e-12);
  EXPECT_NEAR(halves.surface.rim_high, halves.surface.rim_low, 1e-9);
  EXPECT_EQ(halves.surface.faces, 1U);
  EXPECT_EQ(halves.contact_area, 0.0);
  EXPECT_NE(halves.upright_volume, 0.0);
  EXPECT_NEAR(halves.upright_volume / halves.part_volume, 0.0, 1e-5);
}

TEST(UprightWalls, LetHalvesMeetInOnePlaneWhereFacetsLeanBothWays) {
  const auto model = test::model_of(twisted_prism(1.0));
  const glm::dvec3 up(0, 0, 1);
  const MoldLine line = find_mold_line(*model, {up, {}}, {}, Progress{});
  ASSERT_LT(line.line.outer_high - line.line.outer_low, 1e-9);

  const MoldHalves halves = make_halves(*model, up, meeting_place(line), {}, Progress{});
  ASSERT_TRUE(halves.certified()) << halves.refusal;
  EXPECT_NEAR(halves.surface.shelf_share(), 1.0, 1e-12);
  EXPECT_EQ(halves.surface.faces, 1U);
  // Between the part and the prism over both rings' outlines together.
  const double turn = std::numbers::pi / k_twisted;
  const double most = std::numbers::pi - 0.5 * k_twisted * std::sin(2.0 * turn);
  EXPECT_GT(halves.upright_volume, 0.0);
  EXPECT_LT(halves.upright_volume, most);
}

TEST(WallCaps, KeepALineOfOnePlaneLevelBesideAThread) {
  const auto model = load_part((test::asset_folder() / "parts" / "bottle_cap.stl").string(), {}, Progress{});
  const glm::dvec3 along(0, 1, 0);
  const MoldLine line = find_mold_line(*model, {along, {}}, {}, Progress{});
  ASSERT_TRUE(line.line.is_planar(model->frame.diagonal));
  const MoldHalves plain =
      make_halves(*model, along, {.height = line.assignment.height, .line = &line.line}, {}, Progress{});
  ASSERT_TRUE(plain.made()) << plain.refusal;
  EXPECT_LT(plain.surface.shelf_share(), 0.995);
  const MoldHalves halves = make_halves(*model, along, meeting_place(line), {}, Progress{});
  ASSERT_TRUE(halves.certified()) << halves.refusal;
  EXPECT_NEAR(halves.surface.shelf_share(), 1.0, 1e-12);
}

TEST(WallCaps, LeaveWallsThatLeanByMoreThanTwiceTheLateralTolerance) {
  const auto model = test::model_of(twisted_prism(1.004));
  const glm::dvec3 up(0, 0, 1);
  const MoldLine line = find_mold_line(*model, {up, {}}, {}, Progress{});
  const MoldHalves halves = make_halves(*model, up, meeting_place(line), {}, Progress{});
  ASSERT_TRUE(halves.made()) << halves.refusal;
  EXPECT_NEAR(halves.upright_volume, 0.0, 1e-6);
}

}  // namespace
}  // namespace moldlight
