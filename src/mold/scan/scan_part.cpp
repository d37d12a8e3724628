#include "mold/scan/scan_part.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr int k_cell_bits = 4;        // 16 cells along a side of the unit frame
constexpr int k_fine_bits = 6;        // 64 places along a side of a cell
constexpr int k_cluster_normals = 4;  // along a side of a face of the cube of normals
constexpr int k_normal_bits = 7;      // for 6 x 4 x 4 of them

std::uint32_t cell(double value, int cells) {
  return static_cast<std::uint32_t>(std::clamp(static_cast<int>(value * cells), 0, cells - 1));
}

/// Number of the cell of the cube of directions that a normal falls into.
std::uint32_t normal_cell(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  if (size[axis] <= 0.0) return 0;
  const auto face = static_cast<std::uint32_t>(2 * axis + (normal[axis] < 0.0 ? 1 : 0));
  const auto u = cell(0.5 + 0.5 * normal[(axis + 1) % 3] / size[axis], k_cluster_normals);
  const auto v = cell(0.5 + 0.5 * normal[(axis + 2) % 3] / size[axis], k_cluster_normals);
  return (face * k_cluster_normals + u) * k_cluster_normals + v;
}

/// The bits of three numbers below 2^bits, interleaved (Morton): numbers close to each other stand for places
/// close to each other.
std::uint64_t interleaved(const std::uint32_t (&places)[3], int bits) {
  std::uint64_t result = 0;
  for (int bit = bits - 1; bit >= 0; --bit) {
    for (const std::uint32_t place : places) result = result << 1 | (place >> bit & 1U);
  }
  return result;
}

struct PlacedFacet {
  std::uint64_t key;  // cell, cell of the normal, place in the cell
  FacetIndex facet;

  [[nodiscard]] std::uint64_t cluster() const { return key >> (3 * k_fine_bits); }
  bool operator<(const PlacedFacet& other) const {
    return key != other.key ? key < other.key : facet < other.facet;
  }
};

}  // namespace

const ScanPart::Clusters& ScanPart::clusters() const {
  std::call_once(clusters_asked_, [this] { clusters_ = find_clusters(); });
  return clusters_;
}

ScanPart::Clusters ScanPart::find_clusters() const {
  constexpr int k_place_bits = k_cell_bits + k_fine_bits;
  std::vector<PlacedFacet> order;
  order.reserve(mesh_->facets.size());
  for (FacetIndex facet = 0; facet < mesh_->facets.size(); ++facet) {
    const glm::dvec3 centre =
        (mesh_->corner(facet, 0) + mesh_->corner(facet, 1) + mesh_->corner(facet, 2)) / 3.0;
    const glm::dvec3 unit = (centre - frame_.center) / frame_.diagonal + 0.5;
    std::uint32_t cells[3], places[3];
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t place = cell(unit[axis], 1 << k_place_bits);
      cells[axis] = place >> k_fine_bits;
      places[axis] = place & ((1U << k_fine_bits) - 1);
    }
    const std::uint64_t cluster =
        interleaved(cells, k_cell_bits) << k_normal_bits | normal_cell(geometry_->normals[facet]);
    order.push_back({cluster << (3 * k_fine_bits) | interleaved(places, k_fine_bits), facet});
  }
  std::sort(order.begin(), order.end());

  Clusters clusters;
  clusters.of_facet.resize(order.size());
  clusters.facets.reserve(order.size());
  std::vector<glm::dvec3> normal_sums;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || order[i].cluster() != order[i - 1].cluster()) {
      clusters.all.emplace_back().first = static_cast<std::uint32_t>(i);
      normal_sums.emplace_back(0.0);
    }
    const FacetIndex facet = order[i].facet;
    clusters.of_facet[facet] = static_cast<std::uint32_t>(clusters.all.size() - 1);
    clusters.facets.push_back(facet);
    clusters.all.back().area += areas_[facet];
    ++clusters.all.back().count;
    normal_sums.back() += geometry_->normals[facet];
  }
  for (std::size_t i = 0; i < clusters.all.size(); ++i) {
    Cluster& cluster = clusters.all[i];
    const double length = glm::length(normal_sums[i]);
    cluster.axis = glm::vec3(length > 0.0 ? normal_sums[i] / length : glm::dvec3(0, 0, 1));
    cluster.cone_cosine = 1.0F;
    for (const FacetIndex facet : clusters.facets_of(cluster)) {
      const auto cosine = static_cast<float>(glm::dot(glm::dvec3(cluster.axis), geometry_->normals[facet]));
      cluster.cone_cosine = std::min(cluster.cone_cosine, cosine);
    }
    cluster.cone_sine = std::sqrt(std::max(0.0F, 1.0F - cluster.cone_cosine * cluster.cone_cosine));
  }
  return clusters;
}

ScanPart::ScanPart(const TriangleMesh& mesh, const FacetGeometry& geometry, const UnitFrame& frame,
                   std::span<const FacetEdge> concave_edges)
    : mesh_(&mesh), geometry_(&geometry), frame_(frame), concave_edges_(concave_edges) {
  positions_.reserve(mesh.vertices.size());
  for (const glm::dvec3& vertex : mesh.vertices) {
    const glm::vec3 unit = frame.to_unit(vertex);
    positions_.push_back({unit.x, unit.y, unit.z, 0.0F});
  }
  const std::size_t padded = (mesh.facets.size() + k_padding - 1) / k_padding * k_padding;
  for (std::vector<float>* values : {&normals_.x, &normals_.y, &normals_.z, &areas_}) values->resize(padded);
  planes_.reserve(mesh.facets.size());
  const double square = frame.diagonal * frame.diagonal;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3& normal = geometry.normals[facet];
    const double offset = glm::dot(normal, (mesh.corner(facet, 0) - frame.center) / frame.diagonal);
    planes_.push_back({static_cast<float>(normal.x), static_cast<float>(normal.y),
                       static_cast<float>(normal.z), static_cast<float>(offset)});
    normals_.x[facet] = planes_.back().x;
    normals_.y[facet] = planes_.back().y;
    normals_.z[facet] = planes_.back().z;
    areas_[facet] = static_cast<float>(geometry.areas[facet] / square);
  }
}

}  // namespace moldlight
