#include "mesh/file_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "base/check.hpp"
#include "mesh/symmetric_eigen.hpp"
#include "mesh/unit_frame.hpp"

namespace moldlight {

namespace {

using Axes = std::array<glm::dvec3, 3>;

/// The means of values at the vertices, each below 1: of whole numbers, so that they do not depend on the
/// order.
template <std::size_t N, typename Values>
std::array<double, N> means_of(const std::vector<glm::dvec3>& vertices, const Values& values) {
  const double whole = std::ldexp(1.0, 61 - static_cast<int>(std::bit_width(vertices.size())));
  std::array<std::int64_t, N> sums{};
  for (const glm::dvec3& vertex : vertices) {
    const std::array<double, N> its = values(vertex);
    for (std::size_t k = 0; k < N; ++k) sums[k] += static_cast<std::int64_t>(whole * its[k]);
  }
  std::array<double, N> means{};
  for (std::size_t k = 0; k < N; ++k)
    means[k] = static_cast<double>(sums[k]) / (whole * static_cast<double>(vertices.size()));
  return means;
}

/// The file's axes in the space of some of the surface's, each as far as it lies in it.
void take_file_axes(std::span<glm::dvec3> alike) {
  std::vector<glm::dvec3> found;
  for (std::size_t k = 0; k < alike.size(); ++k) {
    glm::dvec3 best(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 within(0.0);
      for (const glm::dvec3& vector : alike) within += vector[axis] * vector;
      for (const glm::dvec3& other : found) within -= glm::dot(within, other) * other;
      if (glm::length(within) > glm::length(best) + 1e-6) best = within;
    }
    found.push_back(glm::normalize(best));
  }
  std::ranges::copy(found, alike.begin());
}

/// Those of inertia of the vertices, each in the sense in which they are skewed, or else in the file's.
Axes vertex_axes(const std::vector<glm::dvec3>& vertices, const UnitFrame& frame) {
  constexpr double k_alike = 1e-3;     // of the sum of the moments
  constexpr double k_balanced = 1e-7;  // skew that rounding may make, cubes of the diagonal
  const double inverse = 1.0 / frame.diagonal;
  const auto [x, y, z] = means_of<3>(vertices, [&](const glm::dvec3& vertex) {
    const glm::dvec3 at = inverse * (vertex - frame.center);
    return std::array{at.x, at.y, at.z};
  });
  const glm::dvec3 centre(x, y, z);
  const auto [xx, xy, xz, yy, yz, zz] = means_of<6>(vertices, [&](const glm::dvec3& vertex) {
    const glm::dvec3 at = inverse * (vertex - frame.center) - centre;
    return std::array{at.x * at.x, at.x * at.y, at.x * at.z, at.y * at.y, at.y * at.z, at.z * at.z};
  });
  const glm::dmat3 moments(xx, xy, xz, xy, yy, yz, xz, yz, zz);
  const SymmetricEigen<3> eigen = symmetric_eigen<3>(moments);
  Axes axes = eigen.vectors;
  const double least = k_alike * (eigen.values[0] + eigen.values[1] + eigen.values[2]);
  for (std::size_t first = 0, end = 1; first < 3; first = end++) {
    while (end < 3 && eigen.values[end] - eigen.values[end - 1] < least) ++end;
    if (end > first + 1) take_file_axes(std::span(axes).subspan(first, end - first));
  }
  const std::array<double, 3> skews = means_of<3>(vertices, [&](const glm::dvec3& vertex) {
    const glm::dvec3 at = inverse * (vertex - frame.center) - centre;
    std::array<double, 3> cubes{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = glm::dot(at, axes[k]);
      cubes[k] = along * along * along;
    }
    return cubes;
  });
  for (std::size_t k = 0; k < 3; ++k) {
    int most = 0;
    for (const int other : {1, 2}) {
      if (std::abs(axes[k][other]) > std::abs(axes[k][most]) + 1e-6) most = other;
    }
    if (std::abs(skews[k]) > k_balanced ? skews[k] < 0.0 : axes[k][most] < 0.0) axes[k] = -axes[k];
  }
  return axes;
}

/// Bit k of a number below 2^21 at place 3 k.
std::uint64_t spread_bits(std::uint64_t bits) {
  bits = (bits | bits << 32U) & 0x001F00000000FFFFU;
  bits = (bits | bits << 16U) & 0x001F0000FF0000FFU;
  bits = (bits | bits << 8U) & 0x100F00F00F00F00FU;
  bits = (bits | bits << 4U) & 0x10C30C30C30C30C3U;
  return (bits | bits << 2U) & 0x1249249249249249U;
}

/// The new number of each vertex.
std::vector<VertexIndex> order_vertices(const std::vector<glm::dvec3>& vertices, const UnitFrame& frame) {
  constexpr double k_steps = 1048576.0;  // 2^20, of the diagonal: nearer vertices are in the file's order
  const Axes axes = vertex_axes(vertices, frame);
  struct Placed {
    std::uint64_t key = 0;
    VertexIndex vertex = 0;
  };
  std::vector<Placed> placed;
  placed.reserve(vertices.size());
  const double inverse = 1.0 / frame.diagonal;
  for (const glm::dvec3& vertex : vertices) {
    const glm::dvec3 at = inverse * (vertex - frame.center);
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto step = static_cast<std::uint64_t>(k_steps * (glm::dot(at, axes[k]) + 0.75) + 0.5);
      key |= spread_bits(step) << k;
    }
    placed.push_back({key, static_cast<VertexIndex>(placed.size())});
  }
  const auto place = [&](const Placed& each) {
    const glm::dvec3& at = vertices[each.vertex];
    return std::tie(at.x, at.y, at.z);
  };
  std::ranges::sort(placed, [&](const Placed& a, const Placed& b) {
    return a.key != b.key ? a.key < b.key : place(a) < place(b);
  });
  std::vector<VertexIndex> number(placed.size());
  for (VertexIndex vertex = 0; vertex < placed.size(); ++vertex) number[placed[vertex].vertex] = vertex;
  return number;
}

struct OrderedFacet {
  std::array<VertexIndex, 3> corners{};
  FacetIndex former = 0;
};

/// By its corners whichever way round, since a mirror turns that.
bool is_before(const OrderedFacet& a, const OrderedFacet& b) {
  const auto key = [](const OrderedFacet& facet) {
    const auto& [first, second, third] = facet.corners;
    return std::tuple(first, std::min(second, third), std::max(second, third), second, facet.former);
  };
  return key(a) < key(b);
}

/// Facets of a body by their corners: first into the runs of their lowest vertices, which are short.
void order_facets(std::vector<OrderedFacet>& facets, std::vector<FacetIndex>& starts) {
  if (8 * facets.size() < starts.size()) {
    std::ranges::sort(facets, is_before);
    return;
  }
  std::ranges::fill(starts, 0);
  for (const OrderedFacet& facet : facets) ++starts[facet.corners[0] + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<OrderedFacet> ordered(facets.size());
  for (const OrderedFacet& facet : facets) ordered[starts[facet.corners[0]]++] = facet;
  for (auto run = ordered.begin(); run != ordered.end();) {
    auto end = run;
    while (end != ordered.end() && end->corners[0] == run->corners[0]) ++end;
    std::sort(run, end, is_before);
    run = end;
  }
  facets = std::move(ordered);
}

/// Values of the facets, in their new order.
std::vector<std::uint32_t> in_order(const std::vector<std::uint32_t>& values,
                                    const std::vector<FacetIndex>& former) {
  std::vector<std::uint32_t> ordered;
  ordered.reserve(former.size());
  for (const FacetIndex facet : former) ordered.push_back(values.empty() ? facet : values[facet]);
  return ordered;
}

}  // namespace

void put_in_place_order(Part& part) {
  TriangleMesh& mesh = part.mesh;
  if (mesh.vertices.empty()) return;
  const std::vector<VertexIndex> number = order_vertices(mesh.vertices, unit_frame(bounds(mesh)));
  std::vector<glm::dvec3> vertices(mesh.vertices.size());
  for (VertexIndex vertex = 0; vertex < vertices.size(); ++vertex)
    vertices[number[vertex]] = mesh.vertices[vertex];
  mesh.vertices = std::move(vertices);
  std::vector<FacetIndex> former, starts(mesh.vertices.size() + 1);
  former.reserve(mesh.facets.size());
  std::vector<std::array<VertexIndex, 3>> facets;
  facets.reserve(mesh.facets.size());
  for (const Body& body : part.bodies) {
    std::vector<OrderedFacet> of_body(body.facet_count);
    for (FacetIndex k = 0; k < body.facet_count; ++k) {
      OrderedFacet& facet = of_body[k];
      facet.former = body.first_facet + k;
      std::array<VertexIndex, 3> corners = mesh.facets[facet.former];
      for (VertexIndex& corner : corners) corner = number[corner];
      facet.corners = corners;
      for (int turn = 0; turn < 2; ++turn) {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        facet.corners = std::min(facet.corners, corners);
      }
    }
    order_facets(of_body, starts);
    for (const OrderedFacet& facet : of_body) {
      facets.push_back(facet.corners);
      former.push_back(facet.former);
    }
  }
  CHECK(facets.size() == mesh.facets.size());
  mesh.facets = std::move(facets);
  if (!part.facet_source.empty()) part.facet_source = in_order(part.facet_source, former);
  part.file_facets = in_order(part.file_facets, former);
}

std::vector<FacetIndex> facets_as_listed(const Part& part) {
  std::vector<FacetIndex> listed(part.mesh.facets.size());
  std::iota(listed.begin(), listed.end(), FacetIndex{0});
  if (part.file_facets.empty()) return listed;
  for (const Body& body : part.bodies) {
    const auto first = listed.begin() + static_cast<std::ptrdiff_t>(body.first_facet);
    std::stable_sort(first, first + static_cast<std::ptrdiff_t>(body.facet_count),
                     [&](FacetIndex a, FacetIndex b) { return part.file_facets[a] < part.file_facets[b]; });
  }
  return listed;
}

std::vector<VertexIndex> vertices_as_listed(const Part& part) {
  std::vector<bool> used(part.mesh.vertices.size(), false);
  std::vector<VertexIndex> listed;
  listed.reserve(used.size());
  for (const FacetIndex facet : facets_as_listed(part)) {
    for (const VertexIndex vertex : part.mesh.facets[facet]) {
      if (used[vertex]) continue;
      used[vertex] = true;
      listed.push_back(vertex);
    }
  }
  for (VertexIndex vertex = 0; vertex < used.size(); ++vertex) {
    if (!used[vertex]) listed.push_back(vertex);
  }
  return listed;
}

TriangleMesh mesh_as_listed(const Part& part) {
  TriangleMesh listed;
  std::vector<VertexIndex> number(part.mesh.vertices.size());
  for (const VertexIndex vertex : vertices_as_listed(part)) {
    number[vertex] = static_cast<VertexIndex>(listed.vertices.size());
    listed.vertices.push_back(part.mesh.vertices[vertex]);
  }
  for (const FacetIndex facet : facets_as_listed(part)) {
    auto corners = part.mesh.facets[facet];
    for (VertexIndex& corner : corners) corner = number[corner];
    listed.facets.push_back(corners);
  }
  return listed;
}

}  // namespace moldlight
