// The help sheet is searched by typing; hints tell a newcomer what to do, each until it was done or
// dismissed.
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

class Help : public WindowWithPart {
 protected:
  [[nodiscard]] bool told(std::string_view text) const {
    return std::ranges::any_of(window.app().texts(), [&](const DrawnText& each) {
      return each.text.find(text) != std::string::npos;
    });
  }
};

TEST_F(Help, TypingLeavesTheLinesThatHaveTheWords) {
  key({.key = 'H'});
  window.frames(3);
  EXPECT_TRUE(told("section across"));
  EXPECT_TRUE(told("bookmark the direction"));
  const Section section = state().settings.look.section;
  window.type("SECTION");
  window.frames(3);
  EXPECT_TRUE(told("section across"));
  EXPECT_FALSE(told("bookmark the direction"));
  EXPECT_EQ(state().settings.look.section, section) << "letters are no shortcuts there";
  key({.key = k_escape});
  EXPECT_FALSE(state().dialogs.help);
  key({.key = 'H'});
  window.frames(3);
  EXPECT_TRUE(told("bookmark the direction")) << "whole again";
}

TEST_F(Help, HintsComeOneByOneAndGoForGood) {
  window.wait_until_measured();
  EXPECT_FALSE(told("Drag the arrow")) << "only where they are asked for";
  window.app().show_hints(true);
  window.settle();
  EXPECT_TRUE(told("Drag the arrow"));
  drag(window.control("core arrow").centre(), window.control("core arrow").centre() + glm::vec2(60, 30));
  window.settle();
  EXPECT_FALSE(told("Drag the arrow"));
  EXPECT_TRUE(told("What becomes of the part"));
  click("dismiss the hint");
  window.settle();
  EXPECT_FALSE(told("What becomes of the part"));
  EXPECT_TRUE(told("Looks for the best"));
  key({.key = 'W'});
  EXPECT_FALSE(told("Looks for the best"));
  EXPECT_EQ(state().hints_done, (std::set<Hint>{Hint::arrow, Hint::verdict, Hint::sweep}));
}

}  // namespace
}  // namespace moldlight::gui::test
