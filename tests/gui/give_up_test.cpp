// Giving up what takes long: a load is held at its first report of progress, so that it is under way for
// sure.
#include "gui/barrier.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

TEST(GivingUp, LoadingIsCancelled) {
  Barrier barrier;
  OffscreenOptions options;
  options.user.window.motion = options.user.window.quick_sweep = false;
  options.wake = [&barrier] { barrier.pass(); };
  const moldlight::test::SmallPart part, other;
  OffscreenWindow window(options);
  window.app().open(part.file());
  window.wait_until_loaded();
  window.wait_until_measured();
  const auto model = window.state().model;

  barrier.set_open(false);
  window.app().open(other.file());
  window.frames(2);
  const auto click_cancel = [&] {
    ASSERT_TRUE(window.state().loading);
    EXPECT_EQ(window.state().loading->path, other.file());
    window.move_mouse(window.control("Cancel").centre());
    window.frames(2);
    window.set_button(0, true);
    window.frame();
    window.set_button(0, false);
    window.frames(2);
  };
  click_cancel();
  EXPECT_FALSE(window.state().loading);
  EXPECT_FALSE(window.app().controls().contains("Cancel")) << "its card goes";

  // Nothing comes after it: neither the part nor a message.
  barrier.set_open(true);
  window.app().open(part.file());
  window.wait_until_loaded();
  EXPECT_EQ(window.state().path, part.file());
  EXPECT_NE(window.state().model, model);
  EXPECT_TRUE(window.state().toasts.empty());
}

}  // namespace
}  // namespace moldlight::gui::test
