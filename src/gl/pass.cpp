#include "gl/pass.hpp"

namespace moldlight::gl {

void begin(const Functions& gl, const Pass& pass) {
  const auto enable = [&gl](GLenum what, bool on) { on ? gl.Enable(what) : gl.Disable(what); };
  gl.BindFramebuffer(GL_FRAMEBUFFER, pass.framebuffer);
  gl.Viewport(pass.corner.x, pass.corner.y, pass.size.x, pass.size.y);
  gl.Disable(GL_SCISSOR_TEST);

  constexpr GLenum k_depth[] = {GL_ALWAYS, GL_LESS, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS};
  enable(GL_DEPTH_TEST, pass.depth != DepthTest::off);
  gl.DepthFunc(k_depth[static_cast<int>(pass.depth)]);
  gl.DepthMask(pass.writes_depth ? GL_TRUE : GL_FALSE);
  const GLboolean colour = pass.writes_colour ? GL_TRUE : GL_FALSE;
  gl.ColorMask(colour, colour, colour, colour);

  enable(GL_CULL_FACE, pass.cull != Cull::none);
  gl.CullFace(pass.cull == Cull::front ? GL_FRONT : GL_BACK);
  enable(GL_CLIP_DISTANCE0, pass.clipped);

  struct Factors {
    GLenum colour, colour_there, alpha, alpha_there;
  };
  constexpr Factors k_blend[] = {{GL_ONE, GL_ZERO, GL_ONE, GL_ZERO},
                                 {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA},
                                 {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE},
                                 {GL_ONE_MINUS_DST_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_ONE},
                                 {GL_ONE, GL_ONE, GL_ONE, GL_ONE},
                                 {GL_ONE, GL_ONE, GL_ONE, GL_ONE}};
  const Factors& factors = k_blend[static_cast<int>(pass.blend)];
  enable(GL_BLEND, pass.blend != Blend::replace);
  gl.BlendEquation(pass.blend == Blend::greatest ? GL_MAX : GL_FUNC_ADD);
  gl.BlendFuncSeparate(factors.colour, factors.colour_there, factors.alpha, factors.alpha_there);
}

void clear_numbers(const Functions& gl) {
  constexpr GLuint k_none[4] = {0, 0, 0, 0};
  constexpr GLfloat k_furthest = 1.0F;
  gl.ClearBufferuiv(GL_COLOR, 0, k_none);
  gl.ClearBufferfv(GL_DEPTH, 0, &k_furthest);
}

void NumberedCorners::draw(int count) const {
  gl_->BindVertexArray(none_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, count);
}

}  // namespace moldlight::gl
