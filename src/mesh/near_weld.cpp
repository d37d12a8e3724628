#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "mesh/edge_table.hpp"
#include "mesh/repair_steps.hpp"

namespace moldlight {

namespace {

/// A cube of space with edges of the tolerance; numbers too great for integers are fine.
struct Cell {
  double x, y, z;
  [[nodiscard]] bool operator==(const Cell&) const = default;
};
struct CellHash {
  [[nodiscard]] std::size_t operator()(const Cell& cell) const {
    const std::hash<double> hash;
    return (hash(cell.x) * 31 + hash(cell.y)) * 31 + hash(cell.z);
  }
};

std::vector<bool> vertices_of_open_edges(const TriangleMesh& mesh) {
  std::vector<bool> marked(mesh.vertices.size(), false);
  EdgeTable(mesh).for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    if (uses.size() == 1) marked[low] = marked[uses[0].high] = true;
  });
  return marked;
}

/// Vertices that others were welded to, findable by place.
class Anchors {
 public:
  Anchors(const TriangleMesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {}

  /// The nearest anchor within the tolerance, the first of equally near ones; the vertex becomes one where
  /// there is none.
  [[nodiscard]] VertexIndex find_or_add(VertexIndex vertex) {
    const glm::dvec3& point = mesh_.vertices[vertex];
    const Cell home = {std::floor(point.x / tolerance_), std::floor(point.y / tolerance_),
                       std::floor(point.z / tolerance_)};
    VertexIndex nearest = vertex;
    double least = tolerance_;
    for (double dx = -1.0; dx <= 1.0; dx += 1.0) {
      for (double dy = -1.0; dy <= 1.0; dy += 1.0) {
        for (double dz = -1.0; dz <= 1.0; dz += 1.0) {
          const auto cell = cells_.find({home.x + dx, home.y + dy, home.z + dz});
          if (cell == cells_.end()) continue;
          for (const VertexIndex anchor : cell->second) {
            const double distance = glm::distance(point, mesh_.vertices[anchor]);
            if (distance < least || (distance == least && (nearest == vertex || anchor < nearest))) {
              least = distance;
              nearest = anchor;
            }
          }
        }
      }
    }
    if (nearest == vertex) cells_[home].push_back(vertex);
    return nearest;
  }

 private:
  const TriangleMesh& mesh_;
  double tolerance_;
  std::unordered_map<Cell, std::vector<VertexIndex>, CellHash> cells_;
};

}  // namespace

std::size_t weld_near_vertices(TriangleMesh& mesh, double tolerance) {
  if (!(tolerance > 0.0)) return 0;
  const std::vector<bool> is_open = vertices_of_open_edges(mesh);
  std::vector<VertexIndex> new_vertex(mesh.vertices.size());
  Anchors anchors(mesh, tolerance);
  std::size_t welded = 0;
  for (VertexIndex vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    new_vertex[vertex] = is_open[vertex] ? anchors.find_or_add(vertex) : vertex;
    if (new_vertex[vertex] != vertex) ++welded;
  }
  for (auto& facet : mesh.facets) {
    for (VertexIndex& corner : facet) corner = new_vertex[corner];
  }
  return welded;
}

}  // namespace moldlight
