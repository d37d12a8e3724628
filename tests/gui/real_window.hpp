// The program's window on a display of its own, used from outside as a user would: mouse, keys, resizing.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"
#include "gui/virtual_display.hpp"
#include "replay/offscreen.hpp"
#include "support/golden.hpp"

namespace moldlight::gui::test {

namespace fs = std::filesystem;
using moldlight::test::Process;
using moldlight::test::processor_seconds;
using moldlight::test::ProcessSettings;

inline constexpr glm::ivec2 k_first_size(1280, 800);

inline std::string whole_number(float number) { return std::to_string(static_cast<int>(number)); }

/// `moldlight view` of a small part, or of `file`, on a display that it has for itself, with a state folder
/// of its own.
class RealWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const std::string missing = VirtualDisplay::missing(); !missing.empty())
      GTEST_SKIP() << "not installed: " << missing;
  }

  void start(const glm::ivec2& screen, int dpi = 0, const std::vector<std::string>& flags = {}) {
    display = std::make_unique<VirtualDisplay>(screen);
    if (dpi > 0) display->set_dots_per_inch(dpi, part.output("resources"));
    ProcessSettings settings;
    settings.time_limit_s = 300.0;
    settings.environment = display->environment();
    settings.environment.push_back("XDG_STATE_HOME=" + part.output("state"));
    std::vector<std::string> command = {
        MOLDLIGHT_BINARY, "view", file, "--resolution", "512", "--samples", "20000", "--quick-sweep", "off"};
    command.insert(command.end(), flags.begin(), flags.end());
    program = std::make_unique<Process>(command, settings);
    window = display->find_window(fs::path(file).filename());
    const std::string manager = display->manager();
    std::printf("window manager: %s\n", manager.empty() ? "none is installed" : manager.c_str());
    static_cast<void>(display->act({"windowfocus", "--sync", window}));
  }

  /// A fresh window of this size and scale with the same part: the same program, without a display.
  [[nodiscard]] std::unique_ptr<OffscreenWindow> twin(const glm::ivec2& size, float scale = 1.0F) const {
    OffscreenOptions options;
    options.size = size;
    options.content_scale = scale;
    options.user.window.quick_sweep = options.user.window.motion = false;
    auto made = std::make_unique<OffscreenWindow>(options);
    made->app().open(file);
    made->wait_until_loaded();
    made->wait_until_measured();
    return made;
  }
  /// Where a control is there.
  [[nodiscard]] glm::vec2 place_of(const std::string& control, const glm::ivec2& size, float scale) const {
    return twin(size, scale)->control(control).centre();
  }
  /// The same once keys were pressed there.
  [[nodiscard]] glm::vec2 place_of(const std::string& control, const std::vector<KeyPress>& keys) const {
    const auto made = twin(display->size_of(window));
    for (const KeyPress& press : keys) {
      made->press_key(press);
      made->frame();
      made->hold_modifiers(false, false, false);
      made->wait_until_measured();
    }
    return made->control(control).centre();
  }
  void click(const glm::vec2& at) const {
    static_cast<void>(display->act({"mousemove", "--window", window, whole_number(at.x), whole_number(at.y),
                                    "sleep", "0.4", "click", "1", "sleep", "0.2"}));
  }
  void resize(const glm::ivec2& size) const {
    static_cast<void>(
        display->act({"windowsize", "--sync", window, std::to_string(size.x), std::to_string(size.y)}));
  }
  /// Ends the program by its key; what it saved of the part.
  [[nodiscard]] nlohmann::ordered_json notes_at_the_end() {
    press("ctrl+q");
    const auto result = program->finish();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return notes();
  }

  /// Once nothing is computed any more either: on a busy machine frames come so late that pictures look
  /// alike.
  [[nodiscard]] Image picture_at_rest() const {
    constexpr double k_idle_s = 0.05;
    for (;;) {
      const double before = processor_seconds(program->id());
      Image picture = display->settled_picture_of(window);
      if (processor_seconds(program->id()) - before < k_idle_s) return picture;
    }
  }

  void drag(const glm::vec2& from, const glm::vec2& by) const {
    const glm::vec2 half = from + 0.5F * by, to = from + by;
    static_cast<void>(display->act({"mousemove",
                                    "--window",
                                    window,
                                    whole_number(from.x),
                                    whole_number(from.y),
                                    "sleep",
                                    "0.2",
                                    "mousedown",
                                    "1",
                                    "sleep",
                                    "0.1",
                                    "mousemove",
                                    "--window",
                                    window,
                                    whole_number(half.x),
                                    whole_number(half.y),
                                    "sleep",
                                    "0.1",
                                    "mousemove",
                                    "--window",
                                    window,
                                    whole_number(to.x),
                                    whole_number(to.y),
                                    "sleep",
                                    "0.2",
                                    "mouseup",
                                    "1"}));
  }
  /// Until it shows in the picture: on a busy machine the field opens late. Gives the picture.
  [[nodiscard]] Image type_into(const glm::vec2& field, const std::string& value, const Image& before) const {
    constexpr int k_attempts = 6;
    for (int attempt = 1;; ++attempt) {
      static_cast<void>(display->act({"mousemove", "--window", window, whole_number(field.x),
                                      whole_number(field.y), "sleep", "0.3", "click", "1", "sleep",
                                      std::to_string(0.5 * attempt), "type", "--delay", "60", value}));
      static_cast<void>(
          display->act({"sleep", "0.2", "key", "Return", "sleep", "0.2", "mousemove", "--window", window,
                        std::to_string(before.width / 2), std::to_string(before.height - 5)}));
      Image after = picture_at_rest();
      if (attempt == k_attempts || moldlight::test::picture_difference(before, after).off_share > 0.02)
        return after;
    }
  }
  void press(const std::string& key) const { static_cast<void>(display->act({"key", key})); }

  /// What the program saved of the part when it ended.
  [[nodiscard]] nlohmann::ordered_json notes() const {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(part.output("state") + "/moldlight/parts", none))
      return moldlight::test::json_of(moldlight::test::file_bytes(entry.path()));
    return {};
  }

  moldlight::test::SmallPart part;
  std::string file = part.file();
  std::unique_ptr<VirtualDisplay> display;
  std::unique_ptr<Process> program;
  std::string window;
};

}  // namespace moldlight::gui::test
