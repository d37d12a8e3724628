// The four mold-piece regions and their areas (Priyadarshi & Gupta 2006, section 2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace moldlight {

/// Which mold half forms a surface point: core: accessible along +d only; cavity: along -d only; both;
/// undercut: neither.
enum class Region : std::uint8_t { core = 0, cavity = 1, both = 2, undercut = 3 };
inline constexpr std::size_t k_region_count = 4;
inline constexpr std::array<Region, k_region_count> k_regions = {Region::core, Region::cavity, Region::both,
                                                                 Region::undercut};

/// An sRGB colour.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
};

/// The paper's colours (core blue, cavity green, both gray, undercut red) or a set that colour-blind eyes
/// distinguish.
enum class Palette : std::uint8_t { paper, colour_blind_safe };

/// What else the program says about a region: the one place for it.
struct RegionFacts {
  std::string_view name;             // in tables, files and their names
  std::string_view title;            // in the window
  std::string_view meaning;          // a sentence
  unsigned accessible;               // a sum of 1 (along +d) and 2 (along -d), as in the shaders
  std::array<Colour, 2> colours;     // by palette
  std::string_view terminal_colour;  // SGR code
};
[[nodiscard]] const RegionFacts& facts(Region region);
[[nodiscard]] inline std::string_view region_name(Region region) { return facts(region).name; }
[[nodiscard]] inline Colour region_colour(Region region, Palette palette) {
  return facts(region).colours[static_cast<std::size_t>(palette)];
}

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

}  // namespace moldlight
