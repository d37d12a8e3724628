#include <algorithm>

#include <glm/geometric.hpp>

#include "render/view_passes.hpp"

namespace moldlight {

namespace {

/// Ambient occlusion looks this far, in the unit frame, but no further than a share of the picture's height.
constexpr double k_openness_radius = 0.09, k_openness_share = 0.11;

/// As shaders/view/surface_bits.glsl has them: what is no facet of the part.
constexpr unsigned k_part_cut = 1;
unsigned steel_number(Steel steel, bool cut) {
  return 2U + 2U * static_cast<unsigned>(steel) + (cut ? 1U : 0U);
}

/// A solid whose section is filled.
struct CutSolid {
  const TriangleBuffer& triangles;
  unsigned number;
  glm::vec3 shift{0.0F};
};

/// Puts the plane of a section where it is inside of solids: lines of sight that begin there leave more of
/// them than they enter. A solid that has moved takes its plane with it.
void draw_cut(ViewTools& tools, const ViewFrame& frame, const CutSolid& solid) {
  ViewTargets& targets = tools.targets;
  targets.make_winding(tools.gl);
  gl::begin(tools.gl, {.framebuffer = targets.to_winding.name(),
                       .size = targets.size,
                       .blend = gl::Blend::add,
                       .clipped = true});
  constexpr GLfloat k_outside[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  tools.gl.ClearBufferfv(GL_COLOR, 0, k_outside);
  const gl::Program& winding =
      tools.programs.use("view/geometry.vert", "view/winding.frag", {"SECTION", "BY_REGION"});
  winding.set("u_clip_from_unit", frame.clip_from_unit);
  winding.set("u_shift", solid.shift);
  frame.set_section(winding);
  solid.triangles.draw(tools.gl);

  // Only what has moved may be before another cut.
  const bool alone = !frame.with_steel();
  gl::begin(tools.gl, {.framebuffer = targets.to_surface.name(),
                       .size = targets.size,
                       .depth = alone ? gl::DepthTest::always : gl::DepthTest::less,
                       .writes_depth = true});
  const gl::Program& program = tools.programs.use("common/fullscreen.vert", "view/cut.frag");
  program.set_texture("t_winding", 0, GL_TEXTURE_2D, targets.winding);
  const CutPlane& cut = *frame.settings.cut;
  const double offset = cut.offset + glm::dot(cut.normal, glm::dvec3(solid.shift));
  program.set("u_section", glm::vec4(glm::dvec4(cut.normal, offset)));
  program.set("u_number", solid.number);
  program.set("u_clip_from_unit", frame.clip_from_unit);
  frame.set_sight(program);
  tools.corners.draw();
}

/// The bodies of a mold around the part.
void draw_steel(ViewTools& tools, const ViewFrame& frame) {
  const bool cut = frame.settings.cut.has_value();
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_surface.name(),
                       .size = tools.targets.size,
                       .depth = gl::DepthTest::less,
                       .writes_depth = true,
                       .cull = gl::Cull::back,
                       .clipped = cut});
  const gl::Program& program =
      tools.programs.use("view/geometry.vert", "view/steel.frag", {"BY_REGION", cut ? "SECTION" : ""});
  program.set("u_clip_from_unit", frame.clip_from_unit);
  if (cut) frame.set_section(program);
  for (const ViewMesh::Solid& solid : tools.mesh.solids_around) {
    program.set("u_shift", frame.steel_shift(solid.steel));
    program.set("u_number", steel_number(solid.steel, false));
    solid.triangles.draw(tools.gl);
  }
  if (!cut) return;
  for (const ViewMesh::Solid& solid : tools.mesh.solids_around)
    draw_cut(tools, frame,
             {solid.triangles, steel_number(solid.steel, true), frame.steel_shift(solid.steel)});
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
    if (cut) draw_cut(tools, frame, {tools.mesh.solids(), k_part_cut});
  }
  if (frame.with_steel()) draw_steel(tools, frame);
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
