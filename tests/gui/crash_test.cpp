// A window whose program crashes: the next one takes its place, with what was set.
#include <csignal>

#include "gui/real_window.hpp"
#include "replay/window_record.hpp"

namespace moldlight::gui::test {
namespace {

TEST(Resume, OpensThePartAndSaysWhatWentOn) {
  const WindowRecord crashed{.part = "/parts/lid.stl",
                             .compare = "/parts/lid 2.stl",
                             .work = "sought side actions of",
                             .part_at_work = "/parts/lid.stl"};
  EXPECT_EQ(parse_record(record_text(crashed)), crashed);
  EXPECT_EQ(parse_record(""), WindowRecord());
  const Resumed next = resume(crashed, "segmentation fault");
  EXPECT_EQ(next.opened.part, crashed.part);
  EXPECT_EQ(next.opened.compare, crashed.compare);
  EXPECT_EQ(next.said,
            "The window crashed (segmentation fault) while it sought side actions of lid.stl. Settings and "
            "bookmarks are kept.");
}

TEST(Resume, DoesNotOpenAgainWhatCannotBeReadOrCrashedTwice) {
  const WindowRecord reading{.part = "/parts/lid.stl", .work = "read", .part_at_work = "/parts/bad\n.stl"};
  const Resumed after_reading = resume(reading, "abort");
  EXPECT_EQ(after_reading.opened.part, "");
  EXPECT_NE(after_reading.said.find("bad .stl is not opened again by itself."), std::string::npos)
      << after_reading.said;

  WindowRecord crashed{.part = "a.stl", .work = "made the mold of", .part_at_work = "a.stl"};
  const WindowRecord next = resume(crashed, "abort").opened;
  crashed.former_work = next.former_work;
  crashed.former_part = next.former_part;
  EXPECT_EQ(resume(crashed, "abort").opened.part, "");
  crashed.work = "measured the regions of";
  EXPECT_EQ(resume(crashed, "abort").opened.part, "a.stl") << "other work";
}

using CrashedWindow = RealWindow;

TEST_F(CrashedWindow, IsFollowedByOneWithThePartAndItsSettings) {
  start({1600, 1000});
  const auto first = moldlight::test::children_of(program->id());
  ASSERT_EQ(first.size(), 1U);
  const Image before = picture_at_rest();
  static_cast<void>(type_into(place_of("x", k_first_size, 1.0F), "1", before));
  ::kill(first.front(), SIGKILL);
  window.clear();
  for (int attempt = 0; attempt < 20 && moldlight::test::children_of(program->id()) == first; ++attempt)
    static_cast<void>(display->act({"sleep", "0.2"}));
  window = display->find_window(fs::path(file).filename());
  const Image after = picture_at_rest();
  moldlight::test::keep_picture(after, "window_after_a_crash");
  EXPECT_NE(moldlight::test::children_of(program->id()), first);
  static_cast<void>(display->act({"windowfocus", "--sync", window}));
  EXPECT_EQ(notes_at_the_end()["settings"]["direction"], nlohmann::ordered_json({1.0, 0.0, 1.0}));
}

}  // namespace
}  // namespace moldlight::gui::test
