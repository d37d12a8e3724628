// The presentation: what it shows one after the other, the film of it, and the views that a report begins
// with.
#include <filesystem>

#include "gui/view/presentation.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

using moldlight::test::file_bytes;

constexpr int k_f5 = 294;

class Presenting : public WindowWithPart {
 protected:
  Presenting() { window.wait_until_measured(); }

  /// Lets it run, half a second a frame, until it has ended; its captions, each once.
  std::vector<std::string> captions() {
    std::vector<std::string> found;
    for (int k = 0; k < 4000 && state().presented; ++k) {
      if (found.empty() || found.back() != state().presented->caption)
        found.push_back(state().presented->caption);
      window.pass_time(0.5);
      window.frame();
    }
    EXPECT_FALSE(state().presented) << "it ends by itself";
    return found;
  }
};

TEST_F(Presenting, GoesFromTheDirectionToTheOpenedMold) {
  const Camera before = state().camera;
  key({.key = k_f5});
  ASSERT_TRUE(state().presented);
  EXPECT_FALSE(window.app().controls().contains("panel Direction")) << "the part alone";
  EXPECT_FALSE(window.app().controls().contains("step Part"));
  const std::vector<std::string> said = captions();
  ASSERT_GE(said.size(), 4U);
  EXPECT_EQ(said[0], "cup opens along z.");
  EXPECT_TRUE(said[1].find("undercut") != std::string::npos) << said[1];
  EXPECT_EQ(said[2], "1 slide moves out first.");
  EXPECT_TRUE(said[3].starts_with("The halves open")) << said[3];
  EXPECT_EQ(said.back(), state().verdict->sentence);
  EXPECT_EQ(state().camera, before) << "nothing is left of it";
  EXPECT_EQ(state().settings.look.open_mold, 0.0);
  window.settle();
  EXPECT_TRUE(window.app().controls().contains("panel Direction"));
}

TEST_F(Presenting, IsPausedAndEnded) {
  key({.key = k_f5});
  key({.key = ' '});
  ASSERT_TRUE(state().presented);
  EXPECT_TRUE(state().presented->paused);
  const double at_s = state().presented->time_s;
  window.pass_time(3.0);
  window.frames(2);
  EXPECT_EQ(state().presented->time_s, at_s);
  key({.key = '3'});
  EXPECT_EQ(state().step, Step::direction) << "other keys mean nothing now";
  key({.key = k_escape});
  EXPECT_FALSE(state().presented);
  click("step Report");
  click("present");
  ASSERT_TRUE(state().presented);
  press();  // anywhere
  EXPECT_FALSE(state().presented);
}

TEST_F(Presenting, StandsInAStudioWithAShadow) {
  // The floor beside the part is darker than the backdrop above it.
  key({.key = k_f5});
  key({.key = ' '});
  window.settle();
  const std::vector<std::uint8_t> shown = window.pixels();
  int darkest = 255;
  for (int x = 0; x < 1280; x += 4)
    for (int y = 60; y < 700; y += 4) {
      const std::size_t at = 4 * (static_cast<std::size_t>(y) * 1280 + static_cast<std::size_t>(x));
      const int most = std::max({shown[at], shown[at + 1], shown[at + 2]}),
                least = std::min({shown[at], shown[at + 1], shown[at + 2]});
      if (most - least < 14 && most > 100) darkest = std::min(darkest, most);  // what has no colour
    }
  EXPECT_LT(darkest, 175) << "the shadow";
  EXPECT_GT(shown[4 * (5 * 1280 + 5)], 200) << "a light backdrop, in the dark theme, too";
}

