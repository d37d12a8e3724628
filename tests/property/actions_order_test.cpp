// The same part in another order, place, hand or size has the same side actions.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// Another way to give a part, and by how much it is larger then.
struct Change {
  std::string name;
  std::function<TriangleMesh(const TriangleMesh&)> mesh;
  glm::dquat turn = glm::dquat(1, 0, 0, 0);
  double scale = 1.0;
  double rounding = 2e-6;  // of travels, share of the diagonal
};

std::vector<Change> orders() {
  std::vector<Change> changes;
  for (const std::uint32_t seed : {1U, 2U, 3U})
    changes.push_back({"facets in order " + std::to_string(seed),
                       [seed](const TriangleMesh& mesh) { return test::permuted(mesh, seed); }});
  return changes;
}

std::vector<Change> all_changes() {
  std::vector<Change> changes = orders();
  changes.push_back({"mirrored", test::mirrored});
  changes.push_back({"twice as large",
                     [](const TriangleMesh& mesh) { return test::scaled(mesh, 2.0); },
                     {1, 0, 0, 0},
                     2.0});
  for (const glm::dquat& turn :
       {glm::angleAxis(glm::radians(37.0), glm::dvec3(0, 0, 1)), test::random_rotation(5)})
    // Rays that graze an edge meet it or not.
    changes.push_back(
        {"turned", [turn](const TriangleMesh& mesh) { return test::rotated(mesh, turn); }, turn, 1.0, 2e-4});
  return changes;
}

Planned changed_plan(const TriangleMesh& mesh, const Change& change, const glm::dvec3& direction) {
  ActionSettings settings;
  for (double* length : {&settings.lifter_room_mm, &settings.clearance_mm, &settings.least_travel_mm,
                         &settings.bundle_across_mm, &settings.bundle_along_mm, &settings.lifter_section_mm,
                         &settings.pin_diameter_mm})
    *length *= change.scale;
  return plan_of(change.mesh(mesh), settings, change.turn * direction);
}

std::vector<double> travels(const ActionPlan& plan, double scale) {
  std::vector<double> found;
  for (const SideAction& action : plan.actions) found.push_back(action.travel / scale);
  std::ranges::sort(found);
  return found;
}

/// `least_rounding`: of the travels, share of the diagonal.
void expect_same(const TriangleMesh& mesh, const std::vector<Change>& changes, double least_rounding = 0.0,
                 const glm::dvec3& direction = {0, 0, 1}) {
  const Planned own = plan_of(mesh, {}, direction);
  for (const Change& change : changes) {
    SCOPED_TRACE(change.name);
    const Planned other = changed_plan(mesh, change, direction);
    EXPECT_EQ(own.plan.undercuts.size(), other.plan.undercuts.size());
    EXPECT_EQ(actions_text(own.plan), actions_text(other.plan));
    EXPECT_EQ(own.plan.rejected.size(), other.plan.rejected.size());
    const std::vector<double> a = travels(own.plan, 1.0), b = travels(other.plan, change.scale);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
      EXPECT_NEAR(a[k], b[k], std::max(least_rounding, change.rounding) * own.model->frame.diagonal);
  }
}

TEST(ActionsOrder, OfMadePartsDoesNotMatter) {
  const Loop2 slot = {{16, 20}, {16, 12}, {12, 12}, {12, 6}, {28, 6}, {28, 12}, {24, 12}, {24, 20}};
  for (const TriangleMesh& mesh :
       {box_with_hook(3.0), box_with_hook(3.0, 5.5, 20.0), box_with_vents(), block_with_pockets(40.0),
        block_with_pockets(60.0), laid(block_with_hole({.draft_deg = 2.0}), 0.0),
        block_with_cavity(slot, {40, 20}, 30.0)})
    expect_same(mesh, all_changes());
  // Its halves meet in a facet; those of a turned one in another.
  expect_same(spool(48, 0.0), all_changes(), 0.01);
}

TEST(ActionsOrder, OfRealPartsDoesNotMatter) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "the shared parts are not here";
  for (const char* name : {"framework_expansion_card.stl", "m5_stamplc_face_shell.stl", "so101_base.stl"}) {
    SCOPED_TRACE(name);
    const auto model = load_part((*shared / "parts" / name).string(), {}, Progress());
    expect_same(model->part.mesh, orders());
  }
}

/// As a file in single precision has them, along directions that the mirror leaves.
TEST(ActionsOrder, OfRealPartsMirroredAndTurnedDoesNotMatter) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "the shared parts are not here";
  const glm::dquat turn = glm::angleAxis(glm::radians(37.0), glm::normalize(glm::dvec3(1, 1, 1)));
  const std::vector<Change> changes = {
      {"mirrored", test::mirrored},
      {"turned",
       [turn](const TriangleMesh& mesh) { return test::rounded_to_float(test::rotated(mesh, turn)); }, turn}};
  const glm::dvec3 y(0, 1, 0);
  for (const auto& [name, direction] : {std::pair("lego_brick_2x4.stl", y),
                                        {"odri_pulley_t30_output.stl", y},
                                        {"so101_trigger.stl", y},
                                        {"so100_lego_gauge.stl", y},
                                        {"framework_expansion_card.stl", y},
                                        {"m5_stamplc_face_shell.stl", y}}) {
    SCOPED_TRACE(name);
    const auto model = load_part((*shared / "parts" / name).string(), {}, Progress());
    expect_same(model->part.mesh, changes, 1e-3, direction);
  }
}

}  // namespace
}  // namespace moldlight
