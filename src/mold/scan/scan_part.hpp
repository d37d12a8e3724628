// A part laid out for scan conversion: what does not depend on the parting direction, shared by all threads.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/edges.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mesh/unit_frame.hpp"

namespace moldlight {

/// Outward unit normal and offset of a facet, unit frame; n.p = offset on the facet. The values are those in
/// the shaders.
struct FacetPlane {
  float x = 0, y = 0, z = 0, offset = 0;
};

/// Immutable; unit frame throughout. Holds references to the mesh and its geometry, which must outlive it.
class ScanPart {
 public:
  ScanPart(const TriangleMesh& mesh, const FacetGeometry& geometry, const UnitFrame& frame,
           std::span<const FacetEdge> concave_edges);

  struct Position {
    float x = 0, y = 0, z = 0, unused = 0;
  };
  /// Components of the facets' normals, one array each, padded with zeros to a multiple of k_padding.
  struct Normals {
    std::vector<float> x, y, z;
  };
  static constexpr std::size_t k_padding = 8;

  [[nodiscard]] const std::vector<Position>& positions() const { return positions_; }
  [[nodiscard]] glm::vec3 position(VertexIndex vertex) const {
    return {positions_[vertex].x, positions_[vertex].y, positions_[vertex].z};
  }
  [[nodiscard]] const std::vector<std::array<VertexIndex, 3>>& facets() const { return mesh_->facets; }
  [[nodiscard]] const Normals& normals() const { return normals_; }
  [[nodiscard]] const std::vector<FacetPlane>& planes() const { return planes_; }
  [[nodiscard]] glm::vec3 normal(FacetIndex facet) const {
    return {planes_[facet].x, planes_[facet].y, planes_[facet].z};
  }
  /// Areas in the unit frame (diagonal squared), padded like the normals.
  [[nodiscard]] const std::vector<float>& areas() const { return areas_; }
  /// Facets close to one another that face about the same way; every facet belongs to one cluster. Clusters
  /// with close numbers are close to one another.
  struct Cluster {
    glm::vec3 axis{0, 0, 1};               // unit
    float cone_cosine = 0, cone_sine = 0;  // half the angle of a cone about the axis that holds all normals
    float area = 0;                        // unit frame squared
    std::uint32_t first = 0, count = 0;    // of its facets, neighbours following each other
  };
  struct Clusters {
    std::vector<Cluster> all;
    std::vector<std::uint32_t> of_facet;
    std::vector<FacetIndex> facets;

    [[nodiscard]] std::span<const FacetIndex> facets_of(const Cluster& cluster) const {
      return std::span(facets).subspan(cluster.first, cluster.count);
    }
  };
  /// Found when they are first asked for: maps alone need none.
  [[nodiscard]] const Clusters& clusters() const;
  [[nodiscard]] std::span<const FacetEdge> concave_edges() const { return concave_edges_; }
  [[nodiscard]] const FacetGeometry& geometry() const { return *geometry_; }
  [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const UnitFrame& frame() const { return frame_; }

 private:
  [[nodiscard]] Clusters find_clusters() const;

  const TriangleMesh* mesh_;
  const FacetGeometry* geometry_;
  UnitFrame frame_;
  std::span<const FacetEdge> concave_edges_;
  std::vector<Position> positions_;
  Normals normals_;
  std::vector<FacetPlane> planes_;
  std::vector<float> areas_;
  mutable std::once_flag clusters_asked_;
  mutable Clusters clusters_;
};

}  // namespace moldlight
