// The two second-depth maps of a parting direction on the processor: a scan converter for exactly this job,
// on all cores. Same texel centres, twist and extent as the GL maps, and the same fill rule: corners snap to
// 1/256 of a texel, and a centre on a common edge belongs to one facet.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/draft.hpp"
#include "mold/map_frame.hpp"

namespace moldlight {

/// What a pair of maps is drawn of; all of it outlives the drawing.
struct SecondDepthPart {
  const TriangleMesh& mesh;
  std::span<const glm::vec3> positions;  // of the vertices, unit frame
  std::span<const glm::dvec3> normals;   // of the facets
  std::span<const FacetEdge> concave_edges;
};

class SecondDepthMaps {
 public:
  /// `resolution` texels along a side, [16, 8192]; takes 24 bytes a texel.
  explicit SecondDepthMaps(int resolution) { set_resolution(resolution); }
  /// Of what is drawn next; room that is there is kept.
  void set_resolution(int resolution);

  /// `classes`: of the facets, for the frame's direction; `edge_thickness`: width of the thick concave
  /// contour edges in texels. The same to the bit for any number of threads.
  void draw(const SecondDepthPart& part, const MapFrame& frame, std::span<const FacetClass> classes,
            double edge_thickness);

  /// Facet + 1 of the +d map (facets that face -d, furthest along +d) or of the -d map, 0 where there is
  /// none; rows from below. Until the next drawing.
  [[nodiscard]] const std::vector<std::uint32_t>& facets(bool plus) const { return facets_[plus ? 1 : 0]; }
  /// Depths of the same, from 0 next to the light to 1 where nothing is.
  [[nodiscard]] std::vector<float> depths(bool plus) const;

  [[nodiscard]] int resolution() const { return resolution_; }

 private:
  struct Corner {
    std::int32_t x, y;  // in 1/256 of a texel
    float height;       // along +d, in steps of the depth
  };
  using Triangle = std::array<Corner, 3>;
  /// The thick edges of one map, and the facets whose depths they carry on.
  struct Strips {
    std::vector<Triangle> triangles;
    std::vector<FacetIndex> facets;
  };
  struct Rows {
    int first, last;
  };

  [[nodiscard]] Triangle triangle_of(const TriangleMesh& mesh, FacetIndex facet) const {
    const auto& vertices = mesh.facets[facet];
    return {corners_[vertices[0]], corners_[vertices[1]], corners_[vertices[2]]};
  }
  [[nodiscard]] static Rows rows_of(const Triangle& triangle);
  [[nodiscard]] Corner corner(const glm::dvec3& point, const MapFrame& frame) const;
  void add_strips(const SecondDepthPart& part, const MapFrame& frame, std::span<const FacetClass> classes,
                  double half_width);
  void fill(Triangle triangle, FacetIndex facet, const Rows& rows, const bool* only_plus);

  int resolution_ = 0;
  std::vector<Corner> corners_;  // of the vertices
  std::vector<Rows> rows_;       // of the facets
  std::array<Strips, 2> strips_;
  /// By map, -d first: depth over inverted facet number, so that the greatest wins; 0 where nothing is.
  std::array<std::vector<std::uint64_t>, 2> maps_;
  std::array<std::vector<std::uint32_t>, 2> facets_;
};

}  // namespace moldlight
