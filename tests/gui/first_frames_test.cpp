// What is drawn for the first time while somebody waits: the GL's programs are there before.
#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "gl/program.hpp"
#include "gui/quick_options.hpp"

namespace moldlight::gui::test {
namespace {

TEST(FirstFrames, WaitForNoProgram) {
  const moldlight::test::SmallPart part;
  OffscreenOptions options = quick_options();
  options.size = {640, 480};
  options.rehearses = true;
  options.user.window.motion = options.user.window.quick_sweep = false;
  OffscreenWindow window(options);
  EXPECT_TRUE(window.app().preparing());
  window.wait_until_prepared();
  const gl::Programs& programs = *window.context().functions().programs.lock();
  const std::size_t rehearsed = programs.count();
  const auto press = [&](int key) {
    window.press_key({.key = key});
    window.frames(2);
    window.wait_until_measured();
  };

  window.app().open(part.file());
  window.wait_until_loaded();
  window.wait_until_measured();
  EXPECT_EQ(programs.count(), rehearsed) << "the part";
  for (int step = 1; step <= 7; ++step) {
    press('0' + step);
    EXPECT_EQ(programs.count(), rehearsed) << "step " << step;
  }
  press('O');
  EXPECT_GT(window.state().settings.look.open_mold, 0.0);
  EXPECT_EQ(programs.count(), rehearsed) << "an opened mold";
  press('O');
  PartNotes notes{.settings = window.state().settings, .bookmarks = {}};
  notes.settings.look.section = Section::x;
  window.app().set_notes(notes);
  window.settle();
  EXPECT_EQ(programs.count(), rehearsed) << "a section";

  // Another part brings none of its own.
  window.app().open(part.folder().write("other.off",
                                        "OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n"
                                        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"));
  window.wait_until_loaded();
  window.wait_until_measured();
  EXPECT_EQ(programs.count(), rehearsed) << "another part";
}

}  // namespace
}  // namespace moldlight::gui::test
