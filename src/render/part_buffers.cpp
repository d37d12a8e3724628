#include "render/part_buffers.hpp"

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace moldlight {

namespace {

struct EdgeInstance {
  glm::vec3 start, end;
  std::array<FacetIndex, 2> facets;
};

std::vector<glm::vec4> unit_planes(const PartShape& shape) {
  const TriangleMesh& mesh = shape.mesh;
  std::vector<glm::vec4> planes;
  planes.reserve(mesh.facets.size());
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3& normal = shape.geometry.normals[facet];
    const double offset =
        glm::dot(normal, (mesh.corner(facet, 0) - shape.frame.center) / shape.frame.diagonal);
    planes.emplace_back(glm::vec3(normal), static_cast<float>(offset));
  }
  return planes;
}

}  // namespace

PartBuffers::PartBuffers(const gl::Functions& gl, const PartShape& shape)
    : gl_(&gl), facet_count_(shape.mesh.facets.size()), concave_edge_count_(shape.concave_edges.size()) {
  const std::vector<glm::vec3> unit = unit_positions(shape.mesh, shape.frame);
  position_buffer_ = gl::make_buffer(gl, GL_ARRAY_BUFFER, std::span<const glm::vec3>(unit));
  positions_ = gl::make_buffer_texture(gl, GL_R32F, position_buffer_);
  facets_ = gl::make_vertex_array(gl);
  gl.BindVertexArray(facets_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, position_buffer_.name());
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(0);
  corner_buffer_ = gl::make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER,
                                   std::span<const std::array<VertexIndex, 3>>(shape.mesh.facets));
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, corner_buffer_.name());
  gl.BindVertexArray(0);
  corners_ = gl::make_buffer_texture(gl, GL_R32UI, corner_buffer_);

  const std::vector<glm::vec4> planes = unit_planes(shape);
  plane_buffer_ = gl::make_buffer(gl, GL_TEXTURE_BUFFER, std::span<const glm::vec4>(planes));
  planes_ = gl::make_buffer_texture(gl, GL_RGBA32F, plane_buffer_);

  std::vector<EdgeInstance> instances;
  instances.reserve(concave_edge_count_);
  for (const FacetEdge& edge : shape.concave_edges)
    instances.push_back({unit[edge.a], unit[edge.b], {edge.left, edge.right}});
  edges_ = gl::make_vertex_array(gl);
  gl.BindVertexArray(edges_.name());
  edge_buffer_ = gl::make_buffer(gl, GL_ARRAY_BUFFER, std::span<const EdgeInstance>(instances));
  gl.BindBuffer(GL_ARRAY_BUFFER, edge_buffer_.name());
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(EdgeInstance),
                         offset(offsetof(EdgeInstance, start)));
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(EdgeInstance), offset(offsetof(EdgeInstance, end)));
  gl.VertexAttribIPointer(2, 2, GL_UNSIGNED_INT, sizeof(EdgeInstance),
                          offset(offsetof(EdgeInstance, facets)));
  for (GLuint attribute = 0; attribute < 3; ++attribute) {
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribDivisor(attribute, 1);
  }
  gl.BindVertexArray(0);
  no_attributes_ = gl::make_vertex_array(gl);
  gl::check_errors(gl, "uploading the part");
}

void PartBuffers::draw_facets() const {
  gl_->BindVertexArray(facets_.name());
  gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * facet_count_), GL_UNSIGNED_INT, nullptr);
}

void PartBuffers::draw_concave_edges() const {
  if (concave_edge_count_ == 0) return;
  gl_->BindVertexArray(edges_.name());
  gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(concave_edge_count_));
}

void PartBuffers::draw_corners() const {
  gl_->BindVertexArray(no_attributes_.name());
  gl_->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * facet_count_));
}

void FacetClassBuffer::set(const gl::Functions& gl, std::span<const FacetClass> classes) {
  if (classes.size() != size_) {
    buffer_ = gl::make_buffer(gl, GL_TEXTURE_BUFFER, classes);
    texels_ = gl::make_buffer_texture(gl, GL_R8UI, buffer_);
    size_ = classes.size();
    return;
  }
  gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
  gl.BufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(classes.size_bytes()), classes.data());
}

}  // namespace moldlight
