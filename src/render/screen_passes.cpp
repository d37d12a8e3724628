#include "render/screen_passes.hpp"

#include "render/view_colours.hpp"

namespace moldlight {

ScreenPass::ScreenPass(const gl::Functions& gl, const gl::ProgramSources& sources)
    : gl_(&gl), program_(gl, sources), corners_(gl) {}

const gl::Program& ScreenPass::begin(GLuint framebuffer, const glm::ivec2& size) const {
  gl::begin(*gl_, {.framebuffer = framebuffer, .size = size});
  program_.use();
  program_.set("u_size", glm::vec2(size));
  return program_;
}

void ScreenPass::finish() const {
  corners_.draw();
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
  const gl::Program& program = begin(framebuffer, size);
  program.set_texture("t_depths", 0, GL_TEXTURE_2D_ARRAY, maps.depths());
  program.set("u_layer", plus ? 0 : 1);
  finish();
}

}  // namespace moldlight
