#include "render/map_picture.hpp"

namespace moldlight {

MapPicture::MapPicture(const gl::Functions& gl)
    : gl_(&gl),
      program_(gl, {.vertex = "common/fullscreen.vert", .fragment = "view/map_picture.frag"}),
      fullscreen_(gl::make_vertex_array(gl)) {}

void MapPicture::draw(GLuint framebuffer, const glm::ivec2& size, const ShadowMaps& maps, bool plus) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Viewport(0, 0, size.x, size.y);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_SCISSOR_TEST);
  program_.use();
  program_.set_texture("t_depth", 0, GL_TEXTURE_2D, maps.depth(plus));
  program_.set("u_size", glm::vec2(size));
  gl_->BindVertexArray(fullscreen_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl::check_errors(*gl_, "drawing a picture of a shadow map");
}

}  // namespace moldlight
