// A study keeps what its questions leave as it is, and finds the rest anew.
#include "study/study.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace moldlight {
namespace {

class StudyOfAPocket : public ::testing::Test {
 protected:
  StudyOfAPocket() {
    Part part;
    part.unit = "mm";
    part.mesh = test::plate_with_side_pocket({}).mesh;
    part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
    study = Study(prepare_part(std::move(part), Progress()));
  }
  /// Asks the present questions, changed.
  template <typename Change>
  void ask(const Change& change) {
    Questions questions = study.questions();
    change(questions);
    study.ask(questions);
  }
  Study study;
};

TEST_F(StudyOfAPocket, FindsAnAnswerOnce) {
  EXPECT_EQ(study.known<ActionPlan>(), nullptr);
  const ActionPlan* plan = &study.find<ActionPlan>(Progress());
  EXPECT_EQ(&study.find<ActionPlan>(Progress()), plan);
  EXPECT_NE(study.known<SplitRegions>(), nullptr) << "what it is found from is kept, too";
}

TEST_F(StudyOfAPocket, KeepsWhatASettingDoesNotTouch) {
  study.find<ActionPlan>(Progress());
  study.find<MoldHalves>(Progress());
  const auto line = study.known<MoldLine>();
  ask([](Questions& asked) { asked.actions.clearance_mm = 7.0; });
  EXPECT_EQ(study.known<ActionPlan>(), nullptr);
  EXPECT_NE(study.known<SplitRegions>(), nullptr);
  EXPECT_EQ(study.known<MoldLine>(), line);
  ask([](Questions& asked) { asked.mold.margin = 12.0; });
  EXPECT_EQ(study.known<MoldHalves>(), nullptr);
  EXPECT_EQ(study.known<MoldLine>(), line) << "the block is no matter of the line";
  ask([](Questions& asked) { asked.mold.soft_deg = 3.0; });
  EXPECT_EQ(study.known<MoldLine>(), nullptr);
  ask([](Questions& asked) { asked.query.direction = glm::dvec3(1, 0, 0); });
  EXPECT_EQ(study.known<SplitRegions>(), nullptr);
}

TEST_F(StudyOfAPocket, GoesBackToNoOldAnswer) {
  const double along_z = study.find<Classification>(Progress()).areas[Region::undercut];
  ask([](Questions& asked) { asked.query.direction = glm::dvec3(1, 0, 0); });
  EXPECT_NE(study.find<Classification>(Progress()).areas[Region::undercut], along_z);
}

TEST_F(StudyOfAPocket, CountsUndercutsAlikeWithAndWithoutAList) {
  Study other = study;
  const UndercutTotals counted = study.find<UndercutTotals>(Progress());
  other.find<ActionPlan>(Progress());
  const UndercutTotals listed = other.find<UndercutTotals>(Progress());
  EXPECT_EQ(counted.count, 1U);
  EXPECT_EQ(counted.count, listed.count);
  EXPECT_DOUBLE_EQ(counted.area, listed.area);
}

TEST_F(StudyOfAPocket, KeepsASweepUntilItsSettingsChange) {
  int scored = 0;
  ask([&](Questions& questions) {
    questions.sweep.kinds = {};
    questions.sweep.refine = 0;
    questions.sweep.user_directions = {{0, 0, 1}, {1, 0, 0}};
    questions.sweep_shows.evaluated = [&](const EvaluatedDirection&) { ++scored; };
  });
  const SweepResult* found = &study.find<SweepResult>(Progress());
  EXPECT_GE(scored, 2);
  EXPECT_EQ(found->candidates.size(), 2U);
  ask([](Questions& questions) { questions.sweep_shows = {}; });
  EXPECT_EQ(&study.find<SweepResult>(Progress()), found);
  ask([](Questions& questions) { questions.sweep.user_directions.pop_back(); });
  EXPECT_EQ(study.known<SweepResult>(), nullptr);
  EXPECT_EQ(study.find<SweepResult>(Progress()).candidates.size(), 1U);
}

TEST_F(StudyOfAPocket, EndsWhereItIsCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(study.find<ActionPlan>(progress), Cancelled);
  EXPECT_EQ(study.known<ActionPlan>(), nullptr);
}

}  // namespace
}  // namespace moldlight
