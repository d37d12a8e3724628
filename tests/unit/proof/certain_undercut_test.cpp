// What is called certain for a cell must be undercut along every direction of it: checked by rays from random
// points of the element along random directions of the cell, and on meshes with faults.
#include "proof/certain_undercut.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/proof_checks.hpp"
#include "support/proof_model.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

test::RaysChecked check(const test::ProofModel& model, const std::vector<SurfaceElement>& elements,
                        std::size_t wanted) {
  return test::check_certain(model, elements, wanted, 1, 11);
}

constexpr std::size_t k_checks = 2000;

TEST(CertainUndercut, OfPointsIsBlockedAlongEveryDirection) {
  for (const test::Shape& shape : {test::snap_hook({}), test::t_slot({}), test::cup_with_side_hole({}),
                                   test::hollow_sphere({}), test::dovetail_slot({})}) {
    const test::ProofModel model(test::model_of(test::subdivided(shape.mesh, 600)));
    const test::RaysChecked checked = check(model, model.samples(5000), k_checks);
    EXPECT_GT(checked.certain, k_checks / 20) << shape.name;
    EXPECT_EQ(checked.wrong, 0U) << shape.name << ", of " << checked.certain;
  }
}

TEST(CertainUndercut, InOneSenseIsBlockedAlongEveryDirection) {
  for (const test::Shape& shape : {test::snap_hook({}), test::t_slot({}), test::cup_with_side_hole({}),
                                   test::hollow_sphere({}), test::dovetail_slot({})}) {
    const test::ProofModel model(test::model_of(test::subdivided(shape.mesh, 600)));
    for (const auto& elements : {model.samples(5000), model.pieces(100).pieces}) {
      const test::RaysChecked checked = test::check_blocked_along(model, elements, k_checks, 12);
      EXPECT_GT(checked.certain, k_checks / 20) << shape.name;
      EXPECT_EQ(checked.wrong, 0U) << shape.name << ", of " << checked.certain;
    }
  }
}

TEST(CertainUndercut, OfTrianglesIsBlockedFromEveryPoint) {
  for (const test::Shape& shape : {test::snap_hook({}), test::t_slot({}), test::cup_with_side_hole({}),
                                   test::hollow_sphere({}), test::dovetail_slot({})}) {
    const test::ProofModel model(test::model_of(test::subdivided(shape.mesh, 600)));
    const test::RaysChecked checked = check(model, model.pieces(100).pieces, k_checks);
    EXPECT_GT(checked.certain, k_checks / 20) << shape.name;
    EXPECT_EQ(checked.wrong, 0U) << shape.name << ", of " << checked.certain;
  }
}

/// A slab over a plate, apart from it.
TriangleMesh plate_under_slab(double half_width) {
  return test::joined(test::box_mesh({-1, -1, 0}, {1, 1, 0.1}),
                      test::box_mesh({-half_width, -half_width, 0.5}, {half_width, half_width, 0.6}));
}

SurfaceElement middle_of_plate(const test::ProofModel& model) {
  for (const SurfaceElement& element : model.samples(4000)) {
    if (model.part().geometry.normals[element.facet].z < 0.5) continue;
    const glm::dvec3 place = element.middle() * model.model().frame.diagonal + model.model().frame.center;
    if (std::abs(place.z - 0.1) < 1e-3 && std::abs(place.x) < 0.05 && std::abs(place.y) < 0.05)
      return element;
  }
  return {};
}

SphereCell cell_about_z(double half_angle_deg) {
  const double sine = std::sin(glm::radians(half_angle_deg)), cosine = std::cos(glm::radians(half_angle_deg));
  std::array<glm::dvec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(k) / 3.0 + 0.1;
    corners[k] = {sine * std::cos(turn), sine * std::sin(turn), cosine};
  }
  return SphereCell(corners);
}

/// The slab is seen from the plate's middle over about atan(1 / 0.4) = 68 degrees.
TEST(CertainUndercut, EndsWhereTheSheetDoes) {
  const test::ProofModel model(test::model_of(plate_under_slab(1.0)));
  CertainUndercut tester(model.part(), model.query());
  const SurfaceElement element = middle_of_plate(model);
  ASSERT_GT(element.area, 0.0);
  EXPECT_GT(tester.ask(element, cell_about_z(60.0)).certain_area, 0.0);
  const ElementAnswer wide = tester.ask(element, cell_about_z(75.0));
  EXPECT_EQ(wide.certain_area, 0.0);
  EXPECT_TRUE(wide.hidden_at_centre);
}

TEST(CertainUndercut, AnOpenEdgeInTheConeIsAnEnd) {
  TriangleMesh mesh = plate_under_slab(1.0);
  const test::ProofModel closed(test::model_of(mesh));
  const SurfaceElement element = middle_of_plate(closed);
  // One of the two facets of the slab's underside goes: the diagonal runs over the plate's middle.
  const auto is_underside = [&](FacetIndex facet) {
    return closed.part().geometry.normals[facet].z < -0.5 && mesh.corner(facet, 0).z > 0.3;
  };
  FacetIndex gone = 0;
  while (!is_underside(gone)) ++gone;
  mesh.facets.erase(mesh.facets.begin() + gone);
  const test::ProofModel open(test::model_of(mesh));
  CertainUndercut tester(open.part(), open.query());
  EXPECT_EQ(tester.ask(element, cell_about_z(30.0)).certain_area, 0.0);
}

TEST(CertainUndercut, DuplicatedFacetsMakeNothingCertainThatIsNot) {
  TriangleMesh mesh = test::snap_hook({}).mesh;
  mesh.facets.insert(mesh.facets.end(), mesh.facets.begin(), mesh.facets.begin() + 12);
  const test::ProofModel model(test::model_of(mesh));
  const test::RaysChecked checked = check(model, model.samples(3000), 1000);
  EXPECT_EQ(checked.wrong, 0U);
}

TEST(CertainUndercut, PilesOfBoxesThatTouchAndOverlapAreCheckedByRays) {
  TriangleMesh mesh = test::joined(plate_under_slab(0.7), test::box_mesh({0.2, 0.2, 0.1}, {0.4, 0.4, 0.55}));
  const test::ProofModel model(test::model_of(test::subdivided(mesh, 800)));
  for (const bool of_points : {true, false}) {
    const test::RaysChecked checked =
        check(model, of_points ? model.samples(5000) : model.pieces(100).pieces, k_checks);
    EXPECT_GT(checked.certain, k_checks / 20);
    EXPECT_EQ(checked.wrong, 0U) << "of " << checked.certain;
  }
}

}  // namespace
}  // namespace moldlight
