// The window's export writes what `classify` writes.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "classify/classify_report.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

class Exports : public WindowWithPart {};

TEST_F(Exports, TheSplitMeshAndItsBordersAsTheCommandLine) {
  // Along a direction that cuts facets.
  PartNotes notes;
  notes.settings.method = method();
  notes.settings.direction = glm::dvec3(0.36, 0.48, 0.8);
  window.app().set_notes(notes);
  window.app().open(part.file());
  window.wait_until_loaded();
  window.wait_until_measured();
  ASSERT_EQ(state().settings, notes.settings);
  ASSERT_GT(state().figures.split->pieces.size(), state().model->part.mesh.facets.size());
  key({.key = 'E', .ctrl = true});
  window.frames(3);
  for (const char* more : {"One STL a region, in a folder", "Lines between regions (OBJ)"}) click(more);
  click("Export");
  for (int i = 0; i < 2000 && state().toasts.empty(); ++i) window.frame();
  ASSERT_EQ(state().toasts.size(), 1U);
  EXPECT_TRUE(state().toasts.front().text.starts_with("Exported ")) << state().toasts.front().text;
  EXPECT_TRUE(state().toasts.front().text.ends_with(" to " + part.folder().path().string()))
      << state().toasts.front().text;

  OutputPaths expected;
  expected.mesh = part.output("expected.ply");
  expected.split_folder = part.output("expected");
  expected.borders = part.output("expected.obj");
  write_outputs(expected, *state().model, classify_exact(*state().model, state().settings, Progress{}, true),
                state().settings.look.palette);
  const auto same = [&](const std::string& ours, const std::string& theirs) {
    const std::string bytes = moldlight::test::file_bytes(part.output(ours));
    EXPECT_GT(bytes.size(), 100U) << ours;
    EXPECT_TRUE(bytes == moldlight::test::file_bytes(part.output(theirs))) << ours;
  };
  same("cup-regions.ply", "expected.ply");
  same("cup-regions-borders.obj", "expected.obj");
  for (const char* region : {"core", "cavity", "undercut"}) {
    const std::string file = std::string("/cup_") + region + ".stl";
    same("cup-regions" + file, "expected" + file);
  }
}

TEST_F(Exports, TheFirstPictureAsksWhereAndTheNextGoBesideIt) {
  namespace fs = std::filesystem;
  const fs::path pictures = part.output("pictures"), chosen = part.output("chosen");
  fs::create_directory(pictures);
  fs::create_directory(chosen);
  ::setenv("XDG_PICTURES_DIR", pictures.c_str(), 1);
  key({.key = k_f12});
  ASSERT_TRUE(state().dialogs.picture);
  EXPECT_EQ(*state().dialogs.picture, (pictures / "cup-01.png").string()) << "not beside the part";
  EXPECT_FALSE(window.app().take_picture_request()) << "not without asking";
  click("Picture path");
  key({.key = 'A', .ctrl = true});
  const std::string first = (chosen / "cup-01.png").string();
  window.type(first);
  window.frames(2);
  window.press_key({.key = k_enter});
  window.frame();
  EXPECT_FALSE(window.app().take_picture_request()) << "the dialog is still in the picture";
  window.frames(3);
  EXPECT_FALSE(state().dialogs.picture);
  EXPECT_EQ(window.app().take_picture_request(), first);
  std::ofstream(first) << "a picture";
  window.app().picture_saved(first);
  EXPECT_NE(state().toasts.back().text.find(first), std::string::npos);

  key({.key = k_f12});
  EXPECT_FALSE(state().dialogs.picture) << "once a session";
  EXPECT_EQ(window.app().take_picture_request(), (chosen / "cup-02.png").string());
  ::unsetenv("XDG_PICTURES_DIR");
}

TEST_F(Exports, AFailedOneOpensTheDialogAgainWithItsPath) {
  key({.key = 'E', .ctrl = true});
  window.frames(3);
  click("Export path");
  key({.key = 'A', .ctrl = true});
  window.type("/nowhere/at/all");
  window.frames(2);
  click("Export");
  for (int i = 0; i < 2000 && state().toasts.empty(); ++i) window.frame();
  ASSERT_FALSE(state().toasts.empty());
  EXPECT_TRUE(state().toasts.front().failure);
  EXPECT_NE(state().toasts.front().text.find("/nowhere/at/all"), std::string::npos);
  EXPECT_TRUE(state().dialogs.exporting);
}

TEST_F(Exports, EscapeAndCancelLeaveTheDialogs) {
  for (const bool cancels : {false, true}) {
    key({.key = 'E', .ctrl = true});
    ASSERT_TRUE(state().dialogs.exporting);
    cancels ? click("Cancel") : key({.key = k_escape});
    EXPECT_FALSE(state().dialogs.exporting);
  }
}

}  // namespace
}  // namespace moldlight::gui::test
