// Why there are no mold halves, where, and what to change.
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace moldlight {

struct MoldFault {
  std::string what;
  std::string change;                    // what helps
  std::optional<glm::dvec3> place = {};  // in the mold's frame; none where it is all of the part
};

/// What helps where the surface itself is at fault.
inline constexpr const char* k_mend_surface =
    "mend the surface there (--repair full), or take one of the part's bodies (--body)";
/// What helps where rounding is.
inline constexpr const char* k_avoid_rounding =
    "make facets there larger or the part coarser (--repair full drops needles), take one of its bodies "
    "(--body), or turn the direction a little";

}  // namespace moldlight
