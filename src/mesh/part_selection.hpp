// Choosing a body of a part, and the unit that its lengths are in.
#pragma once

#include <string_view>

#include "mesh/part.hpp"

namespace moldlight {

/// The part reduced to one body, or the part itself for "all". `selector` is a body's number in the list,
/// from 1, or its name. Throws UsageError that lists the bodies for a number or name that is not there or not
/// the only one.
[[nodiscard]] Part select_body(Part part, std::string_view selector);

/// Body `index` (from 0) of the part as a part of its own. file_facets has which facets of the file it has,
/// chosen_body and file_bodies from among which bodies it comes.
[[nodiscard]] Part extract_body(const Part& part, std::size_t index);

/// Brings the part to `unit` ("mm", "in", …): its lengths are converted where the part names another unit,
/// and only named where it names none. Throws UsageError for an unknown unit.
void set_unit(Part& part, std::string_view unit);

}  // namespace moldlight
