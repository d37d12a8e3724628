#include <cmath>

#include <glm/geometric.hpp>

#include "render/view_colours.hpp"
#include "render/view_passes.hpp"

namespace moldlight {

namespace {

constexpr int k_arrow_sides = 48;

struct LineStyle {
  glm::vec4 colour;  // sRGB and opacity
  double width_px;
};

void draw_segments(ViewTools& tools, const ViewFrame& frame, const SegmentBuffer& segments,
                   const LineStyle& style) {
  if (segments.empty()) return;
  const bool moved = frame.opened(), cut = frame.settings.cut_at.has_value();
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_colour.name(),
                       .size = tools.targets.size,
                       .depth = gl::DepthTest::less,
                       .blend = gl::Blend::over,
                       .clipped = cut});
  const gl::Program& program =
      tools.programs.use("view/lines.vert", "view/lines.frag", {moved ? "OPENED" : "", cut ? "SECTION" : ""});
  if (cut) frame.set_section(program);
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
    program.set("u_shift", glm::vec3(0.0F));
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
    draw_segments(tools, frame, segments, {colour, width_px});
  };
  if (settings.feature_edges) {
    const Colour ink = settings.theme == Theme::dark ? Colour{14, 15, 18} : Colour{34, 38, 46};
    draw(tools.mesh.feature_edges, glm::vec4(screen_value(ink), 0.8F * opacity), 1.1);
  }
  if (settings.contour_edges) {
    draw(tools.mesh.convex_contour, glm::vec4(1.0F, 1.0F, 1.0F, 0.95F * opacity), 1.8);
    draw(tools.mesh.concave_contour, glm::vec4(0.04F, 0.04F, 0.05F, opacity), 2.6);
  }
  // Dark below light: it stands out from every colour.
  draw(tools.mesh.outline, glm::vec4(0.0F, 0.0F, 0.0F, 0.75F), 4.2);
  draw(tools.mesh.outline, glm::vec4(screen_value(k_hover_mark), 1.0F), 2.2);
}

void draw_arrows(ViewTools& tools, const ViewFrame& frame) {
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_colour.name(),
                       .size = tools.targets.size,
                       .depth = gl::DepthTest::less,
                       .cull = gl::Cull::back});
  const gl::Program& program = tools.programs.use("view/arrow.vert", "view/arrow.frag");
  program.set("u_clip_from_unit", frame.clip_from_unit);
  program.set("u_sides", k_arrow_sides);
  frame.set_eye_axes(program);
  program.set("u_opacity", 1.0F);
  for (const bool plus : {true, false}) {
    const glm::dvec3 axis = plus ? frame.direction : -frame.direction;
    const PartingArrow arrow = parting_arrow(tools.mesh.extremes, axis, frame.settings.open_mold);
    const glm::dvec3 least = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    program.set("u_tail", glm::vec3(arrow.tail));
    program.set("u_axis", glm::vec3(axis));
    program.set("u_aside", glm::vec3(glm::normalize(glm::cross(axis, least))));
    program.set("u_shape", glm::vec4(glm::distance(arrow.tip, arrow.tail), arrow.head_length,
                                     arrow.shaft_radius, arrow.head_radius));
    // Lighter than the surface that it may stand before.
    const glm::vec3 colour =
        light_value(region_colour(plus ? Region::core : Region::cavity, frame.settings.palette));
    program.set("u_colour", glm::mix(colour, glm::vec3(1.0F), 0.12F));
    tools.corners.draw(12 * k_arrow_sides);
  }
}

}  // namespace moldlight
