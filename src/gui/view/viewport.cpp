#include "gui/view/viewport.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "gui/draw/widgets.hpp"
#include "gui/view/direction.hpp"
#include "gui/view/mold_view.hpp"
#include "gui/view/side_actions.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_tip_reach = 12.0F;    // layout units around a tip in which it is grabbed
constexpr float k_names_apart = 40.0F;  // layout units between tips whose names do not cover each other
constexpr float k_line_reach = 6.0F;    // layout units around the parting line in which a loop is chosen
constexpr float k_click_reach = 3.0F;   // pixels; a mouse that moves further drags
constexpr double k_least_way = 0.15;    // of a length that is seen askew, to drag along it
constexpr double k_height_lever = 0.1;  // unit frame: along which the parting height is dragged
constexpr double k_turn_per_unit_rad = 0.0085;  // of a drag, by layout units
constexpr double k_zoom_per_notch = 1.15, k_zoom_per_unit = 1.006;

/// As in the programs that people come from.
Gesture middle_gesture(NavigationPreset preset, const ImGuiIO& io) {
  switch (preset) {
    case NavigationPreset::solidworks:
      return io.KeyCtrl ? Gesture::pan : io.KeyShift ? Gesture::zoom : Gesture::orbit;
    case NavigationPreset::fusion:
      return io.KeyShift ? Gesture::orbit : io.KeyCtrl ? Gesture::zoom : Gesture::pan;
    case NavigationPreset::blender:
      return io.KeyShift ? Gesture::pan : io.KeyCtrl ? Gesture::zoom : Gesture::orbit;
    case NavigationPreset::standard:
      break;
  }
  return Gesture::pan;
}

/// `button` is ImGui's.
Gesture gesture_of(NavigationPreset preset, int button, const ImGuiIO& io) {
  if (button == ImGuiMouseButton_Middle) return middle_gesture(preset, io);
  if (button == ImGuiMouseButton_Right)
    return preset == NavigationPreset::standard ? Gesture::pan : Gesture::none;
  // A laptop without a middle button can still turn the part, whatever the preset.
  return io.KeyShift ? Gesture::pan : Gesture::orbit;
}

/// The arrow's name beyond its tip, where the arrow itself does not run.
void draw_name(const Ui& ui, const ArrowOnScreen& arrow, std::string_view name, ImU32 colour) {
  const glm::vec2 room = 0.5F * tag_size(ui, name);
  glm::vec2 middle = beyond_tip(ui, arrow.tail, arrow.tip, name);
  if (middle.y - room.y < ui.px(k_bar_height)) middle = arrow.tip + glm::vec2(ui.px(14) + room.x, 0.0F);
  draw_whole_tag(ui, middle, name, colour);
}

/// How far along the arrow the mouse has gone since it was pressed, in lengths of the scene; nothing where
/// the arrow is not seen. Where it runs towards the eye, up is out.
std::optional<double> way_along(const Camera& camera, const glm::ivec2& size, const ViewArrow& arrow) {
  const auto tail = project(camera, size, arrow.tail), tip = project(camera, size, arrow.tip);
  if (!tail || !tip) return std::nullopt;
  // Pixels by which a way of a unit is seen.
  glm::dvec2 unit = (*tip - *tail) / glm::distance(arrow.tip, arrow.tail);
  const double pixels = 1.0 / pixel_length(camera, size);
  if (glm::length(unit) < k_least_way * pixels) unit = {0.0, -pixels};
  const glm::dvec2 by(mouse_at() - glm::vec2(ImGui::GetIO().MouseClickedPos[0]));
  return glm::dot(by, unit) / glm::dot(unit, unit);
}

}  // namespace

