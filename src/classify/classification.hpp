// The result of classifying one part for one parting direction: what every output and the window's legend
// show.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/map_comparison.hpp"
#include "classify/part_model.hpp"
#include "classify/settings.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/measure.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// How far the undercut area may be off, model units squared, and what that is made of (mold/area_error.hpp).
struct UndercutUncertainty {
  double rounding = 0.0;  // of exact regions
  double mesh = 0.0;      // what an open or overlapping mesh leaves in doubt; 0 for one that is neither
  double readout = 0.0;   // samples and facet-id: the undercut's difference from that of exact regions; where
                          // exact regions sample facets: twice the standard deviation of that
  std::size_t sampled_facets = 0;  // by exact regions, as too much crosses them
  [[nodiscard]] double total() const { return rounding + mesh + readout; }
};

/// The area of the part's shadow along the direction, found in two independent ways: as the projected area
/// of what is accessible along +d of the surface that faces it, and the same along -d. Model units squared.
struct ShadowIdentity {
  double core = 0.0, cavity = 0.0;
  double gap = 0.0;        // core - cavity
  double gap_limit = 0.0;  // |gap| above this means an open or badly wound mesh, or a bug
  [[nodiscard]] bool agrees() const { return gap <= gap_limit && gap >= -gap_limit; }
};

struct Timings {
  double load_ms = 0.0, regions_ms = 0.0, readout_ms = 0.0, total_ms = 0.0;
};

/// Lengths and areas are in the part's unit.
struct Classification {
  MethodSettings settings;
  glm::dvec3 direction{0, 0, 1};  // unit
  std::string backend;            // "EGL device", "OSMesa", …; empty where no GL was needed
  std::string renderer;           // GL_RENDERER
  double texel = 0.0;             // edge length of a shadow-map texel
  double lateral_tolerance = 0.0;
  FacetFractions facet_fractions;  // empty for a direction of a sweep
  RegionValues areas;
  double total_area = 0.0;
  double near_vertical_area = 0.0;
  ReverseDraft reverse_draft;       // by exact regions, whatever the readout
  double shadow_area = 0.0;         // the projected area that the clamp force acts on
  double projected_undercut = 0.0;  // area, projected along d, of the surface hidden from both sides
  UndercutUncertainty uncertainty;
  ShadowIdentity identity;
  Timings timings;
  std::vector<std::string> warnings;
  std::shared_ptr<const SplitMesh> split;  // exact regions, whatever the readout; none if not asked for
  std::optional<MapComparison> maps;       // against the exact regions, if asked for

  [[nodiscard]] Query query() const { return {direction, settings}; }
  [[nodiscard]] bool answers(const Query& asked) const {
    return direction == asked.direction.unit() && settings == asked.method;
  }
};

/// What exact regions are asked for.
[[nodiscard]] ExactQuery exact_query(const PartModel& model, const Query& query);

/// Classifies by exact regions, whatever the readout; needs no GL. Uses all cores of the calling thread's
/// TBB arena; the result is the same to the bit for any number of threads, timings apart. Throws UsageError
/// for settings that make no sense, Cancelled.
[[nodiscard]] Classification classify_exact(const PartModel& model, const Query& query,
                                            const Progress& progress, bool with_split = false);

/// The same without the split mesh, to the bit; nothing as soon as the undercut area is certain to be above
/// the limit.
[[nodiscard]] std::optional<Classification> classify_exact_within(const PartModel& model, const Query& query,
                                                                  const UndercutLimit& limit,
                                                                  const Progress& progress);

}  // namespace moldlight
