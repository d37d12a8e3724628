// The plane cut where the parting surface bends, so that its facets are those of its planes.
#pragma once

#include <span>

#include "parting/halves/outline_plane.hpp"
#include "parting/halves/shelf_field.hpp"

namespace moldlight {

/// Adds points and segments outside of the outline, where the fields of the regions bend, and puts those on
/// the outline into columns.
void lay_shelf(Sheets& sheets, std::span<const ShelfField> fields, double tolerance, OutlinePlane& plane);

}  // namespace moldlight
