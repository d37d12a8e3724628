// Colours of a GIF's picture by median cut (Heckbert 1982); what has not changed since the picture before is
// transparent, so that a scene at rest costs next to nothing.
#include "io/film.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace moldlight {

namespace {

// Of a GIF.
constexpr std::size_t k_colours = 255;
constexpr std::uint8_t k_unchanged = 255;  // the colour that is transparent
constexpr unsigned k_least_code_bits = 8, k_most_code_bits = 12;
constexpr unsigned k_clear = 1U << k_least_code_bits, k_end = k_clear + 1;
constexpr int k_steps_bits = 5;  // of a channel, by which colours are told apart

void append_word(std::string& bytes, unsigned value) {
  bytes.push_back(static_cast<char>(value & 0xFFU));
  bytes.push_back(static_cast<char>(value >> 8U & 0xFFU));
}

/// Codes of growing width, in blocks of at most 255 bytes.
class CodeWriter {
 public:
  explicit CodeWriter(std::string& bytes) : bytes_(bytes) {}

  void write(unsigned code, unsigned bits) {
    held_ |= code << held_bits_;
    for (held_bits_ += bits; held_bits_ >= 8; held_bits_ -= 8, held_ >>= 8U)
      block_.push_back(static_cast<char>(held_ & 0xFFU));
    if (block_.size() >= k_block) flush(k_block);
  }
  void finish() {
    if (held_bits_ > 0) block_.push_back(static_cast<char>(held_ & 0xFFU));
    while (!block_.empty()) flush(std::min(block_.size(), k_block));
    bytes_.push_back('\0');
  }

 private:
  static constexpr std::size_t k_block = 255;
  void flush(std::size_t size) {
    bytes_.push_back(static_cast<char>(size));
    bytes_.append(block_, 0, size);
    block_.erase(0, size);
  }

