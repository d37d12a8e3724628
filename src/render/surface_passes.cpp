#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "render/view_passes.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

namespace {

/// Ambient occlusion looks this far, in the unit frame, but no further than a share of the picture's height.
constexpr double k_openness_radius = 0.09, k_openness_share = 0.11;

/// As shaders/view/surface_bits.glsl has them: what is no facet of the part.
constexpr unsigned k_part_cut = 1;
unsigned steel_number(std::size_t colour, bool cut) {
  return 2U + 2U * static_cast<unsigned>(colour) + (cut ? 1U : 0U);
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
    program.set("u_shift", frame.steel_shift(solid.motion));
    program.set("u_number", steel_number(solid.colour, false));
    solid.triangles.draw(tools.gl);
  }
  if (!cut) return;
  for (const ViewMesh::Solid& solid : tools.mesh.solids_around)
    draw_cut(tools, frame,
             {solid.triangles, steel_number(solid.colour, true), frame.steel_shift(solid.motion)});
}

constexpr double k_hatch_pitch_px = 7.0, k_hatch_strength = 0.30;
constexpr double k_level_pitch_px = 6.0, k_cut_pitch_px = 9.0;
constexpr double k_clear_steel = 0.34;  // opacity
constexpr int k_first_map_unit = 7;     // of the shading's textures

