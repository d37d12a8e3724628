#include "render/view_tools.hpp"

namespace moldlight {

ViewTargets::ViewTargets(const gl::Functions& gl, const glm::ivec2& wanted) : size(wanted) {
  const auto texture = [&](GLenum format) { return gl::make_texture_2d(gl, format, size.x, size.y); };
  surface = texture(GL_RG32UI);
  depth = texture(GL_DEPTH_COMPONENT32F);
  accessible = texture(GL_R8UI);
  openness = texture(GL_R8);
  colour = texture(GL_RGBA8);
  to_surface = gl::make_framebuffer(gl, surface, &depth);
  to_accessible = gl::make_framebuffer(gl, accessible, &depth);
  to_colour = gl::make_framebuffer(gl, colour, &depth);
  const GLuint shaded[] = {colour.name(), accessible.name()};
  to_shaded = gl::make_framebuffer(gl, {.colours = shaded, .depth = depth.name()});
  to_openness = gl::make_framebuffer(gl, openness);
}

void ViewTargets::make(const gl::Functions& gl, GLenum format, gl::Texture& texture,
                       gl::Framebuffer& framebuffer) const {
  if (texture) return;
  texture = gl::make_texture_2d(gl, format, size.x, size.y);
  framebuffer = gl::make_framebuffer(gl, texture);
}

void ViewTargets::make_footprint(const gl::Functions& gl, int side) {
  if (footprint) return;
  footprint = gl::make_texture_2d(gl, GL_R8, side, side);
  to_footprint = gl::make_framebuffer(gl, footprint);
}

void ViewTargets::keep_first(const gl::Functions& gl) {
  if (!first_surface) {
    first_surface = gl::make_texture_2d(gl, GL_RG32UI, size.x, size.y);
    first_depth = gl::make_texture_2d(gl, GL_DEPTH_COMPONENT32F, size.x, size.y);
    first_accessible = gl::make_texture_2d(gl, GL_R8UI, size.x, size.y);
    to_first_surface = gl::make_framebuffer(gl, first_surface, &first_depth);
    to_first_accessible = gl::make_framebuffer(gl, first_accessible);
  }
  const auto copy = [&](const gl::Framebuffer& from, const gl::Framebuffer& to, GLbitfield what) {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.name());
    gl.BlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, what, GL_NEAREST);
  };
  copy(to_surface, to_first_surface, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  copy(to_accessible, to_first_accessible, GL_COLOR_BUFFER_BIT);
}

}  // namespace moldlight
