#include "gl/picture_texture.hpp"

#include <algorithm>
#include <vector>

namespace moldlight::gl {

Texture picture_texture(const Functions& gl, const Image& image) {
  Texture texture = make_texture_2d(gl, GL_RGBA8, image.width, image.height);
  const auto row = static_cast<std::ptrdiff_t>(4 * image.width);
  std::vector<std::uint8_t> below(image.rgba.size());
  for (std::ptrdiff_t y = 0; y < image.height; ++y)
    std::copy_n(image.rgba.begin() + (image.height - 1 - y) * row, row, below.begin() + y * row);
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                   below.data());
  return texture;
}

}  // namespace moldlight::gl
