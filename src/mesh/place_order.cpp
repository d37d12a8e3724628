#include "mesh/place_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace moldlight {

namespace {

constexpr int k_bits = 21;  // an axis, three of which fit into one word
constexpr double k_steps = 1 << k_bits;

/// The bits of a number below 2^21, each at every third place.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001F00000000FFFFu;
  bits = (bits | bits << 16) & 0x001F0000FF0000FFu;
  bits = (bits | bits << 8) & 0x100F00F00F00F00Fu;
  bits = (bits | bits << 4) & 0x10C30C30C30C30C3u;
  return (bits | bits << 2) & 0x1249249249249249u;
}

struct Place {
  std::uint64_t on_curve;
  VertexIndex vertex;
};

/// The step of a coordinate; halves, so that no box is too wide for a double.
std::uint64_t step(double value, double least, double half_width) {
  const double share = half_width > 0.0 ? (0.5 * value - 0.5 * least) / half_width : 0.0;
  return static_cast<std::uint64_t>(std::clamp(std::floor(share * k_steps), 0.0, k_steps - 1.0));
}

/// Each vertex's rank: along the curve, then by coordinates.
std::vector<VertexIndex> vertex_ranks(const std::vector<glm::dvec3>& vertices) {
  Bounds box;
  for (const glm::dvec3& vertex : vertices) box.add(vertex);
  double half_width = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    half_width = std::max(half_width, 0.5 * box.max[axis] - 0.5 * box.min[axis]);
  std::vector<Place> places(vertices.size());
  for (VertexIndex vertex = 0; vertex < vertices.size(); ++vertex) {
    std::uint64_t on_curve = 0;
    for (int axis = 0; axis < 3; ++axis)
      on_curve |= spread(step(vertices[vertex][axis], box.min[axis], half_width)) << axis;
    places[vertex] = {on_curve, vertex};
  }
  std::ranges::sort(places, [&](const Place& a, const Place& b) {
    if (a.on_curve != b.on_curve) return a.on_curve < b.on_curve;
    const glm::dvec3 &p = vertices[a.vertex], &q = vertices[b.vertex];
    return std::tie(p.x, p.y, p.z, a.vertex) < std::tie(q.x, q.y, q.z, b.vertex);
  });
  std::vector<VertexIndex> ranks(vertices.size());
  for (VertexIndex rank = 0; rank < places.size(); ++rank) ranks[places[rank].vertex] = rank;
  return ranks;
}

template <typename T>
void put_in_order(std::vector<T>& values, const std::vector<FacetIndex>& order) {
  std::vector<T> former = std::exchange(values, {});
  values.reserve(order.size());
  for (const FacetIndex facet : order) values.push_back(former[facet]);
}

}  // namespace

void put_in_place_order(Part& part, const Progress& progress) {
  constexpr const char* k_stage = "ordering";
  progress.report(k_stage, 0.0);
  TriangleMesh& mesh = part.mesh;
  const std::vector<VertexIndex> ranks = vertex_ranks(mesh.vertices);
  progress.report(k_stage, 0.4);
  std::vector<glm::dvec3> vertices(mesh.vertices.size());
  for (VertexIndex vertex = 0; vertex < ranks.size(); ++vertex)
    vertices[ranks[vertex]] = mesh.vertices[vertex];
  mesh.vertices = std::move(vertices);
  for (auto& corners : mesh.facets) {
    for (VertexIndex& corner : corners) corner = ranks[corner];
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  }
  std::vector<FacetIndex> order(mesh.facets.size());
  std::iota(order.begin(), order.end(), FacetIndex{0});
  for (const Body& body : part.bodies) {
    progress.report(k_stage, 0.5);
    std::ranges::sort(std::span(order).subspan(body.first_facet, body.facet_count),
                      [&](FacetIndex a, FacetIndex b) {
                        return std::tie(mesh.facets[a], a) < std::tie(mesh.facets[b], b);
                      });
  }
  progress.report(k_stage, 0.9);
  put_in_order(mesh.facets, order);
  if (!part.facet_source.empty()) put_in_order(part.facet_source, order);
  if (part.file_facets.empty())
    part.file_facets = std::move(order);
  else
    put_in_order(part.file_facets, order);
}

std::vector<FacetIndex> listed_facets(const Part& part) {
  std::vector<FacetIndex> listed(part.mesh.facets.size());
  std::iota(listed.begin(), listed.end(), FacetIndex{0});
  if (part.file_facets.empty()) return listed;
  for (const Body& body : part.bodies) {
    std::ranges::stable_sort(std::span(listed).subspan(body.first_facet, body.facet_count), {},
                             [&](FacetIndex facet) { return part.file_facets[facet]; });
  }
  return listed;
}

std::int64_t file_facet(const Part& part, FacetIndex facet) {
  if (part.file_facets.empty()) return facet;
  return part.file_facets[facet] == k_no_facet ? -1 : std::int64_t{part.file_facets[facet]};
}

}  // namespace moldlight
