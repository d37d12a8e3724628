// What a STEP file says beside its shapes: the colours of faces, and how the instances of an assembly are
// placed.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>

#include <STEPControl_Reader.hxx>
#include <TopoDS_TShape.hxx>

namespace moldlight::step {

/// By the face: 0xRRGGBB of sRGB, its own colour or that of the body it is in. Without one it is not there.
using FaceColours = std::unordered_map<const TopoDS_TShape*, std::uint32_t>;
/// Known once the reader has transferred its shapes.
[[nodiscard]] FaceColours face_colours(const STEPControl_Reader& reader);

/// The entity, as "#178", by which a shape is placed mirrored or scaled; empty where there is none.
/// OpenCASCADE takes in no more of such a placement than its origin, axis1 and axis3.
[[nodiscard]] std::string mirrored_or_scaled_placement(const STEPControl_Reader& reader);

}  // namespace moldlight::step
