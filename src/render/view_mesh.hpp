// The part on the GPU as pictures draw it: smooth normals, and lines.
#pragma once

#include <span>
#include <vector>

#include "gl/objects.hpp"
#include "render/view_geometry.hpp"

namespace moldlight {

/// Segments as shaders/view/lines.vert reads them. Valid for one context.
class SegmentBuffer {
 public:
  SegmentBuffer() = default;
  SegmentBuffer(const gl::Functions& gl, std::span<const ViewSegment> segments);

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] const gl::Texture& texels() const { return texels_; }  // RGBA32F, two a segment
  /// Two triangles a segment; vertex 4 k + c is corner c of segment k.
  void draw(const gl::Functions& gl) const;

 private:
  std::size_t count_ = 0;
  gl::Buffer buffer_, index_buffer_;
  gl::Texture texels_;
  gl::VertexArray corners_;
};

/// Valid for one context, which must be current for every call.
class ViewMesh {
 public:
  ViewMesh(const gl::Functions& gl, const ViewGeometry& geometry);

  /// Draws every facet once: position at attribute 0, octahedral normal at 1; gl_PrimitiveID is the facet.
  void draw_facets() const;

  [[nodiscard]] std::size_t facet_count() const { return facet_count_; }
  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] std::span<const glm::vec3> extremes() const { return extremes_; }

  SegmentBuffer feature_edges, convex_contour, concave_contour, outline;

 private:
  const gl::Functions* gl_;
  std::size_t facet_count_ = 0;
  bool closed_ = false;
  std::vector<glm::vec3> extremes_;
  gl::Buffer vertex_buffer_, corner_buffer_;
  gl::VertexArray facets_;
};

}  // namespace moldlight
