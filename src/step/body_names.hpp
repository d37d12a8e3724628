// Names of the bodies of a STEP file.
#pragma once

#include <string>

#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

namespace moldlight::step {

/// Name of a transferred solid, shell or face itself, or else of its product; empty where there is neither.
[[nodiscard]] std::string body_name(const STEPControl_Reader& reader, const TopoDS_Shape& shape);

}  // namespace moldlight::step
