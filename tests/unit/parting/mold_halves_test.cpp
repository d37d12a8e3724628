// Mold halves of solids for which they are known.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mesh/health.hpp"
#include "mesh/orient.hpp"
#include "parting/mold_files.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/mold_checks.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

using test::model_of;

MoldHalves halves_of(const std::shared_ptr<const PartModel>& model, const glm::dvec3& direction,
                     double height, const MoldSettings& settings = {}) {
  return make_halves(*model, direction, height, settings, Progress{});
}

/// All that the certificate promises, found anew on what would be written.
void expect_certified(const MoldHalves& halves, const std::string& name, const TriangleMesh* part = nullptr) {
  ASSERT_TRUE(halves.made()) << name << ": " << halves.refusal;
  EXPECT_LE(std::abs(halves.volume_gap), 1e-9) << name;
  EXPECT_LE(halves.fold_area, 1e-8) << name;
  const WrittenMold written = written_mold(halves);
  ASSERT_EQ(written.refusal, "") << name;
  std::vector<TriangleMesh> bodies;
  for (const WrittenBody& body : written.bodies) {
    EXPECT_TRUE(body.closed) << name;
    EXPECT_NEAR(signed_volume(body.mesh), body.volume, 1e-5 * halves.block_volume) << name;
    bodies.push_back(body.mesh);
  }
  const glm::dvec3 up = written.part_frame ? halves.frame.z : glm::dvec3(0, 0, 1);
  EXPECT_LE(test::undercut_share(bodies[0], up, 0.01), 1e-6) << name;
  EXPECT_LE(test::undercut_share(bodies[1], -up, 0.01), 1e-6) << name;
  if (part != nullptr) bodies.push_back(*part);
  if (part != nullptr) {
    EXPECT_EQ(test::misplaced_points(bodies, 20000, 7), 0U) << name;
  }
  for (const TriangleMesh& body : bodies) {
    const Bounds box = bounds(body);
    const test::SectionCheck sections = test::check_sections(body, (box.max.z - box.min.z) / 40.0);
    EXPECT_GE(sections.sections, 39U) << name;
    EXPECT_EQ(sections.open, 0U) << name;
    EXPECT_EQ(sections.crossing, 0U) << name;
  }
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
  EXPECT_NEAR(halves.parting_area, 6.0 * 5.0 - 4.0 * 3.0, 1e-9);
  EXPECT_EQ(halves.shut_off_area, 0.0);
  EXPECT_NEAR(halves.contact_area, 0.0, 1e-12);
  EXPECT_NEAR(halves.steepest_deg, 0.0, 1e-6);
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
  EXPECT_LE(halves.steepest_deg, 60.001);
}

TEST(MoldHalves, OfPlatesCloseTheirHoles) {
  for (const auto& [rows, columns] : {std::pair{1, 1}, {1, 2}, {5, 10}}) {
    const TriangleMesh plate = test::plate_with_holes(rows, columns, 2.0);
    const MoldHalves halves = halves_of(model_of(plate), {0, 0, 1}, 1.0);
    expect_certified(halves, "plate", &plate);
    EXPECT_NEAR(halves.shut_off_area, 16.0 * rows * columns, 1e-6);
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
  EXPECT_GT(halves.steepest_deg, 5.0);
  EXPECT_LE(halves.steepest_deg, 60.001);
  EXPECT_NEAR(halves.contact_area, 0.0, 1e-9);
}

TEST(MoldHalves, LeaveUndercutsToInserts) {
  const test::Shape shape = test::cup_with_side_hole({});
  const MoldHalves halves = halves_of(model_of(shape.mesh), shape.direction, 1.0);
  expect_certified(halves, "cup", &shape.mesh);
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

TEST(MoldHalves, OfAnOpenPartAreRefused) {
  TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
  box.facets.pop_back();
  const MoldHalves halves = halves_of(model_of(box), {0, 0, 1}, 0.5);
  EXPECT_FALSE(halves.made());
  EXPECT_NE(halves.refusal.find("not closed"), std::string::npos);
  EXPECT_NE(written_mold(halves).refusal, "");
}

TEST(MoldHalves, OfBodiesThatOverlapAreRefusedWithThePlace) {
  const MoldHalves halves = halves_of(
      model_of(test::joined(test::box_mesh({0, 0, 0}, {2, 2, 2}), test::box_mesh({1, 1, 1}, {3, 3, 3}))),
      {0, 0, 1}, 1.0);
  EXPECT_FALSE(halves.made());
  EXPECT_NE(halves.refusal.find("overlap"), std::string::npos) << halves.refusal;
  ASSERT_TRUE(halves.refused_at.has_value());
  EXPECT_NEAR(glm::distance(*halves.refused_at, glm::dvec3(1.5)), 0.0, 1e-6);
}

}  // namespace
}  // namespace moldlight
