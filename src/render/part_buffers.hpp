// The part on the GPU: what does not depend on the parting direction, and the facet classes, which do.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "gl/objects.hpp"
#include "mesh/edges.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/draft.hpp"

namespace moldlight {

/// All coordinates are in the unit frame. Valid for one context, which must be current for every call.
class PartBuffers {
 public:
  PartBuffers(const gl::Functions& gl, const TriangleMesh& mesh, const FacetGeometry& geometry,
              const UnitFrame& frame, std::span<const FacetEdge> concave_edges);

  /// Draws every facet once, shared vertices, position at attribute 0; gl_PrimitiveID is the facet.
  void draw_facets() const;
  /// Draws a strip of four corners for each concave edge: ends at attributes 0 and 1, facets at 2.
  void draw_concave_edges() const;
  /// Draws three corners a facet without attributes: gl_VertexID / 3 is the facet.
  void draw_corners() const;

  /// Uploads the class of each facet for a direction.
  void set_facet_classes(std::span<const FacetClass> classes);

  [[nodiscard]] const gl::Texture& planes() const { return planes_; }          // RGBA32F, one a facet
  [[nodiscard]] const gl::Texture& facet_classes() const { return classes_; }  // R8UI, one a facet
  [[nodiscard]] const gl::Texture& positions() const { return positions_; }    // R32F, three a vertex
  [[nodiscard]] const gl::Texture& corners() const { return corners_; }        // R32UI, three a facet
  [[nodiscard]] std::size_t facet_count() const { return facet_count_; }

 private:
  const gl::Functions* gl_;
  std::size_t facet_count_ = 0, concave_edge_count_ = 0;
  gl::Buffer position_buffer_, corner_buffer_, plane_buffer_, class_buffer_, edge_buffer_;
  gl::Texture positions_, corners_, planes_, classes_;
  gl::VertexArray facets_, edges_, no_attributes_;
};

}  // namespace moldlight
