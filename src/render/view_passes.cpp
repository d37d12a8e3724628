#include "render/view_passes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
#include "render/view_colours.hpp"
#include "render/view_geometry.hpp"

namespace moldlight {

namespace {

constexpr std::uint32_t k_undercut_bits = 1U << 0, k_core_bits = 1U << 1, k_cavity_bits = 1U << 2,
                        k_both_bits = 1U << 3;

/// Ambient occlusion looks this far, in the unit frame, but no further than a share of the picture's height.
constexpr double k_openness_radius = 0.09, k_openness_share = 0.11;

constexpr double k_hatch_pitch_px = 7.0, k_hatch_strength = 0.30;
constexpr double k_level_pitch_px = 6.0;
constexpr int k_arrow_sides = 48;
constexpr int k_first_map_unit = 7;  // of the shading's textures

bool opened(const ViewFrame& frame) { return frame.settings.open_mold > 0.0; }

bool by_region(const ViewFrame& frame, Layer layer) {
  return opened(frame) || layer == Layer::undercuts_alone;
}

bool needs_detail(const ViewSettings& settings) {
  return settings.colour_mode == ColourMode::draft_angle || settings.facet_edges || settings.near_vertical ||
         settings.section || settings.open_mold > 0.0;
}

bool shows_regions(const ViewSettings& settings) {
  return settings.colour_mode != ColourMode::plain || needs_detail(settings) ||
         settings.others_opacity < 1.0 || settings.mark_difference;
}

/// True if the split surface's own regions are shown.
bool exact(const ViewFrame& frame, const ViewSubject& subject) {
  return subject.split != nullptr &&
         (subject.maps == nullptr || frame.settings.regions_by == RegionsBy::exact);
}

std::string_view symmetric(const ViewSubject& subject) {
  return subject.maps != nullptr && subject.maps->settings().symmetric_kernel ? "SYMMETRIC_KERNEL" : "";
}

std::string element(const char* name, std::size_t index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

}  // namespace

ViewSubject asked_for(const ViewSubject& subject, const ViewSettings& settings) {
  ViewSubject asked = subject;
  if (!shows_regions(settings)) {
    asked.maps = nullptr;
    asked.split = nullptr;
    return asked;
  }
  CHECK(subject.maps != nullptr || subject.split != nullptr);
  if (subject.maps == nullptr || subject.split == nullptr || settings.mark_difference) return asked;
  if (settings.regions_by == RegionsBy::exact) {
    asked.maps = nullptr;
  } else {
    asked.split = nullptr;
  }
  return asked;
}

ViewPasses::ViewPasses(const gl::Functions& gl, const ViewGeometry& geometry)
    : gl_(&gl), programs_(gl), mesh_(gl, geometry), fullscreen_(gl::make_vertex_array(gl)) {}

void ViewPasses::test_depth(GLenum function, bool writes) const {
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthFunc(function);
  gl_->DepthMask(writes ? GL_TRUE : GL_FALSE);
}

void ViewPasses::draw_fullscreen() const {
  gl_->BindVertexArray(fullscreen_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<ViewPasses::Piece> ViewPasses::pieces(const ViewFrame& frame, Layer layer) {
  if (layer == Layer::undercuts_alone) return {{glm::vec3(0.0F), k_undercut_bits}};
  const glm::vec3 shift(frame.settings.open_mold * frame.direction);
  return {{glm::vec3(0.0F), k_undercut_bits | k_both_bits}, {shift, k_core_bits}, {-shift, k_cavity_bits}};
}

void ViewPasses::draw_surface(const ViewFrame& frame, const ViewTargets& targets, Layer layer,
                              const ViewSubject& subject) {
  const GLuint nothing[4] = {0, 0, 0, 0};
  const GLfloat furthest = 1.0F;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_surface.name());
  test_depth(GL_LESS, true);
  gl_->ClearBufferuiv(GL_COLOR, 0, nothing);
  gl_->ClearBufferfv(GL_DEPTH, 0, &furthest);
  const bool separate = by_region(frame, layer), cut = frame.settings.section.has_value();
  if (mesh_.closed() && !separate && !cut) {
    gl_->Enable(GL_CULL_FACE);
    gl_->CullFace(GL_BACK);
  }
  const bool split = subject.split != nullptr, look_up = separate && !exact(frame, subject);
  const TriangleBuffer& triangles = split ? subject.split->triangles() : mesh_.facets();
  const gl::Program& program =
      programs_.use("view/geometry.vert", "view/geometry.frag",
                    {split ? "SPLIT" : "", separate ? "BY_REGION" : "", look_up ? "LOOK_UP" : "",
                     look_up ? symmetric(subject) : "", cut ? "SECTION" : ""});
  program.set("u_clip_from_unit", frame.clip_from_unit);
  if (split) program.set_texture("t_sources", 0, GL_TEXTURE_BUFFER, subject.split->sources());
  if (cut) begin_section(program, frame);
  if (look_up) subject.maps->bind(program, subject.part, 1);
  if (separate) {
    for (const Piece& piece : pieces(frame, layer)) {
      program.set("u_shift", piece.shift);
      program.set("u_regions", piece.regions);
      triangles.draw(*gl_);
    }
  } else {
    triangles.draw(*gl_);
  }
  gl_->Disable(GL_CULL_FACE);
  if (cut) {
    gl_->Disable(GL_CLIP_DISTANCE0);
    if (!separate) draw_cut(frame, targets);
  }
}

void ViewPasses::begin_section(const gl::Program& program, const ViewFrame& frame) const {
  program.set("u_section_normal", glm::vec3(frame.direction));
  program.set("u_section_offset", static_cast<float>(*frame.settings.section));
  gl_->Enable(GL_CLIP_DISTANCE0);
}

void ViewPasses::draw_cut(const ViewFrame& frame, const ViewTargets& targets) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_depth.name());
  gl_->DepthFunc(GL_ALWAYS);
  const gl::Program& program = programs_.use("common/fullscreen.vert", "view/cut_depth.frag");
  program.set_texture("t_surface", 0, GL_TEXTURE_2D, targets.surface);
  program.set("u_section",
              glm::vec4(glm::vec3(frame.direction), static_cast<float>(*frame.settings.section)));
  program.set("u_clip_from_unit", frame.clip_from_unit);
  frame.set_sight(program);
  draw_fullscreen();
}

void ViewPasses::draw_openness(const ViewFrame& frame, const ViewTargets& targets, int taps) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_openness.name());
  if (taps == 0) {
    const GLfloat open[4] = {1.0F, 1.0F, 1.0F, 1.0F};
    gl_->ClearBufferfv(GL_COLOR, 0, open);
    return;
  }
  gl_->Disable(GL_DEPTH_TEST);
  const gl::Program& program = programs_.use("common/fullscreen.vert", "view/openness.frag");
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
  program.set("u_radius", static_cast<float>(radius));
  program.set("u_radius_px", static_cast<float>(radius / scale));
  program.set("u_cut", glm::vec4(frame.direction, frame.settings.section && !opened(frame) ? 1.0 : 0.0));
  program.set("u_taps", taps);
  program.set("u_sample", frame.sample);
  draw_fullscreen();
}

