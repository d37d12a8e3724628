#include "support/golden.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "io/png.hpp"
#include "support/read_png.hpp"

namespace moldlight::test {

namespace fs = std::filesystem;

namespace {

// What another version of the driver's compiler may change: roundings, and a pixel here and there at an edge.
constexpr double k_mean_bound = 0.5, k_off_bound = 0.004;
constexpr int k_off_steps = 24;

Image difference_image(const Image& one, const Image& other) {
  Image image = one;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    const int apart = std::abs(int{one.rgba[i]} - int{other.rgba[i]});
    image.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(std::min(255, 4 * apart));
  }
  return image;
}

}  // namespace

PictureDifference picture_difference(const Image& one, const Image& other) {
  PictureDifference result;
  for (std::size_t pixel = 0; pixel < one.rgba.size(); pixel += 4) {
    int worst = 0;
    for (std::size_t i = pixel; i < pixel + 4; ++i) {
      const int apart = std::abs(int{one.rgba[i]} - int{other.rgba[i]});
      worst = std::max(worst, apart);
      result.mean += apart;
    }
    result.off_share += worst > k_off_steps ? 4.0 : 0.0;
  }
  const double channels = static_cast<double>(std::max<std::size_t>(1, one.rgba.size()));
  result.mean /= channels;
  result.off_share /= channels;
  return result;
}

void keep_picture(const Image& image, const std::string& name) {
  const fs::path folder = MOLDLIGHT_PICTURE_FOLDER;
  fs::create_directories(folder);
  write_png((folder / (name + ".png")).string(), image);
}

testing::AssertionResult matches_golden(const Image& actual, const std::string& name) {
  const fs::path golden = fs::path(MOLDLIGHT_GOLDEN_FOLDER) / (name + ".png");
  if (std::getenv("MOLDLIGHT_UPDATE_GOLDEN") != nullptr) {
    write_png(golden.string(), actual);
    return testing::AssertionSuccess() << "written: " << golden;
  }
  const fs::path folder = MOLDLIGHT_PICTURE_FOLDER;
  fs::create_directories(folder);
  const std::string left = (folder / (name + ".actual.png")).string();
  if (!fs::exists(golden)) {
    write_png(left, actual);
    return testing::AssertionFailure() << "there is no " << golden << "; the picture is " << left;
  }
  const Image wanted = read_png(golden.string());
  if (wanted.width != actual.width || wanted.height != actual.height) {
    write_png(left, actual);
    return testing::AssertionFailure() << "another size than " << golden << "; the picture is " << left;
  }
  const PictureDifference apart = picture_difference(actual, wanted);
  if (apart.mean <= k_mean_bound && apart.off_share <= k_off_bound) return testing::AssertionSuccess();
  write_png(left, actual);
  const std::string difference = (folder / (name + ".difference.png")).string();
  write_png(difference, difference_image(actual, wanted));
  return testing::AssertionFailure() << "differs from " << golden << " by " << apart.mean
                                     << " steps in the mean, and much at " << 100.0 * apart.off_share
                                     << " % of the pixels; see " << left << " and " << difference;
}

}  // namespace moldlight::test
