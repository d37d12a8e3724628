#include "render/backdrop_pass.hpp"

#include "render/view_colours.hpp"

namespace moldlight {

BackdropPass::BackdropPass(const gl::Functions& gl)
    : gl_(&gl),
      program_(gl, {.vertex = "common/at_infinity.vert", .fragment = "view/background.frag"}),
      fullscreen_(gl::make_vertex_array(gl)) {}

void BackdropPass::draw(GLuint framebuffer, const glm::ivec2& size, Theme theme) const {
  const BackdropColours colours = backdrop_colours(theme);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(0, 0, size.x, size.y);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_SCISSOR_TEST);
  program_.use();
  program_.set("u_above", screen_value(colours.above));
  program_.set("u_below", screen_value(colours.below));
  program_.set("u_size", glm::vec2(size));
  program_.set("u_sample", 0);
  gl_->BindVertexArray(fullscreen_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace moldlight
