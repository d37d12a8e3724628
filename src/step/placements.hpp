// How the instances of an assembly are placed.
#pragma once

#include <string>

#include <STEPControl_Reader.hxx>

namespace moldlight::step {

/// The entity, as "#178", by which a shape is placed mirrored or scaled; empty where there is none.
/// OpenCASCADE takes in no more of such a placement than its origin, axis1 and axis3.
[[nodiscard]] std::string mirrored_or_scaled_placement(const STEPControl_Reader& reader);

}  // namespace moldlight::step
