// The strip of steps: each is entered by its key or a click and shows its own panel alone; what is left for
// the part; and the light of the verdict.
#include <set>

#include <fmt/format.h>

#include "gui/panels/step_panels.hpp"
#include "gui/sceneries.hpp"

namespace moldlight::gui::test {
namespace {

/// Controls that only one step has, in the strip's order.
constexpr std::array<const char*, 7> k_of_steps = {
    "Unit=mm", "ball", "action options", "Move faces", "draft chart", "play the shot", "Write the report"};

class Steps : public WindowSceneries {
 protected:
  Steps() { settle(); }
  void settle() {
    window.wait_until_measured();
    window.settle();
  }
  [[nodiscard]] bool has(const std::string& control) const {
    return window.app().controls().contains(control);
  }
  /// The panel of the step that is open, and no other one's.
  void expect_alone(const StepRow& row, const char* by) {
    for (const StepRow& each : step_rows()) {
      const bool here = each.step == row.step;
      EXPECT_EQ(has(fmt::format("panel {}", each.title)), here) << each.title << " in " << row.title << by;
      EXPECT_EQ(has(k_of_steps[static_cast<std::size_t>(each.step)]), here)
          << k_of_steps[static_cast<std::size_t>(each.step)] << " in " << row.title << by;
    }
  }
  /// Share of the window that no panel covers.
  [[nodiscard]] double free_share() const {
    const glm::vec2 size(window.size());
    double covered = size.x * k_bar_height;
    for (const auto& [name, box] : window.app().controls()) {
      if (name.starts_with("panel "))
        covered += static_cast<double>(box.max.x - box.min.x) * (box.max.y - box.min.y);
    }
    return 1.0 - covered / (static_cast<double>(size.x) * size.y);
  }
};

TEST_F(Steps, ShowTheirOwnPanelAlone) {
  for (const StepRow& row : step_rows()) {
    enter(row.step);
    settle();
    expect_alone(row, ", by its key");
    EXPECT_TRUE(state().dialogs == Dialogs{}) << "nothing is asked";
  }
  for (const StepRow& row : step_rows()) {
    click(fmt::format("step {}", row.title));
    settle();
    expect_alone(row, ", by a click");
  }
}

TEST_F(Steps, TakeTheirViewWithThem) {
  const auto colours = [&] { return state().settings.look.colour_mode; };
  enter(Step::draft);
  settle();
  EXPECT_EQ(colours(), ColourMode::draft_angle);
  enter(Step::mold);
  EXPECT_EQ(colours(), ColourMode::regions);
  key({.key = 'O'});
  settle();
  EXPECT_GT(state().settings.look.open_mold, 0.0);
  enter(Step::undercuts);
  EXPECT_EQ(state().settings.look.open_mold, 0.0);
  key({.key = 'G'});
  EXPECT_EQ(state().step, Step::mold);
  key({.key = 'G'});
  EXPECT_EQ(state().step, Step::undercuts) << "and back";
  enter(Step::direction);
  settle();
  EXPECT_EQ(state().settings.look, LookSettings{}) << "nothing is left of them";
}

TEST_F(Steps, LeaveThePartMostOfTheWindow) {
  window.resize({1440, 900});
  settle();
  click("settings");
  settle();
  click("Put the panels back in place");  // as shipped: the look is folded up
  key({.key = k_escape});
  for (const StepRow& row : step_rows()) {
    enter(row.step);
    settle();
    EXPECT_GE(free_share(), 0.7) << row.title;
  }
}

TEST_F(Steps, TheLightIsNotGreenWhileThereIsRed) {
  const VerdictCard card = verdict_card(state());
  ASSERT_TRUE(card.red) << "the part has an undercut";
  EXPECT_NE(card.light(), VerdictLight::green);
  // Whatever the study says, and also where the maps alone show it.
  for (const VerdictState verdict :
       {VerdictState::two_plate, VerdictState::side_actions, VerdictState::undercuts,
        VerdictState::not_releasable, VerdictState::unknown}) {
    VerdictCard shown{.verdict = Verdict(), .sentence = {}, .red = true};
    shown.verdict->state = verdict;
    EXPECT_NE(shown.light(), VerdictLight::green) << state_name(verdict);
    EXPECT_FALSE(shown.good());
    shown.red = false;
    EXPECT_EQ(shown.light() == VerdictLight::green, verdict == VerdictState::two_plate);
  }
  EXPECT_EQ(VerdictCard{}.light(), VerdictLight::gray) << "while nothing is known";
}

TEST_F(Steps, HaveNoTickWhileThereIsRed) {
  const auto ticks = [](const AppState& of) {
    return std::ranges::count_if(
        step_rows(), [&](const StepRow& row) { return step_badge(of, row).kind == StepBadge::Kind::tick; });
  };
  enter(Step::mold);
  settle();
  ASSERT_TRUE(verdict_card(state()).red);
  EXPECT_EQ(ticks(state()), 0);
  AppState green = state();
  green.verdict->state = VerdictState::two_plate;
  green.figures.shown->areas[Region::undercut] = 0.0;
  ASSERT_TRUE(verdict_card(green).good());
  EXPECT_GT(ticks(green), 1) << "what is in order then has one";
}

TEST_F(Steps, StayWhereTheyAre) {
  const auto places = [&] {
    std::vector<ScreenBox> found;
    for (const StepRow& row : step_rows()) found.push_back(window.control(fmt::format("step {}", row.title)));
    return found;
  };
  const std::vector<ScreenBox> before = places();
  const auto expect_same = [&](const char* when) {
    const std::vector<ScreenBox> now = places();
    for (std::size_t k = 0; k < now.size(); ++k)
      EXPECT_TRUE(now[k].min == before[k].min && now[k].max == before[k].max) << k << " " << when;
  };
  enter(Step::mold);
  window.frames(2);
  expect_same("while halves are made");
  settle();
  expect_same("with a sign at the mold");
  key({.key = k_right});
  window.frames(2);
  expect_same("while the direction moves");
}

TEST_F(Steps, TheVerdictLeadsToTheUndercuts) {
  click("verdict show");
  settle();
  EXPECT_EQ(state().step, Step::undercuts);
  EXPECT_TRUE(has("undercut 1"));
}

}  // namespace
}  // namespace moldlight::gui::test
