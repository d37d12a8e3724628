// Elements that a proof counts: points of the surface that each stand for an area, or pieces of facets.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/surface_samples.hpp"
#include "proof/blocked_cone.hpp"

namespace moldlight {

/// A point, or a triangle that lies within a facet; unit frame.
struct SurfaceElement {
  std::array<glm::dvec3, 3> corners{};  // a point is the first alone
  FacetIndex facet = 0;
  bool is_point = false;
  double area = 0.0;    // that it stands for, model units squared
  double length = 0.0;  // of a triangle's longest side, unit frame

  [[nodiscard]] std::span<const glm::dvec3> points() const { return {corners.data(), is_point ? 1U : 3U}; }
  [[nodiscard]] glm::dvec3 middle() const {
    return is_point ? corners[0] : (corners[0] + corners[1] + corners[2]) / 3.0;
  }
};

/// One a sample, each of the same area; in an order in which any stretch is spread over the whole part.
[[nodiscard]] std::vector<SurfaceElement> sample_elements(const ProofPart& part,
                                                          const SurfaceSamples& samples);

/// The surface in pieces of facets, and points on it that show where it is worth looking at them.
struct SurfacePieces {
  std::vector<SurfaceElement> pieces;         // facet by facet; none of facets without area
  std::vector<std::uint32_t> first;           // piece of each facet, and one past the last
  std::vector<SurfaceElement> guides;         // points that each stand for the same area
  std::vector<std::uint32_t> piece_of_guide;  // the piece that it is on

  [[nodiscard]] std::uint32_t count_of(FacetIndex facet) const { return first[facet + 1] - first[facet]; }
};

/// Pieces of at most `longest` (unit frame), as long as these are no more than `most`, with sample_elements()
/// as guides.
[[nodiscard]] SurfacePieces surface_pieces(const ProofPart& part, double longest, std::size_t most,
                                           std::vector<SurfaceElement> guides);

/// The two halves of a triangle, cut through its longest side.
[[nodiscard]] std::array<SurfaceElement, 2> halves(const SurfaceElement& triangle);

}  // namespace moldlight
