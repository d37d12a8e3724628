#include "mold/region.hpp"

#include <numeric>

namespace moldlight {

std::string_view region_name(Region region) {
  static constexpr std::array<std::string_view, k_region_count> k_names = {"core", "cavity", "both",
                                                                           "undercut"};
  return k_names[static_cast<std::size_t>(region)];
}

Region region_of(bool accessible_plus, bool accessible_minus) {
  if (accessible_plus) return accessible_minus ? Region::both : Region::core;
  return accessible_minus ? Region::cavity : Region::undercut;
}

double RegionValues::total() const { return std::accumulate(values.begin(), values.end(), 0.0); }

Colour region_colour(Region region, Palette palette) {
  static constexpr Colour k_paper[k_region_count] = {
      {52, 101, 214}, {46, 160, 67}, {153, 156, 160}, {216, 42, 42}};
  static constexpr Colour k_safe[k_region_count] = {
      {0, 114, 178}, {0, 158, 115}, {153, 153, 153}, {213, 94, 0}};
  const auto index = static_cast<std::size_t>(region);
  return palette == Palette::paper ? k_paper[index] : k_safe[index];
}

}  // namespace moldlight
