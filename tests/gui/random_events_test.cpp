// Random input, of which no event may end the window, leave it in a state that cannot be, or unusable
// afterwards. MOLDLIGHT_EVENTS=10000 build/ci/bin/test_gui --gtest_filter='*RandomEvents*' plays that many to
// each of five parts (half an hour); without it one part gets a few hundred. The state folder is not used,
// and what is exported or photographed goes beside the part, into a scratch folder.
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "gui/quick_options.hpp"
#include "gui/store/files.hpp"
#include "support/random.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::gui::test {
namespace {

namespace fs = std::filesystem;
using moldlight::test::Random;

constexpr int k_few_events = 400;
constexpr glm::ivec2 k_usual_size(640, 480), k_least_size(240, 240), k_most_size(720, 540);

/// Codes of GLFW's keys that are no letters or digits: Esc to Home and End, F1, F12, and on the number pad.
constexpr std::array<int, 18> k_other_keys = {32,  256, 257, 258, 259, 261, 262, 263, 264,
                                              265, 268, 269, 290, 301, 320, 325, 327, 329};

int events_a_part() {
  const char* count = std::getenv("MOLDLIGHT_EVENTS");
  return count == nullptr ? k_few_events : std::atoi(count);
}

/// Works in a folder of its own, so that a name that was typed into a path field does not lead anywhere else.
class WorkingFolder {
 public:
  explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
  ~WorkingFolder() { fs::current_path(before_); }
  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path before_;
};

OffscreenOptions options() {
  OffscreenOptions options = quick_options();
  options.size = k_usual_size;
  options.user.sweep.directions = 20;
  options.user.sweep.refine = 1;
  options.user.sweep.top = 3;
  options.user.sweep.scoring_samples = 1000;
  return options;
}

class RandomInput {
 public:
  RandomInput(OffscreenWindow& window, std::uint32_t seed, std::vector<std::string> dropped)
      : window_(window), random_(seed), dropped_(std::move(dropped)) {}

  /// One event and the frame after it.
  void play() {
    const double kind = random_.between(0.0, 1.0);
    if (kind < 0.35) {
      window_.move_mouse(place());
    } else if (kind < 0.60) {
      // Mostly the left one, and seldom held for long.
      const int button = random_.chance(0.7) ? 0 : static_cast<int>(random_.below(3));
      bool& held = held_[static_cast<std::size_t>(button)];
      held = !held;
      window_.set_button(button, held);
    } else if (kind < 0.65) {
      double_click();
    } else if (kind < 0.72) {
      window_.turn_wheel(static_cast<float>(random_.between(-5.0, 5.0)));
    } else if (kind < 0.87) {
      window_.press_key({.key = key(),
                         .ctrl = random_.chance(0.2),
                         .shift = random_.chance(0.2),
                         .alt = random_.chance(0.2)});
    } else if (kind < 0.93) {
      window_.type(characters());
    } else if (kind < 0.96) {
      window_.hold_modifiers(random_.chance(0.3), random_.chance(0.3), random_.chance(0.3));
    } else if (kind < 0.98) {
      window_.resize({between(k_least_size.x, k_most_size.x), between(k_least_size.y, k_most_size.y)});
    } else if (kind < 0.99) {
      window_.set_content_scale(static_cast<float>(random_.between(0.5, 4.0)));
    } else if (kind < 0.995) {
      window_.drop(dropped_[random_.below(dropped_.size())]);
    } else {
      window_.settle();
    }
    window_.frame();
    take_picture();
  }

  void let_go() {
    for (int button = 0; button < 3; ++button) window_.set_button(button, false);
    window_.hold_modifiers(false, false, false);
    window_.set_content_scale(1.0F);
    window_.resize(k_usual_size);
    for (int k = 0; k < 3; ++k) {
      window_.press_key({.key = 256});
      window_.frames(2);
    }
  }

 private:
  int between(int low, int high) {
    return low + static_cast<int>(random_.below(static_cast<std::size_t>(high - low)));
  }

  /// Half of the time on a control, else anywhere, a little outside too.
  glm::vec2 place() {
    const auto& controls = window_.app().controls();
    const glm::vec2 share(static_cast<float>(random_.between(-0.02, 1.02)),
                          static_cast<float>(random_.between(-0.02, 1.02)));
    if (controls.empty() || random_.chance(0.5)) return share * glm::vec2(window_.size());
    const auto chosen =
        std::next(controls.begin(), static_cast<std::ptrdiff_t>(random_.below(controls.size())));
    return chosen->second.min + share * (chosen->second.max - chosen->second.min);
  }

  void double_click() {
    for (const bool down : {true, false, true, false}) {
      window_.set_button(0, down);
      window_.frame();
    }
    held_[0] = false;
  }