void ViewPasses::draw_background(const ViewFrame& frame, const ViewTargets& targets) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_colour.name());
  const BackdropColours colours = backdrop_colours(frame.settings.theme);
  if (frame.settings.backdrop != Backdrop::gradient) {
    const glm::vec3 flat = screen_value(colours.below);
    const bool none = frame.settings.backdrop == Backdrop::none;
    const GLfloat values[4] = {none ? 0.0F : flat.x, none ? 0.0F : flat.y, none ? 0.0F : flat.z,
                               none ? 0.0F : 1.0F};
    gl_->ClearBufferfv(GL_COLOR, 0, values);
    return;
  }
  test_depth(GL_EQUAL, false);
  const gl::Program& program = programs_.use("common/at_infinity.vert", "view/background.frag");
  program.set("u_above", screen_value(colours.above));
  program.set("u_below", screen_value(colours.below));
  program.set("u_size", glm::vec2(frame.size));
  program.set("u_sample", frame.sample);
  draw_fullscreen();
}

void ViewPasses::shade(const ViewFrame& frame, const ViewTargets& targets, Layer layer,
                       const ViewSubject& subject) {
  const ViewSettings& settings = frame.settings;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_shaded.name());
  test_depth(GL_GREATER, false);
  const bool detail = needs_detail(settings), plain = !shows_regions(settings);
  const bool known = exact(frame, subject) || by_region(frame, layer);
  const bool compared = subject.maps != nullptr && subject.split != nullptr;
  const bool look_up = !plain && (!known || (compared && exact(frame, subject)));
  const gl::Program& program =
      programs_.use("common/at_infinity.vert", "view/shade.frag",
                    {plain ? "PLAIN" : "", known ? "KNOWN" : "", look_up ? "LOOK_UP" : "",
                     compared ? "COMPARED" : "", look_up ? symmetric(subject) : "", detail ? "DETAIL" : ""});
  program.set_texture("t_surface", 0, GL_TEXTURE_2D, targets.surface);
  program.set_texture("t_openness", 1, GL_TEXTURE_2D, targets.openness);
  if (look_up) {
    subject.maps->bind(program, subject.part, k_first_map_unit);
    frame.set_sight(program);
  }
  if (compared) program.set("u_difference_colour", light_value(k_difference_mark));
  const bool regions = settings.colour_mode == ColourMode::regions;
  for (unsigned bits = 0; bits < 4; ++bits) {
    const Region region = region_of((bits & 1U) != 0, (bits & 2U) != 0);
    program.set(element("u_colours", bits),
                light_value(regions ? region_colour(region, settings.palette) : k_plain_surface));
  }
  frame.set_eye_axes(program);
  if (!plain) {
    const glm::dvec2 origin =
        project(frame.camera, frame.size, glm::dvec3(0.0)).value_or(glm::dvec2(0.0)) + frame.shift_px;
    program.set("u_hatch_origin", glm::vec2(origin.x, frame.size.y - origin.y));
    program.set("u_hatch", glm::vec2(k_hatch_pitch_px * settings.pixel_scale,
                                     settings.hatch_undercut && regions ? k_hatch_strength : 0.0));
  }
  const bool ghost = settings.others_opacity < 1.0 && layer == Layer::whole;
  program.set("u_others_opacity", ghost ? static_cast<float>(settings.others_opacity) : 1.0F);
  if (detail) set_detail(program, frame, subject.part);
  if (ghost) {
    gl_->Enable(GL_BLEND);
    gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  draw_fullscreen();
  gl_->Disable(GL_BLEND);
}

