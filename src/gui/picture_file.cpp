#include "gui/picture_file.hpp"

#include <memory>
#include <vector>

#include <cairo.h>

#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::gui {

void write_picture(const std::string& path, const glm::ivec2& size, std::span<const std::uint8_t> rgba) {
  // Cairo's pixels are words of 0xXXRRGGBB.
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    pixels[k] = static_cast<std::uint32_t>(rgba[4 * k] << 16 | rgba[4 * k + 1] << 8 | rgba[4 * k + 2]);
  }
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_RGB24,
                                          size.x, size.y, size.x * 4),
      cairo_surface_destroy);
  std::string bytes;
  const cairo_status_t status = cairo_surface_write_to_png_stream(
      surface.get(),
      [](void* out, const unsigned char* data, unsigned int length) {
        static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
      },
      &bytes);
  if (status != CAIRO_STATUS_SUCCESS) {
    throw FileError(path, "",
                    std::string("the picture cannot be encoded: ") + cairo_status_to_string(status));
  }
  write_file(path, bytes);
}

}  // namespace moldlight::gui
