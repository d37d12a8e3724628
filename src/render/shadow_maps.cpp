#include "render/shadow_maps.hpp"

#include <atomic>

#include "base/check.hpp"

namespace moldlight {

namespace {

float sign_of(bool plus) { return plus ? 1.0F : -1.0F; }

}  // namespace

void set_map_frame(const gl::Program& program, const MapFrame& frame, int resolution) {
  program.set("u_direction", glm::vec3(frame.z));
  program.set("u_map_x", glm::vec3(frame.x));
  program.set("u_map_y", glm::vec3(frame.y));
  program.set("u_map_size", static_cast<float>(resolution));
}

MapPainter::MapPainter(const gl::Functions& gl)
    : gl_(&gl),
      facets_(gl, {.vertex = "maps/second_depth.vert", .fragment = "maps/second_depth.frag"}),
      edges_(gl, {.vertex = "maps/contour_edge.vert", .fragment = "maps/contour_edge.frag"}),
      symmetric_edges_(gl, {.vertex = "maps/contour_edge.vert",
                            .fragment = "maps/contour_edge.frag",
                            .defines = {{"SYMMETRIC_KERNEL", "1"}}}),
      far_plane_(gl, {.vertex = "common/at_infinity.vert"}),
      fullscreen_(gl::make_vertex_array(gl)) {}

void MapPainter::draw_facets(const MapSubject& subject, bool plus) const {
  gl_->Viewport(0, 0, subject.settings.resolution, subject.settings.resolution);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthMask(GL_TRUE);
  gl_->DepthFunc(GL_LESS);
  const GLuint none[4] = {0, 0, 0, 0};
  const GLfloat furthest = 1.0F;
  gl_->ClearBufferuiv(GL_COLOR, 0, none);
  gl_->ClearBufferfv(GL_DEPTH, 0, &furthest);

  // Both maps share their axes, so in both a facet that faces +d runs counter-clockwise. Each keeps the
  // facets that face away from its light.
  gl_->Enable(GL_CULL_FACE);
  gl_->CullFace(plus ? GL_FRONT : GL_BACK);
  facets_.use();
  set_map_frame(facets_, subject.frame, subject.settings.resolution);
  facets_.set("u_side", sign_of(plus));
  subject.part.draw_facets();
  gl_->Disable(GL_CULL_FACE);
}

void MapPainter::draw_edges(const MapSubject& subject, bool plus) const {
  const MapSettings& settings = subject.settings;
  if (settings.edge_thickness <= 0.0) return;
  gl_->Viewport(0, 0, settings.resolution, settings.resolution);
  gl_->Enable(GL_DEPTH_TEST);
  const gl::Program& program = settings.symmetric_kernel ? symmetric_edges_ : edges_;
  program.use();
  set_map_frame(program, subject.frame, settings.resolution);
  program.set("u_side", sign_of(plus));
  program.set("u_half_width", static_cast<float>(0.5 * settings.edge_thickness / settings.resolution));
  program.set_texture("t_facet_class", 0, GL_TEXTURE_BUFFER, subject.facet_classes);
  if (!settings.symmetric_kernel)
    program.set_texture("t_planes", 1, GL_TEXTURE_BUFFER, subject.part.planes());
  subject.part.draw_concave_edges();
}

void MapPainter::count_covered(const gl::Query& query) const {
  // What is nearer than the far plane.
  gl_->DepthFunc(GL_GREATER);
  gl_->DepthMask(GL_FALSE);
  gl_->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  far_plane_.use();
  gl_->BindVertexArray(fullscreen_.name());
  gl_->BeginQuery(GL_SAMPLES_PASSED, query.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  gl_->EndQuery(GL_SAMPLES_PASSED);
  gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_->DepthMask(GL_TRUE);
  gl_->DepthFunc(GL_LESS);
}

ShadowMaps::ShadowMaps(const gl::Functions& gl) : gl_(&gl), painter_(gl) {}

void ShadowMaps::begin(const MapFrame& frame, const MapSettings& settings) {
  frame_ = frame;
  settings_ = settings;
  // Views tell drawings apart by it, also those of several pairs of maps.
  static std::atomic<std::uint64_t> drawings = 0;
  revision_ = ++drawings;
  if (settings.resolution == allocated_) return;
  allocated_ = 0;
  for (Side* side : {&plus_, &minus_}) {
    *side = {};
    side->facets = gl::make_texture_2d(*gl_, GL_R32UI, settings.resolution, settings.resolution);
    side->depth = gl::make_texture_2d(*gl_, GL_DEPTH_COMPONENT32F, settings.resolution, settings.resolution);
    side->framebuffer = gl::make_framebuffer(*gl_, side->facets, &side->depth);
  }
  allocated_ = settings.resolution;
}

void ShadowMaps::draw(const PartBuffers& part, const MapFrame& frame, const MapSettings& settings) {
  begin(frame, settings);
  const MapSubject subject{part, part.facet_classes(), frame_, settings_};
  for (const bool plus : {true, false}) {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, side(plus).framebuffer.name());
    painter_.draw_facets(subject, plus);
    painter_.draw_edges(subject, plus);
  }
  gl::check_errors(*gl_, "drawing the shadow maps");
}

void ShadowMaps::load(const MapFrame& frame, const MapSettings& settings, std::span<const std::uint32_t> plus,
                      std::span<const std::uint32_t> minus) {
  const auto size = static_cast<std::size_t>(settings.resolution);
  CHECK(!settings.symmetric_kernel && plus.size() == size * size && minus.size() == size * size);
  begin(frame, settings);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->ActiveTexture(GL_TEXTURE0);
  for (const bool of_plus : {true, false}) {
    gl_->BindTexture(GL_TEXTURE_2D, side(of_plus).facets.name());
    gl_->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, settings.resolution, settings.resolution, GL_RED_INTEGER,
                       GL_UNSIGNED_INT, (of_plus ? plus : minus).data());
  }
  gl::check_errors(*gl_, "uploading the shadow maps");
}

