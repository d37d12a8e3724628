// The heat map of undercut area on the direction ball: colours, colour bar, marks of the best, what the mouse
// reads.
#pragma once

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// A ball on the screen, pixels.
struct BallPlace {
  glm::vec2 centre{0.0F};
  float radius = 1.0F;
};

/// The ball's surface in the colours of the map; where nothing is known yet in the colours of `bare`, which
/// are those of the lit and the dark side.
struct BareBall {
  ImU32 light = 0, dark = 0;
};
void draw_direction_map(ImDrawList& list, const BallPlace& ball, const Camera& camera, const SweepMap& map,
                        const BareBall& bare);
/// Rings around the best directions, dots on those that tie with them, circles of the tilt margins.
void draw_sweep_marks(const Ui& ui, ImDrawList& list, const BallPlace& ball, const Camera& camera,
                      const SweepState& sweep);
/// A tooltip with what is known of the direction under the mouse.
void tell_direction(const PanelContext& context, const glm::dvec3& direction);
/// The scale of the colours with its ends, `width` pixels wide; returns its height.
float draw_colour_bar(const PanelContext& context, const glm::vec2& at, float width);

/// The ball on its own, large, beside the part.
void draw_large_ball(const PanelContext& context, BallDrag& drag);

}  // namespace moldlight::gui
