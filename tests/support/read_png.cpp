#include "support/read_png.hpp"

#include <memory>
#include <stdexcept>

#include <png.h>

namespace moldlight::test {

Image read_png(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&png, png_image_free);
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0) throw std::runtime_error(path);
  png.format = PNG_FORMAT_RGBA;
  Image image = empty_image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0)
    throw std::runtime_error(path);
  return image;
}

}  // namespace moldlight::test
