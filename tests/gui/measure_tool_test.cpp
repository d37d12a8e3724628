// Measuring between two places, by two clicks.
#include <cstdlib>

#include <glm/geometric.hpp>

#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

class MeasureTool : public WindowWithPart {
 protected:
  MeasureTool() {
    window.app().open(
        part.folder().write("box.off",
                            "OFF\n8 6 0\n0 0 0\n30 0 0\n30 20 0\n0 20 0\n0 0 10\n30 0 10\n30 20 10\n0 20 10\n"
                            "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"));
    window.wait_until_loaded();
    window.wait_until_measured();
    window.settle();
  }
  void click_at(const glm::dvec3& point) {
    const auto pixel =
        project(state().camera, window.size(), glm::dvec3(state().model->frame.to_unit(point)));
    move_to(glm::vec2(pixel.value_or(glm::dvec2(-1.0))));
    press();
  }
};

TEST_F(MeasureTool, TakesTwoPlacesAndEndsByEscape) {
  click("measure");
  ASSERT_TRUE(state().measuring);
  click("measure");
  ASSERT_FALSE(state().measuring);
  key({.key = 'R'});
  ASSERT_TRUE(state().measuring);
  click_at({10, 10, 10});
  EXPECT_FALSE(state().face) << "a click measures and chooses nothing";
  ASSERT_EQ(state().measuring->places.size(), 1U);
  click_at({30, 10, 4});
  ASSERT_EQ(state().measuring->places.size(), 2U);
  // To the pixels that were clicked.
  const auto& [from, to] = std::tie(state().measuring->places[0], state().measuring->places[1]);
  EXPECT_NEAR(glm::distance(from.at, glm::dvec3(10, 10, 10)), 0.0, 0.1);
  EXPECT_NEAR(glm::distance(to.at, glm::dvec3(30, 10, 4)), 0.0, 0.1);
  EXPECT_EQ(from.normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(to.normal, glm::dvec3(1, 0, 0));
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
  EXPECT_FALSE(state().can_undo);

  // A third click begins anew; clicks beside the part are none.
  click_at({20, 5, 10});
  EXPECT_EQ(state().measuring->places.size(), 1U);
  move_to({300, 640});
  press();
  EXPECT_EQ(state().measuring->places.size(), 1U);
  key({.key = k_escape});
  EXPECT_FALSE(state().measuring);
  click_at({20, 5, 10});
  EXPECT_TRUE(state().face);
}

TEST_F(MeasureTool, ItsFiguresAreCopied) {
  key({.key = 'R'});
  click_at({10, 0, 5});
  click_at({12, 8, 10});
  window.frames(3);
  move_to(window.control("measured along the direction").centre());
  window.set_button(1, true);
  window.frame();
  window.set_button(1, false);
  window.frames(3);
  const glm::vec2 menu = window.control("measured along the direction").centre() + glm::vec2(30, 18);
  move_to(menu);
  press();
  const double copied = std::strtod(ImGui::GetClipboardText(), nullptr);
  EXPECT_NEAR(copied, 5.0, 0.1);
  EXPECT_EQ(state().measuring->places.size(), 2U) << "the menu was clicked, not the part";
}

}  // namespace
}  // namespace moldlight::gui::test
