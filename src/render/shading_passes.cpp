#include <cmath>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "render/view_colours.hpp"
#include "render/view_passes.hpp"

namespace moldlight {

namespace {

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

void set_detail(const gl::Program& program, const ViewFrame& frame) {
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
  program.set("u_cut_pitch", k_cut_pitch_px * settings.pixel_scale);
  const glm::dmat4 to_pixels = glm::scale(glm::dmat4(1.0), glm::dvec3(0.5 * glm::dvec2(frame.size), 1.0)) *
                               glm::translate(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, 0.0));
  program.set("u_pixel_from_unit", glm::mat4(to_pixels * frame.clip_from_eye * frame.eye_from_unit));
  program.set("u_pixel_length", length);
}

}  // namespace

bool needs_detail(const ViewSettings& settings) {
  return settings.colour_mode == ColourMode::draft_angle || settings.facet_edges || settings.near_vertical ||
         settings.cut || settings.open_mold > 0.0 || settings.steel.shown;
}

void draw_background(ViewTools& tools, const ViewFrame& frame) {
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
                       .depth = gl::DepthTest::greater,
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
  if (compared) program.set("u_difference_colour", light_value(k_difference_mark));
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
  if (detail) set_detail(program, frame);
  tools.corners.draw();
}

}  // namespace moldlight
