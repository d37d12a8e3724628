#include "io/png.hpp"

#include <memory>

#include <png.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace moldlight {

namespace {

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return false;
  return true;
}

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
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&png, png_image_free);
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  const void* pixels = opaque ? rgb.data() : image.rgba.data();
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels, 0, nullptr) == 0)
    throw Error(std::string("a picture cannot be encoded as PNG: ") + png.message);
  bytes.resize(size);
  return bytes;
}

Image read_png(const std::string& path) {
  constexpr png_uint_32 k_most_px = 4096;
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&png, png_image_free);
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0) throw FileError(path, "", png.message);
  if (png.width > k_most_px || png.height > k_most_px) throw FileError(path, "", "is too large a picture");
  png.format = PNG_FORMAT_RGBA;
  Image image = empty_image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr) == 0)
    throw FileError(path, "", png.message);
  return image;
}

void write_png(const std::string& path, const Image& image) { write_file(path, png_bytes(image)); }

}  // namespace moldlight
