// Side actions of real parts, and measurements of the parts that they must agree with.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "actions/side_action.hpp"
#include "support/shared_parts.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

struct RealPlan {
  std::shared_ptr<const PartModel> model;
  Classification result;
  ActionPlan plan;
};

RealPlan plan_of(const std::filesystem::path& path, const ActionSettings& settings = {},
                 const glm::dvec3& direction = {0, 0, 1}) {
  RealPlan real;
  real.model = load_part(path.string(), {}, Progress());
  Query query;
  query.direction = direction;
  real.result = classify_exact(*real.model, query, Progress(), true);
  real.plan = find_actions(*real.model, real.result, settings, Progress());
  return real;
}

std::filesystem::path shipped(const char* name) { return test::asset_folder() / "parts" / name; }

/// The advance of a thread's crest for a turn, from its corners alone: the median of what those between a
/// 200th and a 60th of a turn apart, and hardly higher, rise. `radius` is the crest's about the middle of the
/// part's box.
double crest_pitch(const PartModel& model, double radius) {
  const Bounds box = bounds(model.part.mesh);
  const glm::dvec3 middle = 0.5 * (box.min + box.max);
  std::vector<glm::dvec2> corners;  // turn and height
  for (const glm::dvec3& vertex : model.part.mesh.vertices) {
    const glm::dvec3 from = vertex - middle;
    if (std::abs(std::hypot(from.x, from.y) - radius) < 0.005 * radius)
      corners.emplace_back(std::atan2(from.y, from.x) / (2.0 * std::numbers::pi), vertex.z);
  }
  std::vector<double> pitches;
  for (const glm::dvec2& a : corners) {
    for (const glm::dvec2& b : corners) {
      const glm::dvec2 step = b - a;
      if (step.x > 1.0 / 200.0 && step.x < 1.0 / 60.0 && std::abs(step.y) < 0.01 * radius)
        pitches.push_back(step.y / step.x);
    }
  }
  std::ranges::sort(pitches);
  return pitches.empty() ? 0.0 : pitches[pitches.size() / 2];
}

TEST(RealParts, CapOfOursIsUnscrewedByThePitchItWasModelledWith) {
  const RealPlan cap = plan_of(shipped("bottle_cap.stl"));
  ASSERT_EQ(actions_text(cap.plan), "1 unscrewing core");
  EXPECT_NEAR(cap.plan.actions[0].about->pitch, 2.2, 0.005 * 2.2) << "right-handed";
  EXPECT_TRUE(cap.plan.unreleased.empty());
  EXPECT_LT(std::hypot(cap.plan.actions[0].about->point.x, cap.plan.actions[0].about->point.y), 0.05);
}

TEST(RealParts, SharedCapIsUnscrewedByThePitchOfItsCrest) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "the shared parts are not here";
  const RealPlan cap = plan_of(*shared / "parts" / "screwcap_medical_bottle.stl");
  ASSERT_EQ(actions_text(cap.plan), "1 unscrewing core");
  const double pitch = cap.plan.actions[0].about->pitch;
  EXPECT_NEAR(pitch, 4.2, 0.005 * 4.2);
  EXPECT_NEAR(crest_pitch(*cap.model, 12.8), pitch, 0.01 * pitch) << "measured on the crest's corners";
}

/// The ring and the hole beside it are within the lengths of a slide: two slides, or three where none is
/// shared.
TEST(RealParts, ClipHasThreeSlidesOfWhichTwoAreOne) {
  const RealPlan shared = plan_of(shipped("cable_clip.stl"));
  EXPECT_EQ(shared.plan.undercuts.size(), 3U);
  EXPECT_EQ(actions_text(shared.plan), "2 slides");
  ActionSettings alone;
  alone.bundle_across_mm = 0.0;
  const RealPlan apart = plan_of(shipped("cable_clip.stl"), alone);
  EXPECT_EQ(actions_text(apart.plan), "3 slides");
  EXPECT_TRUE(apart.plan.unreleased.empty());
}

struct KnownSlides {
  const char* name;
  glm::dvec3 direction;
  const char* set;
  bool all;      // nothing is left unreleased
  int axis = 2;  // along which all slides stand
};

/// As many slides as there are sides to leave to, along the axes that the parts' walls stand along.
TEST(RealParts, SlidesStandSquareToTheWalls) {
  std::vector<std::pair<std::filesystem::path, KnownSlides>> rows = {
      {shipped("enclosure_lid.stl"), {"lid", {0, 1, 0}, "1 slide", false}}};
  const auto shared = test::shared_folder();
  if (shared) {
    for (const KnownSlides& known :
         {KnownSlides{"m5_base26_main.stl", {1, 0, 0}, "2 slides", true},
          KnownSlides{"m5_base26_main.stl", {0, 1, 0}, "2 slides", true},
          KnownSlides{"odri_hip_cover_64k.stl", {0, 1, 0}, "2 slides", true},
          KnownSlides{"m5_rfid2_face_shell.stl", {1, 0, 0}, "1 slide", false},
          KnownSlides{"m5_basic27_bottom_shell_open.obj", {0, 0, 1}, "2 slides", true, 1}})
      rows.emplace_back(*shared / "parts" / known.name, known);
  }
  for (const auto& [path, known] : rows) {
    SCOPED_TRACE(known.name);
    const RealPlan real = plan_of(path, {}, known.direction);
    EXPECT_EQ(actions_text(real.plan), known.set);
    EXPECT_EQ(real.plan.unreleased.empty(), known.all);
    for (const SideAction& action : real.plan.actions) {
      EXPECT_NEAR(std::abs(action.direction[known.axis]), 1.0, 1e-12);
      EXPECT_TRUE(action.body && !action.body->hit);
    }
  }
  RecordProperty("parts", static_cast<int>(rows.size()));
}

