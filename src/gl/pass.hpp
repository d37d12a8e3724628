// The GL's state as a value: everything that a draw depends on besides its program, textures and corners.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "gl/program.hpp"

namespace moldlight::gl {

/// How a fragment's depth must compare to what is there.
/// There is no test for what is further away: a card's driver was seen to pass wrong fragments by it.
enum class DepthTest : std::uint8_t { off, less, equal, unequal, always };
/// Triangles that are left out, counter-clockwise ones being fronts.
enum class Cull : std::uint8_t { none, back, front };
/// What becomes of the colour that is there: replaced; covered as far as the new one is opaque, where the sum
/// is as opaque as both together or stays as opaque as it was; added to; the greater of both, a channel each.
/// `under`: only where nothing or little has been drawn, straight alpha.
enum class Blend : std::uint8_t { replace, over, over_keeping_alpha, under, add, greatest };

/// Where a pass draws and how; what it does not name is as it is here, whatever was drawn before.
struct Pass {
  GLuint framebuffer = 0;  // 0: the window's own
  glm::ivec2 size{0};      // pixels, from `corner` on
  glm::ivec2 corner{0};    // lower left one
  DepthTest depth = DepthTest::off;
  bool writes_depth = false;  // takes a depth test
  bool writes_colour = true;
  Cull cull = Cull::none;
  Blend blend = Blend::replace;
  bool clipped = false;  // by gl_ClipDistance[0]
};

/// What follows is drawn so. A pass that writes depths may be cleared as well as drawn to.
void begin(const Functions& gl, const Pass& pass);
/// Clears a pass to what is furthest: numbers to 0 and depths to the far plane.
void clear_numbers(const Functions& gl);

/// Corners without attributes, which shaders know by gl_VertexID.
class NumberedCorners {
 public:
  explicit NumberedCorners(const Functions& gl) : gl_(&gl), none_(make_vertex_array(gl)) {}
  /// Triangles of so many corners; three make the one that covers the viewport.
  void draw(int count = 3) const;

 private:
  const Functions* gl_;
  VertexArray none_;
};

/// What passes are drawn with. Valid for one context.
struct Tools {
  explicit Tools(const Functions& functions)
      : gl(functions), held(Programs::of(functions)), programs(*held), corners(functions) {}

  const Functions& gl;
  std::shared_ptr<Programs> held;
  Programs& programs;
  NumberedCorners corners;
};

}  // namespace moldlight::gl
