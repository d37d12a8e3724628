#include "render/map_painter.hpp"

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

}  // namespace moldlight
