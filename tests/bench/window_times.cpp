// How long the window takes from a dropped file to the verdict and to a recommended direction, and its
// longest frames meanwhile, while the steps are entered, the direction is dragged and the mold opens. Of the
// shipped parts, or of those given.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"
#include "replay/offscreen.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::gui {
namespace {

constexpr glm::ivec2 k_window(1440, 900);
constexpr double k_patience_ms = 120'000.0, k_idle_ms = 4.0;

/// Draws frames as the desktop's window does: where one is wanted, or something in the background is done.
class Watched {
 public:
  explicit Watched(std::atomic<bool>& woken) : woken_(woken), window_(options(woken)) {}

  [[nodiscard]] OffscreenWindow& window() { return window_; }
  [[nodiscard]] const AppState& state() const { return window_.state(); }

  void frame() {
    const Stopwatch stopwatch;
    woken_ = false;
    const double now_ms = clock_.elapsed_ms();
    window_.pass_time(1e-3 * (now_ms - std::exchange(time_ms_, now_ms)));
    const double cpu_ms = thread_ms();
    window_.frame_at_once();
    longest_.wall_ms = std::max(longest_.wall_ms, stopwatch.elapsed_ms());
    longest_.thread_ms = std::max(longest_.thread_ms, thread_ms() - cpu_ms);
  }
  void press(const KeyPress& key) {
    window_.press_key(key);
    frame();
  }
  /// Frames until it is so; how long that took, milliseconds.
  template <typename Condition>
  double until(const Condition& condition) {
    const Stopwatch stopwatch;
    while (!condition() && stopwatch.elapsed_ms() < k_patience_ms) {
      const bool wanted = woken_ || window_.app().next_frame_s() <= 1e-3 * clock_.elapsed_ms();
      if (wanted) {
        frame();
      } else {
        std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(k_idle_ms));
      }
    }
    return stopwatch.elapsed_ms();
  }
  void frames_for(double ms) {
    const Stopwatch stopwatch;
    static_cast<void>(until([&] { return stopwatch.elapsed_ms() > ms; }));
  }
  /// The longest frame since the last call, as text: until it is there, and what of that this thread
  /// computes. The software GL draws with threads of its own, which share the cores with what runs in the
  /// background.
  std::string longest() {
    const Longest longest = std::exchange(longest_, {});
    return std::to_string(std::lround(longest.wall_ms)) + " (" +
           std::to_string(std::lround(longest.thread_ms)) + ")";
  }

 private:
  /// Of the processor, by this thread.
  static double thread_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }
  static OffscreenOptions options(std::atomic<bool>& woken) {
    OffscreenOptions options;
    options.size = k_window;
    options.rehearses = true;
    options.wake = [&woken] { woken = true; };
    return options;
  }

  std::atomic<bool>& woken_;
  OffscreenWindow window_;
  Stopwatch clock_;
  double time_ms_ = 0.0;  // of the last frame
  struct Longest {
    double wall_ms = 0.0, thread_ms = 0.0;
  };
  Longest longest_;
};

void show(const std::string& path) {
  std::atomic<bool> woken = false;
  Watched watched(woken);
  OffscreenWindow& window = watched.window();
  static_cast<void>(watched.until([&] { return !window.app().preparing(); }));
  std::printf("start %s; ", watched.longest().c_str());
  window.drop(path);
  watched.frame();
  const AppState& state = watched.state();
  const double verdict_ms = watched.until([&] { return state.verdict && is_settled(state.actions); });
  if (!state.model) {
    std::printf("%s: cannot be read\n", path.c_str());
    return;
  }
  const std::string until_verdict = watched.longest();
  const double best_ms = watched.until([&] { return !state.sweep.running && state.sweep.result; });
  std::printf(
      "%s: %zu facets, verdict %.1f s, recommendation %.1f s; longest frames, ms (of this thread): "
      "verdict %s, recommendation %s",
      std::filesystem::path(path).filename().c_str(), state.model->part.mesh.facets.size(), 1e-3 * verdict_ms,
      1e-3 * (verdict_ms + best_ms), until_verdict.c_str(), watched.longest().c_str());
  for (int step = 1; step <= 7; ++step) {
    watched.press({.key = '0' + step});
    watched.frames_for(600.0);
  }
  std::printf(", steps %s", watched.longest().c_str());
  for (int k = 0; k < 20; ++k) {
    watched.press({.key = k % 2 == 0 ? 262 : 265});  // GLFW's arrow keys
    watched.frames_for(60.0);
  }
  std::printf(", turning %s", watched.longest().c_str());
  static_cast<void>(watched.until([&] { return !window.app().measuring(); }));
  std::printf(", at rest %s", watched.longest().c_str());
  watched.press({.key = 'O'});
  watched.frames_for(6000.0);
  std::printf(", opening %s\n", watched.longest().c_str());
}

}  // namespace
}  // namespace moldlight::gui

int main(int count, char** arguments) {
  std::vector<std::string> parts(arguments + 1, arguments + count);
  if (parts.empty()) {
    for (const auto& entry : std::filesystem::directory_iterator(moldlight::test::asset_folder() / "parts"))
      if (entry.path().extension() == ".stl") parts.push_back(entry.path().string());
  }
  for (const std::string& part : parts) moldlight::gui::show(part);
}
