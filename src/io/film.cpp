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
#include <gif_lib.h>
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
constexpr int k_steps_bits = 5;            // of a channel, by which colours are distinguished

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

/// A file of giflib's, which is closed with it.
using GifFile = std::unique_ptr<GifFileType, void (*)(GifFileType*)>;
using GifColours = std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)>;

class GifFilm final : public Film {
 public:
  GifFilm(const std::string& path, const FilmSettings& settings)
      : file_(path),
        settings_(settings),
        gif_(nullptr, [](GifFileType* gif) { EGifCloseFile(gif, nullptr); }) {
    gif_.reset(EGifOpen(
        &bytes_,
        [](GifFileType* gif, const GifByteType* bytes, int size) {
          static_cast<std::string*>(gif->UserData)
              ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
          return size;
        },
        nullptr));
    CHECK(gif_ != nullptr);
    EGifSetGifVersion(gif_.get(), true);
    put(EGifPutScreenDesc(gif_.get(), settings.size.x, settings.size.y, 8, 0, nullptr));
    put(EGifPutExtensionLeader(gif_.get(), APPLICATION_EXT_FUNC_CODE));
    put(EGifPutExtensionBlock(gif_.get(), 11, "NETSCAPE2.0"));
    put(EGifPutExtensionBlock(gif_.get(), 3, "\x01\x00\x00"));  // without end
    put(EGifPutExtensionTrailer(gif_.get()));
  }

  void add(const Image& picture) override {
    CHECK(picture.width == settings_.size.x && picture.height == settings_.size.y);
    const Colours colours = colours_of(picture);
    std::vector<GifByteType> indices;
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
    // Hundredths of a second do not divide by every rate: the sum stays right.
    const int until = static_cast<int>(std::lround(100.0 * ++count_ / settings_.rate));
    const GraphicsControlBlock control = {.DisposalMode = DISPOSE_DO_NOT,
                                          .UserInputFlag = false,
                                          .DelayTime = until - std::exchange(until_, until),
                                          .TransparentColor = k_unchanged};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    put(EGifPutExtension(gif_.get(), GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()), bytes.data()));
    const GifColours map(GifMakeMapObject(k_unchanged + 1, nullptr), GifFreeMapObject);
    CHECK(map != nullptr);
    for (std::size_t k = 0; k < colours.table.size(); ++k)
      map->Colors[k] = {colours.table[k][0], colours.table[k][1], colours.table[k][2]};
    put(EGifPutImageDesc(gif_.get(), 0, 0, settings_.size.x, settings_.size.y, false, map.get()));
    put(EGifPutLine(gif_.get(), indices.data(), static_cast<int>(indices.size())));
    file_.write(std::exchange(bytes_, {}));
  }

  void finish() override {
    gif_.reset();  // which writes its end
    file_.write(bytes_);
    file_.commit();
  }

 private:
  /// It writes to memory.
  static void put(int result) { CHECK(result == GIF_OK); }

  /// To noise.
  static bool is_like(const Rgb& shown, const std::uint8_t* pixel) {
    constexpr int k_near = 2;
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(int{shown[c]} - int{pixel[c]}) > k_near) return false;
    return true;
  }

  AtomicFile file_;
  FilmSettings settings_;
  std::string bytes_;  // not yet in the file
  GifFile gif_;
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
