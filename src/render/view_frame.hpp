// Input of the passes of a picture: one sample of it, and one of its layers.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gl/program.hpp"
#include "render/camera.hpp"
#include "render/view_mesh.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

/// Which surface is drawn, one layer over the other: a picture that looks through all but the undercuts has
/// two, one that looks through a mold's steel another one for it.
enum class Layer : std::uint8_t { undercuts_alone, whole, steel };

/// All that a picture depends on but for its marks.
struct ViewInputs {
  Camera camera;
  ViewSettings settings;
  glm::dvec3 direction{0, 0, 1};      // parting direction, unit
  std::uint64_t maps = 0, split = 0;  // revisions; 0: none

  bool operator==(const ViewInputs&) const = default;
};

/// A copy of the surface that the mold's opening moves, and the accessibility bits it is made of.
struct Piece {
  glm::vec3 shift{0.0F};
  std::uint32_t regions = 0;  // bit k: accessibility bits k
};

/// One sample of a picture. The subject has what the settings ask for and no more.
struct ViewFrame : ViewInputs {
  ViewFrame(const ViewInputs& inputs, const ViewSubject& subject, const glm::ivec2& size, int sample);

  /// Each sets the uniforms of the shader file of that name (or of the eye's axes, of a section's plane).
  void set_sight(const gl::Program& program) const;
  void set_eye_axes(const gl::Program& program) const;
  void set_eye_depth(const gl::Program& program) const;
  void set_section(const gl::Program& program) const;

  [[nodiscard]] bool opened() const { return settings.open_mold > 0.0; }
  /// True if the surface is drawn in pieces(), each of its own regions.
  [[nodiscard]] bool by_region() const { return opened() || layer == Layer::undercuts_alone; }
  [[nodiscard]] std::vector<Piece> pieces() const;
  /// True if the layer has the mold's steel around the part.
  [[nodiscard]] bool with_steel() const {
    return settings.steel.shown && (settings.steel.clear ? layer == Layer::steel : layer == Layer::whole);
  }
  /// By which a body of the mold has moved, unit frame.
  [[nodiscard]] glm::vec3 steel_shift(const SteelMotion& motion) const {
    return glm::vec3(motion.shift(settings.steel, direction));
  }
  /// True if the split surface's own regions are shown.
  [[nodiscard]] bool exact() const;
  /// The define that the maps' look-ups want; may be empty.
  [[nodiscard]] std::string_view kernel_define() const;

  ViewSubject subject;
  glm::ivec2 size;
  int sample;           // 0, 1, …
  glm::dvec2 shift_px;  // of the picture, y down; that of sample 0 is zero
  glm::dmat4 eye_from_unit, clip_from_eye;
  glm::mat4 clip_from_unit;
  Layer layer = Layer::whole;
};

}  // namespace moldlight
