// The four mold-piece regions and their areas (Priyadarshi & Gupta 2006, section 2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace moldlight {

/// Which mold half forms a surface point: core: accessible along +d only; cavity: along -d only; both;
/// undercut: neither. The values are those in the shaders.
enum class Region : std::uint8_t { core = 0, cavity = 1, both = 2, undercut = 3 };
inline constexpr std::size_t k_region_count = 4;
inline constexpr std::array<Region, k_region_count> k_regions = {Region::core, Region::cavity, Region::both,
                                                                 Region::undercut};

/// "core", "cavity", "both", "undercut".
[[nodiscard]] std::string_view region_name(Region region);

/// Region of a point from its accessibility along +d and -d.
[[nodiscard]] Region region_of(bool accessible_plus, bool accessible_minus);

/// One number a region: areas in model units squared, or fractions in [0, 1].
struct RegionValues {
  std::array<double, k_region_count> values{};

  [[nodiscard]] double operator[](Region region) const { return values[static_cast<std::size_t>(region)]; }
  [[nodiscard]] double& operator[](Region region) { return values[static_cast<std::size_t>(region)]; }
  [[nodiscard]] double total() const;
};

/// A row a facet: the share of each region in its area, sum 1; 0 for a facet without area.
using FacetFractions = std::vector<std::array<double, k_region_count>>;

/// An sRGB colour.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
};

/// The paper's colours (core blue, cavity green, both gray, undercut red) or a set that colour-blind eyes
/// tell apart.
enum class Palette : std::uint8_t { paper, colour_blind_safe };
[[nodiscard]] Colour region_colour(Region region, Palette palette);

}  // namespace moldlight
