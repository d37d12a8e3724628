#include <algorithm>

#include "render/view_passes.hpp"

namespace moldlight {

namespace {

/// Ambient occlusion looks this far, in the unit frame, but no further than a share of the picture's height.
constexpr double k_openness_radius = 0.09, k_openness_share = 0.11;

/// Puts the plane of a section where it is inside of solids: lines of sight that begin there leave more of
/// them than they enter.
void draw_cut(ViewTools& tools, const ViewFrame& frame) {
  ViewTargets& targets = tools.targets;
  targets.make_winding(tools.gl);
  gl::begin(tools.gl, {.framebuffer = targets.to_winding.name(),
                       .size = targets.size,
                       .blend = gl::Blend::add,
                       .clipped = true});
  constexpr GLfloat k_outside[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  tools.gl.ClearBufferfv(GL_COLOR, 0, k_outside);
  const gl::Program& winding = tools.programs.use("view/geometry.vert", "view/winding.frag", {"SECTION"});
  winding.set("u_clip_from_unit", frame.clip_from_unit);
  frame.set_section(winding);
  tools.mesh.solids().draw(tools.gl);

  gl::begin(tools.gl, {.framebuffer = targets.to_surface.name(),
                       .size = targets.size,
                       .depth = gl::DepthTest::always,
                       .writes_depth = true});
  const gl::Program& program = tools.programs.use("common/fullscreen.vert", "view/cut.frag");
  program.set_texture("t_winding", 0, GL_TEXTURE_2D, targets.winding);
  program.set("u_section", glm::vec4(glm::dvec4(frame.settings.cut->normal, frame.settings.cut->offset)));
  program.set("u_clip_from_unit", frame.clip_from_unit);
  frame.set_sight(program);
  tools.corners.draw();
}

}  // namespace

void draw_surface(ViewTools& tools, const ViewFrame& frame) {
  const bool separate = frame.by_region(), cut = frame.settings.cut.has_value();
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_surface.name(),
                       .size = tools.targets.size,
                       .depth = gl::DepthTest::less,
                       .writes_depth = true,
                       .cull = tools.mesh.closed && !separate ? gl::Cull::back : gl::Cull::none,
                       .clipped = cut});
  gl::clear_numbers(tools.gl);
  const SplitSurface* split = frame.subject.split;
  const bool look_up = separate && !frame.exact();
  const TriangleBuffer& triangles = split != nullptr ? split->triangles() : tools.mesh.facets;
  const gl::Program& program = tools.programs.use(
      "view/geometry.vert", "view/geometry.frag",
      {split != nullptr ? "SPLIT" : "", separate ? "BY_REGION" : "", look_up ? "LOOK_UP" : "",
       look_up ? frame.kernel_define() : "", cut ? "SECTION" : ""});
  program.set("u_clip_from_unit", frame.clip_from_unit);
  if (split != nullptr) program.set_texture("t_sources", 0, GL_TEXTURE_BUFFER, split->sources());
  if (cut) frame.set_section(program);
  if (look_up) frame.subject.maps->bind(program, 1);
  if (separate) {
    for (const Piece& piece : frame.pieces()) {
      program.set("u_shift", piece.shift);
      program.set("u_regions", piece.regions);
      triangles.draw(tools.gl);
    }
  } else {
    triangles.draw(tools.gl);
    if (cut) draw_cut(tools, frame);
  }
}

void draw_openness(ViewTools& tools, const ViewFrame& frame, int taps) {
  const ViewTargets& targets = tools.targets;
  gl::begin(tools.gl, {.framebuffer = targets.to_openness.name(), .size = targets.size});
  if (taps == 0) {
    constexpr GLfloat k_open[4] = {1.0F, 1.0F, 1.0F, 1.0F};
    tools.gl.ClearBufferfv(GL_COLOR, 0, k_open);
    return;
  }
  const gl::Program& program = tools.programs.use("common/fullscreen.vert", "view/openness.frag");
  program.set_texture("t_surface", 0, GL_TEXTURE_2D, targets.surface);
  program.set_texture("t_depth", 1, GL_TEXTURE_2D, targets.depth);
  frame.set_eye_axes(program);
  frame.set_eye_depth(program);
  const bool perspective = frame.camera.projection == Projection::perspective;
  const double length = pixel_length(frame.camera, frame.size);
  const double scale = perspective ? length / frame.camera.eye_distance() : length;
  program.set("u_eye_plane", glm::vec4(scale, scale, -(0.5 * frame.size.x + frame.shift_px.x) * scale,
                                       (frame.shift_px.y - 0.5 * frame.size.y) * scale));
  program.set("u_perspective", perspective ? 1.0F : 0.0F);
  const double radius = std::min(k_openness_radius, k_openness_share * frame.camera.height);
  program.set("u_radius", radius);
  program.set("u_radius_px", radius / scale);
  program.set("u_taps", taps);
  program.set("u_sample", frame.sample);
  tools.corners.draw();
}

}  // namespace moldlight