/// Nothing for one that is not shown.
std::optional<ViewArrow> Viewport::arrow_in_scene(const AppState& state, const SceneFrame& frame,
                                                  Arrow which) {
  if (which == Arrow::section) return state.cut ? std::optional(section_arrow(*state.cut)) : std::nullopt;
  if (which == Arrow::height) {
    const auto handle = height_handle(state, frame.free);
    if (!handle) return std::nullopt;
    return ViewArrow{.tail = handle->at - k_height_lever * state.settings.direction.unit(),
                     .tip = handle->at};
  }
  if (which == Arrow::side) {
    const auto side = side_arrow(state);
    if (!side) return std::nullopt;
    return ViewArrow{.tail = side->tail,
                     .tip = side->tail + side_arrow_length(state.camera) * side->direction};
  }
  if (!state.settings.look.arrows) return std::nullopt;
  const glm::dvec3 direction = state.settings.direction.unit();
  return parting_arrow(state.extremes, which == Arrow::core ? direction : -direction, frame.open_mold);
}

std::optional<ArrowOnScreen> Viewport::arrow(const AppState& state, const SceneFrame& frame, Arrow which) {
  if (which == Arrow::divider) {  // which is held anywhere along its line
    if (!state.divider) return std::nullopt;
    const glm::vec2 at(divider_place(*state.divider, frame.free), mouse_at().y);
    return ArrowOnScreen{at, at};
  }
  const auto shape = arrow_in_scene(state, frame, which);
  if (!shape) return std::nullopt;
  const auto tail = project(state.camera, frame.size, shape->tail);
  const auto tip = project(state.camera, frame.size, shape->tip);
  if (!tail || !tip) return std::nullopt;
  return ArrowOnScreen{glm::vec2(*tail), glm::vec2(*tip),
                       glm::dot(shape->tip, state.camera.toward_viewer()) >= 0.0};
}

void Viewport::handle_mouse(const Ui& ui, const AppState& state, const SceneFrame& frame, Edits& edits) {
  const ImGuiIO& io = ImGui::GetIO();
  hovers_ = false;
  near_tip_.reset();
  near_loop_.reset();
  if (!state.model) {
    gesture_ = Gesture::none;
    drag_.reset();
    press_.reset();
    return;
  }
  if (gesture_ != Gesture::none && !io.MouseDown[button_]) gesture_ = Gesture::none;
  if (drag_ && !io.MouseDown[0]) drag_.reset();
  if (press_ && ImGui::IsMouseDragging(0, k_click_reach)) press_.reset();
  if (press_ && !io.MouseDown[0]) {
    const auto& point = press_->point;
    if (!edits.measuring && press_->change) {
      auto& chosen = edits.revision_choices.chosen;
      chosen = chosen == press_->change ? std::nullopt : press_->change;
    } else if (!edits.measuring && point && (edits.mold_choices.moves_faces || io.KeyCtrl)) {
      edits.ask(&Commands::move_face, point->facet);
    } else if (!edits.measuring && point && !edits.draft_choices.kind.empty()) {
      edits.ask(&Commands::give_finish, point->facet);
    } else if (press_->loop) {
      auto& chosen = edits.mold_choices.loop;
      chosen = chosen == press_->loop ? std::nullopt : press_->loop;
    } else if (!edits.measuring) {
      edits.ask(&Commands::choose_face, point ? std::optional(point->facet) : std::nullopt);
    } else if (point) {
      edits.measuring->add(measured_place(*state.model, *point));
    }
    press_.reset();
  }
  const bool on_scene = !io.WantCaptureMouse && ImGui::IsMousePosValid();
  if (!dragging() && on_scene) {
    for (const Arrow each :
         {Arrow::divider, Arrow::core, Arrow::cavity, Arrow::section, Arrow::side, Arrow::height}) {
      const auto shown = arrow(state, frame, each);
      if (shown && !frame.in_second(mouse_at()) && glm::distance(shown->tip, mouse_at()) < ui.px(k_tip_reach))
        near_tip_ = each;
    }
    const bool chooses = frame.line_shown && state.mold.line && !near_tip_ && !edits.measuring &&
                         !edits.mold_choices.moves_faces && !io.KeyCtrl;
    if (chooses) {
      const auto surface =
          state.hover ? std::optional(glm::dvec3(state.hover->point.position)) : std::nullopt;
      near_loop_ = loop_under(*state.mold.line, state.camera,
                              {.size = frame.size,
                               .at = glm::dvec2(mouse_at()),
                               .reach_px = static_cast<double>(ui.px(k_line_reach)),
                               .surface = surface});
    }
    for (int button = 0; button < 3; ++button)
      if (io.MouseClicked[button]) start(state, frame, button);
    const bool gives = edits.mold_choices.moves_faces || !edits.draft_choices.kind.empty();
    if (io.MouseDoubleClicked[0] && state.hover && !near_tip_ && !edits.measuring && !gives)
      edits.ask(io.KeyAlt ? &Commands::take_axis : &Commands::take_normal);
    if (io.MouseWheel != 0.0F) {
      edits.camera = zoomed(edits.camera, std::pow(k_zoom_per_notch, io.MouseWheel),
                            glm::dvec2(frame.in_first(mouse_at())), frame.size);
    }
    hovers_ = !dragging() && !near_tip_;
  }
  if (near_tip_ || near_loop_ || drag_) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  // A press alone, or a hand that trembles, leaves what it holds as it is.
  if (drag_ && ImGui::IsMouseDragging(0, k_click_reach)) {
    if (drag_->arrow == Arrow::section) {
      drag_section(state, frame, edits);
    } else if (drag_->arrow == Arrow::height) {
      drag_height(state, frame, *drag_, edits);
    } else if (drag_->arrow == Arrow::divider) {
      const float from = static_cast<float>(frame.free.min.x), to = static_cast<float>(frame.free.max.x);
      edits.divider = std::clamp((mouse_at().x + drag_->grip.x - from) / (to - from), 0.0F, 1.0F);
    } else if (drag_->arrow == Arrow::side) {
      drag_side(state, frame, edits);
    } else {
      drag_direction(state, frame, edits);
    }
  }
  move_camera(ui, frame, edits);
}

