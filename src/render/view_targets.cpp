#include "render/view_targets.hpp"

namespace moldlight {

ViewTargets::ViewTargets(const gl::Functions& gl, const glm::ivec2& wanted) : size(wanted) {
  const auto texture = [&](GLenum format) { return gl::make_texture_2d(gl, format, size.x, size.y); };
  const auto framebuffer = [&](const gl::Texture& target, const gl::Texture* depth_target) {
    const GLuint name = target.name();
    return gl::make_framebuffer(
        gl, {.colours = {&name, 1}, .depth = depth_target != nullptr ? depth_target->name() : 0});
  };
  surface = texture(GL_RG32UI);
  depth = texture(GL_DEPTH_COMPONENT32F);
  accessible = texture(GL_R8UI);
  openness = texture(GL_R8);
  colour = texture(GL_RGBA8);
  to_surface = framebuffer(surface, &depth);
  to_accessible = framebuffer(accessible, &depth);
  to_colour = framebuffer(colour, &depth);
  const GLuint shaded[] = {colour.name(), accessible.name()};
  to_shaded = gl::make_framebuffer(gl, {.colours = shaded, .depth = depth.name()});
  to_depth = gl::make_framebuffer(gl, {.colours = {}, .depth = depth.name()});
  to_openness = framebuffer(openness, nullptr);
}

void ViewTargets::make_sum(const gl::Functions& gl) {
  if (sum) return;
  sum = gl::make_texture_2d(gl, GL_RGBA32F, size.x, size.y);
  const GLuint name = sum.name();
  to_sum = gl::make_framebuffer(gl, {.colours = {&name, 1}});
}

}  // namespace moldlight
