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
  }
  [[nodiscard]] DirectionFacts facts() const {
    return {.model = *model_, .settings = settings_, .classification = classification_, .draw_depth = 5.0};
  }
  [[nodiscard]] std::string text(std::string_view key, const DirectionFacts& from) const {
    SweepCandidate candidate;
    candidate.measured = from.measured;
    candidate.classification = from.classification;
    candidate.tilt = from.tilt;
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
  measured.patches = 3;
  EXPECT_EQ(text("undercut", measured), "60.000");
  EXPECT_EQ(text("undercut_share", measured), "10.00");
  EXPECT_EQ(text("draw_depth", measured), "5.000");
  EXPECT_EQ(text("patches", measured), "3");
  EXPECT_EQ(text("undraughted_area", measured), "42.000");
  EXPECT_EQ(figure_heading(direction_figure("draw_depth"), model_->part), "depth unit");
  EXPECT_EQ(text("clamp_force", measured), "-");
  settings_.pressure = 2.5;
  EXPECT_EQ(text("clamp_force", measured), "250");
}

/// Exact figures are off by rounding alone, which the digits of an area do not show.
TEST_F(OfABox, UncertaintiesHaveTwoDigits) {
  classification_.uncertainty.rounding = 1.49e-5;
  EXPECT_EQ(text("undercut_uncertainty", facts()), "1.5e-05");
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
  EXPECT_EQ(text("undercut", facts()), "≈ 60.000");
  EXPECT_EQ(text("patches", facts()), "-");
  EXPECT_EQ(text("undraughted_area", facts()), "≈ 400.000") << "the walls";
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