void Viewport::start(const AppState& state, const SceneFrame& frame, int button) {
  const glm::vec2 mouse = mouse_at();
  if (button == ImGuiMouseButton_Left && near_tip_) {
    const auto shown = arrow(state, frame, *near_tip_);
    drag_ = ArrowDrag{
        .arrow = *near_tip_,
        .front = shown->toward_viewer,
        .grip = shown->tip - mouse,
        .place = *near_tip_ == Arrow::height ? parting_height(state) : state.settings.look.section_at};
    return;
  }
  if (button == ImGuiMouseButton_Left)
    press_ = Press{.point = state.hover ? std::optional(state.hover->point) : std::nullopt,
                   .change = state.revisions.hover ? state.revisions.hover->change : std::nullopt,
                   .loop = near_loop_};
  gesture_ = gesture_of(state.window.navigation, button, ImGui::GetIO());
  button_ = button;
  // Turning about what is under the cursor keeps it there; beside the part, about the picture's middle.
  pivot_ = state.hover ? glm::dvec3(state.hover->point.position) : state.camera.target;
  if (const auto& other = state.revisions.hover; other && other->second) pivot_ = other->place;
}

void Viewport::move_camera(const Ui& ui, const SceneFrame& frame, Edits& edits) const {
  const glm::dvec2 by(ImGui::GetIO().MouseDelta.x, ImGui::GetIO().MouseDelta.y);
  if (gesture_ == Gesture::none || by == glm::dvec2(0.0)) return;
  switch (gesture_) {
    case Gesture::orbit: {
      const glm::dvec2 turn = by / static_cast<double>(ui.scale) * k_turn_per_unit_rad;
      edits.camera = orbited(edits.camera, turn, {0, 0, 1}, pivot_);
      break;
    }
    case Gesture::pan:
      edits.camera = panned(edits.camera, by, frame.size);
      break;
    case Gesture::zoom:
      edits.camera = zoomed(edits.camera, std::pow(k_zoom_per_unit, -by.y / static_cast<double>(ui.scale)),
                            0.5 * glm::dvec2(frame.size), frame.size);
      break;
    case Gesture::none:
      break;
  }
}

