// The program's window on a display of its own, used from outside as a user
// would: mouse, keys, resizing, end.
#include <csignal>
#include <filesystem>
#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"
#include "gui/virtual_display.hpp"
#include "replay/offscreen.hpp"
#include "support/golden.hpp"

namespace moldlight::gui::test {
namespace {

namespace fs = std::filesystem;
using moldlight::test::Process;
using moldlight::test::processor_seconds;
using moldlight::test::ProcessSettings;

constexpr glm::ivec2 k_first_size(1280, 800);

std::string text(float number) {
  return std::to_string(static_cast<int>(number));
}

/// `moldlight view` of a small part, on a display that it has for itself, with
/// a state folder of its own.
class RealWindow : public ::testing::Test {
protected:
  void SetUp() override {
    if (const std::string missing = VirtualDisplay::missing(); !missing.empty())
      GTEST_SKIP() << "not installed: " << missing;
  }

  void start(const glm::ivec2 &screen, int dpi = 0,
             const std::vector<std::string> &flags = {}) {
    display = std::make_unique<VirtualDisplay>(screen);
    if (dpi > 0)
      display->set_dots_per_inch(dpi, part.output("resources"));
    ProcessSettings settings;
    settings.time_limit_s = 300.0;
    settings.environment = display->environment();
    settings.environment.push_back("XDG_STATE_HOME=" + part.output("state"));
    std::vector<std::string> command = {
        MOLDLIGHT_BINARY, "view",  part.file(),     "--resolution", "512",
        "--samples",      "20000", "--quick-sweep", "off"};
    command.insert(command.end(), flags.begin(), flags.end());
    program = std::make_unique<Process>(command, settings);
    window = display->find_window("cup.obj");
    static_cast<void>(display->act({"windowfocus", "--sync", window}));
  }

  /// Where a control is in a fresh window of this size and scale: the same
  /// program shows it without a display.
  [[nodiscard]] glm::vec2 place_of(const std::string &control,
                                   const glm::ivec2 &size, float scale) const {
    OffscreenOptions options;
    options.size = size;
    options.content_scale = scale;
    options.user.window.quick_sweep = false;
    OffscreenWindow twin(options);
    twin.app().open(part.file());
    twin.wait_until_loaded();
    return twin.control(control).centre();
  }

  /// Once nothing is computed any more either: on a busy machine frames come so
  /// late that pictures look alike.
  [[nodiscard]] Image picture_at_rest() const {
    constexpr double k_idle_s = 0.05;
    for (;;) {
      const double before = processor_seconds(program->id());
      Image picture = display->settled_picture_of(window);
      if (processor_seconds(program->id()) - before < k_idle_s)
        return picture;
    }
  }

  void drag(const glm::vec2 &from, const glm::vec2 &by) const {
    const glm::vec2 half = from + 0.5F * by, to = from + by;
    static_cast<void>(display->act(
        {"mousemove",  "--window",  window,      text(from.x), text(from.y),
         "sleep",      "0.2",       "mousedown", "1",          "sleep",
         "0.1",        "mousemove", "--window",  window,       text(half.x),
         text(half.y), "sleep",     "0.1",       "mousemove",  "--window",
         window,       text(to.x),  text(to.y),  "sleep",      "0.2",
         "mouseup",    "1"}));
  }
  /// Until it shows in the picture: on a busy machine the field opens late.
  /// Gives the picture.
  [[nodiscard]] Image type_into(const glm::vec2 &field,
                                const std::string &value,
                                const Image &before) const {
    constexpr int k_attempts = 6;
    for (int attempt = 1;; ++attempt) {
      static_cast<void>(display->act(
          {"mousemove", "--window", window, text(field.x), text(field.y),
           "sleep", "0.3", "click", "1", "sleep", std::to_string(0.5 * attempt),
           "type", "--delay", "60", value}));
      static_cast<void>(display->act({"sleep", "0.2", "key", "Return", "sleep",
                                      "0.2", "mousemove", "--window", window,
                                      std::to_string(before.width / 2),
                                      std::to_string(before.height - 5)}));
      Image after = picture_at_rest();
      if (attempt == k_attempts ||
          moldlight::test::picture_difference(before, after).off_share > 0.02)
        return after;
    }
  }
  void press(const std::string &key) const {
    static_cast<void>(display->act({"key", key}));
  }

