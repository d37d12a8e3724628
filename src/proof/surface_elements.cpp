#include "proof/surface_elements.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// Samples lie above their facet by the rounding of single precision, as where they are asked by rays.
constexpr double k_above = 5e-7;
constexpr std::array<std::size_t, 16> k_passes = {0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};

std::size_t longest_side(const SurfaceElement& triangle) {
  std::size_t longest = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = glm::distance(triangle.corners[k], triangle.corners[(k + 1) % 3]);
    if (length > most) longest = k;
    most = std::max(most, length);
  }
  return longest;
}

double side_length(const SurfaceElement& triangle, std::size_t side) {
  return glm::distance(triangle.corners[side], triangle.corners[(side + 1) % 3]);
}

SurfaceElement whole_facet(const ProofPart& part, FacetIndex facet) {
  SurfaceElement element;
  for (std::size_t k = 0; k < 3; ++k) element.corners[k] = part.positions[part.mesh.facets[facet][k]];
  element.facet = facet;
  element.area = part.geometry.areas[facet];
  element.length = side_length(element, longest_side(element));
  return element;
}

/// How far within a triangle's sides a point lies, as seen along the normal; below 0 outside.
double depth_within(const SurfaceElement& triangle, const glm::dvec3& point, const glm::dvec3& normal) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 side = triangle.corners[(k + 1) % 3] - triangle.corners[k];
    const double length = glm::length(side);
    if (length > 0.0)
      least = std::min(least, glm::dot(glm::cross(normal, side), point - triangle.corners[k]) / length);
  }
  return least;
}

}  // namespace

std::vector<SurfaceElement> sample_elements(const ProofPart& part, const SurfaceSamples& samples) {
  std::vector<SurfaceElement> elements;
  const std::size_t count = samples.samples.size();
  elements.reserve(count);
  for (const std::size_t first : k_passes) {
    for (std::size_t k = first; k < count; k += k_passes.size()) {
      const SurfaceSample& sample = samples.samples[k];
      SurfaceElement element;
      element.corners[0] = glm::dvec3(sample.position) + k_above * part.geometry.normals[sample.facet];
      element.facet = sample.facet;
      element.is_point = true;
      element.area = part.geometry.total_area / static_cast<double>(count);
      elements.push_back(element);
    }
  }
  return elements;
}

std::array<SurfaceElement, 2> halves(const SurfaceElement& triangle) {
  const std::size_t side = longest_side(triangle), next = (side + 1) % 3;
  const glm::dvec3 middle = 0.5 * (triangle.corners[side] + triangle.corners[next]);
  std::array<SurfaceElement, 2> both = {triangle, triangle};
  both[0].corners[next] = middle;
  both[1].corners[side] = middle;
  for (SurfaceElement& half : both) {
    half.area = 0.5 * triangle.area;
    half.length = side_length(half, longest_side(half));
  }
  return both;
}

SurfacePieces surface_pieces(const ProofPart& part, double longest, std::size_t most,
                             std::vector<SurfaceElement> guides) {
  SurfacePieces all;
  std::vector<SurfaceElement> open;
  for (FacetIndex facet = 0; facet < part.mesh.facets.size(); ++facet) {
    all.first.push_back(static_cast<std::uint32_t>(all.pieces.size()));
    if (part.geometry.areas[facet] <= 0.0) continue;
    open.assign(1, whole_facet(part, facet));
    while (!open.empty()) {
      const SurfaceElement piece = open.back();
      open.pop_back();
      if (piece.length <= longest || all.pieces.size() + open.size() + 1 >= most) {
        all.pieces.push_back(piece);
        continue;
      }
      const auto both = halves(piece);
      open.insert(open.end(), both.begin(), both.end());
    }
  }
  all.first.push_back(static_cast<std::uint32_t>(all.pieces.size()));
  for (const SurfaceElement& guide : guides) {
    const auto begin = all.pieces.begin() + all.first[guide.facet],
               end = all.pieces.begin() + all.first[guide.facet + 1];
    const auto nearest = std::ranges::max_element(begin, end, {}, [&](const SurfaceElement& piece) {
      return depth_within(piece, guide.corners[0], part.geometry.normals[guide.facet]);
    });
    all.piece_of_guide.push_back(static_cast<std::uint32_t>(nearest - all.pieces.begin()));
  }
  all.guides = std::move(guides);
  return all;
}

}  // namespace moldlight
