// The result of classifying one part for one parting direction: what every output and the window's legend
// show.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "mold/region.hpp"
#include "session/settings.hpp"

namespace moldlight {

/// How far the undercut area may be off (95 % level), model units squared, and what that is made of.
struct UndercutUncertainty {
  double total = 0.0;
  double sampling = 0.0;   // two standard errors of the stratified samples
  double audit = 0.0;      // from samples of no doubt that exact rays checked all the same
  double unsettled = 0.0;  // surface whose samples stayed doubtful (no rays, or the facet-id readout)
};

/// Area, projected along the direction, of the surface hidden from both sides, found in two independent ways:
/// `surface` from the classified samples, `identity` from the shadow's area alone (sum |n.d| A - 2 S).
struct ProjectedUndercut {
  double surface = 0.0;
  double identity = 0.0;
  double gap = 0.0;        // surface - identity
  double gap_limit = 0.0;  // |gap| above this means an open or badly wound mesh, or a bug
  [[nodiscard]] bool agrees() const { return gap <= gap_limit && gap >= -gap_limit; }
};

struct Timings {
  double load_ms = 0.0, maps_ms = 0.0, measure_ms = 0.0, total_ms = 0.0;
};

/// Lengths and areas are in the part's unit.
struct Classification {
  MethodSettings settings;        // as given
  glm::dvec3 direction{0, 0, 1};  // unit
  std::string backend;            // "EGL device", "EGL surfaceless", "OSMesa", "window"
  std::string renderer;           // GL_RENDERER
  double texel = 0.0;             // edge length of a shadow-map texel
  double lateral_tolerance = 0.0;
  std::vector<std::array<float, k_region_count>> facet_fractions;  // a row a facet: shares of each region,
                                                                   // sum 1 (0 for a facet without area)
  RegionValues areas;
  double total_area = 0.0;
  double near_vertical_area = 0.0;
  double shadow_area =
      0.0;  // of the part along the direction: the projected area that the clamp force acts on
  UndercutUncertainty uncertainty;
  ProjectedUndercut projected;
  std::size_t samples = 0, doubtful_samples = 0, settled_samples = 0, audited_samples = 0, audited_wrong = 0;
  Timings timings;
  std::vector<std::string> warnings;
};

/// Region with the greatest share of a facet; ties go to the more troublesome one (undercut, both, cavity,
/// core).
[[nodiscard]] Region dominant_region(const std::array<float, k_region_count>& fractions);

}  // namespace moldlight
