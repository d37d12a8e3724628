// Bits of a part's surface as sheets that are drawn over its picture.
#pragma once

#include <optional>
#include <span>

#include "render/view_geometry.hpp"

namespace moldlight {

/// Of one colour, flat, without what a plane cuts away. Frame and plane must outlive it.
class SurfaceSheets {
 public:
  SurfaceSheets(const UnitFrame& frame, Colour colour, const std::optional<CutPlane>& cut)
      : frame_(frame), cut_(cut) {
    body.colour = colour;
  }

  /// A convex polygon, in the part's unit; `normal`: unit, on the side from which it is seen.
  void add(std::span<const glm::dvec3> corners, const glm::dvec3& normal);

  ViewBody body;

 private:
  const UnitFrame& frame_;
  const std::optional<CutPlane>& cut_;
};

}  // namespace moldlight
