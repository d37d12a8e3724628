// PNG files: what is written is read back, and failures name the file.
#include "io/png.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

Image pattern(int width, int height, bool opaque) {
  Image image = empty_image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* pixel = image.at(x, y);
      pixel[0] = static_cast<std::uint8_t>(7 * x);
      pixel[1] = static_cast<std::uint8_t>(5 * y);
      pixel[2] = static_cast<std::uint8_t>(x * y);
      pixel[3] = opaque ? 255 : static_cast<std::uint8_t>(200 - x);
    }
  }
  return image;
}

TEST(Png, PicturesComeBackAsTheyWere) {
  const test::ScratchFolder folder;
  for (const bool opaque : {true, false}) {
    const Image image = pattern(37, 21, opaque);
    write_png(folder.file("picture.png"), image);
    const Image back = read_png(folder.file("picture.png"));
    EXPECT_EQ(back.width, 37);
    EXPECT_EQ(back.height, 21);
    EXPECT_EQ(back.rgba, image.rgba);
  }
  EXPECT_LT(png_bytes(pattern(37, 21, true)).size(), png_bytes(pattern(37, 21, false)).size());
}

TEST(Png, FailuresNameTheFile) {
  const test::ScratchFolder folder;
  EXPECT_THROW(write_png(folder.file("no/such/folder.png"), pattern(2, 2, true)), FileError);
  EXPECT_THROW(static_cast<void>(read_png(folder.file("absent.png"))), FileError);
  const std::string whole = png_bytes(pattern(64, 64, false));
  try {
    static_cast<void>(read_png(folder.write("half.png", whole.substr(0, whole.size() / 2))));
    ADD_FAILURE() << "half a picture was read";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("half.png"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace moldlight
