// The heat map of undercut area on the direction ball: colours, colour bar, marks of the best, what the mouse
// reads; and the ball on its own, large.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/direction.hpp"
#include "mold/direction.hpp"
#include "mold/direction_field.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_large_ball = 360.0F;  // layout units
/// A direction within so many degrees of the mouse is shown itself; farther ones by what lies around them.
constexpr double k_read_deg = 1.5;

ImU32 map_colour(const SweepMap* map, const glm::dvec3& direction, float lit, const BareBall& bare) {
  const ImU32 base = mixed(bare.dark, bare.light, lit);
  if (map == nullptr) return base;
  const DirectionField::Reading reading = map->field.at(direction);
  if (reading.cover <= 0.0) return base;
  const ImU32 colour = packed(undercut_scale_colour(undercut_scale(reading.value, map->worst)));
  // Enough shade to be a ball, too little to be taken for a value.
  const ImU32 shaded = mixed(colour, IM_COL32(0, 0, 0, 255), 0.22F * (1.0F - lit));
  return mixed(base, shaded, static_cast<float>(reading.cover));
}

/// Of the proof of the best, or of all free directions where that one has none.
const SweepProof* shown_proof(const SweepState& sweep) {
  if (!sweep.result) return nullptr;
  const SweepResult& result = *sweep.result;
  if (result.proof && result.proof->bound > 0.0) return &*result.proof;
  return result.all_free ? &*result.all_free : nullptr;
}

void draw_open_caps(const Ui& ui, const Ball& ball, const SweepProof& proof) {
  constexpr ImU32 k_dark = IM_COL32(24, 16, 20, 180), k_open = IM_COL32(255, 196, 64, 255);
  constexpr double k_least_deg = 4.0;  // a smaller ring would be hidden by the mark in it
  for (const OpenCap& open : proof.open) {
    for (const double sign : {1.0, -1.0}) {
      const double radius_deg = std::max(open.cap.radius_deg, k_least_deg);
      draw_circle(ball, sign * open.cap.direction, radius_deg, {k_dark, 2.5F * ui.scale});
      draw_circle(ball, sign * open.cap.direction, radius_deg, {k_open, 1.2F * ui.scale});
    }
  }
}

}  // namespace

void draw_sphere(const Ball& ball, const SweepMap* map, const BareBall& bare) {
  ImDrawList& list = ball.list;
  // As fine as the map itself on a large ball; a few pixels on a small one. Shade alone needs less.
  const int rings = map != nullptr ? std::clamp(static_cast<int>(ball.radius / 3.0F), 16, 48) : 7;
  const int spokes = map != nullptr ? 3 * rings : 40;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  const int vertices = (rings + 1) * spokes;
  list.PrimReserve(rings * spokes * 6, vertices);
  const unsigned first = list._VtxCurrentIdx;
  for (int ring = 0; ring <= rings; ++ring) {
    const double r = std::sin(0.5 * glm::pi<double>() * ring / rings);
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double turn = 2.0 * glm::pi<double>() * spoke / spokes;
      const glm::dvec2 at(r * std::cos(turn), r * std::sin(turn));
      const glm::dvec3 seen(at.x, -at.y, std::sqrt(std::max(0.0, 1.0 - r * r)));
      const double lit = std::clamp(glm::dot(seen, glm::normalize(glm::dvec3(-0.5, 0.7, 0.8))), 0.0, 1.0);
      list.PrimWriteVtx(ball.centre + ball.radius * glm::vec2(at), white,
                        map_colour(map, ball.camera.orientation * seen, static_cast<float>(lit), bare));
    }
  }
  const auto index = [&](int ring, int spoke) {
    list.PrimWriteIdx(static_cast<ImDrawIdx>(first + static_cast<unsigned>(ring * spokes + spoke % spokes)));
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int spoke = 0; spoke < spokes; ++spoke) {
      for (const auto& [up, along] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        index(ring + up, spoke + along);
    }
  }
  list.AddCircle(ball.centre, ball.radius, bare.dark, map != nullptr ? 96 : 64, 1.5F);
}

void draw_circle(const Ball& ball, const glm::dvec3& axis, double angle_deg, const Stroke& stroke) {
  const glm::dvec3 side = std::abs(axis.z) > 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 x = glm::normalize(glm::cross(axis, side)), y = glm::cross(axis, x);
  const double sine = std::sin(glm::radians(angle_deg)), cosine = std::cos(glm::radians(angle_deg));
  constexpr int k_steps = 48;
  glm::vec2 before(0.0F);
  for (int step = 0; step <= k_steps; ++step) {
    const double turn = 2.0 * glm::pi<double>() * step / k_steps;
    const BallPoint point = ball.point(cosine * axis + sine * (std::cos(turn) * x + std::sin(turn) * y));
    const glm::vec2 here = ball.screen(point);
    if (step > 0 && point.front) ball.list.AddLine(before, here, stroke.colour, stroke.thickness);
    before = here;
  }
}

