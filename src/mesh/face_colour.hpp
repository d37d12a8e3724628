// The colour that a CAD file gives a face: 0xRRGGBB of sRGB.
#pragma once

#include <cstdint>

namespace moldlight {

inline constexpr std::uint32_t k_no_colour = 0xFFFFFFFF;  // of a face to which the file gives none

}  // namespace moldlight