  std::string& bytes_;
  std::string block_;
  unsigned held_ = 0, held_bits_ = 0;
};

/// Welch's compression (1984) as GIF has it.
void append_codes(std::string& bytes, const std::vector<std::uint8_t>& indices) {
  bytes.push_back(static_cast<char>(k_least_code_bits));
  CodeWriter writer(bytes);
  // Of a known string and one more index: the code of both. A code has up to 256 followers.
  std::vector<std::uint16_t> next(std::size_t{1} << (k_most_code_bits + 8), 0);
  unsigned bits = k_least_code_bits + 1, free_code = k_end + 1;
  writer.write(k_clear, bits);
  unsigned known = indices.front();
  for (std::size_t k = 1; k < indices.size(); ++k) {
    const std::size_t both = known << 8U | indices[k];
    if (next[both] != 0) {
      known = next[both];
      continue;
    }
    writer.write(known, bits);
    if (free_code < 1U << k_most_code_bits) {
      next[both] = static_cast<std::uint16_t>(free_code++);
      if (free_code > 1U << bits && bits < k_most_code_bits) ++bits;
    } else {
      writer.write(k_clear, bits);
      std::ranges::fill(next, std::uint16_t{0});
      bits = k_least_code_bits + 1;
      free_code = k_end + 1;
    }
    known = indices[k];
  }
  writer.write(known, bits);
  writer.write(k_end, bits);
  writer.finish();
}

using Rgb = std::array<std::uint8_t, 3>;

unsigned step_of(const std::uint8_t* pixel) {
  unsigned step = 0;
  for (int c = 0; c < 3; ++c) step = step << k_steps_bits | pixel[c] >> (8 - k_steps_bits);
  return step;
}

/// A colour of the picture, as a mean of what falls into a step of each channel.
struct Tint {
  unsigned step = 0;
  std::array<double, 3> sum{};
  double count = 0.0;
  [[nodiscard]] double channel(std::size_t c) const { return sum[c] / count; }
};

/// The colours, and which of them stands for each step.
struct Colours {
  std::vector<Rgb> table;
  std::vector<std::uint8_t> of_step;
};

Colours colours_of(const Image& picture) {
  std::vector<Tint> steps(std::size_t{1} << (3 * k_steps_bits));
  for (std::size_t k = 0; k < picture.rgba.size(); k += 4) {
    Tint& tint = steps[step_of(&picture.rgba[k])];
    for (std::size_t c = 0; c < 3; ++c) tint.sum[c] += picture.rgba[k + c];
    tint.count += 1.0;
  }
  std::vector<Tint> tints;
  for (unsigned step = 0; step < steps.size(); ++step) {
    if (steps[step].count == 0.0) continue;
    steps[step].step = step;
    tints.push_back(steps[step]);
  }
  struct Box {
    std::size_t from, to, along = 0;
    double spread = 0.0;
  };
  const auto measured = [&](std::size_t from, std::size_t to) {
    Box box{from, to};
    for (std::size_t c = 0; c < 3; ++c) {
      double low = 255.0, high = 0.0, weight = 0.0;
      for (std::size_t k = from; k < to; ++k) {
        low = std::min(low, tints[k].channel(c));
        high = std::max(high, tints[k].channel(c));
        weight += tints[k].count;
      }
      const double spread = (high - low) * std::sqrt(std::sqrt(weight));
      if (spread > box.spread) box.along = c;
      box.spread = std::max(box.spread, spread);
    }
    return box;
  };
  std::vector<Box> boxes = {measured(0, tints.size())};
  while (boxes.size() < k_colours) {
    const auto widest = std::ranges::max_element(boxes, {}, &Box::spread);
    if (!(widest->spread > 0.0)) break;
    const Box box = *widest;
    const auto at = [&](std::size_t k) { return tints.begin() + static_cast<std::ptrdiff_t>(k); };
    const std::size_t middle = (box.from + box.to) / 2;
    std::nth_element(at(box.from), at(middle), at(box.to), [&](const Tint& a, const Tint& b) {
      return std::pair(a.channel(box.along), a.step) < std::pair(b.channel(box.along), b.step);
    });
    *widest = measured(box.from, middle);
    boxes.push_back(measured(middle, box.to));
  }
  Colours colours{.table = {}, .of_step = std::vector<std::uint8_t>(steps.size(), 0)};
  for (const Box& box : boxes) {
    std::array<double, 3> sum{};
    double count = 0.0;
    for (std::size_t k = box.from; k < box.to; ++k) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += tints[k].sum[c];
      count += tints[k].count;
      colours.of_step[tints[k].step] = static_cast<std::uint8_t>(colours.table.size());
    }
    Rgb mean{};
    for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>(std::lround(sum[c] / count));
    colours.table.push_back(mean);
  }
  return colours;
}

class GifFilm final : public Film {
 public:
  GifFilm(const std::string& path, const FilmSettings& settings) : file_(path), settings_(settings) {
    std::string head = "GIF89a";
    append_word(head, static_cast<unsigned>(settings.size.x));
    append_word(head, static_cast<unsigned>(settings.size.y));
    head += std::string("\x70\x00\x00", 3);                                  // colours come with each picture
    head += std::string("\x21\xFF\x0BNETSCAPE2.0\x03\x01\x00\x00\x00", 19);  // without end
    file_.write(head);
  }

  void add(const Image& picture) override {
    CHECK(picture.width == settings_.size.x && picture.height == settings_.size.y);
    const Colours colours = colours_of(picture);
    std::vector<std::uint8_t> indices;
    indices.reserve(picture.rgba.size() / 4);
    const bool first = shown_.empty();
    if (first) shown_.resize(picture.rgba.size() / 4);
    for (std::size_t k = 0; k < picture.rgba.size(); k += 4) {
      const std::uint8_t index = colours.of_step[step_of(&picture.rgba[k])];
      Rgb& before = shown_[k / 4];
      const bool same = !first && is_like(before, &picture.rgba[k]);
      indices.push_back(same ? k_unchanged : index);
      if (!same) before = {picture.rgba[k], picture.rgba[k + 1], picture.rgba[k + 2]};
    }
    std::string bytes("\x21\xF9\x04\x05", 4);  // stays, with a transparent colour
    // Hundredths of a second do not divide by every rate: the sum stays right.
    const int until = static_cast<int>(std::lround(100.0 * ++count_ / settings_.rate));
    append_word(bytes, static_cast<unsigned>(until - std::exchange(until_, until)));
    bytes.push_back(static_cast<char>(k_unchanged));
    bytes += std::string("\x00\x2C\x00\x00\x00\x00", 6);
    append_word(bytes, static_cast<unsigned>(settings_.size.x));
    append_word(bytes, static_cast<unsigned>(settings_.size.y));
    bytes.push_back('\x87');  // 256 colours of its own
    for (std::size_t k = 0; k <= k_colours; ++k)
      for (std::size_t c = 0; c < 3; ++c)
        bytes.push_back(k < colours.table.size() ? static_cast<char>(colours.table[k][c]) : '\0');
    append_codes(bytes, indices);
    file_.write(bytes);
  }

