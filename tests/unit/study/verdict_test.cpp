// The verdict: each of its states, what its sentence leads with, and that doubt is never a tick.
#include "study/verdict.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/weld.hpp"
#include "study/study.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

std::shared_ptr<const PartModel> model_of(TriangleMesh mesh) {
  Part part;
  part.unit = "mm";
  part.mesh = std::move(mesh);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  return prepare_part(std::move(part), Progress());
}

Verdict verdict_on(TriangleMesh mesh, bool with_actions) {
  Questions questions;
  questions.with_actions = with_actions;
  return Study(model_of(std::move(mesh)), questions).verdict(Progress());
}

TEST(VerdictOf, ABoxIsATwoPlateMold) {
  for (const bool with_actions : {false, true}) {
    const Verdict verdict = verdict_on(test::box_shape({}).mesh, with_actions);
    EXPECT_EQ(verdict.state, VerdictState::two_plate);
    EXPECT_EQ(verdict.sentence, "Two-plate mold: no undercut.");
    EXPECT_TRUE(verdict.good());
    EXPECT_TRUE(verdict.reasons.empty());
  }
}

TEST(VerdictOf, AnUndercutIsOneWhetherActionsWereAskedForOrNot) {
  const TriangleMesh pocket = test::plate_with_side_pocket({}).mesh;
  const Verdict before = verdict_on(pocket, false), after = verdict_on(pocket, true);
  EXPECT_EQ(before.state, VerdictState::undercuts);
  EXPECT_TRUE(before.sentence.starts_with("1 undercut, ")) << before.sentence;
  EXPECT_EQ(after.state, VerdictState::side_actions);
  EXPECT_TRUE(after.sentence.starts_with("1 slide releases the undercut (")) << after.sentence;
  EXPECT_EQ(before.undercuts, after.undercuts);
  EXPECT_DOUBLE_EQ(before.undercut_area, after.undercut_area);
  EXPECT_EQ(after.actions[static_cast<std::size_t>(ActionKind::slide)], 1U);
}

TEST(VerdictOf, AVoidIsNotReleasableAndItsAreaIsSaidFirst) {
  const test::Shape sphere = test::hollow_sphere({});
  const Verdict verdict = verdict_on(sphere.mesh, true);
  EXPECT_EQ(verdict.state, VerdictState::not_releasable);
  EXPECT_TRUE(verdict.sentence.starts_with("Not releasable: no action that was tried releases "))
      << verdict.sentence;
  EXPECT_GT(verdict.unreleased_area, 0.9 * verdict.undercut_area);
  EXPECT_EQ(std::ranges::count(
                verdict.reasons,
                "Undercut 1 is a closed void, which no mold forms. Fill it, or open it to the outside."),
            1);
}

TEST(VerdictOf, AnOpenMeshIsNeverATwoPlateMold) {
  TriangleMesh box = test::box_shape({}).mesh;
  box.facets.pop_back();
  const Verdict verdict = verdict_on(box, true);
  EXPECT_EQ(verdict.state, VerdictState::unknown);
  EXPECT_NE(verdict.sentence.find("open at 3 edges, near ("), std::string::npos) << verdict.sentence;
  ASSERT_FALSE(verdict.reasons.empty());
  EXPECT_NE(verdict.reasons.front().find("--repair"), std::string::npos) << verdict.reasons.front();
}

TEST(VerdictOf, AnOpenMeshKeepsItsUndercutsAndNamesTheRepair) {
  const TriangleMesh pocket = test::plate_with_side_pocket({}).mesh;
  std::size_t decided = 0, undecided = 0;
  for (std::size_t hole = 0; hole < pocket.facets.size(); ++hole) {
    TriangleMesh open = pocket;
    open.facets.erase(open.facets.begin() + static_cast<std::ptrdiff_t>(hole));
    const Verdict verdict = verdict_on(open, false);
    const auto said = [&](std::string_view words) {
      return std::ranges::any_of(verdict.reasons, [&](const std::string& reason) {
        return reason.find(words) != std::string::npos;
      });
    };
    EXPECT_TRUE(said("--repair")) << hole;
    EXPECT_FALSE(said("No undercut")) << hole;
    if (verdict.undercuts == 0) continue;
    const bool unknown = verdict.state == VerdictState::unknown;
    (unknown ? undecided : decided) += 1;
    EXPECT_TRUE(unknown ? said("As it is: 1 undercut, ") : verdict.sentence.starts_with("1 undercut, "))
        << hole << ": " << verdict.sentence;
    EXPECT_TRUE(said(unknown ? "To decide it: " : "in doubt: the mesh is open at 3 edges")) << hole;
  }
  EXPECT_GT(decided, 0U);
  EXPECT_GT(undecided, 0U);
}