void draw_sweep_marks(const Ui& ui, const Ball& ball, const SweepState& sweep) {
  ImDrawList& list = ball.list;
  constexpr ImU32 k_dark = IM_COL32(24, 16, 20, 230), k_light = IM_COL32(255, 255, 255, 240);
  if (!sweep.result) return;
  if (const SweepProof* proof = shown_proof(sweep)) draw_open_caps(ui, ball, *proof);
  for (const SweepCandidate& candidate : sweep.result->candidates) {
    const bool best = candidate.rank == 1;
    if (candidate.tie_group != 1 && !best) continue;
    for (const double sign : {1.0, -1.0}) {
      const glm::dvec3 direction = sign * candidate.candidate.direction;
      if (const auto& tilt = candidate.tilt; best && tilt && tilt->deg > 0.0) {
        draw_circle(ball, direction, tilt->deg, {faded(k_dark, 0.7F), 2.5F * ui.scale});
        draw_circle(ball, direction, tilt->deg, {k_light, 1.0F * ui.scale});
      }
      const BallPoint point = ball.point(direction);
      if (!point.front) continue;
      const ImVec2 at = ball.screen(point);
      if (best) {
        list.AddCircle(at, 7.0F * ui.scale, k_dark, 0, 3.0F * ui.scale);
        list.AddCircle(at, 7.0F * ui.scale, k_light, 0, 1.5F * ui.scale);
      } else {
        list.AddCircleFilled(at, 3.5F * ui.scale, k_dark);
        list.AddCircleFilled(at, 2.25F * ui.scale, k_light);
      }
    }
  }
}

void describe_direction(const PanelContext& context, const glm::dvec3& direction) {
  const AppState& state = context.state;
  const Ui& ui = context.ui;
  const SweepMap& map = *state.sweep.map;
  const double total = state.model->geometry.total_area;
  std::string title, text, source;
  if (const EvaluatedDirection* found = map.nearest(direction, k_read_deg)) {
    title =
        direction_words(glm::dot(found->direction, direction) < 0.0 ? -found->direction : found->direction);
    text = fmt::format("undercut {} ± {}", area_with_unit(*state.model, found->undercut),
                       error_text(found->undercut_error));
    source = fmt::format("{}  ·  {}", share_text(found->undercut, total), candidate_kind_name(found->kind));
  } else {
    const DirectionField::Reading reading = map.field.at(direction);
    title = direction_words(direction);
    if (reading.cover > 0.2) {
      text = fmt::format("undercut about {}", area_with_unit(*state.model, reading.value));
      source = fmt::format("{}  ·  between scored directions", share_text(reading.value, total));
    } else {
      text = "not looked at yet";
    }
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  ImGui::BeginTooltip();
  heading(ui, title);
  draw_item_text(ui.colours->text, text);
  if (!source.empty()) hint(ui, source);
  if (const SweepProof* proof = shown_proof(state.sweep))
    hint(ui, proof_text(*state.model, *proof, direction));
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

float draw_colour_bar(const PanelContext& context, const glm::vec2& at, float width) {
  const Ui& ui = context.ui;
  const SweepMap& map = *context.state.sweep.map;
  ImDrawList& list = window_list();
  const float height = ui.px(6), gap = ui.px(3);
  constexpr int k_steps = 24;
  for (int k = 0; k < k_steps; ++k) {
    const float left = at.x + std::round(width * static_cast<float>(k) / k_steps);
    const float right = at.x + std::round(width * static_cast<float>(k + 1) / k_steps);
    const ImU32 a = packed(undercut_scale_colour(static_cast<double>(k) / k_steps));
    const ImU32 b = packed(undercut_scale_colour((k + 1.0) / k_steps));
    list.AddRectFilledMultiColor(ImVec2(left, at.y), ImVec2(right, at.y + height), a, b, b, a);
  }
  const float top = at.y + height + gap;
  const Lettering lettering = ui.note();
  draw_text(list, lettering, {at.x, top}, "0");
  draw_text_to(lettering, at.x + width, top, area_with_unit(*context.state.model, map.worst));
  return height + gap + ui.fonts.small.size;
}

void draw_large_ball(const PanelContext& context, BallDrag& drag) {
  if (!context.state.sweep_choices.large_ball || !context.state.sweep.map) {
    drag.active = false;
    return;
  }
  const Ui& ui = context.ui;
  const FreeArea area = context.layout.free_area(false);
  // The view cube keeps its place.
  const glm::vec2 free = glm::vec2(area.max - area.min) - glm::vec2(ui.px(140), ui.px(120));
  const float room = std::min(free.x, free.y);
  const float size = std::clamp(ui.px(k_large_ball), ui.px(120), std::max(room, ui.px(120)));
  ImGui::SetNextWindowPos(
      ImVec2(static_cast<float>(area.min.x) + ui.px(12), static_cast<float>(area.min.y) + ui.px(8)));
  ImGui::SetNextWindowSize(ImVec2(size + ui.px(24), 0.0F));
  ImGui::Begin("##Large ball", nullptr, k_fixed_window | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::AlignTextToFramePadding();
  heading(ui, "Undercut by direction");
  ImGui::SameLine(room_left() + ui.px(12) - ui.px(k_row_height));
  if (icon_button(ui, {"close ball", Icon::close, "Close the large ball"}))
    context.edits.sweep_choices.large_ball = false;
  draw_ball(context, drag, size);
  const glm::vec2 at = cursor_at();
  const float height = draw_colour_bar(context, at + glm::vec2(0.0F, ui.px(4)), size);
  ImGui::Dummy(ImVec2(size, height + ui.px(6)));
  if (const SweepProof* proof = shown_proof(context.state.sweep))
    hint(ui, proved_text(*context.state.model, *proof));
  ImGui::End();
}

}  // namespace moldlight::gui
