// Lines in and out of a pipe, for a program that is to end in good order whatever stands at the other end.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace moldlight::serve {

/// A line that is longer than a bound is passed over without room for it.
class LineReader {
 public:
  enum class Got : std::uint8_t { nothing, line, too_long, end };

  LineReader(int descriptor, std::size_t most_bytes) : descriptor_(descriptor), most_bytes_(most_bytes) {}

  /// The next line without its end, also the last one that has none. Waits a tenth of a second at most, and
  /// then has got nothing.
  [[nodiscard]] Got next(std::string& line);

 private:
  /// False where nothing came in time.
  bool read_more();

  int descriptor_;
  std::size_t most_bytes_;
  std::string buffer_;
  std::size_t begin_ = 0;  // of what was not handed out
  bool passing_over_ = false, ended_ = false;
};

/// Safe to use from several threads.
class LineWriter {
 public:
  /// `gives_up` is asked while the other end takes nothing.
  LineWriter(int descriptor, std::function<bool()> gives_up)
      : descriptor_(descriptor), gives_up_(std::move(gives_up)) {}

  /// Writes the line and its end. Does nothing once the pipe is broken.
  void write(std::string line);
  /// Nobody reads, or writing was given up in the midst of a line.
  [[nodiscard]] bool broken() const { return broken_; }
  /// Whether somebody reads still, where that can be known.
  [[nodiscard]] bool is_read() const;

 private:
  int descriptor_;
  std::function<bool()> gives_up_;
  std::mutex mutex_;
  std::atomic<bool> broken_ = false;
};

}  // namespace moldlight::serve