void ViewPasses::set_detail(const gl::Program& program, const ViewFrame& frame,
                            const PartBuffers& part) const {
  const ViewSettings& settings = frame.settings;
  const double length = pixel_length(frame.camera, frame.size);
  program.set_texture("t_planes", 3, GL_TEXTURE_BUFFER, part.planes());
  program.set_texture("t_facet_class", 4, GL_TEXTURE_BUFFER, part.facet_classes());
  program.set_texture("t_positions", 5, GL_TEXTURE_BUFFER, part.positions());
  program.set_texture("t_corners", 6, GL_TEXTURE_BUFFER, part.corners());
  frame.set_sight(program);
  program.set("u_parting", glm::vec3(frame.direction));
  program.set("u_draft_colours", settings.colour_mode == ColourMode::draft_angle ? 1 : 0);
  const DraftScale scale = draft_scale(settings.tau_deg, settings.palette);
  for (std::size_t i = 0; i < scale.limits_deg.size(); ++i) {
    program.set(element("u_draft_sines", i), static_cast<float>(std::sin(glm::radians(scale.limits_deg[i]))));
  }
  for (std::size_t i = 0; i < scale.colours.size(); ++i) {
    program.set(element("u_draft", i), light_value(scale.colours[i]));
  }
  program.set("u_opened", static_cast<float>(settings.open_mold));
  program.set("u_facet_edge", settings.facet_edges ? static_cast<float>(0.5 * settings.pixel_scale) : 0.0F);
  program.set("u_facet_edge_colour", light_value({26, 28, 33}));
  // Level lines keep their distance on the screen within a factor of two, and their place on the part.
  const double wanted = k_level_pitch_px * settings.pixel_scale * length;
  program.set("u_level_step",
              settings.near_vertical ? static_cast<float>(std::exp2(std::ceil(std::log2(wanted)))) : 0.0F);
  program.set("u_level_colour", light_value({255, 255, 255}));
  program.set("u_section", settings.section && !opened(frame) ? 1 : 0);
  program.set("u_cut_colour", light_value(k_cut_surface));
  const glm::dmat4 to_pixels = glm::scale(glm::dmat4(1.0), glm::dvec3(0.5 * glm::dvec2(frame.size), 1.0)) *
                               glm::translate(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, 0.0));
  program.set("u_pixel_from_unit", glm::mat4(to_pixels * frame.clip_from_eye * frame.eye_from_unit));
  program.set("u_pixel_length", static_cast<float>(length));
}

