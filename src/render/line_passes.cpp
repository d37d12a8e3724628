#include <cmath>

#include <glm/geometric.hpp>

#include "render/view_passes.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

namespace {

constexpr int k_arrow_sides = 48;
constexpr double k_tube_px = 7.0, k_chosen_tube_px = 9.0;          // with a dark rim
constexpr double k_hidden_tube = 0.3, k_hidden_chosen_tube = 0.5;  // opacity where surface hides it
constexpr double k_hidden_in_steel = 0.4;                          // share of that
constexpr double k_tube_beside_chosen = 0.6;

struct LineStyle {
  glm::vec4 colour;  // sRGB and opacity
  double width_px;
  glm::vec3 shift{0.0F};  // of lines that do not go with the surface that a mold moves
};

/// Where lines are drawn over a finished picture.
struct OverPicture {
  GLuint framebuffer;
  float hidden;                // share of the opacity that is left where surface hides the line
  bool on_surface;             // they go with the surface that a mold moves, and end where it is cut
  bool depth_of_tube = false;  // they are known by how deep in a tube they are, apart where they are hidden
};

void draw_segments(ViewTools& tools, const ViewFrame& frame, const SegmentBuffer& segments,
                   const LineStyle& style, const std::optional<OverPicture>& over) {
  if (segments.empty()) return;
  const bool on_surface = !over || over->on_surface, tube = over && over->depth_of_tube;
  const bool moved = on_surface && frame.opened(), cut = on_surface && frame.settings.cut.has_value();
  gl::begin(tools.gl, {.framebuffer = over ? over->framebuffer : tools.targets.to_colour.name(),
                       .size = tools.targets.size,
                       .depth = over ? gl::DepthTest::off : gl::DepthTest::less,
                       .blend = tube   ? gl::Blend::greatest
                                : over ? gl::Blend::over_keeping_alpha
                                       : gl::Blend::over,
                       .clipped = cut});
  const gl::Program& program = tools.programs.use(
      "view/lines.vert", "view/lines.frag",
      {moved ? "OPENED" : "", cut ? "SECTION" : "", over ? "OVER" : "", tube ? "TUBE" : ""});
  if (cut) frame.set_section(program);
  if (over) {
    program.set_texture("t_depth", 3, GL_TEXTURE_2D, tools.targets.depth);
    if (!tube) program.set("u_hidden", over->hidden);
  }
  program.set_texture("t_segments", 0, GL_TEXTURE_BUFFER, segments.texels());
  program.set("u_eye_from_unit", glm::mat4(frame.eye_from_unit));
  program.set("u_clip_from_eye", glm::mat4(frame.clip_from_eye));
  program.set("u_size_px", glm::vec2(frame.size));
  const double half_width = 0.5 * style.width_px * frame.settings.pixel_scale + 0.5;
  program.set("u_half_width_px", half_width);
  const bool perspective = frame.camera.projection == Projection::perspective;
  const double lift = (half_width + 0.7) * pixel_length(frame.camera, frame.size);
  program.set("u_lift", perspective ? lift / frame.camera.eye_distance() : lift);
  program.set("u_perspective", perspective ? 1.0F : 0.0F);
  program.set("u_near", depth_range(frame.camera).near);
  program.set("u_colour", style.colour);
  if (!moved) {
    program.set("u_shift", style.shift);
    segments.draw(tools.gl);
    return;
  }
  program.set_texture("t_surface", 1, GL_TEXTURE_2D, tools.targets.surface);
  program.set_texture("t_planes", 2, GL_TEXTURE_BUFFER, frame.subject.part.planes());
  frame.set_sight(program);
  frame.set_eye_depth(program);
  program.set("u_clip_from_unit", frame.clip_from_unit);
  program.set("u_slack", 4.0 * lift);
  for (const Piece& piece : frame.pieces()) {
    program.set("u_shift", piece.shift);
    program.set("u_regions", piece.regions);
    segments.draw(tools.gl);
  }
}

}  // namespace

void draw_lines(ViewTools& tools, const ViewFrame& frame) {
  const ViewSettings& settings = frame.settings;
  const float opacity = 1.0F - 0.65F * static_cast<float>(settings.transparency);
  const auto draw = [&](const SegmentBuffer& segments, const glm::vec4& colour, double width_px) {
    draw_segments(tools, frame, segments, {colour, width_px}, std::nullopt);
  };
  if (settings.feature_edges) {
    const Colour ink = settings.theme == Theme::dark ? Colour{14, 15, 18} : Colour{34, 38, 46};
    draw(tools.mesh.feature_edges, glm::vec4(screen_value(ink), 0.8F * opacity), 1.1);
  }
  if (settings.parting_line) {
    draw(tools.mesh.parting_line, glm::vec4(0.04F, 0.04F, 0.05F, 0.8F * opacity), 3.8);
    draw(tools.mesh.parting_line, glm::vec4(1.0F, 1.0F, 1.0F, opacity), 2.0);
  }
}

void draw_steel_edges(ViewTools& tools, const ViewFrame& frame) {
  if (!frame.settings.steel.shown) return;
  const float opacity = frame.settings.steel.clear ? 0.5F : 0.8F;
  const Colour ink = frame.settings.theme == Theme::dark ? Colour{14, 15, 18} : Colour{34, 38, 46};
  for (const ViewMesh::Solid& solid : tools.mesh.solids_around)
    draw_segments(tools, frame, solid.edges,
                  {glm::vec4(screen_value(ink), opacity), 1.1, frame.steel_shift(solid.motion)},
                  std::nullopt);
}

