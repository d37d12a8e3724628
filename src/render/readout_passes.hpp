// The measuring passes: what of the shadow maps, and of facets seen from both sides, comes back from the GL.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gl/pass.hpp"
#include "gl/program.hpp"
#include "mold/measure.hpp"
#include "mold/surface_samples.hpp"
#include "render/shadow_maps.hpp"

namespace moldlight {

/// Whether a verdict says that it depends on which of the texels around the sample is looked up.
enum class Doubt : std::uint8_t { unmarked, marked };
/// Added to such a verdict; as in shaders/measure/samples.frag.
inline constexpr std::uint8_t k_doubtful = 4;

/// Looks every surface sample up in the shadow maps, one fragment a sample. Needs its context current.
class SamplePass {
 public:
  explicit SamplePass(const gl::Functions& gl);

  /// One verdict (mold/measure.hpp) a sample, in order. Uploads and reads back in blocks, so that memory
  /// stays bounded. Doubt is marked with the one-sided kernel alone.
  [[nodiscard]] std::vector<std::uint8_t> run(std::span<const SurfaceSample> samples, const ShadowMaps& maps,
                                              Doubt doubt = Doubt::unmarked);

 private:
  gl::Tools tools_;
  gl::Texture samples_, verdicts_;
  gl::Framebuffer framebuffer_;
};

/// Counts surface samples by region for all directions of the maps; a few numbers a direction come back.
/// Needs its context current.
class SampleCounting {
 public:
  /// Uploads the samples, 10 million at most, and makes room for the counts of so many directions.
  SampleCounting(const gl::Functions& gl, std::span<const SurfaceSample> samples, int directions);

  /// Counts of the first `directions` places of the maps, which must be drawn. Waits for the GL, once.
  [[nodiscard]] std::vector<SampleCounts> run(const ShadowMaps& maps, int directions);

 private:
  /// A number of four parts for each direction (row) and block of samples (column).
  struct Counts {
    gl::Texture regions;
    gl::Framebuffer framebuffer;
  };
  [[nodiscard]] Counts make_counts(int width, int height) const;

  gl::Tools tools_;
  gl::Texture samples_;
  int sample_count_ = 0, block_ = 0, blocks_ = 0;
  std::array<Counts, 2> counts_;
};

struct FacetIdSettings {
  int resolution = 2048;                // pixels along a side; the side is the part's diagonal
  double draft_perturbation_deg = 0.0;  // by which near-vertical facets are opened, so that they can be seen
};

/// The paper's readback (section 2.4): facet numbers rendered from both sides; a facet seen from a side is
/// accessible from there, as a whole.
class FacetIdPass {
 public:
  explicit FacetIdPass(const gl::Functions& gl);

  /// Accessibility bits (verdict::k_accessible_plus and _minus) a facet. `top[0]` and `top[1]` are the part's
  /// extents along +d and -d in the unit frame.
  [[nodiscard]] std::vector<std::uint8_t> run(const MapSubject& subject, const float top[2],
                                              const FacetIdSettings& settings);

 private:
  const gl::Functions* gl_;
  gl::Program program_;
  FacetClassBuffer classes_;
};

}  // namespace moldlight
