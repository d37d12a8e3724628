// Welding by an open-addressing hash table over the bits of the coordinates; the table holds vertex numbers
// only.
#include "mesh/weld.hpp"

#include <bit>

#include "base/check.hpp"

namespace moldlight {
namespace {

constexpr VertexIndex k_empty = std::numeric_limits<VertexIndex>::max();

std::uint64_t mix(std::uint64_t bits) {
  bits ^= bits >> 32;
  bits *= 0x9E3779B97F4A7C15u;
  bits ^= bits >> 29;
  bits *= 0xBF58476D1CE4E5B9u;
  return bits ^ (bits >> 32);
}

std::size_t hash_of(const glm::dvec3& point) {
  // Adding 0.0 turns -0.0 into 0.0, so that points that compare equal have equal bits.
  const std::uint64_t x = std::bit_cast<std::uint64_t>(point.x + 0.0);
  const std::uint64_t y = std::bit_cast<std::uint64_t>(point.y + 0.0);
  const std::uint64_t z = std::bit_cast<std::uint64_t>(point.z + 0.0);
  return static_cast<std::size_t>(mix(x + mix(y + mix(z))));
}

/// Numbers distinct points in order of first appearance.
class PointTable {
 public:
  explicit PointTable(std::vector<glm::dvec3>& points) : points_(points), slots_(1024, k_empty) {}

  VertexIndex number_of(const glm::dvec3& point) {
    std::size_t slot = find_slot(point);
    if (slots_[slot] != k_empty) return slots_[slot];
    if (2 * (points_.size() + 1) > slots_.size()) {
      grow();
      slot = find_slot(point);
    }
    CHECK(points_.size() < k_empty);
    slots_[slot] = static_cast<VertexIndex>(points_.size());
    points_.push_back(point + 0.0);
    return slots_[slot];
  }

 private:
  /// The slot that holds the point, or the empty one where it belongs.
  [[nodiscard]] std::size_t find_slot(const glm::dvec3& point) const {
    std::size_t slot = hash_of(point) & (slots_.size() - 1);
    while (slots_[slot] != k_empty && points_[slots_[slot]] != point) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    slots_.assign(4 * slots_.size(), k_empty);
    for (std::size_t vertex = 0; vertex < points_.size(); ++vertex) {
      slots_[find_slot(points_[vertex])] = static_cast<VertexIndex>(vertex);
    }
  }

  std::vector<glm::dvec3>& points_;
  std::vector<VertexIndex> slots_;  // a power of two, at most half full
};

}  // namespace

TriangleMesh weld_corners(std::span<const glm::dvec3> corners) {
  CHECK(corners.size() % 3 == 0);
  TriangleMesh welded;
  welded.facets.reserve(corners.size() / 3);
  PointTable table(welded.vertices);
  for (std::size_t first = 0; first < corners.size(); first += 3) {
    const VertexIndex a = table.number_of(corners[first]);
    const VertexIndex b = table.number_of(corners[first + 1]);
    const VertexIndex c = table.number_of(corners[first + 2]);
    welded.facets.push_back({a, b, c});
  }
  return welded;
}

TriangleMesh weld_vertices(const TriangleMesh& mesh) {
  TriangleMesh welded;
  welded.facets = mesh.facets;
  PointTable table(welded.vertices);
  std::vector<VertexIndex> new_number(mesh.vertices.size(), k_empty);
  for (auto& facet : welded.facets) {
    for (VertexIndex& vertex : facet) {
      if (new_number[vertex] == k_empty) new_number[vertex] = table.number_of(mesh.vertices[vertex]);
      vertex = new_number[vertex];
    }
  }
  return welded;
}

}  // namespace moldlight
