// Output of the program: results on stdout and nothing else there; progress, log and warnings on stderr.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/shown_text.hpp"

namespace moldlight::cli {

enum class Verbosity : std::uint8_t { quiet, normal, verbose };

/// Safe to use from several threads.
class Console {
 public:
  Console();
  ~Console();

  void set_verbosity(Verbosity verbosity) { verbosity_ = verbosity; }

  /// Results to stdout, at once; throws Error where it cannot be written.
  void result(std::string_view text);
  /// One line; not when quiet.
  void warning(std::string_view sentence);
  /// One line; only when verbose.
  void log(std::string_view line);
  /// One line that says why the program fails; always.
  void failure(std::string_view sentence);
  /// What is being done: a line that is redrawn on a terminal, one log line a stage elsewhere.
  void progress(std::string_view stage, double fraction);
  /// What a line of progress says, for a terminal of so many columns; 0 elsewhere.
  using ProgressText = std::function<std::string(std::string_view stage, double fraction, int columns)>;
  /// From now on progress() says this, also where stderr is no terminal: there a line every so many seconds
  /// at most, for work that takes long. Called from whichever thread reports.
  void set_progress_text(ProgressText text, std::chrono::seconds plain_interval = std::chrono::seconds(2));

  /// One line with the stages that progress() was given, each with its time; only when verbose.
  void log_stages();

  /// stdout is a terminal and NO_COLOR is not set.
  [[nodiscard]] bool colour() const { return colour_; }

 private:
  void line(std::string_view text);
  void plain_progress(std::string_view stage, double fraction);
  void clear_progress();
  void count_stage(std::string_view stage);

  struct Stage {
    std::string name;
    std::chrono::duration<double> took{0.0};
  };

  std::mutex mutex_;
  Verbosity verbosity_ = Verbosity::normal;
  bool colour_ = false;
  bool terminal_ = false;  // stderr
  bool progress_shown_ = false;
  std::string stage_;
  std::vector<Stage> stages_;  // in the order in which they began
  std::size_t counted_ = 0;    // the one that goes on since `counted_from_`
  std::chrono::steady_clock::time_point counted_from_;
  ProgressText progress_text_;
  std::chrono::seconds plain_interval_{0};  // between lines where nothing can be redrawn
  std::chrono::steady_clock::time_point drawn_;
};

/// Why the work failed, in one sentence.
[[nodiscard]] std::string failure_text(const std::exception& error);

/// A terminal with fewer columns has no room for a bar.
inline constexpr int k_least_columns_for_bar = 70;

/// "45 s", "12 min", "3.5 h"
[[nodiscard]] inline std::string time_text(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

/// A bar for a share in [0, 1].
[[nodiscard]] inline std::string bar(double share) {
  constexpr std::size_t k_cells = 24;
  const auto full = static_cast<std::size_t>(share * static_cast<double>(k_cells));
  std::string cells;
  for (std::size_t i = 0; i < k_cells; ++i) cells += i < full ? "█" : "░";
  return cells;
}

}  // namespace moldlight::cli
