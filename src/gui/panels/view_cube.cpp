// The view cube: shows how the part is turned, and turns it to the side that is clicked.
#include <array>
#include <cmath>
#include <string>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_least_facing = 0.25;  // of a face whose name is read

struct Side {
  std::string_view name;
  StandardView view;
  glm::dvec3 normal, right, up;  // as its name is read
};

const std::array<Side, 6> k_sides = {{
    {"FRONT", StandardView::front, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    {"BACK", StandardView::back, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
    {"LEFT", StandardView::left, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
    {"RIGHT", StandardView::right, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {"TOP", StandardView::top, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
    {"BOTTOM", StandardView::bottom, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
}};

/// Where a side lies on the screen: a parallelogram.
struct Face {
  glm::vec2 centre{0.0F}, right{0.0F}, up{0.0F};  // pixels; half edges
  float half = 1.0F;                              // of an edge that is seen straight on
  double facing = 0.0;

  [[nodiscard]] std::array<glm::vec2, 4> corners() const {
    return {centre - right - up, centre + right - up, centre + right + up, centre - right + up};
  }
  [[nodiscard]] bool contains(const glm::vec2& point) const {
    const float area = right.x * up.y - right.y * up.x;
    if (std::abs(area) < 1.0F) return false;
    const glm::vec2 from = point - centre;
    const float u = (from.x * up.y - from.y * up.x) / area, v = (right.x * from.y - right.y * from.x) / area;
    return std::abs(u) <= 1.0F && std::abs(v) <= 1.0F;
  }
};

Face face_of(const Side& side, const Camera& camera, const glm::vec2& centre, float half) {
  const auto screen = [&](const glm::dvec3& v) {
    const glm::dvec3 seen = glm::conjugate(camera.orientation) * v;
    return glm::vec2(seen.x, -seen.y) * half;
  };
  return {centre + screen(side.normal), screen(side.right), screen(side.up), half,
          (glm::conjugate(camera.orientation) * side.normal).z};
}

/// Text that lies on the face: drawn flat, then its vertices are moved onto the parallelogram.
void draw_name(ImDrawList& list, const Lettering& lettering, const Face& face, std::string_view name) {
  const int first = list.VtxBuffer.Size;
  const glm::vec2 size = text_size(lettering.font, name);
  // Drawn in place, as what lies outside the window is left out.
  const glm::vec2 corner = face.centre - 0.5F * size;
  list.AddText(lettering.font.font, lettering.font.size, corner, lettering.colour, name.data(),
               name.data() + name.size());
  glm::vec2 low = face.centre, high = face.centre;
  for (int k = first; k < list.VtxBuffer.Size; ++k) {
    const glm::vec2 flat = (glm::vec2(list.VtxBuffer[k].pos) - face.centre) / face.half;
    const glm::vec2 at = face.centre + flat.x * face.right - flat.y * face.up;
    list.VtxBuffer[k].pos = at;
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  note_text(list, lettering.colour, {low, high}, name);
}

}  // namespace

void draw_view_cube(const PanelContext& context) {
  const Ui& ui = context.ui;
  const FreeArea area = context.free_area();
  const float size = ui.px(84), half = ui.px(22);
  // Below the titles of the panels that two revisions fold up.
  const bool folded = context.state.revisions.seen() && area.max.x == area.window.x;
  const float below = folded                                 ? 2.0F * (k_title_height + 8.0F)
                      : context.state.sweep_choices.compared ? k_comparison_height
                                                             : 0.0F;
  const glm::vec2 corner(static_cast<float>(area.max.x) - size - ui.px(8), ui.px(k_bar_height + 8 + below));
  ImGui::SetNextWindowPos(corner);
  ImGui::SetNextWindowSize(ImVec2(size, size));
  ImGui::Begin("View cube", nullptr,
               k_fixed_window | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus);
  put_cursor(corner);
  const bool clicked = ImGui::InvisibleButton("cube", ImVec2(size, size));
  const bool hovered = ImGui::IsItemHovered();
  const glm::vec2 mouse = mouse_at(), centre = corner + glm::vec2(0.5F * size);
  ImDrawList& list = window_list();
  const bool dark = context.state.window.theme == Theme::dark;
  for (const Side& side : k_sides) {
    const Face face = face_of(side, context.state.camera, centre, half);
    if (face.facing <= 0.01) continue;
    const bool under_mouse = hovered && face.contains(mouse);
    const auto corners = face.corners();
    const ImU32 lit =
        dark ? mixed(IM_COL32(54, 58, 64, 250), IM_COL32(84, 89, 96, 250), static_cast<float>(face.facing))
             : mixed(IM_COL32(190, 195, 200, 240), IM_COL32(252, 252, 253, 240),
                     static_cast<float>(face.facing));
    list.AddQuadFilled(corners[0], corners[1], corners[2], corners[3],
                       under_mouse ? ui.colours->accent : lit);
    list.AddQuad(corners[0], corners[1], corners[2], corners[3], IM_COL32(0, 0, 0, 60), 1.0F);
    if (face.facing > k_least_facing) {
      draw_name(list, {ui.fonts.small, under_mouse ? ui.colours->on_accent : ui.colours->text}, face,
                side.name);
    }
    glm::vec2 low = corners[0], high = corners[0];
    for (const glm::vec2& each : corners) {
      low = glm::min(low, each);
      high = glm::max(high, each);
    }
    ui.memory->controls[std::string(side.name)] = {low, high};
    const bool pressed = face.facing > k_least_facing && has_keyboard(ui, side.name, {low, high}) &&
                         ui.memory->keyboard.takes(ControlKey::press);
    if (pressed || (under_mouse && clicked))
      context.edits.ask(&Commands::look_from, standard_orientation(side.view));
  }
  ImGui::End();
}

}  // namespace moldlight::gui
