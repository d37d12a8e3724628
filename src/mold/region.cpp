#include "mold/region.hpp"

#include <numeric>

namespace moldlight {

namespace {

constexpr std::array<RegionFacts, k_region_count> k_facts = {{
    {.name = "core",
     .title = "Core",
     .meaning = "Accessible along +d only: the core forms it.",
     .accessible = 1,
     .colours = {{{52, 101, 214}, {0, 114, 178}}},
     .terminal_colour = "\033[34m"},
    {.name = "cavity",
     .title = "Cavity",
     .meaning = "Accessible along −d only: the cavity forms it.",
     .accessible = 2,
     .colours = {{{46, 160, 67}, {0, 158, 115}}},
     .terminal_colour = "\033[32m"},
    {.name = "both",
     .title = "Both",
     .meaning = "Accessible along +d and along −d: either half may form it.",
     .accessible = 3,
     .colours = {{{153, 156, 160}, {153, 153, 153}}},
     .terminal_colour = "\033[90m"},
    {.name = "undercut",
     .title = "Undercut",
     .meaning = "Not accessible: it needs a side action, another direction or another shape.",
     .accessible = 0,
     .colours = {{{216, 42, 42}, {213, 94, 0}}},
     .terminal_colour = "\033[31m"},
}};

}  // namespace

const RegionFacts& facts(Region region) { return k_facts[static_cast<std::size_t>(region)]; }

Region region_of(bool accessible_plus, bool accessible_minus) {
  if (accessible_plus) return accessible_minus ? Region::both : Region::core;
  return accessible_minus ? Region::cavity : Region::undercut;
}

double RegionValues::total() const { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace moldlight