  void finish() override {
    file_.write(";");
    file_.commit();
  }

 private:
  /// To noise.
  static bool is_like(const Rgb& shown, const std::uint8_t* pixel) {
    constexpr int k_near = 2;
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(int{shown[c]} - int{pixel[c]}) > k_near) return false;
    return true;
  }

  AtomicFile file_;
  FilmSettings settings_;
  std::vector<Rgb> shown_;     // as they were given
  int count_ = 0, until_ = 0;  // until_: hundredths of a second
};

/// Pictures go to ffmpeg as they are, through a socket: one that it closes is an error, not a signal.
class Mp4Film final : public Film {
 public:
  Mp4Film(const std::string& path, const FilmSettings& settings)
      : path_(path), temporary_(temporary_path(std::filesystem::path(path).parent_path().string()) + ".mp4") {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail(std::strerror(errno));
    const std::string size = fmt::format("{}x{}", settings.size.x, settings.size.y);
    const std::string rate = std::to_string(settings.rate);
    std::vector<std::string> words = {
        "ffmpeg",      "-y",       "-loglevel",     "error",
        "-f",          "rawvideo", "-pixel_format", "rgba",
        "-video_size", size,       "-framerate",    rate,
        "-i",          "-",        "-vf",           "crop=trunc(iw/2)*2:trunc(ih/2)*2",
        "-pix_fmt",    "yuv420p",  "-movflags",     "+faststart",
        temporary_};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const int error = ::posix_spawnp(&child_, "ffmpeg", &actions, nullptr, arguments.data(), ::environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    to_ = ends[0];
    if (error != 0) {
      child_ = 0;
      ::close(to_);
      fail("ffmpeg does not start; choose a GIF");
    }
  }
  ~Mp4Film() override {
    if (child_ != 0) static_cast<void>(ended());
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
  }
  Mp4Film(const Mp4Film&) = delete;
  Mp4Film& operator=(const Mp4Film&) = delete;

  void add(const Image& picture) override {
    for (std::size_t sent = 0; sent < picture.rgba.size() && !broken_;) {
      const auto count = ::send(to_, &picture.rgba[sent], picture.rgba.size() - sent, MSG_NOSIGNAL);
      if (count > 0)
        sent += static_cast<std::size_t>(count);
      else
        broken_ = errno != EINTR;
    }
  }

  void finish() override {
    if (!ended() || broken_) fail("ffmpeg cannot make it; choose a GIF");
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    if (error) fail(error.message());
  }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw FileError(path_, "", why); }
  /// Whether it has done what it was to do.
  bool ended() {
    ::close(to_);
    int status = 0;
    const bool waited = ::waitpid(std::exchange(child_, 0), &status, 0) > 0;
    return waited && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  std::string path_, temporary_;
  pid_t child_ = 0;
  int to_ = -1;
  bool broken_ = false;
};

}  // namespace

bool has_ffmpeg() {
  const char* const path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::size_t end = folders.find(':');
    const std::string program = std::string(folders.substr(0, end)) + "/ffmpeg";
    if (::access(program.c_str(), X_OK) == 0) return true;
    folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);
  }
  return false;
}

std::unique_ptr<Film> begin_film(const std::string& path, const FilmSettings& settings) {
  if (path.ends_with(".mp4")) return std::make_unique<Mp4Film>(path, settings);
  return std::make_unique<GifFilm>(path, settings);
}

}  // namespace moldlight
