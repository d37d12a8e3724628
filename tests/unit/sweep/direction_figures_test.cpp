// The table of a direction's figures, and the objectives made of it.
#include "sweep/direction_figures.hpp"

#include <set>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"

namespace moldlight {
namespace {

TEST(DirectionFigures, HaveNamesOfTheirOwn) {
  std::set<std::string_view> keys, labels;
  for (const DirectionFigure& row : direction_figures()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_TRUE(labels.insert(row.label).second) << row.label;
    EXPECT_GT(row.help.size(), 20U) << row.key;
    EXPECT_EQ(&direction_figure(row.key), &row);
  }
}

class OfABox : public testing::Test {
 protected:
  OfABox() : model_(test::model_of(test::box_mesh({0, 0, 0}, {10, 10, 10}))) {
    classification_.total_area = 600.0;
    classification_.areas[Region::undercut] = 60.0;
    classification_.shadow_area = 100.0;
    classification_.near_vertical_area = 42.0;
    classification_.reverse_draft = {.area = 7.0, .worst_deg = 0.5, .facet = 0};
  }
  [[nodiscard]] DirectionFacts facts() const {
    return {.model = *model_, .settings = settings_, .classification = classification_, .draw_depth = 5.0};
  }
  [[nodiscard]] std::string text(std::string_view key, const DirectionFacts& from) const {
    SweepCandidate candidate;
    candidate.measured = from.measured;
    candidate.classification = from.classification;
    candidate.tilt = from.tilt;
    if (from.actions != nullptr) candidate.actions = *from.actions;
    candidate.figures = find_figures(from);
    const DirectionFigure& row = direction_figure(key);
    return figure_text(row, *model_, candidate) + figure_aside(row, candidate);
  }