void Viewport::drag_direction(const AppState& state, const SceneFrame& frame, Edits& edits) const {
  const auto centre = project(state.camera, frame.size, glm::dvec3(0.0));
  if (!centre) return;
  const glm::dvec2 tip = glm::dvec2(mouse_at() + drag_->grip) - *centre;
  // How far out the tip stands depends on where it points: that is found by going round a few times.
  glm::dvec3 direction = state.settings.direction.unit() * (drag_->arrow == Arrow::core ? 1.0 : -1.0);
  for (int round = 0; round < 6; ++round) {
    const double distance = glm::length(parting_arrow(state.extremes, direction, frame.open_mold).tip);
    const double radius = distance / pixel_length(state.camera, frame.size);
    direction = ball_direction(state.camera, {glm::dvec2(tip.x, -tip.y) / radius, drag_->front});
  }
  if (drag_->arrow == Arrow::cavity) direction = -direction;
  if (ImGui::GetIO().KeyCtrl) direction = snapped_to(state.features, direction);
  edits.settings.direction = tidy(direction);
  edits.dragging = true;
}

void Viewport::drag_side(const AppState& state, const SceneFrame& frame, Edits& edits) const {
  const auto held = side_arrow(state);
  if (!held) return;
  const glm::dvec3& parting = state.settings.direction.unit();
  const glm::vec2 tip = mouse_at() + drag_->grip;
  glm::dvec3 direction =
      side_direction_at(state.camera, frame.size, {held->tail, parting, held->direction}, tip);
  if (ImGui::GetIO().KeyCtrl) {
    const glm::dvec3 near = snapped_to(state.features, direction);
    const glm::dvec3 level = near - glm::dot(near, parting) * parting;
    if (glm::length(level) > 1e-3) direction = tidy(level);
  }
  give_side_direction(edits.settings.actions, held->direction, direction);
  edits.action_choices.wish = direction;
  edits.dragging = true;
}

void Viewport::drag_height(const AppState& state, const SceneFrame& frame, const ArrowDrag& held,
                           Edits& edits) {
  constexpr double k_inside = 1e-3;  // of the part's height: where the halves could just meet
  const auto handle = arrow_in_scene(state, frame, Arrow::height);
  const auto way = handle ? way_along(state.camera, frame.size, *handle) : std::nullopt;
  if (!way) return;
  const HeightRange range = height_range(state);
  const double inset = k_inside * (range.high - range.low);
  edits.settings.mold.parting_height =
      std::clamp(held.place + *way * state.model->frame.diagonal, range.low + inset, range.high - inset);
  edits.dragging = true;
}

void Viewport::drag_section(const AppState& state, const SceneFrame& frame, Edits& edits) const {
  if (!state.cut) return;
  const auto way = way_along(state.camera, frame.size, section_arrow(*state.cut));
  if (!way) return;
  edits.settings.look.section_at = std::clamp(drag_->place + *way / state.cut->extent, 0.0, 1.0);
  edits.dragging = true;
}

double divider_place(double divider, const FreeArea& free) {
  return std::round(glm::mix(static_cast<double>(free.min.x), static_cast<double>(free.max.x), divider));
}

