#include "gui/view/mold_view.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/mold_halves.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_same_loop = 0.5;          // of a loop's size: two loops nearer than that are one
constexpr double k_least_loop_reach = 0.04;  // of a picture of a loop, unit frame
constexpr double k_beside = 0.07;            // between the part and the outline around it, unit frame
constexpr double k_handle_share = 0.02;      // of the window's height, about a handle's middle

Bounds box_of(const std::vector<ViewSegment>& loop) {
  Bounds box;
  for (const ViewSegment& segment : loop) box.add(glm::dvec3(segment.start));
  return box;
}

/// Of the block around the line that is known; else along the direction.
MoldFrame frame_of(const AppState& state) {
  const glm::dvec3& d = state.settings.direction.unit();
  return state.mold.line && state.mold.line->frame.z == d ? state.mold.line->frame : mold_frame(d);
}

/// The part's box in the mold's axes, unit frame.
Bounds mold_box(const AppState& state) {
  const MoldFrame frame = frame_of(state);
  Bounds box;
  for (const glm::vec3& point : state.extremes) box.add(frame.to_mold(glm::dvec3(point)));
  return box;
}

/// Whether all of the handle there is beside the panels.
bool is_within(const FreeArea& free, const glm::dvec2& pixel) {
  const double reach = k_handle_share * free.window.y;
  return glm::all(glm::greaterThan(pixel, glm::dvec2(free.min) + reach)) &&
         glm::all(glm::lessThan(pixel, glm::dvec2(free.max) - reach));
}

}  // namespace

std::optional<std::size_t> nearest_loop(const MoldLine& line, const MoldLine& former, std::size_t loop) {
  const Bounds here = box_of(former.loops[loop]);
  std::optional<std::size_t> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < line.loops.size(); ++k) {
    const Bounds other = box_of(line.loops[k]);
    const double distance = glm::distance(here.min, other.min) + glm::distance(here.max, other.max);
    if (line.line.loops[k].kind != former.line.loops[loop].kind || distance >= nearest ||
        distance > 2.0 * k_same_loop * std::max(here.diagonal(), other.diagonal()))
      continue;
    nearest = distance;
    found = k;
  }
  return found;
}

std::vector<glm::vec3> surroundings(const MoldLine& line, std::size_t loop) {
  const Bounds box = box_of(line.loops[loop]);
  const double reach = std::max(0.15 * box.diagonal(), k_least_loop_reach);
  std::vector<glm::vec3> points = points_around(glm::vec3(box.center()), reach);
  for (const ViewSegment& segment : line.loops[loop]) points.push_back(segment.start);
  return points;
}

std::optional<std::size_t> loop_under(const MoldLine& line, const Camera& camera, const LinePick& pick) {
  // The surface beside a tube may be seen edge-on, and be that much nearer.
  constexpr double k_edge_on = 4.0;
  const double slack = k_edge_on * pick.reach_px * pixel_length(camera, pick.size);
  const glm::dvec3 toward = camera.toward_viewer();
  std::optional<std::size_t> found;
  double nearest = pick.reach_px;
  for (std::size_t k = 0; k < line.loops.size(); ++k) {
    for (const ViewSegment& segment : line.loops[k]) {
      const glm::dvec3 start(segment.start), end(segment.end);
      const auto a = project(camera, pick.size, start), b = project(camera, pick.size, end);
      if (!a || !b) continue;
      const glm::dvec2 along = *b - *a;
      const double squared = glm::dot(along, along);
      const double share =
          squared > 0.0 ? std::clamp(glm::dot(pick.at - *a, along) / squared, 0.0, 1.0) : 0.0;
      const double away = glm::distance(*a + share * along, pick.at);
      if (away > nearest || (away == nearest && found)) continue;
      if (pick.surface && glm::dot(*pick.surface - glm::mix(start, end, share), toward) > slack) continue;
      nearest = away;
      found = k;
    }
  }
  return found;
}

std::array<std::string, 2> loop_lines(const AppState& state, std::size_t number) {
  const PartingLoop& loop = state.mold.line->line.loops[number];
  const FigureStyle style(*state.model);
  return {
      fmt::format("Loop {}: {}", number + 1, loop_name(loop.kind)),
      fmt::format("{} long, climbs {}, steepest {:.0f}°", style.with_unit(FigureKind::length, loop.length),
                  style.with_unit(FigureKind::length, loop.climb()), loop.steepest_deg)};
}

std::vector<glm::vec3> block_corners(const AppState& state) {
  const MoldFrame frame = frame_of(state);
  const double margin =
      block_margin(state.settings.mold, state.model->frame.diagonal) / state.model->frame.diagonal;
  std::vector<glm::vec3> corners;
  for (const glm::dvec3& corner : mold_box(state).widened(margin).corners())
    corners.emplace_back(frame.to_part(corner));
  return corners;
}

double parting_height(const AppState& state) {
  const auto& given = state.settings.mold.parting_height;
  if (given || !state.mold.line) return given.value_or(0.0);
  const PartingLine& line = state.mold.line->line;
  // Walls may have been divided elsewhere than where a line in one plane runs.
  const bool outer = !line.loops.empty() && line.loops.front().kind == LoopKind::outer;
  return outer && line.is_planar(state.model->frame.diagonal) ? line.outer_low
                                                              : state.mold.line->assignment.height;
}

