// The contour of a bent face, where its normal has a given angle with the parting direction. A border that
// was found on facets lies up to half a facet beside it.
#pragma once

#include <optional>

#include <TopoDS_Face.hxx>
#include <gp_Dir.hxx>

#include "step/face_mesh.hpp"

namespace moldlight::step {

struct Contour {
  gp_Dir direction;
  double sine = 0.0;  // of the outer normal there: n . d
};

/// Where a place comes to that is moved to the contour the shortest way, along its edge if it is on one; none
/// where that is farther than `reach`, in mm.
[[nodiscard]] std::optional<Place> on_contour(const TopoDS_Face& face, const Contour& contour,
                                              const Place& from, double reach);

}  // namespace moldlight::step
