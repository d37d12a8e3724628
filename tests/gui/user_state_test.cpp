// What the window remembers of its user, from one start to the next.
#include "gui/store/user_state.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace moldlight::gui {
namespace {

TEST(UserState, IsReadBackAsItWasWritten) {
  UserState state;
  state.window.theme = Theme::light;
  state.window.navigation = NavigationPreset::blender;
  state.sweep.directions = 123;
  state.sweep.thorough = true;
  state.sweep.pressure = 30.5;
  state.sweep.objective = parse_objective("undercut:1,draw-depth:0.1");
  state.sweep.kinds = {CandidateKind::plane, CandidateKind::axis};
  state.sweep.user_directions = {{1, 0, 0.25}, {0, -1, 0}};
  state.hints_done = {Hint::arrow, Hint::sweep};
  state.remember("/a part.stl");
  state.remember("/b.step");
  const UserState read = parse_user_state(user_state_json(state));
  EXPECT_EQ(read.window, state.window);
  EXPECT_EQ(read.recent, (std::vector<std::string>{"/b.step", "/a part.stl"}));
  EXPECT_EQ(read.sweep.directions, 123);
  EXPECT_TRUE(read.sweep.thorough);
  EXPECT_EQ(read.hints_done, state.hints_done);
  EXPECT_EQ(read.sweep.pressure, 30.5);
  EXPECT_EQ(read.sweep.kinds, state.sweep.kinds);
  EXPECT_EQ(read.sweep.user_directions, state.sweep.user_directions);
  EXPECT_EQ(user_state_json(read), user_state_json(state)) << "every option";
}

TEST(UserState, WhatAnotherVersionWroteIsPassedOver) {
  const UserState read = parse_user_state(
      R"({"settings": {"theme": "light", "wings": 2}, "sweep": {"top": 7, "directions": -4, "fins": 1}, "recent": [3]})");
  EXPECT_EQ(read.window.theme, Theme::light);
  EXPECT_EQ(read.sweep.top, 7);
  EXPECT_EQ(read.sweep.directions, SweepSettings{}.directions);
  EXPECT_TRUE(read.recent.empty());
}

}  // namespace
}  // namespace moldlight::gui
