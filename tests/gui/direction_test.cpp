// The parting direction by hand: arrow, ball, fields, buttons, keys; undo of each.
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

TEST_F(WindowWithPart, TheArrowsTipFollowsTheMouse) {
  const glm::vec2 tip = window.control("core arrow").centre();
  const glm::vec2 to = tip + glm::vec2(70, 25);
  drag(tip, to);
  EXPECT_GT(angle_deg(direction(), {0, 0, 1}), 5.0);
  EXPECT_NEAR(glm::length(direction()), 1.0, 1e-12);
  EXPECT_LT(glm::distance(window.control("core arrow").centre(), to), 2.0F);
}

TEST_F(WindowWithPart, ADragIsOneStepOfUndo) {
  const glm::vec2 tip = window.control("core arrow").centre();
  drag(tip, tip + glm::vec2(70, 25));
  const glm::dvec3 turned = direction();
  EXPECT_TRUE(state().can_undo);
  undo();
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
  EXPECT_FALSE(state().can_undo);
  key({.key = 'Y', .ctrl = true});
  EXPECT_EQ(direction(), turned);
}

TEST_F(WindowWithPart, EscapeGivesADragUp) {
  const glm::vec2 tip = window.control("core arrow").centre();
  drag(tip, tip + glm::vec2(70, 25), false);
  EXPECT_NE(direction(), glm::dvec3(0, 0, 1));
  key({.key = k_escape});
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
  window.move_mouse(tip + glm::vec2(-40, 40));
  window.frames(2);
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1)) << "the drag goes on";
  window.set_button(0, false);
  window.frames(2);
  EXPECT_FALSE(state().can_undo);
}

TEST_F(WindowWithPart, AClickOnTheArrowChangesNothing) {
  move_to(window.control("core arrow").centre() + glm::vec2(3, 2));
  press();
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
}

TEST_F(WindowWithPart, CtrlSnapsToThePartsDirections) {
  const glm::vec2 tip = window.control("core arrow").centre();
  window.hold_modifiers(true, false, false);
  drag(tip, tip + glm::vec2(30, 8));
  window.hold_modifiers(false, false, false);
  EXPECT_FALSE(state().features.empty());
  const bool snapped =
      std::any_of(state().features.begin(), state().features.end(), [&](const auto& feature) {
        return feature.direction == direction() || -feature.direction == direction();
      });
  EXPECT_TRUE(snapped);
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1)) << "a small drag stays with the nearest";
}

TEST_F(WindowWithPart, CtrlSnapsToTheNearestFromAnywhere) {
  const glm::vec2 tip = window.control("core arrow").centre();
  window.hold_modifiers(true, false, false);
  // Down to the right on the screen: x as it is seen from the first view.
  drag(tip, tip + glm::vec2(180, 330));
  window.hold_modifiers(false, false, false);
  EXPECT_EQ(direction(), glm::dvec3(1, 0, 0));
}

TEST_F(WindowWithPart, TheBallTurnsTheDirection) {
  const ScreenBox ball = window.control("ball");
  drag(ball.centre(), ball.centre() + glm::vec2(10, 0));
  // From the ball's middle towards the viewer, turned to the right.
  const glm::dvec3 seen = glm::conjugate(state().camera.orientation) * direction();
  EXPECT_GT(seen.x, 0.1);
  EXPECT_NEAR(seen.y, 0.0, 1e-9);
  EXPECT_GT(seen.z, 0.9);
}

TEST_F(WindowWithPart, ButtonsSetTheAxes) {
  click("−X");
  EXPECT_EQ(direction(), glm::dvec3(-1, 0, 0));
  click("+Y");
  EXPECT_EQ(direction(), glm::dvec3(0, 1, 0));
  click("flip");
  EXPECT_EQ(direction(), glm::dvec3(0, -1, 0));
  undo();
  undo();
  EXPECT_EQ(direction(), glm::dvec3(-1, 0, 0));
}

TEST_F(WindowWithPart, FieldsTakeNumbers) {
  click("x");
  window.type("1");
  window.frame();
  key({.key = k_enter});
  EXPECT_EQ(direction(), glm::dvec3(1, 0, 1));
  click("elevation");
  window.type("30");
  window.frame();
  key({.key = k_enter});
  EXPECT_NEAR(direction().z, 0.5, 1e-12);
}

TEST_F(WindowWithPart, OneArrowHasItsNameWhereBothAreSeenFromTheirTips) {
  EXPECT_TRUE(window.app().controls().contains("cavity arrow"));
  key({.key = '0'});
  window.settle();
  EXPECT_TRUE(window.app().controls().contains("core arrow"));
  EXPECT_FALSE(window.app().controls().contains("cavity arrow"));
}

TEST_F(WindowWithPart, TabGoesFromFieldToField) {
  const auto tab = [&](bool back) { key({.key = k_tab, .ctrl = false, .shift = back}); };
  const auto type = [&](const char* number) {
    window.type(number);
    window.frames(2);
  };
  click("x");
  type("0.5");
  tab(false);
  EXPECT_EQ(direction(), glm::dvec3(0.5, 0, 1));
  type("0.25");
  tab(false);
  type("2");
  tab(true);
  EXPECT_EQ(direction(), glm::dvec3(0.5, 0.25, 2));
  type("-1");
  key({.key = k_enter});
  EXPECT_EQ(direction(), glm::dvec3(0.5, -1, 2));
}

TEST_F(WindowWithPart, FieldsRefuseWhatIsNoDirection) {
  click("z");
  window.type("0");
  window.frame();
  key({.key = k_enter});
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
  click("z");
  window.type("nan");
  window.frame();
  key({.key = k_enter});
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
}

TEST_F(WindowWithPart, ArrowKeysNudge) {
  key({.key = k_right});
  EXPECT_NEAR(angle_deg(direction(), {0, 0, 1}), 1.0, 1e-9);
  undo();
  key({.key = k_up, .shift = true});
  EXPECT_NEAR(angle_deg(direction(), {0, 0, 1}), 0.1, 1e-9);
}

TEST_F(WindowWithPart, BookmarksAreKept) {
  key({.key = 'B'});
  ASSERT_EQ(state().bookmarks.size(), 1U);
  EXPECT_EQ(state().bookmarks[0].direction, glm::dvec3(0, 0, 1));
  EXPECT_FALSE(state().bookmarks[0].note.empty());
}

}  // namespace
}  // namespace moldlight::gui::test
