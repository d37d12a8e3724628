// The program's window on a display of its own, used from outside as a user would: mouse, keys, resizing,
// end.
#include "gui/real_window.hpp"

#include <csignal>
#include <numeric>

namespace moldlight::gui::test {
namespace {

TEST_F(RealWindow, IsDraggedTypedIntoResizedSweptAndQuit) {
  start({1600, 1000});
  EXPECT_EQ(display->size_of(window), k_first_size);
  const Image first = picture_at_rest();
  moldlight::test::keep_picture(first, "window");
  EXPECT_GT(colours_of(first), 1000U) << "blank";

  // Beside the part: the view turns about its middle, and panels stay.
  drag({640, 640}, {160, 30});
  const Image turned = picture_at_rest();
  moldlight::test::keep_picture(turned, "window_turned");
  EXPECT_GT(moldlight::test::picture_difference(first, turned).off_share, 0.05);

  const Image typed = type_into(place_of("x", k_first_size, 1.0F), "1", turned);
  moldlight::test::keep_picture(typed, "window_typed");
  EXPECT_GT(moldlight::test::picture_difference(turned, typed).off_share, 0.02);

  static_cast<void>(display->act({"windowsize", "--sync", window, "1500", "900"}));
  const Image resized = display->settled_picture_of(window);
  moldlight::test::keep_picture(resized, "window_resized");
  EXPECT_EQ(glm::ivec2(resized.width, resized.height), glm::ivec2(1500, 900));
  EXPECT_GT(colours_of(resized), 1000U) << "blank";

  // Nothing changes any more: no frame is drawn. A window that draws all the time takes a core or more.
  const double before = processor_seconds(program->id());
  constexpr double k_idle_s = 3.0;
  static_cast<void>(display->act({"sleep", std::to_string(k_idle_s)}));
  const double used = processor_seconds(program->id()) - before;
  std::printf("idle: %.2f s of the processor in %.0f s\n", used, k_idle_s);
  EXPECT_LT(used, 0.1 * k_idle_s);

  // The sweep runs beside the frames and ends with its table, however long that takes.
  press("w");
  Image swept = display->settled_picture_of(window);
  const auto share = [&] { return moldlight::test::picture_difference(resized, swept).off_share; };
  for (int attempt = 0; attempt < 20 && share() <= 0.05; ++attempt)
    swept = display->settled_picture_of(window);
  moldlight::test::keep_picture(swept, "window_swept");
  EXPECT_GT(share(), 0.05);

  press("ctrl+q");
  const auto result = program->finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(notes()["settings"]["direction"], nlohmann::ordered_json({1.0, 0.0, 1.0})) << notes();
}

TEST_F(RealWindow, FollowsTheMonitorsScale) {
  start({2700, 1700}, 192, {"--theme", "light", "--navigation", "blender"});
  EXPECT_EQ(display->size_of(window), 2 * k_first_size) << "as large on the desk as on a coarse monitor";
  const Image picture = picture_at_rest();
  moldlight::test::keep_picture(picture, "window_scale_2");
  EXPECT_GT(colours_of(picture), 1000U) << "blank";
  const double brightness = std::accumulate(picture.rgba.begin(), picture.rgba.end(), 0.0) /
                            static_cast<double>(picture.rgba.size());
  EXPECT_GT(brightness, 160.0) << "the light theme, as the flag says";
  const Image typed = type_into(place_of("y", 2 * k_first_size, 2.0F), "1", picture);
  EXPECT_GT(moldlight::test::picture_difference(picture, typed).off_share, 0.02);
  // An interrupt ends it in good order too.
  program->send_signal(SIGTERM);
  const auto result = program->finish();
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(result.err, "moldlight: interrupted\n");
  EXPECT_EQ(notes()["settings"]["direction"], nlohmann::ordered_json({0.0, 1.0, 1.0})) << notes();
  const auto kept = moldlight::test::json_of(
      moldlight::test::file_bytes(part.output("state") + "/moldlight/window.json"))["settings"];
  EXPECT_EQ(kept["theme"], "dark") << "flags hold this time";
  EXPECT_EQ(kept["navigation"], "standard");
  EXPECT_EQ(kept["motion"], true);
}

TEST(NoDisplay, IsToldInOneLineWithTheWayOut) {
  const moldlight::test::SmallPart part;
  ProcessSettings settings;
  settings.removed_environment = {"DISPLAY", "WAYLAND_DISPLAY"};
  settings.environment = {"XDG_STATE_HOME=" + part.output("state")};
  const auto result = moldlight::test::run_moldlight({"view", part.file()}, settings);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.error_lines(), 1U) << result.err;
  EXPECT_NE(result.err.find("no display"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("moldlight classify"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("--screenshot"), std::string::npos) << result.err;
  EXPECT_EQ(moldlight::test::run_moldlight({part.file()}, settings).err, result.err) << "short for view";
}

}  // namespace
}  // namespace moldlight::gui::test