void ViewPasses::draw_segments(const ViewFrame& frame, const ViewTargets& targets, const PartBuffers& part,
                               const SegmentBuffer& segments, const LineStyle& style) {
  if (segments.empty()) return;
  const bool moved = opened(frame);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_colour.name());
  test_depth(GL_LESS, false);
  gl_->Enable(GL_BLEND);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const gl::Program& program = programs_.use(
      "view/lines.vert", "view/lines.frag", {moved ? "OPENED" : "", frame.settings.section ? "SECTION" : ""});
  if (frame.settings.section) begin_section(program, frame);
  program.set_texture("t_segments", 0, GL_TEXTURE_BUFFER, segments.texels());
  program.set("u_eye_from_unit", glm::mat4(frame.eye_from_unit));
  program.set("u_clip_from_eye", glm::mat4(frame.clip_from_eye));
  program.set("u_size_px", glm::vec2(frame.size));
  const double half_width = 0.5 * style.width_px * frame.settings.pixel_scale + 0.5;
  program.set("u_half_width_px", static_cast<float>(half_width));
  const bool perspective = frame.camera.projection == Projection::perspective;
  const double lift = (half_width + 0.7) * pixel_length(frame.camera, frame.size);
  program.set("u_lift", static_cast<float>(perspective ? lift / frame.camera.eye_distance() : lift));
  program.set("u_perspective", perspective ? 1.0F : 0.0F);
  program.set("u_near", static_cast<float>(depth_range(frame.camera).near));
  program.set("u_colour", style.colour);
  if (moved) {
    program.set_texture("t_surface", 1, GL_TEXTURE_2D, targets.surface);
    program.set_texture("t_planes", 2, GL_TEXTURE_BUFFER, part.planes());
    frame.set_sight(program);
    frame.set_eye_depth(program);
    program.set("u_clip_from_unit", frame.clip_from_unit);
    program.set("u_slack", static_cast<float>(4.0 * lift));
    for (const Piece& piece : pieces(frame, Layer::whole)) {
      program.set("u_shift", piece.shift);
      program.set("u_regions", piece.regions);
      segments.draw(*gl_);
    }
  } else {
    program.set("u_shift", glm::vec3(0.0F));
    segments.draw(*gl_);
  }
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_CLIP_DISTANCE0);
}

void ViewPasses::draw_lines(const ViewFrame& frame, const ViewTargets& targets, const PartBuffers& part) {
  const ViewSettings& settings = frame.settings;
  const float opacity = 0.35F + 0.65F * static_cast<float>(settings.others_opacity);
  if (settings.feature_edges) {
    const Colour ink = settings.theme == Theme::dark ? Colour{14, 15, 18} : Colour{34, 38, 46};
    draw_segments(frame, targets, part, mesh_.feature_edges,
                  {glm::vec4(screen_value(ink), 0.8F * opacity), 1.1});
  }
  if (settings.contour_edges) {
    draw_segments(frame, targets, part, mesh_.convex_contour,
                  {glm::vec4(1.0F, 1.0F, 1.0F, 0.95F * opacity), 1.8});
    draw_segments(frame, targets, part, mesh_.concave_contour,
                  {glm::vec4(0.04F, 0.04F, 0.05F, opacity), 2.6});
  }
  // Dark below light: it stands out from every colour.
  const glm::vec3 mark = screen_value(k_hover_mark);
  draw_segments(frame, targets, part, mesh_.outline, {glm::vec4(0.0F, 0.0F, 0.0F, 0.75F), 4.2});
  draw_segments(frame, targets, part, mesh_.outline, {glm::vec4(mark, 1.0F), 2.2});
}