std::string element(const char* name, std::size_t index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

void draw_gradient(gl::Tools& tools, Theme theme, const glm::ivec2& size, int sample) {
  const BackdropColours colours = backdrop_colours(theme);
  const gl::Program& program = tools.programs.use("common/at_infinity.vert", "view/background.frag");
  program.set("u_above", screen_value(colours.above));
  program.set("u_below", screen_value(colours.below));
  program.set("u_size", glm::vec2(size));
  program.set("u_sample", sample);
  tools.corners.draw();
}

constexpr int k_footprint_side = 384;       // pixels
constexpr double k_footprint_reach = 0.75;  // half its side, unit frame: a soft shadow is wider than the part
constexpr Colour k_studio_above = {250, 250, 252}, k_studio_below = {212, 216, 222};

/// The floor's shadow is that of the part in place, as light from above makes it.
void draw_studio(ViewTools& tools, const ViewFrame& frame) {
  ViewTargets& targets = tools.targets;
  if (frame.sample == 0) {
    targets.make_footprint(tools.gl, k_footprint_side);
    gl::begin(tools.gl, {.framebuffer = targets.to_footprint.name(), .size = glm::ivec2(k_footprint_side)});
    constexpr GLfloat k_bare[4] = {0.0F, 0.0F, 0.0F, 0.0F};
    tools.gl.ClearBufferfv(GL_COLOR, 0, k_bare);
    const gl::Program& footprint = tools.programs.use("view/geometry.vert", "view/footprint.frag");
    const glm::dvec3 flat(1.0 / k_footprint_reach, 1.0 / k_footprint_reach, 0.0);
    footprint.set("u_clip_from_unit", glm::mat4(glm::scale(glm::dmat4(1.0), flat)));
    tools.mesh.facets.draw(tools.gl);
    if (frame.settings.steel.shown)
      for (const ViewMesh::Solid& solid : tools.mesh.solids_around) solid.triangles.draw(tools.gl);
  }
  gl::begin(tools.gl,
            {.framebuffer = targets.to_colour.name(), .size = targets.size, .depth = gl::DepthTest::equal});
  const gl::Program& program = tools.programs.use("common/at_infinity.vert", "view/studio.frag");
  program.set_texture("t_footprint", 0, GL_TEXTURE_2D, targets.footprint);
  program.set("u_ground", *frame.settings.ground);
  program.set("u_reach", k_footprint_reach);
  program.set("u_above", screen_value(k_studio_above));
  program.set("u_below", screen_value(k_studio_below));
  program.set("u_size", glm::vec2(frame.size));
  program.set("u_sample", frame.sample);
  frame.set_sight(program);
  tools.corners.draw();
}

void set_detail(const gl::Program& program, const ViewFrame& frame, const ViewMesh& mesh) {
  const ViewSettings& settings = frame.settings;
  const PartBuffers& part = frame.subject.part;
  const double length = pixel_length(frame.camera, frame.size);
  program.set_texture("t_planes", 3, GL_TEXTURE_BUFFER, part.planes());
  program.set_texture("t_facet_class", 4, GL_TEXTURE_BUFFER, frame.subject.classes());
  program.set_texture("t_positions", 5, GL_TEXTURE_BUFFER, part.positions());
  program.set_texture("t_corners", 6, GL_TEXTURE_BUFFER, part.corners());
  frame.set_sight(program);
  program.set("u_parting", glm::vec3(frame.direction));
  program.set("u_draft_colours", settings.colour_mode == ColourMode::draft_angle);
  const DraftScale scale = draft_scale(settings.required_draft_deg, settings.palette);
  for (std::size_t i = 0; i < scale.limits_deg.size(); ++i)
    program.set(element("u_draft_sines", i), std::sin(glm::radians(scale.limits_deg[i])));
  for (std::size_t i = 0; i < scale.colours.size(); ++i)
    program.set(element("u_draft", i), light_value(scale.colours[i]));
  program.set("u_opened", settings.travel());
  program.set("u_facet_edge", settings.facet_edges ? 0.5 * settings.pixel_scale : 0.0);
  program.set("u_facet_edge_colour", light_value({26, 28, 33}));
  // Level lines keep their distance on the screen within a factor of two, and their place on the part.
  const double wanted = k_level_pitch_px * settings.pixel_scale * length;
  program.set("u_level_step", settings.near_vertical ? std::exp2(std::ceil(std::log2(wanted))) : 0.0);
  program.set("u_level_colour", light_value({255, 255, 255}));
  program.set("u_cut_colour", light_value(k_cut_surface));
  for (std::size_t k = 0; k < k_steels; ++k)
    program.set(element("u_steel", k), light_value(steel_colour(static_cast<Steel>(k), settings.palette)));
  for (std::size_t k = 0; k < mesh.moved_colours.size(); ++k)
    program.set(element("u_steel", k_steels + k), light_value(moved_steel_colour(mesh.moved_colours[k])));
  program.set("u_cut_pitch", k_cut_pitch_px * settings.pixel_scale);
  const glm::dmat4 to_pixels = glm::scale(glm::dmat4(1.0), glm::dvec3(0.5 * glm::dvec2(frame.size), 1.0)) *
                               glm::translate(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, 0.0));
  program.set("u_pixel_from_unit", glm::mat4(to_pixels * frame.clip_from_eye * frame.eye_from_unit));
  program.set("u_pixel_length", length);
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

bool needs_detail(const ViewSettings& settings) {
  return settings.colour_mode == ColourMode::draft_angle || settings.facet_edges || settings.near_vertical ||
         settings.cut || settings.open_mold > 0.0 || settings.steel.shown;
}

void draw_background(ViewTools& tools, const ViewFrame& frame) {
  if (frame.settings.ground) return draw_studio(tools, frame);
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_colour.name(),
                       .size = tools.targets.size,
                       .depth = gl::DepthTest::equal});
  if (frame.settings.backdrop != Backdrop::gradient) {
    const bool none = frame.settings.backdrop == Backdrop::none;
    const glm::vec4 flat =
        none ? glm::vec4(0.0F) : glm::vec4(screen_value(backdrop_colours(frame.settings.theme).below), 1.0F);
    tools.gl.ClearBufferfv(GL_COLOR, 0, &flat.x);
    return;
  }
  draw_gradient(tools, frame.settings.theme, frame.size, frame.sample);
}

void draw_backdrop(gl::Tools& tools, const ViewTarget& target, Theme theme) {
  gl::begin(tools.gl, {.framebuffer = target.framebuffer, .size = target.size});
  draw_gradient(tools, theme, target.size, 0);
}