/// A sweep that looks for no side actions counts the undercuts that their list would have.
TEST(RealParts, UndercutsAreCountedAlikeWithAndWithoutSideActions) {
  std::vector<std::filesystem::path> paths;
  for (const char* name : {"bottle_cap.stl", "cable_clip.stl", "enclosure_lid.stl", "tilted_bracket.stl"})
    paths.push_back(shipped(name));
  if (const auto shared = test::shared_folder()) {
    for (const char* name : {"framework_expansion_card.stl", "m5_stamplc_face_shell.stl", "so101_base.stl",
                             "odri_pulley_t30_output.stl", "trimesh_fixed_top.ply"})
      paths.push_back(*shared / "parts" / name);
  }
  std::size_t greatest = 0;
  for (const std::filesystem::path& path : paths) {
    const auto model = load_part(path.string(), {}, Progress());
    SweepSettings settings;
    settings.directions = 20;
    settings.refine = 0;
    settings.rank = SweepRank::objective;
    settings.top = 2;
    settings.user_directions = {{0.3, 0.5, 0.8}};
    const SweepResult result = run_sweep(model, settings, Progress(), {});
    ASSERT_FALSE(result.candidates.empty());
    for (const SweepCandidate& candidate : result.candidates) {
      const Classification split = classify_exact(*model, candidate.classification.query(), Progress(), true);
      // Of the first what would be reported, of the others what is ranked.
      const bool first = &candidate == result.candidates.data();
      const ActionPlan plan =
          find_actions(*model, split, {}, Progress(), first ? PlanDetail::whole : PlanDetail::rank);
      EXPECT_EQ(figure_value(direction_figure("undercuts"), candidate),
                static_cast<double>(plan.undercuts.size()))
          << path.filename() << " along " << split.direction.x << ", " << split.direction.y << ", "
          << split.direction.z;
      greatest = std::max(greatest, plan.undercuts.size());
    }
  }
  EXPECT_GT(greatest, 5U);
}

/// Outwards a lifter has 0.57 mm beyond the 2.4 mm that the catch reaches out; along the wall a rib stands in
/// its way. So none is built.
TEST(RealParts, LidsHooksHaveNoRoomForALifter) {
  const RealPlan lid = plan_of(shipped("enclosure_lid.stl"));
  const Release release(*lid.model, exact_query(*lid.model, lid.result.query()));
  const double mm = 1.0 / lid.model->frame.diagonal;
  ASSERT_EQ(lid.plan.undercuts.size(), 3U);
  for (std::size_t k = 0; k < 2; ++k) {
    const Undercut& hook = lid.plan.undercuts[k].undercut;
    const auto samples = sample_undercut(*lid.model, *lid.result.split, hook, 400);
    EXPECT_EQ(action_of(lid.plan, k), nullptr);
    EXPECT_TRUE(std::ranges::any_of(lid.plan.rejected, [&](const RejectedAction& refused) {
      return refused.undercut == k && refused.kind == ActionKind::lifter;
    }));
    const auto cleared_area = [&](const LifterWay& way, double room = 0.0) {
      double area = 0.0;
      for (const UndercutSample& sample : samples)
        area += release.clears(sample, way, room) ? sample.area : 0.0;
      return area;
    };
    const LifterWay outwards{{0, -1, 0}, {0, 0, 1}, 2.41 * mm};
    EXPECT_GT(cleared_area(outwards), 0.85 * hook.area);
    EXPECT_LT(cleared_area(outwards, 3.0 * mm), 0.2 * hook.area) << "with a blade's room";
    for (double travel = 0.5; travel < 30.0; travel *= 1.05) {
      for (const double sense : {-1.0, 1.0})
        EXPECT_LT(cleared_area({{sense, 0, 0}, {0, 0, 1}, travel * mm}), 0.8 * hook.area) << travel;
    }
  }
}

/// Across its axis a pulley is a spool: what one end's slide can form of all teeth, holes and windows is one
/// slide. The trigger's row of holes is one slide though what is beside them would keep it in.
TEST(RealParts, PulleyAndTriggerHaveASlideASide) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  const RealPlan pulley = plan_of(*shared / "parts" / "odri_pulley_t30_output.stl", {}, {0, 1, 0});
  ASSERT_EQ(actions_text(pulley.plan), "2 slides");
  EXPECT_TRUE(pulley.plan.unreleased.empty());
  for (const SideAction& action : pulley.plan.actions) EXPECT_NEAR(std::abs(action.direction.z), 1.0, 1e-9);

  const RealPlan trigger = plan_of(*shared / "parts" / "so101_trigger.stl", {}, {0, 1, 0});
  EXPECT_TRUE(trigger.plan.unreleased.empty());
  EXPECT_EQ(actions_text(trigger.plan), "2 slides");
  EXPECT_EQ(trigger.plan.actions[0].undercuts.size(), 7U);
}

/// A body of the gears' side actions is a splinter of next to no surface. Lines as close as that asks for
/// took without end.
TEST(RealParts, SplinterOfABodyIsTestedInTime) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  const RealPlan gears = plan_of(*shared / "parts" / "3mf_cube_gears_17parts.3mf", {}, {1, 1, 1});
  EXPECT_GT(gears.plan.actions.size(), 10U);
  for (const SideAction& action : gears.plan.actions) EXPECT_TRUE(action.body.has_value() || action.about);
}

}  // namespace
}  // namespace moldlight