void ShadowMaps::load_depths(std::span<const float> plus, std::span<const float> minus) {
  const auto size = static_cast<std::size_t>(settings_.resolution);
  CHECK(plus.size() == size * size && minus.size() == size * size);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->ActiveTexture(GL_TEXTURE0);
  for (const bool of_plus : {true, false}) {
    gl_->BindTexture(GL_TEXTURE_2D, side(of_plus).depth.name());
    gl_->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, settings_.resolution, settings_.resolution, GL_DEPTH_COMPONENT,
                       GL_FLOAT, (of_plus ? plus : minus).data());
  }
  gl::check_errors(*gl_, "uploading depths of the shadow maps");
}

void ShadowMaps::bind(const gl::Program& program, const PartBuffers& part, int first_unit) const {
  set_map_frame(program, frame_, settings_.resolution);
  program.set_texture("t_facet_class", first_unit, GL_TEXTURE_BUFFER, part.facet_classes());
  if (settings_.symmetric_kernel) {
    program.set_texture("t_depth_plus", first_unit + 1, GL_TEXTURE_2D, plus_.depth);
    program.set_texture("t_depth_minus", first_unit + 2, GL_TEXTURE_2D, minus_.depth);
    program.set("u_kernel_radius", settings_.kernel_radius);
  } else {
    program.set_texture("t_map_plus", first_unit + 1, GL_TEXTURE_2D, plus_.facets);
    program.set_texture("t_map_minus", first_unit + 2, GL_TEXTURE_2D, minus_.facets);
    program.set("u_lateral", static_cast<float>(settings_.lateral));
  }
  if (program.has("t_planes"))
    program.set_texture("t_planes", first_unit + 3, GL_TEXTURE_BUFFER, part.planes());
}

}  // namespace moldlight