void Viewport::draw_divider(const Ui& ui, const AppState& state, const FreeArea& free) const {
  if (!state.divider) return;
  ImDrawList& list = scene_list();
  const glm::vec2 top(divider_place(*state.divider, free), free.min.y), bottom(top.x, free.max.y);
  const bool lively = drag_ ? drag_->arrow == Arrow::divider : near_tip_ == Arrow::divider;
  list.AddLine(top, bottom, faded(ui.colours->panel, 0.9F), 4.0F * ui.scale);
  list.AddLine(top, bottom, ui.colours->text, (lively ? 2.5F : 1.5F) * ui.scale);
  const glm::vec2 middle = 0.5F * (top + bottom), reach(ui.px(11));
  list.AddCircleFilled(middle, reach.x, ui.colours->panel);
  list.AddCircle(middle, reach.x, ui.colours->text, 0, 1.5F * ui.scale);
  draw_icon(list, Icon::chevron_left, middle - glm::vec2(ui.px(4), 0.0F), ui.px(8), ui.colours->text);
  draw_icon(list, Icon::chevron_right, middle + glm::vec2(ui.px(4), 0.0F), ui.px(8), ui.colours->text);
  ui.memory->controls["dividing line"] = {middle - reach, middle + reach};
  for (const bool maps : {true, false}) {
    const std::string_view name = maps ? "shadow maps" : "exact";
    const float aside = 0.5F * tag_size(ui, name).x + ui.px(10);
    draw_whole_tag(ui, bottom + glm::vec2(maps ? -aside : aside, -ui.px(24)), name, ui.colours->text);
  }
}

/// Above the cursor: what is said of the surface stands beside it.
void Viewport::draw_loop(const Ui& ui, const AppState& state) const {
  if (!near_loop_ || !state.mold.line || *near_loop_ >= state.mold.line->loops.size()) return;
  const glm::vec2 mouse = mouse_at();
  const auto [name, figures] = loop_lines(state, *near_loop_);
  const std::string text = fmt::format("{}  ·  {}", name, figures);
  const glm::vec2 room = 0.5F * tag_size(ui, text);
  const float right = screen_size().x - room.x;
  const glm::vec2 at(std::clamp(mouse.x, room.x, std::max(right, room.x)), mouse.y - ui.px(16) - room.y);
  ui.memory->controls["loop at the cursor"] = {at - room, at + room};
  draw_tag(ui, at, text, ui.colours->text);
}

void Viewport::draw_arrow_names(const Ui& ui, const AppState& state, const SceneFrame& frame) const {
  if (!state.model) return;
  draw_loop(ui, state);
  draw_divider(ui, state, frame.free);
  draw_height_handle(ui, state, frame.free,
                     drag_ ? drag_->arrow == Arrow::height : near_tip_ == Arrow::height);
  draw_undercut_window(ui, state, frame.size);
  draw_side_arrow(ui, state, frame.size, drag_ ? drag_->arrow == Arrow::side : near_tip_ == Arrow::side);
  for (const Arrow each : {Arrow::core, Arrow::cavity, Arrow::section}) {
    const auto shown = arrow(state, frame, each);
    if (!shown) continue;
    const std::string_view name = each == Arrow::core ? "core" : each == Arrow::cavity ? "cavity" : "section";
    if (each != Arrow::section) {
      // Seen along the direction one arrow is behind the other, and so is its name.
      const auto opposite = arrow(state, frame, each == Arrow::core ? Arrow::cavity : Arrow::core);
      const bool behind = opposite && !shown->toward_viewer &&
                          glm::distance(shown->tip, opposite->tip) < ui.px(k_names_apart);
      if (behind) continue;
    }
    const glm::vec2 reach(ui.px(k_tip_reach));
    ui.memory->controls[fmt::format("{} arrow", name)] = {shown->tip - reach, shown->tip + reach};
    const bool lively = drag_ ? drag_->arrow == each : near_tip_ == each;
    draw_name(ui, *shown, name, lively || shown->toward_viewer ? ui.colours->text : ui.colours->muted);
    if (lively)
      scene_list().AddCircle(shown->tip, ui.px(k_tip_reach), faded(ui.colours->text, 0.6F), 0,
                             1.5F * ui.scale);
  }
}

}  // namespace moldlight::gui
