// What a page needs to find the regions of any direction by itself, by shadow maps on the reader's graphics
// card: the part, what is known exactly, and how far the maps are off.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/image.hpp"
#include "classify/json.hpp"
#include "classify/settings.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mold/region.hpp"

namespace moldlight::report {

/// More facets make the page slow to load and to draw: it gets a coarser mesh.
inline constexpr std::size_t k_most_live_facets = 500'000;
/// Areas by maps are counted by so many surface samples (sample_surface_evenly).
inline constexpr int k_live_samples = 65'536;

/// A direction whose exact areas the page has.
struct LiveDirection {
  std::string name;  // "+z"
  glm::dvec3 direction{0, 0, 1};
  RegionValues areas = {};   // model units squared
  std::string verdict = {};  // of one that is listed as a card; else empty
};

/// Of maps with this resolution: what an area by them is off the exact one at most, a share of the surface.
/// While the direction rests, samples at the maps' borders are settled by rays.
struct LiveError {
  int resolution = 2048;
  double moving = 0.0, resting = 0.0;
};

struct LiveView {
  TriangleMesh mesh;       // the part's, or a coarser one
  glm::dvec3 centre{0.0};  // of the unit frame, with `diagonal`
  double diagonal = 1.0;
  double total_area = 0.0;
  std::string length_unit, area_unit;
  MethodSettings method;
  double lateral = 0.0;              // lateral tolerance in the unit frame
  std::vector<LiveDirection> known;  // the asked one first
  std::vector<LiveError> errors;     // by rising resolution
  std::size_t measured = 0;          // directions that they are from
  Image sphere = {};  // undercut over the half-sphere, Lambert's equal-area map about +z; may be empty
};

/// For the page's script. Each known direction comes before its opposite. The mesh is in `data`, as
/// PackedBytes: the coordinates of the vertices in the order of their first use, in single precision where
/// that holds them and else in double, first the first byte of all of them; then the corners (pack_corners).
[[nodiscard]] Json packed(const LiveView& live);

/// What is shown over the part, and below it.
[[nodiscard]] std::string live_stage_html(const LiveView& live);
[[nodiscard]] std::string live_controls_html(const LiveView& live);

/// The shaders of a page's view, each a vertex and a fragment stage, for its script: those of shaders/ for
/// GLSL ES 3.00.
[[nodiscard]] Json page_shaders(bool live);

}  // namespace moldlight::report
