// Sweeps that are cancelled in one stage or another: they end at once and keep what they have.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "sweep/candidates/candidate.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/sweep_report.hpp"

namespace moldlight {
namespace {

class SweepEndedEarly : public testing::Test {
 protected:
  SweepEndedEarly() : model_(test::model_of(test::refined(test::snap_hook({}), 300).mesh)) {
    settings_.directions = 60;
    settings_.refine = 1;
    settings_.top = 4;
    settings_.rank = SweepRank::objective;
  }

  /// Cancelled when it reports this stage for the `times`th time.
  SweepResult cancelled_in(std::string_view stage, int times = 1) {
    Progress* cancelled = nullptr;
    Progress progress([&](std::string_view reported, double) {
      if (reported == stage && --times == 0) cancelled->cancel();
    });
    cancelled = &progress;
    SweepResult result = run_sweep(model_, settings_, progress, {});
    EXPECT_FALSE(result.complete) << stage;
    return result;
  }

  std::shared_ptr<const PartModel> model_;
  SweepSettings settings_;
};

std::ptrdiff_t measured(const SweepResult& result) {
  return std::ranges::count(result.candidates, true, &SweepCandidate::measured);
}

TEST_F(SweepEndedEarly, WhileItLooksForCandidatesThereAreNone) {
  const SweepResult result = cancelled_in(sweep_stage::k_candidates);
  EXPECT_TRUE(result.evaluated.empty());
  EXPECT_TRUE(result.candidates.empty());
}

TEST_F(SweepEndedEarly, WhileItScoresTheScoresAreListed) {
  settings_.jobs = 1;
  const SweepResult result = cancelled_in(sweep_stage::k_scoring, 30);
  ASSERT_EQ(result.evaluated.size(), 30U);
  ASSERT_EQ(result.candidates.size(), 4U);
  EXPECT_EQ(measured(result), 0);
  for (const SweepCandidate& candidate : result.candidates) {
    const auto same =
        std::ranges::find(result.evaluated, candidate.candidate.direction, &EvaluatedDirection::direction);
    ASSERT_NE(same, result.evaluated.end());
    EXPECT_EQ(candidate.classification.areas[Region::undercut], same->undercut);
    EXPECT_EQ(candidate.classification.uncertainty.total(), same->undercut_error);
    for (const char* key : {"draw_depth", "projected_area"})
      EXPECT_GT(figure_value(direction_figure(key), candidate).value_or(0.0), 0.0) << key;
  }
  EXPECT_TRUE(std::ranges::is_sorted(result.candidates, {}, &SweepCandidate::tie_group));
}

TEST_F(SweepEndedEarly, BeforeItMeasuresTheReportTellsSo) {
  const SweepResult result = cancelled_in(sweep_stage::k_measuring);
  ASSERT_EQ(result.candidates.size(), 4U);
  EXPECT_EQ(measured(result), 0);
  const auto json = sweep_json(*model_, result);
  for (const auto& candidate : json["candidates"]) {
    for (const char* key : {"undercuts", "projected_undercut", "identity", "uncertainty_parts"})
      EXPECT_TRUE(candidate[key].is_null()) << key;
  }
  EXPECT_EQ(json["remarks"][0], "Ended early: 4 of the 4 listed directions were not measured, only scored.");
}

TEST_F(SweepEndedEarly, WhileItPolishesWhatIsMeasuredIsListed) {
  const SweepResult whole = run_sweep(model_, settings_, Progress{}, {});
  const SweepResult result = cancelled_in(sweep_stage::k_polishing);
  ASSERT_EQ(result.candidates.size(), 4U);
  EXPECT_EQ(measured(result), 4);
  for (const SweepCandidate& candidate : result.candidates) {
    const Query query{candidate.candidate.direction, settings_.method};
    EXPECT_EQ(candidate.classification.areas.values, classify_exact(*model_, query, {}).areas.values);
    EXPECT_FALSE(candidate.tilt);
  }
  EXPECT_LE(whole.candidates.front().classification.areas[Region::undercut],
            result.candidates.front().classification.areas[Region::undercut]);
}

/// Those that were found by then come first, the others behind them by their undercut.
TEST_F(SweepEndedEarly, WhileItFindsSideActionsThoseFoundAreTold) {
  settings_.objective = parse_objective("side-actions");
  settings_.jobs = 1;
  const SweepResult result = cancelled_in(sweep_stage::k_actions, 3);
  EXPECT_EQ(result.with_actions, 2U) << "the first report comes before any is found";
  ASSERT_EQ(result.candidates.size(), 4U);
  EXPECT_EQ(measured(result), 4);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(result.candidates[k].actions.has_value(), k < 2) << k;
  const auto json = sweep_json(*model_, result);
  EXPECT_TRUE(json["candidates"][0]["actions"].is_string());
  for (const char* key : {"actions", "side_actions", "travel", "unreleased_area"})
    EXPECT_TRUE(json["candidates"][3][key].is_null()) << key;
  EXPECT_EQ(result.remarks[1], "Ended early: side actions of 2 of the 4 listed directions were not found.");
}

TEST_F(SweepEndedEarly, AtTheTimeLimitTheBestIsMeasured) {
  settings_.time_limit_s = 1e-6;
  const SweepResult result = run_sweep(model_, settings_, Progress{}, {});
  EXPECT_FALSE(result.complete);
  ASSERT_EQ(result.candidates.size(), 1U);
  EXPECT_EQ(measured(result), 1);
}

}  // namespace
}  // namespace moldlight
