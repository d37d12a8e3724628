// From the window's settings to those of the picture, and where the camera goes.
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "gui/app_state.hpp"
#include "gui/scene.hpp"
#include "render/view_geometry.hpp"

namespace moldlight::gui {

/// A mold that is open all the way: the halves have moved by this much of the part's diagonal each.
inline constexpr double k_mold_travel = 0.5;

/// The arrow along `toward` (unit), as the picture draws it beside the part's outermost points.
[[nodiscard]] PartingArrow parting_arrow_of(std::span<const glm::vec3> extremes, const glm::dvec3& toward,
                                            double open_mold);

/// `pixel_scale`: pixels per layout unit.
[[nodiscard]] ViewSettings view_settings(const LookSettings& look, const MethodSettings& method, Theme theme,
                                         const Extent& extent, double open_mold, double pixel_scale);

/// The part of the window that panels leave free, pixels.
struct FreeArea {
  glm::ivec2 window{0};
  glm::ivec2 min{0}, max{0};

  bool operator==(const FreeArea&) const = default;
};
/// The camera with its orientation and projection, so that the part fills the free area; opened halves
/// included.
[[nodiscard]] Camera fitted_to(const Camera& camera, std::span<const glm::vec3> extremes,
                               const glm::dvec3& direction, double open_mold, const FreeArea& area);

}  // namespace moldlight::gui
