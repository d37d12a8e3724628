// The borders on a face as chains between the places where they meet, in the parameters of its surface.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include "io/step_labels.hpp"
#include "step/face_mesh.hpp"

namespace moldlight::step {

/// A run of borders with the same labels on its sides, which begins and ends where others do, on an edge of
/// the face, or closed at its own first point.
struct Chain {
  std::vector<Place> places;
  std::uint32_t first = 0, last = 0;  // numbers of the end points
  std::uint32_t left = 0, right = 0;  // in the parameters
};

[[nodiscard]] gp_Pnt point_of(const std::array<double, 3>& at, const gp_Trsf& to_body);

/// Chains of the borders of a face, whose facets begin at `first_facet`. Throws std::runtime_error where they
/// are not on the facets.
[[nodiscard]] std::vector<Chain> chains_of(const TopoDS_Face& face, std::uint32_t first_facet,
                                           std::span<const StepBorder> borders, const gp_Trsf& to_body,
                                           double tolerance);

}  // namespace moldlight::step
