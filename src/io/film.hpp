// Films of pictures: a GIF (CompuServe 89a), or an MP4 where ffmpeg is installed.
#pragma once

#include <memory>
#include <string>

#include <glm/vec2.hpp>

#include "base/image.hpp"

namespace moldlight {

/// Whether an MP4 can be made: ffmpeg is among the user's programs.
[[nodiscard]] bool has_ffmpeg();

/// Takes one picture after the other; the file is there, whole, once finish() has returned, or as it was.
class Film {
 public:
  virtual ~Film() = default;
  /// Of the film's size; what is transparent is taken as black.
  virtual void add(const Image& picture) = 0;
  /// Call once, last. Throws FileError.
  virtual void finish() = 0;

 protected:
  Film() = default;
  Film(const Film&) = default;
  Film& operator=(const Film&) = default;
};

struct FilmSettings {
  glm::ivec2 size{0};  // pixels, up to 65,535 each
  int rate = 12;       // pictures a second, [1, 50]
};

/// An MP4 where the path ends in ".mp4", else a GIF that is shown again and again. Throws FileError where
/// there is no ffmpeg for an MP4.
[[nodiscard]] std::unique_ptr<Film> begin_film(const std::string& path, const FilmSettings& settings);

}  // namespace moldlight
