// The part on the GPU: what does not depend on the parting direction; and the facet classes, which do.
#pragma once

#include <span>

#include "gl/objects.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/draft.hpp"

namespace moldlight {

/// What goes there, in model units.
struct PartShape {
  const TriangleMesh& mesh;
  const FacetGeometry& geometry;
  const UnitFrame& frame;
  std::span<const FacetEdge> concave_edges;
};

/// All coordinates are in the unit frame. Valid for one context, which must be current for every call.
class PartBuffers {
 public:
  PartBuffers(const gl::Functions& gl, const PartShape& shape);

  /// Draws every facet once, shared vertices, position at attribute 0; gl_PrimitiveID is the facet.
  void draw_facets() const;
  /// Draws a strip of four corners for each concave edge: ends at attributes 0 and 1, facets at 2.
  void draw_concave_edges() const;
  /// Draws three corners a facet without attributes: gl_VertexID / 3 is the facet.
  void draw_corners() const;

  [[nodiscard]] const gl::Texture& planes() const { return planes_; }        // RGBA32F, one a facet
  [[nodiscard]] const gl::Texture& positions() const { return positions_; }  // R32F, three a vertex
  [[nodiscard]] const gl::Texture& corners() const { return corners_; }      // R32UI, three a facet
  [[nodiscard]] std::size_t facet_count() const { return facet_count_; }

 private:
  const gl::Functions* gl_;
  std::size_t facet_count_ = 0, concave_edge_count_ = 0;
  gl::Buffer position_buffer_, corner_buffer_, plane_buffer_, edge_buffer_;
  gl::Texture positions_, corners_, planes_;
  gl::VertexArray facets_, edges_, no_attributes_;
};

/// The class of a facet whose samples are not to be counted; it is drawn as before.
[[nodiscard]] constexpr FacetClass left_out(FacetClass own) {
  return static_cast<FacetClass>(static_cast<std::uint8_t>(own) | 4U);
}
[[nodiscard]] constexpr FacetClass counted(FacetClass of_facet) {
  return static_cast<FacetClass>(static_cast<std::uint8_t>(of_facet) & 3U);
}

/// The class of each facet for a direction, as shaders/common/facets.glsl reads it. Valid for one context.
class FacetClassBuffer {
 public:
  void set(const gl::Functions& gl, std::span<const FacetClass> classes);
  [[nodiscard]] const gl::Texture& texels() const { return texels_; }  // R8UI, one a facet

 private:
  gl::Buffer buffer_;
  gl::Texture texels_;
  std::size_t size_ = 0;
};

}  // namespace moldlight
