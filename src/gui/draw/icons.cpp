// Icons drawn as strokes: a row each.
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "gui/draw/ui.hpp"

namespace moldlight::gui {

namespace {

enum class Shape : std::uint8_t { line, loop, circle, dot, arc };

/// In a square from -1 to 1, y down. What is round has its centre and its radius as points, an arc its ends,
/// too: degrees clockwise from the right.
struct IconStroke {
  Icon icon;
  Shape shape;
  std::vector<glm::vec2> points;
};

const std::vector<IconStroke>& strokes() {
  using enum Icon;
  using enum Shape;
  static const std::vector<IconStroke> k_strokes = {
      {open,
       loop,
       {{-0.8F, 0.65F}, {-0.8F, -0.6F}, {-0.25F, -0.6F}, {-0.05F, -0.35F}, {0.8F, -0.35F}, {0.8F, 0.65F}}},
      {file, loop, {{-0.55F, 0.8F}, {-0.55F, -0.8F}, {0.15F, -0.8F}, {0.55F, -0.4F}, {0.55F, 0.8F}}},
      {file, line, {{0.12F, -0.76F}, {0.12F, -0.36F}, {0.52F, -0.36F}}},
      {ruler, loop, {{-0.85F, 0.35F}, {0.35F, -0.85F}, {0.85F, -0.35F}, {-0.35F, 0.85F}}},
      {ruler, line, {{-0.3F - 0.25F, 0.3F - 0.25F}, {-0.3F - 0.02F, 0.3F - 0.02F}}},
      {ruler, line, {{-0.25F, -0.25F}, {-0.02F, -0.02F}}},
      {ruler, line, {{0.3F - 0.25F, -0.3F - 0.25F}, {0.3F - 0.02F, -0.3F - 0.02F}}},
      {undo, line, {{-0.35F, -0.75F}, {-0.75F, -0.35F}, {-0.35F, 0.05F}}},
      {undo, line, {{-0.75F, -0.35F}, {0.25F, -0.35F}}},
      {undo, arc, {{0.25F, 0.15F}, {0.5F, 0}, {-90, 90}}},
      {undo, line, {{0.25F, 0.65F}, {-0.35F, 0.65F}}},
      {redo, line, {{0.35F, -0.75F}, {0.75F, -0.35F}, {0.35F, 0.05F}}},
      {redo, line, {{0.75F, -0.35F}, {-0.25F, -0.35F}}},
      {redo, arc, {{-0.25F, 0.15F}, {0.5F, 0}, {90, 270}}},
      {redo, line, {{-0.25F, 0.65F}, {0.35F, 0.65F}}},
      {help, arc, {{0, -0.35F}, {0.42F, 0}, {170, 405}}},
      {help, line, {{0.3F, -0.05F}, {0.0F, 0.2F}, {0.0F, 0.36F}}},
      {help, dot, {{0, 0.72F}, {0.13F, 0}}},
      {settings, circle, {{0, 0}, {0.30F, 0}}},
      {settings, circle, {{0, 0}, {0.62F, 0}}},
      {flip, line, {{-0.4F, 0.8F}, {-0.4F, -0.75F}}},
      {flip, line, {{-0.72F, -0.4F}, {-0.4F, -0.75F}, {-0.08F, -0.4F}}},
      {flip, line, {{0.4F, -0.8F}, {0.4F, 0.75F}}},
      {flip, line, {{0.08F, 0.4F}, {0.4F, 0.75F}, {0.72F, 0.4F}}},
      {bookmark, loop, {{-0.5F, -0.8F}, {0.5F, -0.8F}, {0.5F, 0.8F}, {0, 0.35F}, {-0.5F, 0.8F}}},
      {chevron_down, line, {{-0.55F, -0.25F}, {0, 0.3F}, {0.55F, -0.25F}}},
      {chevron_up, line, {{-0.55F, 0.3F}, {0, -0.25F}, {0.55F, 0.3F}}},
      {chevron_left, line, {{0.25F, -0.55F}, {-0.3F, 0}, {0.25F, 0.55F}}},
      {chevron_right, line, {{-0.25F, -0.55F}, {0.3F, 0}, {-0.25F, 0.55F}}},
      {close, line, {{-0.55F, -0.55F}, {0.55F, 0.55F}}},
      {close, line, {{-0.55F, 0.55F}, {0.55F, -0.55F}}},
      {check, line, {{-0.65F, 0.05F}, {-0.2F, 0.5F}, {0.65F, -0.5F}}},
      {alert, loop, {{0, -0.75F}, {0.85F, 0.7F}, {-0.85F, 0.7F}}},
      {alert, line, {{0, -0.2F}, {0, 0.2F}}},
      {alert, dot, {{0, 0.45F}, {0.1F, 0}}},
      {up, line, {{0, 0.75F}, {0, -0.7F}}},
      {up, line, {{-0.5F, -0.2F}, {0, -0.7F}, {0.5F, -0.2F}}},
      {revisions, loop, {{-0.85F, -0.6F}, {-0.15F, -0.6F}, {-0.15F, 0.6F}, {-0.85F, 0.6F}}},
      {revisions, loop, {{0.15F, -0.6F}, {0.85F, -0.6F}, {0.85F, 0.6F}, {0.15F, 0.6F}}},
      {revisions, dot, {{0.5F, 0.0F}, {0.2F, 0}}},
      {exchange, line, {{-0.8F, -0.35F}, {0.75F, -0.35F}}},
      {exchange, line, {{0.4F, -0.7F}, {0.75F, -0.35F}, {0.4F, 0.0F}}},
      {exchange, line, {{0.8F, 0.4F}, {-0.75F, 0.4F}}},
      {exchange, line, {{-0.4F, 0.05F}, {-0.75F, 0.4F}, {-0.4F, 0.75F}}},
      {eye, loop, {{-0.85F, 0}, {-0.4F, -0.42F}, {0.4F, -0.42F}, {0.85F, 0}, {0.4F, 0.42F}, {-0.4F, 0.42F}}},
      {eye, dot, {{0, 0}, {0.24F, 0}}},
      {sphere, circle, {{0, 0}, {0.8F, 0}}},
      {sphere, line, {{-0.8F, 0}, {-0.55F, 0.19F}, {-0.2F, 0.27F}, {0.2F, 0.27F}, {0.55F, 0.19F}, {0.8F, 0}}},
  };
  return k_strokes;
}

/// The teeth of the gear.
void draw_teeth(ImDrawList& list, const glm::vec2& centre, float half, ImU32 colour, float width) {
  for (int tooth = 0; tooth < 8; ++tooth) {
    const float angle = static_cast<float>(tooth) * glm::pi<float>() / 4.0F;
    const glm::vec2 out(std::cos(angle), std::sin(angle));
    list.PathLineTo(centre + out * 0.62F * half);
    list.PathLineTo(centre + out * 0.86F * half);
    list.PathStroke(colour, ImDrawFlags_None, width);
  }
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, const glm::vec2& centre, float size, ImU32 colour) {
  if (icon == Icon::folder) icon = Icon::open;
  const float half = 0.5F * size, width = std::max(1.0F, size * 0.085F), rad = glm::pi<float>() / 180.0F;
  for (const IconStroke& stroke : strokes()) {
    if (stroke.icon != icon) continue;
    const auto at = [&](std::size_t k) { return centre + stroke.points[k] * half; };
    const auto& points = stroke.points;
    if (stroke.shape == Shape::circle) {
      list.AddCircle(at(0), points[1].x * half, colour, 0, width);
    } else if (stroke.shape == Shape::dot) {
      list.AddCircleFilled(at(0), points[1].x * half, colour);
    } else if (stroke.shape == Shape::arc) {
      list.PathArcTo(at(0), points[1].x * half, points[2].x * rad, points[2].y * rad, 24);
      list.PathStroke(colour, ImDrawFlags_None, width);
    } else {
      for (std::size_t k = 0; k < points.size(); ++k) list.PathLineTo(at(k));
      list.PathStroke(colour, stroke.shape == Shape::loop ? ImDrawFlags_Closed : ImDrawFlags_None, width);
    }
  }
  if (icon == Icon::settings) draw_teeth(list, centre, half, colour, width);
}

}  // namespace moldlight::gui
