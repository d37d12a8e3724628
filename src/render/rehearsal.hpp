// Pictures that nobody sees, in all the looks that a window has. A GL that draws on the processor makes a
// program's code when something is first drawn by it, and a card's driver does some of that, too: up to 0.1 s
// each, which would be missed in the first frames of a part, of a section and of an opened mold.
#pragma once

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>

#include "render/part_view.hpp"

namespace moldlight {

/// A small cube, drawn in one look after the other: each asks for little that those before it did not.
/// Needs its context current at every call.
class Rehearsal {
 public:
  explicit Rehearsal(const gl::Functions& gl);

  /// Draws the next look into the lower left corner of a framebuffer of at least 64 pixels a side, of the
  /// kind that pictures go to. Returns true while there are others.
  bool draw_next(GLuint framebuffer);

 private:
  struct Cube;
  Rehearsal(const gl::Functions& gl, const Cube& cube);
  /// Each of the looks, as what becomes different.
  using Change = void (*)(Rehearsal& rehearsal, const Cube& cube);
  static const std::array<Change, 22> k_changes;

  const gl::Functions& gl_;
  PartBuffers part_;
  PartView view_;
  ShadowMaps maps_;
  std::optional<SplitSurface> split_;
  View look_;
  glm::dmat4 in_place_{1.0};  // of a body
  std::size_t next_ = 0;
};

}  // namespace moldlight
