// Films are read again by a decoder of the test's own; ffmpeg is a program that the test puts in its place.
#include "io/film.hpp"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

using moldlight::test::file_bytes;

/// What a viewer would show of a GIF, one picture after the other, with their times in hundredths of a
/// second.
struct ShownFilm {
  glm::ivec2 size{0};
  std::vector<std::vector<std::uint8_t>> pictures;  // three bytes a pixel
  std::vector<int> times;
};

class GifReader {
 public:
  explicit GifReader(std::string bytes) : bytes_(std::move(bytes)) {}

  ShownFilm read() {
    ShownFilm film;
    EXPECT_EQ(bytes_.substr(0, 6), "GIF89a");
    at_ = 6;
    film.size = {word(), word()};
    at_ = 13;
    std::vector<std::uint8_t> shown(static_cast<std::size_t>(3 * film.size.x * film.size.y));
    int transparent = -1;
    for (;;) {
      const int mark = byte();
      if (mark == ';') break;
      if (mark == '!') {
        if (byte() == 0xF9) {
          EXPECT_EQ(byte(), 4);
          const int flags = byte();
          film.times.push_back(word());
          transparent = (flags & 1) != 0 ? byte() : (byte(), -1);
        }
        while (const int size = byte()) at_ += static_cast<std::size_t>(size);
        continue;
      }
      EXPECT_EQ(mark, ',');
      at_ += 8;
      EXPECT_EQ(byte(), 0x87);
      const std::size_t colours = at_;
      at_ += 768;
      const std::vector<int> indices = decoded(film.size.x * film.size.y);
      for (std::size_t k = 0; k < indices.size(); ++k)
        for (std::size_t c = 0; c < 3 && indices[k] != transparent; ++c)
          shown[3 * k + c] =
              static_cast<std::uint8_t>(bytes_[colours + 3 * static_cast<std::size_t>(indices[k]) + c]);
      film.pictures.push_back(shown);
    }
    EXPECT_EQ(at_, bytes_.size());
    return film;
  }

 private:
  int byte() { return static_cast<std::uint8_t>(bytes_.at(at_++)); }
  int word() {
    const int low = byte();
    return low + 256 * byte();
  }
  std::vector<int> decoded(int count) {
    const int least = byte();
    std::vector<int> bits;
    while (const int size = byte())
      for (int k = 0; k < size; ++k)
        for (int value = byte(), bit = 0; bit < 8; ++bit) bits.push_back(value >> bit & 1);
    std::vector<std::vector<int>> strings;
    const auto clear = [&] {
      strings.assign((std::size_t{1} << least) + 2, {});
      for (int k = 0; k < 1 << least; ++k) strings[static_cast<std::size_t>(k)] = {k};
    };
    clear();
    std::vector<int> indices, former;
    for (std::size_t at = 0;;) {
      int width = least + 1;
      while (width < 12 && strings.size() + (former.empty() ? 0 : 1) > std::size_t{1} << width) ++width;
      int code = 0;
      for (int k = 0; k < width; ++k) code |= bits.at(at++) << k;
      if (code == (1 << least) + 1) break;
      if (code == 1 << least) {
        clear();
        former.clear();
        continue;
      }
      std::vector<int> found;
      if (static_cast<std::size_t>(code) < strings.size()) {
        found = strings[static_cast<std::size_t>(code)];
      } else {
        found = former;
        found.push_back(former.at(0));
      }
      indices.insert(indices.end(), found.begin(), found.end());
      if (!former.empty() && strings.size() < 4096) {
        former.push_back(found.front());
        strings.push_back(former);
      }
      former = std::move(found);
    }
    EXPECT_EQ(indices.size(), static_cast<std::size_t>(count));
    return indices;
  }

  std::string bytes_;
  std::size_t at_ = 0;
};

/// Many colours, a square of one colour that moves.
Image film_picture(int width, int height, int number) {
  Image image = empty_image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = image.at(x, y);
      pixel[0] = static_cast<std::uint8_t>(x * 255 / width);
      pixel[1] = static_cast<std::uint8_t>(y * 255 / height);
      pixel[2] = static_cast<std::uint8_t>((x * 7 + y * 3) % 64);
      if (x / 20 == number && y > 20 && y < 60) pixel[0] = 250, pixel[1] = pixel[2] = 20;
      pixel[3] = 255;
    }
  return image;
}

