// The part on the GPU as pictures draw it: smooth normals, lines, and where its regions come from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gl/objects.hpp"
#include "render/shadow_maps.hpp"
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

/// Triangles as shaders/view/geometry.vert reads them. Valid for one context.
class TriangleBuffer {
 public:
  TriangleBuffer(const gl::Functions& gl, std::span<const ViewVertex> vertices,
                 std::span<const std::array<VertexIndex, 3>> triangles);

  /// Position at attribute 0, octahedral normal at 1; gl_PrimitiveID is the triangle.
  void draw(const gl::Functions& gl) const;

 private:
  std::size_t count_;
  gl::Buffer vertex_buffer_, corner_buffer_;
  gl::VertexArray triangles_;
};

/// So many colours of moved steel has the shading beside those of Steel; the last is for all others.
inline constexpr std::size_t k_moved_colours = 13;

/// A surface whose regions are known (see split_geometry()), and the classes of the part's facets for its
/// direction. Valid for one context.
class SplitSurface {
 public:
  SplitSurface(const gl::Functions& gl, const SplitGeometry& geometry, std::span<const FacetClass> classes);

  [[nodiscard]] const TriangleBuffer& triangles() const { return triangles_; }
  [[nodiscard]] const gl::Texture& sources() const { return sources_; }  // R32UI, one a piece
  [[nodiscard]] const gl::Texture& classes() const { return classes_.texels(); }
  /// Another for every surface.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  TriangleBuffer triangles_;
  gl::Buffer source_buffer_;
  gl::Texture sources_;
  FacetClassBuffer classes_;
  std::uint64_t revision_;
};

/// The face of each facet, as shaders/view/marks.frag reads it; none as it is made. Valid for one context.
class FaceNumbers {
 public:
  FaceNumbers() = default;
  FaceNumbers(const gl::Functions& gl, std::span<const std::uint32_t> of_facet);

  [[nodiscard]] const gl::Texture& texels() const { return texels_; }  // R32UI, one a facet

 private:
  gl::Buffer buffer_;
  gl::Texture texels_;
};

/// Lines among the marks: outlines of the chosen face and of the blocking one; ways that are drawn with their
/// lengths.
enum class MarkedLines : std::uint8_t { chosen, blocking, ways };
inline constexpr std::size_t k_marked_lines = 3;

/// Valid for one context.
struct ViewMesh {
  ViewMesh(const gl::Functions& gl, const ViewGeometry& geometry);

  /// In place of the facets and edges that are there; what is marked stays.
  void take(const gl::Functions& gl, const ViewGeometry& geometry);

  TriangleBuffer facets;  // triangle k is facet k
  bool closed;
  /// The facets of bodies without open edges.
  [[nodiscard]] const TriangleBuffer& solids() const { return some_solid ? *some_solid : facets; }
  std::optional<TriangleBuffer> some_solid;  // where not all of them are
  std::vector<glm::vec3> extremes;
  SegmentBuffer feature_edges, parting_line;
  std::array<SegmentBuffer, k_marked_lines> marked;  // by MarkedLines
  std::optional<TriangleBuffer> veiled;
  struct Body {
    TriangleBuffer triangles;
    Colour colour;
  };
  std::vector<Body> bodies;
  struct Solid {
    TriangleBuffer triangles;
    SegmentBuffer edges;
    std::size_t colour = 0;  // its place among those of the shading: by Steel, then those that are moved
    SteelMotion motion;
  };
  std::vector<Solid> solids_around;   // of a mold
  std::vector<Colour> moved_colours;  // of those that are moved, at most k_moved_colours
  SegmentBuffer tube, chosen_tube;    // the mold's parting line, and the loop of it that is looked at
  FaceNumbers faces;
};

/// What a picture shows: a part, a parting direction, and where the regions come from. A plain picture needs
/// neither maps nor a split surface, any other at least one of them; to mark their difference takes both.
/// What is pointed at must live as long as a picture is drawn.
struct ViewSubject {
  const PartBuffers& part;
  glm::dvec3 direction{0.0, 0.0, 1.0};  // unit
  const ShadowMaps* maps = nullptr;     // drawn from `part` for the direction
  const SplitSurface* split = nullptr;  // of the part for the direction

  /// Of the facets; there are maps or a split surface.
  [[nodiscard]] const gl::Texture& classes() const {
    return maps != nullptr ? maps->classes() : split->classes();
  }
};

}  // namespace moldlight