void draw_map(gl::Tools& tools, const ViewTarget& target, const ShadowMaps& maps, bool plus) {
  gl::begin(tools.gl, {.framebuffer = target.framebuffer, .size = target.size});
  const gl::Program& program = tools.programs.use("common/fullscreen.vert", "view/map_picture.frag");
  program.set("u_size", glm::vec2(target.size));
  program.set_texture("t_depths", 0, GL_TEXTURE_2D_ARRAY, maps.depths());
  program.set("u_layer", plus ? 0 : 1);
  tools.corners.draw();
}

void shade(ViewTools& tools, const ViewFrame& frame) {
  const ViewSettings& settings = frame.settings;
  const ViewSubject& subject = frame.subject;
  const bool ghost = settings.transparency > 0.0 && frame.layer == Layer::whole,
             over = ghost || frame.layer == Layer::steel;
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_shaded.name(),
                       .size = tools.targets.size,
                       .depth = gl::DepthTest::unequal,
                       .blend = over ? gl::Blend::over : gl::Blend::replace});
  const bool detail = needs_detail(settings), plain = subject.maps == nullptr && subject.split == nullptr;
  const bool known = frame.exact() || frame.by_region();
  const bool compared = subject.maps != nullptr && subject.split != nullptr;
  const bool look_up = !plain && (!known || (compared && frame.exact()));
  const gl::Program& program = tools.programs.use(
      "common/at_infinity.vert", "view/shade.frag",
      {plain ? "PLAIN" : "", known ? "KNOWN" : "", look_up ? "LOOK_UP" : "", compared ? "COMPARED" : "",
       look_up ? frame.kernel_define() : "", detail ? "DETAIL" : ""});
  program.set_texture("t_surface", 0, GL_TEXTURE_2D, tools.targets.surface);
  program.set_texture("t_openness", 1, GL_TEXTURE_2D, tools.targets.openness);
  if (look_up) {
    subject.maps->bind(program, k_first_map_unit);
    frame.set_sight(program);
  }
  if (compared) {
    const double everywhere = frame.size.x, from = settings.maps_left_of_px.value_or(everywhere);
    program.set("u_difference",
                glm::vec4(light_value(k_difference_mark), settings.mark_difference ? 1.0F : 0.0F));
    // What is known is exact; the other side of the line has what it is compared with.
    const glm::dvec2 swapped =
        frame.exact() || frame.by_region() ? glm::dvec2(-1.0, from) : glm::dvec2(from, everywhere + 1.0);
    program.set("u_swapped", glm::vec2(settings.maps_left_of_px ? swapped : glm::dvec2(0.0)));
  }
  const bool regions = settings.colour_mode == ColourMode::regions;
  for (const Region region : k_regions) {
    program.set(element("u_colours", facts(region).accessible),
                light_value(regions ? region_colour(region, settings.palette) : k_plain_surface));
  }
  frame.set_eye_axes(program);
  if (!plain) {
    const glm::dvec2 origin =
        project(frame.camera, frame.size, glm::dvec3(0.0)).value_or(glm::dvec2(0.0)) + frame.shift_px;
    program.set("u_hatch_origin", glm::vec2(origin.x, frame.size.y - origin.y));
    program.set("u_hatch", glm::vec2(k_hatch_pitch_px * settings.pixel_scale,
                                     settings.hatching && regions ? k_hatch_strength : 0.0));
  }
  program.set("u_dimmed", settings.dimmed);
  // A layer of steel leaves the part as it is.
  const bool steel = frame.layer == Layer::steel;
  const double part = ghost ? 1.0 - settings.transparency : 1.0;
  program.set("u_opacity", steel ? glm::vec3(0.0, 0.0, k_clear_steel) : glm::vec3(part, 1.0, 1.0));
  if (detail) set_detail(program, frame, tools.mesh);
  tools.corners.draw();
}

}  // namespace moldlight