HeightRange height_range(const AppState& state) {
  const UnitFrame& frame = state.model->frame;
  const Bounds box = mold_box(state);
  const double middle = glm::dot(frame.center, state.settings.direction.unit());
  return {middle + box.min.z * frame.diagonal, middle + box.max.z * frame.diagonal};
}

std::optional<HeightHandle> height_handle(const AppState& state, const FreeArea& free) {
  const bool asked = looks_at_line(state) && state.settings.look.open_mold == 0.0;
  if (!asked || !state.mold.line || state.dialogs.panels_hidden) return std::nullopt;
  const UnitFrame& unit = state.model->frame;
  const glm::dvec3& d = state.settings.direction.unit();
  const MoldFrame frame = frame_of(state);
  const Bounds box = mold_box(state);
  const double height = (parting_height(state) - glm::dot(unit.center, d)) / unit.diagonal;
  HeightHandle handle;
  for (std::size_t k = 0; k < 4; ++k) {
    const bool right = k == 1 || k == 2, upper = k >= 2;
    handle.outline[k] = frame.to_part({right ? box.max.x + k_beside : box.min.x - k_beside,
                                       upper ? box.max.y + k_beside : box.min.y - k_beside, height});
  }
  // On the outline as far to the right as no panel covers it, or else at the corner that is seen there.
  const auto to_the_right = [&](const glm::dvec3& place) {
    return glm::dot(place, state.camera.right()) + 1e-3 * glm::dot(place, state.camera.toward_viewer());
  };
  constexpr int k_outline_places = 64;  // a side of the outline
  std::optional<glm::dvec3> seen;
  for (std::size_t k = 0; k < 4; ++k) {
    for (int place = 0; place < k_outline_places; ++place) {
      const glm::dvec3 at = glm::mix(handle.outline[k], handle.outline[(k + 1) % 4],
                                     static_cast<double>(place) / k_outline_places);
      const auto pixel = project(state.camera, free.window, at);
      if (pixel && is_within(free, *pixel) && (!seen || to_the_right(at) > to_the_right(*seen))) seen = at;
    }
  }
  handle.at = seen ? *seen : *std::ranges::max_element(handle.outline, {}, to_the_right);
  return handle;
}

void draw_height_handle(const Ui& ui, const AppState& state, const FreeArea& free, bool lively) {
  const glm::ivec2& size = free.window;
  const auto handle = height_handle(state, free);
  if (!handle) return;
  ImDrawList& list = scene_list();
  std::vector<ImVec2> outline;
  for (const glm::dvec3& corner : handle->outline) {
    const auto seen = project(state.camera, size, corner);
    if (!seen) return;
    outline.push_back(glm::vec2(*seen));
  }
  const auto seen = project(state.camera, size, handle->at);
  if (!seen) return;
  const glm::vec2 at(*seen);
  const ImU32 ink = lively ? ui.colours->text : faded(ui.colours->text, 0.75F);
  list.AddPolyline(outline.data(), 4, faded(ui.colours->panel, lively ? 0.7F : 0.35F), ImDrawFlags_Closed,
                   3.5F * ui.scale);
  list.AddPolyline(outline.data(), 4, faded(ui.colours->text, lively ? 0.85F : 0.3F), ImDrawFlags_Closed,
                   1.3F * ui.scale);
  const float radius = ui.px(lively ? 10 : 9);
  list.AddCircleFilled(at, radius + 1.0F, ui.colours->panel);
  list.AddCircle(at, radius, ink, 0, 1.5F * ui.scale);
  for (const float way : {-1.0F, 1.0F}) {
    const float y = at.y + way * ui.px(2), tip = at.y + way * ui.px(6), half = ui.px(3.5F);
    list.AddTriangleFilled(ImVec2(at.x - half, y), ImVec2(at.x + half, y), ImVec2(at.x, tip), ink);
  }
  const glm::vec2 reach(ui.px(12));
  ui.memory->controls["parting height handle"] = {at - reach, at + reach};
  if (!lively) return;
  const std::string text =
      "halves meet at " +
      with_minus(FigureStyle(*state.model).with_unit(FigureKind::length, parting_height(state)));
  const glm::vec2 room = 0.5F * tag_size(ui, text);
  const float right = screen_size().x;
  const float side = at.x + ui.px(18) + 2.0F * room.x < right ? 1.0F : -1.0F;
  draw_tag(ui, at + glm::vec2(side * (ui.px(18) + room.x), 0.0F), text, ui.colours->text);
}

FaceHalves halves_of_face(const AppState& state, std::uint32_t face) {
  const Assignment& assignment = state.mold.line->assignment;
  FaceHalves halves;
  for (PieceIndex piece = 0; piece < assignment.mesh.pieces.size(); ++piece) {
    if (state.faces->of_facet[assignment.mesh.pieces[piece].facet] != face) continue;
    const double area = 0.5 * glm::length(twice_piece_area(assignment.mesh, piece));
    const bool free = assignment.free[piece] != 0;
    switch (assignment.sides[piece]) {
      case MoldSide::core:
        (free ? halves.core : halves.fixed_core) += area;
        break;
      case MoldSide::cavity:
        (free ? halves.cavity : halves.fixed_cavity) += area;
        break;
      case MoldSide::action:
        halves.action += area;
        break;
    }
  }
  return halves;
}

}  // namespace moldlight::gui