  int key() {
    if (random_.chance(0.4)) return k_other_keys[random_.below(k_other_keys.size())];
    return random_.chance(0.3) ? between('0', '9' + 1) : between('A', 'Z' + 1);
  }

  /// No slash, so that a path field leads nowhere else.
  std::string characters() {
    static constexpr std::string_view k_characters[] = {"0", "1", "7", ".", ",", "-",     "e",
                                                        "a", " ", "%", "ü", "°", "\u4e2d"};
    std::string text;
    for (std::size_t left = 1 + random_.below(4); left > 0; --left)
      text += k_characters[random_.below(std::size(k_characters))];
    return text;
  }

  void take_picture() {
    if (const auto path = window_.app().take_picture_request())
      write_picture(fs::path(*path).filename().string(), window_.size(), window_.pixels());
  }

  OffscreenWindow& window_;
  Random random_;
  std::vector<std::string> dropped_;
  std::array<bool, 3> held_{};
};

/// What must hold at any time.
void expect_sound(const AppState& state) {
  EXPECT_NEAR(glm::length(state.settings.direction.unit()), 1.0, 1e-9);
  EXPECT_TRUE(std::isfinite(state.camera.height) && state.camera.height > 0.0);
  EXPECT_NEAR(glm::length(state.camera.orientation), 1.0, 1e-6);
  for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(std::isfinite(state.camera.target[axis]));
}

std::size_t resident_kib() {
  std::ifstream lines("/proc/self/status");
  for (std::string word; lines >> word;) {
    std::size_t kib = 0;
    if (word == "VmRSS:" && lines >> kib) return kib;
  }
  return 0;
}

/// The file is copied, since what the window writes goes beside it.
void play_to(const fs::path& original, int events, std::uint32_t seed) {
  SCOPED_TRACE(original.filename().string() + ", seed " + std::to_string(seed));
  const moldlight::test::ScratchFolder folder;
  const WorkingFolder working(folder.path());
  const std::string part = folder.write(original.filename().string(), moldlight::test::file_bytes(original));
  const std::string broken = folder.write("broken.stl", "solid a\nfacet normal 0 0\n");
  OffscreenWindow window(options());
  PartNotes notes;
  notes.settings.method.resolution = 256;
  notes.settings.method.samples = 5'000;
  window.app().set_notes(notes);
  window.app().open(part);
  window.wait_until_loaded();
  RandomInput input(window, seed, {part, broken, folder.file("none.obj"), folder.path().string()});
  for (int k = 0; k < events && !testing::Test::HasFailure(); ++k) {
    SCOPED_TRACE("event " + std::to_string(k));
    input.play();
    expect_sound(window.state());
    if (events > k_few_events && (k + 1) % (events / 4) == 0)
      std::cout << original.filename().string() << ": " << k + 1 << " events, " << resident_kib() / 1024
                << " MiB\n";
  }
  input.let_go();
  window.wait_until_swept();
  window.app().open(part);
  window.wait_until_loaded();
  ASSERT_TRUE(window.state().model);
  EXPECT_EQ(window.state().path, part);
  window.wait_until_measured();
  ASSERT_TRUE(window.state().figures.shown);
  window.settle();
}

struct Played {
  const char* name;
  std::uint32_t seed;
  fs::path (*file)();  // empty: the small part, which is made for the test
};

const Played k_parts[] = {
    {"cup", 1, [] { return fs::path(); }},
    {"cable_clip", 2, [] { return moldlight::test::asset_folder() / "parts" / "cable_clip.stl"; }},
    {"tilted_bracket", 3, [] { return moldlight::test::asset_folder() / "parts" / "tilted_bracket.stl"; }},
    {"pin_and_block", 4, [] { return moldlight::test::data_folder() / "pin_and_block_inch.step"; }},
    {"pins", 5, [] { return moldlight::test::data_folder() / "pins_assembly_mm.step"; }}};

class RandomEvents : public testing::TestWithParam<Played> {};

TEST_P(RandomEvents, LeaveTheWindowSoundAndUsable) {
  const int events = events_a_part();
  const fs::path file = GetParam().file();
  if (events == k_few_events && !file.empty()) GTEST_SKIP() << "plays to this part if asked for more events";
  if (file.extension() == ".step" && !MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built without STEP support";
  const moldlight::test::SmallPart cup;
  play_to(file.empty() ? fs::path(cup.file()) : file, events, GetParam().seed);
}

INSTANTIATE_TEST_SUITE_P(Parts, RandomEvents, testing::ValuesIn(k_parts),
                         [](const auto& part) { return std::string(part.param.name); });

}  // namespace
}  // namespace moldlight::gui::test