void ViewPasses::draw_arrows(const ViewFrame& frame, const ViewTargets& targets) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_colour.name());
  test_depth(GL_LESS, false);
  gl_->Enable(GL_CULL_FACE);
  gl_->CullFace(GL_BACK);
  gl_->BindVertexArray(fullscreen_.name());
  const gl::Program& program = programs_.use("view/arrow.vert", "view/arrow.frag");
  program.set("u_clip_from_unit", frame.clip_from_unit);
  program.set("u_sides", k_arrow_sides);
  frame.set_eye_axes(program);
  program.set("u_opacity", 1.0F);
  for (const bool plus : {true, false}) {
    const glm::dvec3 axis = plus ? frame.direction : -frame.direction;
    const PartingArrow arrow = parting_arrow(mesh_.extremes(), axis, frame.settings.open_mold);
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
    gl_->DrawArrays(GL_TRIANGLES, 0, 12 * k_arrow_sides);
  }
  gl_->Disable(GL_CULL_FACE);
}

void ViewPasses::accumulate(const ViewTargets& targets, bool first) {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets.to_sum.name());
  gl_->Disable(GL_DEPTH_TEST);
  if (!first) {
    gl_->Enable(GL_BLEND);
    gl_->BlendFunc(GL_ONE, GL_ONE);
  }
  const gl::Program& program = programs_.use("common/fullscreen.vert", "view/accumulate.frag");
  program.set_texture("t_colour", 0, GL_TEXTURE_2D, targets.colour);
  draw_fullscreen();
  gl_->Disable(GL_BLEND);
}

void ViewPasses::present(const ViewTargets& targets, int samples, GLuint framebuffer) {
  if (samples == 1) {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, targets.to_colour.name());
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    gl_->BlitFramebuffer(0, 0, targets.size.x, targets.size.y, 0, 0, targets.size.x, targets.size.y,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    return;
  }
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Disable(GL_DEPTH_TEST);
  const gl::Program& program = programs_.use("common/fullscreen.vert", "view/resolve.frag");
  program.set_texture("t_sum", 0, GL_TEXTURE_2D, targets.sum);
  program.set("u_weight", 1.0F / static_cast<float>(samples));
  draw_fullscreen();
}

void ViewPasses::draw_marks(const ViewTargets& targets, const ViewMarks& marks, GLuint framebuffer) {
  if (!marks.hovered && !marks.blocking && marks.undercut_glow <= 0.0 && !any_chosen_) return;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Enable(GL_BLEND);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  const gl::Program& program = programs_.use("common/fullscreen.vert", "view/marks.frag");
  program.set_texture("t_surface", 0, GL_TEXTURE_2D, targets.surface);
  program.set_texture("t_accessible", 1, GL_TEXTURE_2D, targets.accessible);
  if (!chosen_) choose_facets({});
  program.set_texture("t_chosen", 2, GL_TEXTURE_BUFFER, chosen_);
  program.set("u_any_chosen", any_chosen_ ? 1 : 0);
  const auto number = [](const std::optional<FacetIndex>& facet) { return facet ? *facet + 1 : 0U; };
  program.set("u_hovered", number(marks.hovered));
  program.set("u_blocking", number(marks.blocking));
  program.set("u_glow", static_cast<float>(marks.undercut_glow));
  program.set("u_hover_colour", screen_value(k_hover_mark));
  program.set("u_block_colour", screen_value(k_block_mark));
  draw_fullscreen();
  gl_->Disable(GL_BLEND);
}

void ViewPasses::choose_facets(std::span<const FacetIndex> facets) {
  std::vector<std::uint8_t> chosen(mesh_.facet_count(), 0);
  for (const FacetIndex facet : facets) chosen[facet] = 1;
  chosen_buffer_ = gl::make_buffer(*gl_, GL_TEXTURE_BUFFER, std::span<const std::uint8_t>(chosen));
  chosen_ = gl::make_buffer_texture(*gl_, GL_R8UI, chosen_buffer_);
  any_chosen_ = !facets.empty();
}

void ViewPasses::set_outline(std::span<const ViewSegment> segments) {
  mesh_.outline = SegmentBuffer(*gl_, segments);
}

void ViewPasses::set_contour_edges(std::span<const ViewSegment> convex,
                                   std::span<const ViewSegment> concave) {
  mesh_.convex_contour = SegmentBuffer(*gl_, convex);
  mesh_.concave_contour = SegmentBuffer(*gl_, concave);
}

}  // namespace moldlight
