#include "mold/sweep/scan_part.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr int k_cluster_cells = 16;   // along a side of the unit frame
constexpr int k_cluster_normals = 4;  // along a side of a face of the cube of normals

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

}  // namespace

void ScanPart::find_clusters() {
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;
  std::vector<glm::dvec3> normal_sums;
  cluster_of_facet_.reserve(mesh_->facets.size());
  for (FacetIndex facet = 0; facet < mesh_->facets.size(); ++facet) {
    const glm::dvec3 centre =
        (mesh_->corner(facet, 0) + mesh_->corner(facet, 1) + mesh_->corner(facet, 2)) / 3.0;
    const glm::dvec3 unit = (centre - frame_.center) / frame_.diagonal + 0.5;
    std::uint32_t key = normal_cell(geometry_->normals[facet]);
    for (int axis = 0; axis < 3; ++axis) key = key * k_cluster_cells + cell(unit[axis], k_cluster_cells);
    const std::uint32_t number =
        numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
    if (number == clusters_.size()) {
      clusters_.emplace_back();
      normal_sums.emplace_back(0.0);
    }
    cluster_of_facet_.push_back(number);
    clusters_[number].area += areas_[facet];
    ++clusters_[number].count;
    normal_sums[number] += geometry_->normals[facet];
  }
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    clusters_[i].first = first;
    first += clusters_[i].count;
    clusters_[i].count = 0;
    const double length = glm::length(normal_sums[i]);
    clusters_[i].axis = glm::vec3(length > 0.0 ? normal_sums[i] / length : glm::dvec3(0, 0, 1));
    clusters_[i].cone_cosine = 1.0F;
  }
  clustered_facets_.resize(cluster_of_facet_.size());
  for (FacetIndex facet = 0; facet < cluster_of_facet_.size(); ++facet) {
    Cluster& cluster = clusters_[cluster_of_facet_[facet]];
    clustered_facets_[cluster.first + cluster.count++] = facet;
    const auto cosine = static_cast<float>(glm::dot(glm::dvec3(cluster.axis), geometry_->normals[facet]));
    cluster.cone_cosine = std::min(cluster.cone_cosine, cosine);
  }
  for (Cluster& cluster : clusters_) {
    cluster.cone_sine = std::sqrt(std::max(0.0F, 1.0F - cluster.cone_cosine * cluster.cone_cosine));
  }
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
  find_clusters();
}

}  // namespace moldlight
