// The borders on a face as chains between the places where they meet, in the parameters of its surface.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <TopoDS_Face.hxx>
#include <gp_Dir.hxx>
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

/// Of one face.
struct FaceBorders {
  std::uint32_t first_facet = 0;  // of the face
  std::span<const StepBorder> borders;
  gp_Trsf to_body;
  double tolerance = 0.0;
  std::optional<gp_Dir> direction;  // of the body; borders of contours along it are moved there
};

/// Throws std::runtime_error where the borders are not on the facets.
[[nodiscard]] std::vector<Chain> chains_of(const TopoDS_Face& face, const FaceBorders& asked);

}  // namespace moldlight::step
