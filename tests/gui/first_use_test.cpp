// The first use that the documentation shows: its script is played, and each step does what the text says.
#include <filesystem>

#include <gtest/gtest.h>

#include "gui/panels/panels.hpp"
#include "replay/offscreen.hpp"
#include "replay/script.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::gui::test {
namespace {

namespace fs = std::filesystem;

TEST(FirstUse, LeadsFromTheVerdictToTheExport) {
  const moldlight::test::ScratchFolder folder;
  const fs::path assets = moldlight::test::asset_folder();
  const std::string part = folder.file("enclosure_lid.stl");
  fs::copy_file(assets / "parts" / "enclosure_lid.stl", part);
  std::string text = moldlight::test::file_bytes((assets / "first_use.json").string());
  const std::string pictures = "assets/pictures/";
  for (std::size_t at = text.find(pictures); at != std::string::npos; at = text.find(pictures, at))
    text.replace(at, pictures.size(), folder.file(""));

  OffscreenOptions options;
  options.size = {1280, 720};
  options.user.window.motion = false;
  options.reading.unit = "mm";
  OffscreenWindow window(options);
  PartNotes notes;
  notes.settings.direction = glm::dvec3(0, 1, 0);
  window.app().set_notes(notes);
  window.app().open(part);
  window.wait_until_loaded();
  // What is to be seen when each picture is taken.
  const std::vector<std::function<void()>> steps = {
      [&] { EXPECT_TRUE(window.app().controls().contains("card 1")) << "a better direction is known"; },
      [&] {
        EXPECT_EQ(window.state().settings.direction.unit(), glm::dvec3(0, 0, 1));
        EXPECT_FALSE(verdict_card(window.state()).good());
      },
      [&] {
        ASSERT_TRUE(window.state().hover.has_value()) << "on an undercut";
        EXPECT_EQ(window.state().hover->point.region, Region::undercut);
        EXPECT_TRUE(window.state().hover->blocker.has_value());
      },
      [&] { EXPECT_TRUE(window.state().dialogs.exporting); },
  };
  std::size_t pictures_taken = 0;
  for (const ScriptEvent& event : parse_script(text)) {
    event.play(window);
    if (event.text.find("screenshot") == std::string::npos) continue;
    ASSERT_LT(pictures_taken, steps.size());
    steps[pictures_taken++]();
  }
  EXPECT_EQ(pictures_taken, steps.size());
  EXPECT_TRUE(fs::exists(folder.file("enclosure_lid-regions.ply")));
  EXPECT_TRUE(fs::exists(folder.file("enclosure_lid-regions.json")));
}

}  // namespace
}  // namespace moldlight::gui::test
