#include "support/mesh_edits.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <span>

#include <glm/geometric.hpp>

#include "mesh/adjacency.hpp"

namespace moldlight::test {
namespace {

constexpr VertexIndex k_unsplit = std::numeric_limits<VertexIndex>::max();

struct LongEdge {
  double length = 0.0;
  VertexIndex low = 0, high = 0;
  std::vector<HalfEdgeIndex> uses;
};

/// Edges longer than 0.6 of the longest, longest first.
std::vector<LongEdge> long_edges(const TriangleMesh& mesh) {
  const EdgeTable table(mesh);
  const auto length_of = [&](VertexIndex low, VertexIndex high) {
    return glm::distance(mesh.vertices[low], mesh.vertices[high]);
  };
  double longest = 0.0;
  table.for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    longest = std::max(longest, length_of(low, uses[0].high));
  });
  std::vector<LongEdge> edges;
  table.for_each_edge([&](VertexIndex low, std::span<const EdgeUse> uses) {
    const double length = length_of(low, uses[0].high);
    if (length <= 0.6 * longest) return;
    edges.push_back({length, low, uses[0].high, {}});
    for (const EdgeUse& use : uses) edges.back().uses.push_back(use.half_edge);
  });
  std::stable_sort(edges.begin(), edges.end(),
                   [](const LongEdge& a, const LongEdge& b) { return a.length > b.length; });
  return edges;
}

/// Replaces a facet whose edges e have the new vertices split[e] (k_unsplit: none).
void split_facet(const std::array<VertexIndex, 3>& facet, const std::array<VertexIndex, 3>& split,
                 const TriangleMesh& mesh, std::vector<std::array<VertexIndex, 3>>& facets) {
  // Turned so that the split edges come first.
  std::size_t turn = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    if (split[e] != k_unsplit && split[(e + 2) % 3] == k_unsplit) turn = e;
  }
  const VertexIndex a = facet[turn], b = facet[(turn + 1) % 3], c = facet[(turn + 2) % 3];
  const VertexIndex ab = split[turn], bc = split[(turn + 1) % 3], ca = split[(turn + 2) % 3];
  if (ab == k_unsplit) {
    facets.push_back(facet);
  } else if (bc == k_unsplit) {
    facets.push_back({a, ab, c});
    facets.push_back({ab, b, c});
  } else if (ca == k_unsplit) {
    facets.push_back({ab, b, bc});
    // Of the two ways to cut the rest, the one with the shorter cut.
    if (glm::distance(mesh.vertices[a], mesh.vertices[bc]) <
        glm::distance(mesh.vertices[ab], mesh.vertices[c])) {
      facets.push_back({a, ab, bc});
      facets.push_back({a, bc, c});
    } else {
      facets.push_back({a, ab, c});
      facets.push_back({ab, bc, c});
    }
  } else {
    facets.push_back({a, ab, ca});
    facets.push_back({ab, b, bc});
    facets.push_back({ca, bc, c});
    facets.push_back({ab, bc, ca});
  }
}

}  // namespace

TriangleMesh translated(TriangleMesh mesh, const glm::dvec3& offset) {
  for (glm::dvec3& vertex : mesh.vertices) vertex += offset;
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (glm::dvec3& vertex : mesh.vertices) vertex *= factor;
  return mesh;
}

TriangleMesh rotated(TriangleMesh mesh, const glm::dquat& rotation) {
  for (glm::dvec3& vertex : mesh.vertices) vertex = rotation * vertex;
  return mesh;
}

TriangleMesh mirrored(TriangleMesh mesh) {
  for (glm::dvec3& vertex : mesh.vertices) vertex.x = -vertex.x;
  for (auto& facet : mesh.facets) std::swap(facet[1], facet[2]);
  return mesh;
}

TriangleMesh rounded_to_float(TriangleMesh mesh) {
  for (glm::dvec3& vertex : mesh.vertices) vertex = glm::dvec3(glm::vec3(vertex));
  return mesh;
}

glm::dquat random_rotation(std::uint32_t seed) {
  std::mt19937 random(seed);
  // Points of a ball, cast out to the sphere of unit quaternions. The engine alone: distributions differ by
  // library.
  const auto coordinate = [&random] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  for (;;) {
    const glm::dquat candidate(coordinate(), coordinate(), coordinate(), coordinate());
    const double length = glm::length(candidate);
    if (length > 0.1 && length <= 1.0) return candidate / length;
  }
}

TriangleMesh permuted(const TriangleMesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto shuffle = [&random](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
  };
  std::vector<VertexIndex> order(mesh.vertices.size()), new_number(mesh.vertices.size());
  for (VertexIndex i = 0; i < order.size(); ++i) order[i] = i;
  shuffle(order);
  TriangleMesh result;
  for (VertexIndex i = 0; i < order.size(); ++i) {
    new_number[order[i]] = i;
    result.vertices.push_back(mesh.vertices[order[i]]);
  }
  for (const auto& facet : mesh.facets) {
    const std::size_t first = random() % 3;
    result.facets.push_back(
        {new_number[facet[first]], new_number[facet[(first + 1) % 3]], new_number[facet[(first + 2) % 3]]});
  }
  shuffle(result.facets);
  return result;
}

TriangleMesh subdivided(TriangleMesh mesh, std::size_t target_facets) {
  std::mt19937 random(5489);
  while (mesh.facets.size() + 1 < target_facets) {
    std::size_t facets_left = target_facets - mesh.facets.size();
    std::vector<std::array<VertexIndex, 3>> split(mesh.facets.size(), {k_unsplit, k_unsplit, k_unsplit});
    for (const LongEdge& edge : long_edges(mesh)) {
      if (edge.uses.size() > facets_left) break;
      facets_left -= edge.uses.size();
      const double place = 0.42 + 0.16 * static_cast<double>(random()) / 4294967296.0;
      const auto vertex = static_cast<VertexIndex>(mesh.vertices.size());
      mesh.vertices.push_back(mesh.vertices[edge.low] +
                              place * (mesh.vertices[edge.high] - mesh.vertices[edge.low]));
      for (const HalfEdgeIndex use : edge.uses) split[facet_of(use)][use % 3] = vertex;
    }
    if (facets_left == target_facets - mesh.facets.size()) break;  // only edges of many facets are left
    std::vector<std::array<VertexIndex, 3>> facets;
    facets.reserve(target_facets);
    for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
      split_facet(mesh.facets[facet], split[facet], mesh, facets);
    }
    mesh.facets = std::move(facets);
  }
  return mesh;
}

TriangleMesh cut_in_four(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.vertices = mesh.vertices;
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middles;
  for (const auto& facet : mesh.facets) {
    std::array<VertexIndex, 3> middle{};
    for (std::size_t side = 0; side < 3; ++side) {
      const VertexIndex a = facet[side], b = facet[(side + 1) % 3];
      const auto [place, is_new] =
          middles.emplace(std::minmax(a, b), static_cast<VertexIndex>(result.vertices.size()));
      if (is_new) result.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
      middle[side] = place->second;
    }
    result.facets.push_back({facet[0], middle[0], middle[2]});
    result.facets.push_back({middle[0], facet[1], middle[1]});
    result.facets.push_back({middle[2], middle[1], facet[2]});
    result.facets.push_back({middle[0], middle[1], middle[2]});
  }
  return result;
}

}  // namespace moldlight::test
