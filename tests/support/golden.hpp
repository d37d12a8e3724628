// Golden pictures: what the program drew, against what it drew when somebody looked and was content.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "base/image.hpp"

namespace moldlight::test {

/// How far two pictures are apart.
struct PictureDifference {
  double mean = 0.0;       // over all channels, in steps of 255
  double off_share = 0.0;  // of the pixels that differ by more than 24 steps in a channel
};
[[nodiscard]] PictureDifference picture_difference(const Image& one, const Image& other);

/// Compares with tests/render/golden/<name>.png; where it fails, <name>.actual.png and <name>.difference.png
/// lie in the build folder's pictures/. With MOLDLIGHT_UPDATE_GOLDEN=1 in the environment the golden picture
/// is replaced:
///   MOLDLIGHT_UPDATE_GOLDEN=1 build/dev/bin/test_render --gtest_filter='GoldenPictures*'
[[nodiscard]] testing::AssertionResult matches_golden(const Image& actual, const std::string& name);

/// Leaves a picture in the build folder's pictures/, for somebody to look at.
void keep_picture(const Image& image, const std::string& name);

}  // namespace moldlight::test
