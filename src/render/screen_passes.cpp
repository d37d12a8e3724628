#include "render/screen_passes.hpp"

#include "render/view_colours.hpp"

namespace moldlight {

ScreenPass::ScreenPass(const gl::Functions& gl, const gl::ProgramSources& sources)
    : gl_(&gl), program_(gl, sources), fullscreen_(gl::make_vertex_array(gl)) {}

const gl::Program& ScreenPass::begin(GLuint framebuffer, const glm::ivec2& size) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(0, 0, size.x, size.y);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_SCISSOR_TEST);
  program_.use();
  program_.set("u_size", glm::vec2(size));
  return program_;
}

void ScreenPass::finish() const {
  gl_->BindVertexArray(fullscreen_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl::check_errors(*gl_, "drawing over a framebuffer");
}

BackdropPass::BackdropPass(const gl::Functions& gl)
    : ScreenPass(gl, {.vertex = "common/at_infinity.vert", .fragment = "view/background.frag"}) {}

void BackdropPass::draw(GLuint framebuffer, const glm::ivec2& size, Theme theme) const {
  const BackdropColours colours = backdrop_colours(theme);
  const gl::Program& program = begin(framebuffer, size);
  program.set("u_above", screen_value(colours.above));
  program.set("u_below", screen_value(colours.below));
  program.set("u_sample", 0);
  finish();
}

MapPicture::MapPicture(const gl::Functions& gl)
    : ScreenPass(gl, {.vertex = "common/fullscreen.vert", .fragment = "view/map_picture.frag"}) {}

void MapPicture::draw(GLuint framebuffer, const glm::ivec2& size, const ShadowMaps& maps, bool plus) const {
  begin(framebuffer, size).set_texture("t_depth", 0, GL_TEXTURE_2D, maps.depth(plus));
  finish();
}

}  // namespace moldlight