  std::shared_ptr<const PartModel> model_;
  SweepSettings settings_;
  Classification classification_;
};

TEST_F(OfABox, FiguresAreWrittenByTheirKind) {
  DirectionFacts measured = facts();
  measured.measured = true;
  measured.undercuts = 3;
  EXPECT_EQ(text("undercut", measured), "60");
  EXPECT_EQ(text("undercut_share", measured), "10.00");
  EXPECT_EQ(text("draw_depth", measured), "5");
  EXPECT_EQ(text("undercuts", measured), "3");
  EXPECT_EQ(text("near_vertical_area", measured), "42");
  EXPECT_EQ(text("reverse_draft", measured), "7");
  EXPECT_EQ(figure_heading(direction_figure("draw_depth"), *model_), "depth unit");
  EXPECT_EQ(text("clamp_force", measured), "-");
  settings_.pressure = 2.5;
  EXPECT_EQ(text("clamp_force", measured), "250");
}

/// Exact figures are off by rounding alone, which the digits of an area do not show.
TEST_F(OfABox, UncertaintiesHaveTwoDigits) {
  classification_.uncertainty.rounding = 1.49e-5;
  EXPECT_EQ(text("undercut_uncertainty", facts()), "< 0.0006");
  classification_.uncertainty.rounding = 0.01494;
  EXPECT_EQ(text("undercut_uncertainty", facts()), "0.015");
  classification_.uncertainty = {.rounding = 0.0, .mesh = 12.3};
  EXPECT_EQ(text("undercut_uncertainty", facts()), "12");
  classification_.uncertainty = {};
  EXPECT_EQ(text("undercut_uncertainty", facts()), "0");
}

TEST_F(OfABox, TiltsTellTheLeastTolerantSide) {
  DirectionFacts tilted = facts();
  EXPECT_EQ(text("tilt_margin_deg", tilted), "-");
  tilted.tilt = {.deg = 2.54, .toward = {0.04, 0.0, 0.999}};
  EXPECT_EQ(text("tilt_margin_deg", tilted), "2.5° to +x");
  tilted.tilt->deg = 0.001;
  EXPECT_EQ(text("tilt_margin_deg", tilted), "< 0.01° to +x");
  tilted.tilt->deg = k_widest_tilt_deg;
  EXPECT_EQ(text("tilt_margin_deg", tilted), "> 30°");
}

TEST_F(OfABox, WhatAScoreDoesNotTellIsNotKnown) {
  EXPECT_EQ(text("undercut", facts()), "≈ 60");
  EXPECT_EQ(text("undercuts", facts()), "-");
  EXPECT_EQ(text("near_vertical_area", facts()), "≈ 400") << "the walls";
  EXPECT_EQ(text("reverse_draft", facts()), "-") << "known of what is measured";
}

TEST_F(OfABox, AnObjectiveIsASumOfShares) {
  const double diagonal = model_->frame.diagonal;
  const auto value = [&](std::string_view text) { return objective_value(parse_objective(text), facts()); };
  EXPECT_DOUBLE_EQ(value("undercut"), 0.1);
  EXPECT_DOUBLE_EQ(value("draw-depth"), 5.0 / diagonal);
  EXPECT_DOUBLE_EQ(value("projected-area"), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(value("undercut:2,draw-depth:0.5"), 0.2 + 2.5 / diagonal);
  EXPECT_DOUBLE_EQ(value("undercut:1,patches:0.1"), 0.1) << "patches are not known";
}

TEST_F(OfABox, SideActionsAreToldInWordsOnceTheyAreFound) {
  for (const char* key : {"side_actions", "travel", "unreleased_area"}) EXPECT_EQ(text(key, facts()), "-");
  const DirectionActions found{.undercuts = {.count = 4},
                               .totals = {.counts = {2, 0, 1}, .unreleased_area = 0.25},
                               .weight = 3.2,
                               .travel = 12.5};
  DirectionFacts known = facts();
  known.measured = true;
  known.undercuts = 7;
  EXPECT_EQ(text("undercuts", known), "7");
  known.actions = &found;
  EXPECT_EQ(text("side_actions", known), "2 slides, 1 lifter");
  EXPECT_EQ(text("undercuts", known), "4") << "as the list of side actions counts them";
  EXPECT_EQ(text("travel", known), "12.5");
  EXPECT_EQ(text("unreleased_area", known), "0.25");
}

/// Beside them a narrow table has no room for shares, uncertainties and counts.
TEST(DirectionFigures, YieldToSideActionsInNarrowTables) {
  std::vector<const DirectionFigure*> columns = {
      &direction_figure("undercut"), &direction_figure("undercut_share"), &direction_figure("draw_depth")};
  keep_brief(columns);
  EXPECT_EQ(columns, (std::vector{&direction_figure("undercut"), &direction_figure("undercut_share")}));
  columns.push_back(&direction_figure("side_actions"));
  keep_brief(columns);
  EXPECT_EQ(columns, (std::vector{&direction_figure("undercut"), &direction_figure("side_actions")}));
}

/// What is left weighs more than an action would, and more than a thousandth of the part behind all.
TEST_F(OfABox, WhatNothingReleasesRanksBehind) {
  DirectionActions found{
      .undercuts = {}, .totals = {.counts = {3}}, .weight = 3.0, .travel = 0.5 * model_->frame.diagonal};
  const auto value = [&](std::string_view text, double left) {
    found.totals.unreleased_area = left;
    DirectionFacts known = facts();
    known.actions = &found;
    return objective_value(parse_objective(text), known);
  };
  EXPECT_DOUBLE_EQ(value("side-actions", 0.0), 3.0);
  EXPECT_DOUBLE_EQ(value("travel", 0.0), 0.5);
  EXPECT_DOUBLE_EQ(value("undercut:1,side-actions:0.5", 0.0), 1.6);
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind)
    EXPECT_GT(value("side-actions", 0.01), 3.0 + moldlight::facts(static_cast<ActionKind>(kind)).weight);
  EXPECT_LT(value("side-actions", 0.3), value("side-actions", 0.6));
  EXPECT_GT(value("side-actions", 0.7), 1000.0);
  EXPECT_GT(value("travel", 0.7), 1000.0);
  EXPECT_LT(value("side-actions", 6.0), value("side-actions", 12.0));
  classification_.uncertainty.rounding = 0.02;
  EXPECT_DOUBLE_EQ(value("side-actions", 0.01), 3.0) << "within rounding";
}

TEST(Objective, SaysWhetherItNeedsSideActions) {
  EXPECT_FALSE(needs_actions(parse_objective("undercut:1,draw-depth:0.1")));
  EXPECT_TRUE(needs_actions(parse_objective("undercut:1,side-actions:0.1")));
  EXPECT_TRUE(needs_actions(parse_objective("travel")));
  SweepSettings settings;
  EXPECT_TRUE(seeks_actions(settings)) << "as molds go";
  settings.rank = SweepRank::objective;
  EXPECT_FALSE(seeks_actions(settings));
  settings.actions = true;
  EXPECT_TRUE(seeks_actions(settings));
}

TEST(Objective, RefusesWhatMakesNoSense) {
  EXPECT_EQ(parse_objective("undercut:1,patches:0").terms.size(), 1U);
  EXPECT_EQ(parse_objective("draw-depth:1e-3").text, "draw-depth:1e-3");
  for (const char* bad : {"", "depth", "draw_depth", "undercut,", "undercut:", "undercut:-1", "undercut:x",
                          "undercut:inf", "undercut:0", "clamp-force", "undercut-share"}) {
    EXPECT_THROW(static_cast<void>(parse_objective(bad)), UsageError) << bad;
  }
}

}  // namespace
}  // namespace moldlight
