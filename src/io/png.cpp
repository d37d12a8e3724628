#include "io/png.hpp"

#include <algorithm>

#include <png.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace moldlight {

namespace {

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

/// A png_image, whose memory libpng gives back.
struct PngImage {
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  png_image image{};
};

}  // namespace

std::string png_bytes(const Image& image) {
  CHECK(image.width > 0 && image.height > 0);
  const bool opaque = is_opaque(image);
  std::vector<std::uint8_t> rgb;
  if (opaque) {
    rgb.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      rgb.insert(rgb.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                 image.rgba.begin() + static_cast<std::ptrdiff_t>(i + 3));
    }
  }
  PngImage png;
  png.image.width = static_cast<png_uint_32>(image.width);
  png.image.height = static_cast<png_uint_32>(image.height);
  png.image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const void* pixels = opaque ? rgb.data() : image.rgba.data();
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png.image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png.image, bytes.data(), &size, 0, pixels, 0, nullptr) == 0) {
    throw Error(std::string("a picture cannot be encoded as PNG: ") + png.image.message);
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::string& path, const Image& image) { write_file(path, png_bytes(image)); }

Image read_png(const std::string& path) {
  PngImage png;
  if (png_image_begin_read_from_file(&png.image, path.c_str()) == 0) {
    throw FileError(path, "", std::string("is no PNG that can be read: ") + png.image.message);
  }
  png.image.format = PNG_FORMAT_RGBA;
  Image image = empty_image(static_cast<int>(png.image.width), static_cast<int>(png.image.height));
  if (png_image_finish_read(&png.image, nullptr, image.rgba.data(), 0, nullptr) == 0) {
    throw FileError(path, "", std::string("is a damaged PNG: ") + png.image.message);
  }
  return image;
}

}  // namespace moldlight
