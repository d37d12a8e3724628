// What a STEP file says beside its shapes: the colours of faces, and how the instances of an assembly are
// placed.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include <STEPControl_Reader.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_TShape.hxx>

namespace moldlight::step {

/// Known once the reader has transferred its shapes.
class FaceColours {
 public:
  explicit FaceColours(const STEPControl_Reader& reader);

  [[nodiscard]] bool any() const { return !of_face_.empty(); }
  /// 0xRRGGBB of sRGB: the face's own colour, or that of the body it is in; k_no_colour without one.
  [[nodiscard]] std::uint32_t of(const TopoDS_Face& face) const;

 private:
  std::unordered_map<const TopoDS_TShape*, std::uint32_t> of_face_;
};

/// The entity, as "#178", by which a shape is placed mirrored or scaled; empty where there is none.
/// OpenCASCADE takes in no more of such a placement than its origin, axis1 and axis3.
[[nodiscard]] std::string mirrored_or_scaled_placement(const STEPControl_Reader& reader);

}  // namespace moldlight::step