  /// What the program saved of the part when it ended.
  [[nodiscard]] nlohmann::ordered_json notes() const {
    std::error_code none;
    for (const auto &entry : fs::directory_iterator(
             part.output("state") + "/moldlight/parts", none))
      return moldlight::test::json_of(
          moldlight::test::file_bytes(entry.path()));
    return {};
  }

  moldlight::test::SmallPart part;
  std::unique_ptr<VirtualDisplay> display;
  std::unique_ptr<Process> program;
  std::string window;
};

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

  static_cast<void>(
      display->act({"windowsize", "--sync", window, "1500", "900"}));
  const Image resized = display->settled_picture_of(window);
  moldlight::test::keep_picture(resized, "window_resized");
  EXPECT_EQ(glm::ivec2(resized.width, resized.height), glm::ivec2(1500, 900));
  EXPECT_GT(colours_of(resized), 1000U) << "blank";

  // Nothing changes any more: no frame is drawn. A window that draws all the
  // time takes a core or more.
  const double before = processor_seconds(program->id());
  constexpr double k_idle_s = 3.0;
  static_cast<void>(display->act({"sleep", std::to_string(k_idle_s)}));
  const double used = processor_seconds(program->id()) - before;
  std::printf("idle: %.2f s of the processor in %.0f s\n", used, k_idle_s);
  EXPECT_LT(used, 0.1 * k_idle_s);

  // The sweep runs beside the frames and ends with its table, however long that
  // takes.
  press("w");
  Image swept = display->settled_picture_of(window);
  const auto share = [&] {
    return moldlight::test::picture_difference(resized, swept).off_share;
  };
  for (int attempt = 0; attempt < 20 && share() <= 0.05; ++attempt)
    swept = display->settled_picture_of(window);
  moldlight::test::keep_picture(swept, "window_swept");
  EXPECT_GT(share(), 0.05);

  press("ctrl+q");
  const auto result = program->finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(notes()["settings"]["direction"],
            nlohmann::ordered_json({1.0, 0.0, 1.0}))
      << notes();
}

TEST_F(RealWindow, FollowsTheMonitorsScale) {
  start({2700, 1700}, 192, {"--theme", "light", "--navigation", "blender"});
  EXPECT_EQ(display->size_of(window), 2 * k_first_size)
      << "as large on the desk as on a coarse monitor";
  const Image picture = picture_at_rest();
  moldlight::test::keep_picture(picture, "window_scale_2");
  EXPECT_GT(colours_of(picture), 1000U) << "blank";
  const double brightness =
      std::accumulate(picture.rgba.begin(), picture.rgba.end(), 0.0) /
      static_cast<double>(picture.rgba.size());
  EXPECT_GT(brightness, 160.0) << "the light theme, as the flag says";
  const Image typed =
      type_into(place_of("y", 2 * k_first_size, 2.0F), "1", picture);
  EXPECT_GT(moldlight::test::picture_difference(picture, typed).off_share,
            0.02);
  // An interrupt ends it in good order too.
  program->send_signal(SIGTERM);
  const auto result = program->finish();
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(result.err, "moldlight: interrupted\n");
  EXPECT_EQ(notes()["settings"]["direction"],
            nlohmann::ordered_json({0.0, 1.0, 1.0}))
      << notes();
  const auto kept = moldlight::test::json_of(moldlight::test::file_bytes(
      part.output("state") + "/moldlight/window.json"))["settings"];
  EXPECT_EQ(kept["theme"], "dark") << "flags hold this time";
  EXPECT_EQ(kept["navigation"], "standard");
  EXPECT_EQ(kept["motion"], true);
}

TEST(NoDisplay, IsToldInOneLineWithTheWayOut) {
  const moldlight::test::SmallPart part;
  ProcessSettings settings;
  settings.removed_environment = {"DISPLAY", "WAYLAND_DISPLAY"};
  settings.environment = {"XDG_STATE_HOME=" + part.output("state")};
  const auto result =
      moldlight::test::run_moldlight({"view", part.file()}, settings);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.error_lines(), 1U) << result.err;
  EXPECT_NE(result.err.find("no display"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("moldlight classify"), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("--screenshot"), std::string::npos) << result.err;
  EXPECT_EQ(moldlight::test::run_moldlight({part.file()}, settings).err,
            result.err)
      << "short for view";
}

} // namespace
} // namespace moldlight::gui::test