TEST_F(Presenting, IsWrittenAsAFilm) {
  window.resize({720, 450});
  window.settle();
  enter(Step::report);
  click("film");
  ASSERT_TRUE(state().dialogs.film);
  click("Make it");
  ASSERT_TRUE(state().presented);
  EXPECT_TRUE(state().presented->recording);
  for (int k = 0; k < 2000 && state().presented; ++k) window.frame();
  ASSERT_FALSE(state().presented);
  const std::string film = file_bytes(part.output("cup.gif"));
  ASSERT_TRUE(film.starts_with("GIF89a")) << "beside the part";
  EXPECT_EQ(static_cast<unsigned char>(film[6]) + 256 * static_cast<unsigned char>(film[7]), 720);
  std::size_t pictures = 0;
  const std::string mark("\x21\xF9\x04", 3);
  for (std::size_t at = film.find(mark); at != std::string::npos; at = film.find(mark, at + 1)) ++pictures;
  EXPECT_GT(pictures, 150U) << "twelve a second";
  EXPECT_EQ(state().toasts.back().text, "Film saved as " + part.output("cup.gif"));
}

TEST_F(Presenting, EndsWithAMessageWhereTheDiskIsFull) {
  std::filesystem::create_symlink("/dev/full", part.output("cup.gif"));
  window.resize({720, 450});
  window.settle();
  enter(Step::report);
  click("film");
  click("Make it");
  ASSERT_TRUE(state().presented);
  for (int k = 0; k < 2000 && state().presented; ++k) window.frame();
  EXPECT_FALSE(state().presented);
  ASSERT_FALSE(state().toasts.empty());
  EXPECT_NE(state().toasts.back().text.find("cannot be written"), std::string::npos)
      << state().toasts.back().text;
  window.settle();
  EXPECT_TRUE(window.app().controls().contains("panel Report")) << "the window goes on";
}

TEST_F(Presenting, ReportsBeginWithTheViewsThatWereAdded) {
  enter(Step::report);
  click("Add this view");
  key({.key = '3', .shift = true});  // from the right
  click("Add this view");
  ASSERT_EQ(state().views.size(), 2U);
  EXPECT_EQ(state().views[0].light.width, 1400);
  EXPECT_NE(state().views[0].light.rgba, state().views[1].light.rgba);
  window.settle();
  click("Write the report");
  for (int i = 0; i < 200'000 && state().toasts.empty(); ++i) window.frame();
  const std::string page = file_bytes(part.output("cup-report.html"));
  const std::size_t views = page.find(">Views<");
  ASSERT_NE(views, std::string::npos);
  EXPECT_NE(page.find("1. " + state().verdict->sentence, views), std::string::npos);
  click("views");
  EXPECT_TRUE(state().views.empty());
}

TEST(Presentation, IsAFunctionOfTime) {
  Camera near, far;
  near.height = 1.0;
  far.height = 3.0;
  const Presentation show({{.length_s = 4.0, .camera = near, .open = 0.0, .floor = -0.2, .caption = "a"},
                           {.length_s = 3.0, .camera = far, .open = 0.5, .floor = -0.4, .caption = "b"},
                           {.length_s = 5.0, .camera = far, .open = 1.0, .floor = -0.4, .caption = "c"}});
  EXPECT_EQ(show.length_s(), 12.0);
  EXPECT_EQ(show.opens_s(), 4.0);
  EXPECT_EQ(show.at(2.0).caption, "a");
  EXPECT_EQ(show.at(2.0).open, 0.0);
  EXPECT_EQ(show.at(4.1).caption, "b");
  EXPECT_NEAR(show.at(4.0).camera.height, 1.0, 1e-9);
  EXPECT_NEAR(show.at(5.8).open, 0.25, 1e-9) << "time is shared out, not the way";
  EXPECT_EQ(show.at(6.9).open, 0.5);
  EXPECT_EQ(show.at(3.9).floor, -0.2) << "what is shown stands on it";
  EXPECT_NEAR(show.at(6.9).floor, -0.4, 1e-9);
  EXPECT_NEAR(show.at(6.9).camera.height, 3.0, 1e-9);
  EXPECT_EQ(show.at(100.0).open, 1.0);
  double before = 0.0;
  for (double time_s = 0.0; time_s < 12.0; time_s += 0.1) {
    EXPECT_GE(show.at(time_s).open, before);
    before = show.at(time_s).open;
  }
}

}  // namespace
}  // namespace moldlight::gui::test
