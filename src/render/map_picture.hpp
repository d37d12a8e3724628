// A shadow map as a picture: near facets light, far ones dark; for thumbnails.
#pragma once

#include <glm/vec2.hpp>

#include "gl/program.hpp"
#include "render/shadow_maps.hpp"

namespace moldlight {

/// Needs its context current.
class MapPicture {
 public:
  explicit MapPicture(const gl::Functions& gl);

  /// Draws the map of one side over the whole of a framebuffer of `size` pixels; texels without a facet get
  /// alpha 0.
  void draw(GLuint framebuffer, const glm::ivec2& size, const ShadowMaps& maps, bool plus) const;

 private:
  const gl::Functions* gl_;
  gl::Program program_;
  gl::VertexArray fullscreen_;
};

}  // namespace moldlight
