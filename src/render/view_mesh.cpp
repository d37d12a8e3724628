#include "render/view_mesh.hpp"

#include <atomic>
#include <cstddef>

#include <glm/vec4.hpp>

namespace moldlight {

SegmentBuffer::SegmentBuffer(const gl::Functions& gl, std::span<const ViewSegment> segments)
    : count_(segments.size()) {
  if (segments.empty()) return;
  std::vector<glm::vec4> texels;
  std::vector<std::array<std::uint32_t, 6>> corners;
  texels.reserve(2 * count_);
  corners.reserve(count_);
  for (const ViewSegment& segment : segments) {
    const auto first = static_cast<std::uint32_t>(4 * corners.size());
    texels.emplace_back(segment.start, 0.0F);
    texels.emplace_back(segment.end, 0.0F);
    corners.push_back({first, first + 1, first + 2, first + 2, first + 1, first + 3});
  }
  buffer_ = gl::make_buffer(gl, GL_TEXTURE_BUFFER, std::span<const glm::vec4>(texels));
  texels_ = gl::make_buffer_texture(gl, GL_RGBA32F, buffer_);
  corners_ = gl::make_vertex_array(gl);
  gl.BindVertexArray(corners_.name());
  index_buffer_ =
      gl::make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, std::span<const std::array<std::uint32_t, 6>>(corners));
  gl.BindVertexArray(0);
}

void SegmentBuffer::draw(const gl::Functions& gl) const {
  gl.BindVertexArray(corners_.name());
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * count_), GL_UNSIGNED_INT, nullptr);
}

TriangleBuffer::TriangleBuffer(const gl::Functions& gl, std::span<const ViewVertex> vertices,
                               std::span<const std::array<VertexIndex, 3>> triangles)
    : count_(triangles.size()), triangles_(gl::make_vertex_array(gl)) {
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  gl.BindVertexArray(triangles_.name());
  vertex_buffer_ = gl::make_buffer(gl, GL_ARRAY_BUFFER, vertices);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_.name());
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ViewVertex),
                         offset(offsetof(ViewVertex, position)));
  gl.VertexAttribPointer(1, 2, GL_SHORT, GL_TRUE, sizeof(ViewVertex), offset(offsetof(ViewVertex, normal)));
  gl.EnableVertexAttribArray(0);
  gl.EnableVertexAttribArray(1);
  corner_buffer_ = gl::make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, triangles);
  gl.BindVertexArray(0);
  gl::check_errors(gl, "uploading the picture's mesh");
}

void TriangleBuffer::draw(const gl::Functions& gl) const {
  gl.BindVertexArray(triangles_.name());
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * count_), GL_UNSIGNED_INT, nullptr);
}

SplitSurface::SplitSurface(const gl::Functions& gl, const SplitGeometry& geometry,
                           std::span<const FacetClass> classes)
    : triangles_(gl, geometry.vertices, geometry.pieces),
      source_buffer_(
          gl::make_buffer(gl, GL_TEXTURE_BUFFER, std::span<const std::uint32_t>(geometry.sources))),
      sources_(gl::make_buffer_texture(gl, GL_R32UI, source_buffer_)) {
  // Views distinguish surfaces by it, wherever they lie in memory.
  static std::atomic<std::uint64_t> surfaces = 0;
  revision_ = ++surfaces;
  classes_.set(gl, classes);
}

FaceNumbers::FaceNumbers(const gl::Functions& gl, std::span<const std::uint32_t> of_facet)
    : buffer_(gl::make_buffer(gl, GL_TEXTURE_BUFFER, of_facet)),
      texels_(gl::make_buffer_texture(gl, GL_R32UI, buffer_)) {}

namespace {

std::optional<TriangleBuffer> some_solids(const gl::Functions& gl, const ViewGeometry& geometry) {
  if (geometry.all_solid) return std::nullopt;
  return std::optional<TriangleBuffer>(std::in_place, gl, geometry.vertices, geometry.solids);
}

}  // namespace

ViewMesh::ViewMesh(const gl::Functions& gl, const ViewGeometry& geometry)
    : facets(gl, geometry.vertices, geometry.facets),
      closed(geometry.closed),
      some_solid(some_solids(gl, geometry)),
      extremes(geometry.extremes),
      feature_edges(gl, geometry.feature_edges) {}

void ViewMesh::take(const gl::Functions& gl, const ViewGeometry& geometry) {
  facets = TriangleBuffer(gl, geometry.vertices, geometry.facets);
  feature_edges = SegmentBuffer(gl, geometry.feature_edges);
  some_solid = some_solids(gl, geometry);
}

}  // namespace moldlight