TEST(Films, ShowEachPictureInItsTime) {
  const moldlight::test::ScratchFolder folder;
  const std::string path = folder.file("film.gif");
  constexpr int k_width = 210, k_height = 130;
  const auto film = begin_film(path, {.size = {k_width, k_height}, .rate = 12});
  for (int k = 0; k < 5; ++k) film->add(film_picture(k_width, k_height, k));
  EXPECT_FALSE(std::filesystem::exists(path)) << "not before it is whole";
  film->finish();
  const ShownFilm shown = GifReader(file_bytes(path)).read();
  EXPECT_EQ(shown.size, glm::ivec2(k_width, k_height));
  EXPECT_EQ(shown.times, (std::vector<int>{8, 9, 8, 8, 9})) << "12 a second";
  ASSERT_EQ(shown.pictures.size(), 5U);
  for (int number = 0; number < 5; ++number) {
    const Image wanted = film_picture(k_width, k_height, number);
    double off = 0.0;
    int most = 0;
    for (std::size_t k = 0; k < wanted.rgba.size(); k += 4)
      for (std::size_t c = 0; c < 3; ++c) {
        const int each = std::abs(int{wanted.rgba[k + c]} -
                                  int{shown.pictures[static_cast<std::size_t>(number)][k / 4 * 3 + c]});
        off += each;
        most = std::max(most, each);
      }
    EXPECT_LT(off / (0.75 * static_cast<double>(wanted.rgba.size())), 8.0) << number;
    EXPECT_LT(most, 60) << number;
  }
}

TEST(Films, AtRestCostLittle) {
  const moldlight::test::ScratchFolder folder;
  const auto size_of = [&](int pictures) {
    const std::string path = folder.file("rest.gif");
    const auto film = begin_film(path, {.size = {200, 120}, .rate = 10});
    Image flat = empty_image(200, 120);
    for (std::size_t k = 0; k < flat.rgba.size(); ++k)
      flat.rgba[k] = k % 4 == 3 ? 255 : static_cast<std::uint8_t>(k / 4 % 200 / 2 + 100);
    for (int k = 0; k < pictures; ++k) film->add(flat);
    film->finish();
    return std::filesystem::file_size(path);
  };
  const auto one = size_of(1), ten = size_of(10);
  EXPECT_LT(ten - one, 9 * 1200U) << "their colours, and next to nothing else";
}

/// Puts a program of this text before all others, by the name of ffmpeg.
class InPlaceOfFfmpeg : public ::testing::Test {
 protected:
  void put(const std::string& text) {
    const std::string program = folder.write("ffmpeg", "#!/bin/sh\n" + text);
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const char* const path = std::getenv("PATH");
    before = path != nullptr ? path : "";
    ::setenv("PATH", (std::filesystem::path(program).parent_path().string() + ":" + before).c_str(), 1);
  }
  void TearDown() override {
    if (!before.empty()) ::setenv("PATH", before.c_str(), 1);
  }
  moldlight::test::ScratchFolder folder;
  std::string before;
};

TEST_F(InPlaceOfFfmpeg, PicturesGoThereAsTheyAre) {
  // Its last word is the file; what it is asked for goes beside it.
  put("echo \"$@\" > " + folder.file("asked") + "\nfor last; do :; done\ncat > \"$last\"\n");
  EXPECT_TRUE(has_ffmpeg());
  const std::string path = folder.file("film.mp4");
  const auto film = begin_film(path, {.size = {40, 30}, .rate = 15});
  std::string sent;
  for (int k = 0; k < 3; ++k) {
    const Image picture = film_picture(40, 30, k);
    sent.append(picture.rgba.begin(), picture.rgba.end());
    film->add(picture);
  }
  film->finish();
  EXPECT_EQ(file_bytes(path), sent);
  const std::string asked = file_bytes(folder.file("asked"));
  EXPECT_NE(asked.find("-video_size 40x30 -framerate 15"), std::string::npos) << asked;
}

TEST_F(InPlaceOfFfmpeg, OneThatFailsLeavesNothing) {
  put("exit 3\n");
  const std::string path = folder.file("film.mp4");
  const auto film = begin_film(path, {.size = {640, 480}, .rate = 15});
  for (int k = 0; k < 3; ++k) film->add(film_picture(640, 480, k));
  EXPECT_THROW(film->finish(), FileError);
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("")))
    EXPECT_EQ(entry.path().extension(), "") << entry.path();
}

}  // namespace
}  // namespace moldlight
