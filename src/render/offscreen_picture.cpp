#include "render/offscreen_picture.hpp"

#include <algorithm>

namespace moldlight {

OffscreenPicture::OffscreenPicture(const gl::Functions& gl, const glm::ivec2& size)
    : gl_(&gl), size_(size), colour_(gl::make_texture_2d(gl, GL_RGBA8, size.x, size.y)) {
  const GLuint name = colour_.name();
  framebuffer_ = gl::make_framebuffer(gl, {.colours = {&name, 1}});
}

Image OffscreenPicture::read() const {
  Image image = empty_image(size_.x, size_.y);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_->ReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  gl::check_errors(*gl_, "reading the picture");
  // GL's rows count from below.
  for (int y = 0; y < size_.y / 2; ++y) {
    std::swap_ranges(image.at(0, y), image.at(0, y) + 4 * size_.x, image.at(0, size_.y - 1 - y));
  }
  return image;
}

}  // namespace moldlight
