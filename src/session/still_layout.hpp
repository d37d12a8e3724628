// Where legend and part stand in a still picture.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "picture/legend.hpp"
#include "render/camera.hpp"
#include "render/part_view.hpp"

namespace moldlight {

struct StillLayout {
  double scale = 1.0;         // of text, lines and hatches
  std::optional<Box> legend;  // none where there is no content or no room for it
};
/// `content` may be null.
[[nodiscard]] StillLayout still_layout(const glm::ivec2& size, const LegendContent* content);

/// What a picture must find room for. Points are in the unit frame.
struct Composition {
  glm::ivec2 size{0};
  std::optional<Box> legend;
  std::span<const glm::vec3> extremes;  // the part's outermost points
  std::span<const glm::vec3> beyond;    // points off the part that are to be seen too
};
/// The camera moved and zoomed so that the part is as large as it can be without running into the legend.
/// Draws small pictures with `view` to find out.
[[nodiscard]] Camera composed(const gl::Functions& gl, PartView& view, const PartBuffers& part,
                              const Camera& camera, const Composition& composition);

}  // namespace moldlight
