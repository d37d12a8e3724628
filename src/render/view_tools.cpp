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

void ViewTargets::make_sum(const gl::Functions& gl) {
  if (sum) return;
  sum = gl::make_texture_2d(gl, GL_RGBA32F, size.x, size.y);
  to_sum = gl::make_framebuffer(gl, sum);
}

void ViewTargets::make_winding(const gl::Functions& gl) {
  if (winding) return;
  winding = gl::make_texture_2d(gl, GL_R16F, size.x, size.y);
  to_winding = gl::make_framebuffer(gl, winding);
}

}  // namespace moldlight
