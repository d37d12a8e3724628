// Mold halves of solids for which they are known.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "mesh/orient.hpp"
#include "parting/halves/parting_surface.hpp"
#include "parting/make_halves.hpp"
#include "parting/mold_files.hpp"
#include "parting/mold_report.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/mesh_edits.hpp"
#include "support/mold_checks.hpp"
#include "support/shapes.hpp"
#include "unit/parting/certified_halves.hpp"

namespace moldlight {
namespace {

using test::expect_certified;
using test::model_of;

MoldHalves halves_of(const std::shared_ptr<const PartModel>& model, const glm::dvec3& direction,
                     double height, const MoldSettings& settings = {}) {
  return make_halves(*model, direction, {height}, settings, Progress{});
}

TEST(MoldHalves, OfABoxAreTwoHalvesOfABlock) {
  const TriangleMesh box = test::box_mesh({1, 2, 3}, {5, 5, 5});
  MoldSettings settings;
  settings.margin = 1.0;
  const MoldHalves halves = halves_of(model_of(box), {0, 0, 1}, 3.5, settings);
  expect_certified(halves, "box", &box);
  EXPECT_NEAR(halves.block_volume, 6.0 * 5.0 * 4.0, 1e-9);
  EXPECT_NEAR(halves.core.volume, 6.0 * 5.0 * 2.5 - 4.0 * 3.0 * 1.5, 1e-9);
  EXPECT_NEAR(halves.cavity.volume, 6.0 * 5.0 * 1.5 - 4.0 * 3.0 * 0.5, 1e-9);
  EXPECT_NEAR(halves.surface.parting_area, 6.0 * 5.0 - 4.0 * 3.0, 1e-9);
  EXPECT_EQ(halves.surface.shut_off_area, 0.0);
  EXPECT_NEAR(halves.contact_area, 0.0, 1e-12);
  EXPECT_NEAR(halves.surface.steepest_deg, 0.0, 1e-6);
  EXPECT_TRUE(halves.inserts.empty());
  EXPECT_EQ(test::crossed_facets(halves.core.mesh), 0U);
  EXPECT_TRUE(written_mold(halves).part_frame);
}

TEST(MoldHalves, GrowByTheShrinkage) {
  const TriangleMesh box = test::box_mesh({1, 2, 3}, {5, 5, 5});
  MoldSettings settings;
  settings.margin = 1.0;
  settings.shrink_pct = 20.0;
  const MoldHalves halves = halves_of(model_of(box), {0, 0, 1}, 3.5, settings);
  expect_certified(halves, "box");
  EXPECT_NEAR(halves.part_volume, 24.0 * 1.25 * 1.25 * 1.25, 1e-9);
  EXPECT_NEAR(halves.core.volume, (6.0 * 5.0 * 2.5 - 4.0 * 3.0 * 1.5) * 1.953125, 1e-9);
}

TEST(MoldHalves, HaveConesThatKeepThemInRegister) {
  const TriangleMesh box = test::box_mesh({1, 2, 3}, {5, 5, 5});
  MoldSettings settings;
  settings.margin = 1.0;
  const MoldHalves plain = halves_of(model_of(box), {0, 0, 1}, 3.5, settings);
  settings.registration = true;
  const MoldHalves halves = halves_of(model_of(box), {0, 0, 1}, 3.5, settings);
  expect_certified(halves, "box with cones", &box);
  const auto frustum = [](double foot, double top) {
    const double depth = 0.9 * std::sqrt(3.0) * (foot - top);
    return std::numbers::pi * depth * (foot * foot + foot * top + top * top) / 3.0;
  };
  const double grown = halves.core.volume - plain.core.volume;
  EXPECT_NEAR(grown / (3.0 * frustum(0.36, 0.16) + frustum(0.288, 0.128)), 1.0, 0.02);
  EXPECT_LE(halves.surface.steepest_deg, 60.001);
}

TEST(MoldHalves, OfPlatesCloseTheirHoles) {
  for (const auto& [rows, columns] : {std::pair{1, 1}, {1, 2}, {5, 10}}) {
    const TriangleMesh plate = test::plate_with_holes(rows, columns, 2.0);
    const MoldHalves halves = halves_of(model_of(plate), {0, 0, 1}, 1.0);
    expect_certified(halves, "plate", &plate);
    EXPECT_NEAR(halves.surface.shut_off_area, 16.0 * rows * columns, 1e-6);
    EXPECT_NEAR(halves.contact_area, 0.0, 1e-9);
  }
}

TEST(MoldHalves, OfCurvedSolidsKeepTheSlope) {
  const TriangleMesh torus = test::torus_mesh(10.0, 2.0, 60, 24);
  expect_certified(halves_of(model_of(torus), {0, 0, 1}, 0.0), "torus", &torus);
  const TriangleMesh saddle =
      test::sheet_mesh(90, 10.0, 0.5, [](double x, double y) { return 0.02 * (x * x - y * y); });
  const MoldHalves halves = halves_of(model_of(saddle), {0, 0, 1}, 0.0);
  expect_certified(halves, "saddle", &saddle);
  EXPECT_GT(halves.surface.steepest_deg, 5.0);
  EXPECT_LE(halves.surface.steepest_deg, 60.001);
  EXPECT_NEAR(halves.contact_area, 0.0, 1e-9);
}

TEST(MoldHalves, LeaveUndercutsToInserts) {
  const test::Shape shape = test::cup_with_side_hole({});
  const MoldHalves halves = halves_of(model_of(shape.mesh), shape.direction, 1.0);
  expect_certified(halves, "cup_with_side_hole", &shape.mesh);
  ASSERT_EQ(halves.inserts.size(), 1U);
  EXPECT_GT(halves.insert_volume, 0.0);
  EXPECT_EQ(halves.inserts[0].open_edges, 0U);
  const MoldHalves upright = halves_of(model_of(test::torus_mesh(10.0, 2.0, 60, 24)), {1, 0, 0}, 0.0);
  expect_certified(upright, "upright torus");
  ASSERT_GE(upright.inserts.size(), 1U);
  EXPECT_NEAR(insert_place(upright, 0).x, 0.0, 0.5);
}

TEST(MoldHalves, OfKnownShapesAreCertified) {
  std::size_t made = 0;
  for (const test::Shape& shape : test::all_shapes({})) {
    const MoldHalves halves = halves_of(model_of(shape.mesh), shape.direction, 0.0);
    expect_certified(halves, shape.name);
    made += halves.made() ? 1 : 0;
  }
  EXPECT_GT(made, 30U);
}

TEST(MoldHalves, AreTheSameTwice) {
  const TriangleMesh torus = test::torus_mesh(10.0, 2.0, 60, 24);
  const MoldHalves one = halves_of(model_of(torus), {0, 0, 1}, 0.0),
                   two = halves_of(model_of(torus), {0, 0, 1}, 0.0);
  EXPECT_EQ(one.core.mesh.vertices, two.core.mesh.vertices);
  EXPECT_EQ(one.core.mesh.facets, two.core.mesh.facets);
}

TEST(MoldHalves, OfATurnedPartHaveABlockThatIsSquareToItsWalls) {
  const test::Shape upright = test::cup({});
  MoldSettings settings;
  settings.margin = 5.0;
  const double diagonal = model_of(upright.mesh)->frame.diagonal;
  const auto size_of = [](const MoldHalves& halves, double unit) {
    const glm::dvec2 size = unit * (halves.block_high - halves.block_low);
    return glm::dvec2(std::min(size.x, size.y), std::max(size.x, size.y));
  };
  const MoldHalves straight = halves_of(model_of(upright.mesh), upright.direction, 0.5, settings);
  ASSERT_TRUE(straight.made()) << straight.refusal;
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const glm::dquat rotation = test::random_rotation(seed);
    const auto part = model_of(test::rotated(upright.mesh, rotation));
    const MoldHalves turned = halves_of(part, rotation * upright.direction, 0.5, settings);
    ASSERT_TRUE(turned.made()) << turned.refusal;
    EXPECT_LT(glm::distance(size_of(turned, part->frame.diagonal), size_of(straight, diagonal)), 0.1)
        << "columns of the block are whole";
  }
}

/// Why, where, at which loop, and what to change.
void expect_refused(const MoldHalves& halves, std::string_view why, const glm::dvec3& place, double slack) {
  EXPECT_FALSE(halves.made());
  EXPECT_NE(halves.refusal.find(why), std::string::npos) << halves.refusal;
  EXPECT_NE(halves.change, "") << halves.refusal;
  ASSERT_TRUE(halves.refused_at.has_value()) << halves.refusal;
  EXPECT_LE(glm::distance(*halves.refused_at, place), slack) << halves.refusal;
}

TEST(MoldHalvesRefused, OfAnOpenPartTellWhereItIsOpen) {
  TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
  glm::dvec3 hole(0.0);
  for (int k = 0; k < 3; ++k) hole += box.corner(static_cast<FacetIndex>(box.facets.size() - 1), k) / 3.0;
  box.facets.pop_back();
  const auto model = model_of(box);
  const MoldHalves halves = halves_of(model, {0, 0, 1}, 0.5);
  expect_refused(halves, "not closed", hole, 0.3);
  const WrittenMold written = written_mold(halves);
  EXPECT_EQ(written.refusal, halves.refusal);
  const Assignment assignment = assign_sides(*model, {glm::dvec3(0, 0, 1), {}}, {}, Progress{});
  const PartingLine line = parting_line(assignment);
  const std::string loop = loop_near(line, *halves.refused_at);
  const std::string text = refusal_text(*model, halves, written, loop);
  EXPECT_NE(text.find(", near "), std::string::npos) << text;
  EXPECT_NE(text.find("at outer loop 1"), std::string::npos) << text;
  EXPECT_NE(text.find("--repair full"), std::string::npos) << text;
}

TEST(MoldHalvesRefused, OfBodiesThatOverlap) {
  const MoldHalves halves = halves_of(
      model_of(test::joined(test::box_mesh({0, 0, 0}, {2, 2, 2}), test::box_mesh({1, 1, 1}, {3, 3, 3}))),
      {0, 0, 1}, 1.0);
  expect_refused(halves, "overlap", glm::dvec3(1.5), 1e-6);
}

TEST(MoldHalvesRefused, OfBodiesThatOverlapBeforeAnyHalfIsMade) {
  const auto model =
      model_of(test::joined(test::box_mesh({0, 0, 0}, {2, 2, 2}), test::box_mesh({1, 1, 1}, {3, 3, 3})));
  const auto farthest = [](const PartModel& part) {
    double most = 0.0;
    const Progress progress([&](std::string_view stage, double fraction) {
      if (stage == k_halves_stage) most = std::max(most, fraction);
    });
    static_cast<void>(make_halves(part, {0, 0, 1}, {1.0}, {}, progress));
    return most;
  };
  const double refused = farthest(*model), made = farthest(*model_of(test::box_mesh({0, 0, 0}, {2, 2, 2})));
  EXPECT_GT(refused, 0.0);
  EXPECT_LT(refused, 0.5);
  EXPECT_GE(made, 0.5);
}

TEST(MoldHalvesRefused, OfAPartThatIsAllButEdgeOn) {
  const MoldHalves halves = halves_of(model_of(test::box_mesh({0, 0, 0}, {1e-11, 1, 1})), {0, 0, 1}, 0.5);
  EXPECT_FALSE(halves.made());
  EXPECT_NE(halves.refusal.find("too thin"), std::string::npos) << halves.refusal;
  EXPECT_NE(halves.change.find("direction"), std::string::npos) << halves.change;
}

/// Sheets of a square that is seen from above, each wrong in its own way.
TEST(MoldHalvesRefused, NameThePlaceInTheSheets) {
  const auto square = [](Sheet sheet, double z, bool up, Sheets& sheets) {
    const auto first = static_cast<SheetVertex>(sheets.vertices.size());
    for (const glm::dvec2& at : {glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
      sheets.vertices.emplace_back(at, z);
    sheets.column_of.resize(sheets.vertices.size(), k_no_plane_point);
    for (const std::array<SheetVertex, 3>& c : {std::array<SheetVertex, 3>{0, 1, 2}, {0, 2, 3}}) {
      const SheetVertex a = first + c[0], b = first + c[1], d = first + c[2];
      sheets.facets.push_back({up ? std::array{a, b, d} : std::array{a, d, b}, sheet});
    }
  };
  const auto on_rim = [](const std::optional<glm::dvec3>& place) {
    return place && (place->x == 0.0 || place->x == 1.0 || place->y == 0.0 || place->y == 1.0);
  };
  SurfaceWish wish{.low = {-1, -1}, .high = {2, 2}};
  Sheets twice;
  square(Sheet::upper, 1.0, true, twice);
  square(Sheet::upper, 2.0, true, twice);
  ASSERT_FALSE(twice.align_ends(1e-7).has_value());
  PartingSurface surface;
  const auto over = add_parting_surface(twice, wish, surface, Progress{});
  ASSERT_TRUE(over.has_value());
  EXPECT_NE(over->what.find("overlaps itself"), std::string::npos) << over->what;
  EXPECT_TRUE(on_rim(over->place));
  EXPECT_NE(over->change, "");

  Sheets open;
  square(Sheet::upper, 1.0, true, open);
  ASSERT_FALSE(open.align_ends(1e-7).has_value());
  std::vector<std::array<SheetVertex, 3>> facets;
  const auto gap = close_upright(
      open, {.sheets = Sheets::bit(Sheet::upper) | Sheets::bit(Sheet::lower), .turned = 0}, facets);
  EXPECT_TRUE(on_rim(gap));
  square(Sheet::lower, 0.0, false, open);
  ASSERT_FALSE(open.align_ends(1e-7).has_value());
  facets.clear();
  EXPECT_FALSE(close_upright(open,
                             {.sheets = Sheets::bit(Sheet::upper) | Sheets::bit(Sheet::lower), .turned = 0},
                             facets)
                   .has_value());
  EXPECT_NEAR(check_body(open.vertices, facets).volume, 1.0, 1e-12);
  facets.pop_back();
  EXPECT_TRUE(check_body(open.vertices, facets).open_at.has_value());
}

/// What the certificate in single precision finds wrong with bodies that are.
TEST(MoldHalvesRefused, WhereTheFilesWouldBeWrong) {
  const MoldHalves sound = halves_of(model_of(test::box_mesh({1, 2, 3}, {5, 5, 5})), {0, 0, 1}, 3.5);
  ASSERT_TRUE(sound.made());
  EXPECT_EQ(written_mold(sound).refusal, "");
  MoldHalves folded = sound;
  folded.core.mesh = test::joined(sound.core.mesh, test::box_mesh({-1, -1, 0}, {1, 1, 0.5}));
  const WrittenMold over = written_mold(folded);
  EXPECT_NE(over.refusal.find("fold over itself"), std::string::npos) << over.refusal;
  ASSERT_TRUE(over.refused_at.has_value());
  EXPECT_LE(glm::distance(*over.refused_at, sound.centre), 1.5);
  MoldHalves open = sound;
  MoldBody hollow{.mesh = test::box_mesh({0, 0, 0}, {1, 1, 1}), .name = "insert_1"};
  hollow.mesh.facets.pop_back();
  open.inserts.push_back(hollow);
  const WrittenMold gap = written_mold(open);
  EXPECT_NE(gap.refusal.find("insert_1 would not be closed"), std::string::npos) << gap.refusal;
  ASSERT_TRUE(gap.refused_at.has_value());
  EXPECT_LE(glm::distance(*gap.refused_at, sound.centre + 0.5), 1.0);
}

}  // namespace
}  // namespace moldlight
