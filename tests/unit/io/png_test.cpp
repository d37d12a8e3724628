// PNG files: what is written is read back, and failures name the file.
#include "io/png.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/read_png.hpp"
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
    const Image back = test::read_png(folder.file("picture.png"));
    EXPECT_EQ(back.width, 37);
    EXPECT_EQ(back.height, 21);
    EXPECT_EQ(back.rgba, image.rgba);
  }
  EXPECT_LT(png_bytes(pattern(37, 21, true)).size(), png_bytes(pattern(37, 21, false)).size());
}

TEST(Png, AFailureNamesTheFile) {
  const test::ScratchFolder folder;
  try {
    write_png(folder.file("no/such/folder.png"), pattern(2, 2, true));
    ADD_FAILURE() << "written into a folder that is not there";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("folder.png"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace moldlight