TEST(VerdictOf, BodiesThatCrossLeaveItOpenWhereTheCrossingIsAllOfTheUndercut) {
  test::SolidBuilder solid;
  solid.box({0, 0, 0}, {20, 20, 10});
  solid.box({5, 5, 3}, {15, 15, 14});
  const Verdict verdict = verdict_on(solid.mesh(), false);
  EXPECT_EQ(verdict.state, VerdictState::unknown);
  EXPECT_NE(verdict.sentence.find("surfaces cross each other, near ("), std::string::npos)
      << verdict.sentence;
}

TEST(VerdictOf, SeveralBodiesAreToldWhereThereIsAnUndercut) {
  test::SolidBuilder boxes;
  boxes.box({0, 0, 0}, {20, 20, 10});
  boxes.box({0, 0, 30}, {20, 20, 40});
  Part part;
  part.mesh = boxes.mesh();
  const FacetIndex each = static_cast<FacetIndex>(part.mesh.facets.size() / 2);
  part.bodies = {{"lower", 0, each}, {"upper", each, each}};
  const auto verdict_along = [&](const glm::dvec3& direction) {
    Questions questions;
    questions.query.direction = direction;
    return Study(prepare_part(part, Progress()), questions).verdict(Progress());
  };
  // One above the other they hide each other; side by side they do not.
  const std::string told = "Both bodies of the file share one mold here; --body takes one of them.";
  EXPECT_EQ(std::ranges::count(verdict_along({0, 0, 1}).reasons, told), 1);
  EXPECT_EQ(std::ranges::count(verdict_along({1, 0, 0}).reasons, told), 0);
}

TEST(VerdictOf, SampledFacetsAreStatedWithTheirErrorInVerdictAndJson) {
  test::Random random(7);
  std::vector<glm::dvec3> corners;
  for (int corner = 0; corner < 3 * 500; ++corner) corners.push_back(random.in_cube(10.0));
  Study study(model_of(weld_corners(corners)), {});
  const Verdict verdict = study.verdict(Progress());
  EXPECT_EQ(verdict.state, VerdictState::unknown);
  const Classification& regions = study.find<Classification>(Progress());
  ASSERT_GT(regions.uncertainty.sampled_facets, 0U);
  EXPECT_TRUE(std::ranges::any_of(verdict.reasons, [&](const std::string& reason) {
    return reason.find(std::to_string(regions.uncertainty.sampled_facets) + " facets are sampled") == 0 &&
           reason.find("±") != std::string::npos && reason.find("--effort") != std::string::npos;
  }));
  const nlohmann::ordered_json json = classify_json(study, Progress());
  EXPECT_EQ(json["sampled_facets"], regions.uncertainty.sampled_facets);
  try {
    static_cast<void>(study.find<MoldLine>(Progress()));
    ADD_FAILURE() << "a parting line of samples";
  } catch (const Error& error) {
    EXPECT_NE(std::string_view(error.what()).find("or raise --effort"), std::string_view::npos)
        << error.what();
  }
  EXPECT_GT(json["uncertainty_parts"]["readout"].get<double>(), 0.0);
}

TEST(VerdictOf, IsTheSameInJson) {
  const Verdict verdict = verdict_on(test::plate_with_side_pocket({}).mesh, true);
  const auto json = verdict_json(verdict);
  EXPECT_EQ(json["state"], "side-actions");
  EXPECT_EQ(json["sentence"], verdict.sentence);
  EXPECT_EQ(json["undercuts"], 1);
  EXPECT_EQ(json["actions"], (nlohmann::ordered_json{{"slide", 1}}));
  EXPECT_EQ(json["undercut_area"], verdict.undercut_area);
  EXPECT_EQ(json["unreleased_area"], 0.0);
}

TEST(IsStuck, IsHalfAPerCentAndTheToleranceSquared) {
  EXPECT_TRUE(is_stuck(0.6, 100.0, 0.1));
  EXPECT_FALSE(is_stuck(0.4, 100.0, 0.1)) << "of its area";
  EXPECT_FALSE(is_stuck(0.6, 100.0, 1.0)) << "a speck";
}

}  // namespace
}  // namespace moldlight