void draw_tube(ViewTools& tools, const ViewFrame& frame, GLuint framebuffer) {
  const bool any = !tools.mesh.tube.empty(), chosen = !tools.mesh.chosen_tube.empty();
  if (!any && !chosen) return;
  ViewTargets& targets = tools.targets;
  targets.make_tube(tools.gl);
  gl::begin(tools.gl, {.framebuffer = targets.to_tube.name(), .size = targets.size});
  constexpr GLfloat k_none[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  tools.gl.ClearBufferfv(GL_COLOR, 0, k_none);
  const OverPicture into{
      .framebuffer = targets.to_tube.name(), .hidden = 0.0F, .on_surface = true, .depth_of_tube = true};
  // The colour says into which channels: seen and hidden, of the line and of the loop that is looked at.
  draw_segments(tools, frame, tools.mesh.tube, {glm::vec4(1.0F, 1.0F, 0.0F, 0.0F), k_tube_px}, into);
  draw_segments(tools, frame, tools.mesh.chosen_tube, {glm::vec4(0.0F, 0.0F, 1.0F, 1.0F), k_chosen_tube_px},
                into);
  gl::begin(tools.gl,
            {.framebuffer = framebuffer, .size = targets.size, .blend = gl::Blend::over_keeping_alpha});
  const gl::Program& program = tools.programs.use("common/fullscreen.vert", "view/tube.frag");
  program.set_texture("t_tube", 0, GL_TEXTURE_2D, targets.tube);
  program.set("u_colour", screen_value(k_tube));
  program.set("u_chosen_colour", screen_value(k_chosen_tube));
  program.set("u_radius_px",
              glm::vec2(0.5 * frame.settings.pixel_scale * glm::dvec2(k_tube_px, k_chosen_tube_px)));
  program.set("u_rim_px", frame.settings.pixel_scale);
  // Solid steel is not to look clear.
  const SteelLook& steel = frame.settings.steel;
  const double hidden = steel.shown && !steel.clear ? k_hidden_in_steel : 1.0;
  program.set("u_hidden", glm::vec2(hidden * glm::dvec2(k_hidden_tube, k_hidden_chosen_tube)));
  program.set("u_paler", chosen ? k_tube_beside_chosen : 1.0);
  tools.corners.draw();
}

void draw_marked_lines(ViewTools& tools, const ViewFrame& frame, GLuint framebuffer) {
  const auto draw = [&](MarkedLines which, Colour colour, const OverPicture& over) {
    const SegmentBuffer& lines = tools.mesh.marked[static_cast<std::size_t>(which)];
    // Dark below light: it stands out from every colour.
    draw_segments(tools, frame, lines, {glm::vec4(0.0F, 0.0F, 0.0F, 0.75F), 4.2}, over);
    draw_segments(tools, frame, lines, {glm::vec4(screen_value(colour), 1.0F), 2.2}, over);
  };
  draw(MarkedLines::chosen, k_hover_mark, {framebuffer, 0.0F, true});
  draw(MarkedLines::blocking, k_block_mark, {framebuffer, 0.45F, true});
  draw(MarkedLines::ways, k_block_mark, {framebuffer, 0.6F, false});
}

void draw_arrows(ViewTools& tools, const ViewFrame& frame) {
  const ViewSettings& settings = frame.settings;
  struct Painted {
    ViewArrow arrow;
    Colour colour;
  };
  std::vector<Painted> arrows;
  for (const bool plus : {true, false}) {
    if (!settings.arrows) continue;
    arrows.push_back(
        {parting_arrow(tools.mesh.extremes, plus ? frame.direction : -frame.direction, settings.open_mold),
         region_colour(plus ? Region::core : Region::cavity, settings.palette)});
  }
  if (settings.cut && settings.cut_arrow) arrows.push_back({section_arrow(*settings.cut), k_cut_surface});
  if (arrows.empty()) return;
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_colour.name(),
                       .size = tools.targets.size,
                       .depth = gl::DepthTest::less,
                       .cull = gl::Cull::back});
  const gl::Program& program = tools.programs.use("view/arrow.vert", "view/arrow.frag");
  program.set("u_clip_from_unit", frame.clip_from_unit);
  program.set("u_sides", k_arrow_sides);
  frame.set_eye_axes(program);
  program.set("u_opacity", 1.0F);
  for (const auto& [arrow, colour] : arrows) {
    const double length = glm::distance(arrow.tip, arrow.tail);
    const glm::dvec3 axis = (arrow.tip - arrow.tail) / length;
    const glm::dvec3 least = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    program.set("u_tail", glm::vec3(arrow.tail));
    program.set("u_axis", glm::vec3(axis));
    program.set("u_aside", glm::vec3(glm::normalize(glm::cross(axis, least))));
    program.set("u_shape", glm::vec4(length, arrow.head_length, arrow.shaft_radius, arrow.head_radius));
    // Lighter than the surface that it may stand before.
    program.set("u_colour", glm::mix(light_value(colour), glm::vec3(1.0F), 0.12F));
    tools.corners.draw(12 * k_arrow_sides);
  }
}

}  // namespace moldlight
