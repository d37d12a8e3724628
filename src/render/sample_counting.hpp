// Counts surface samples by region for all directions of the maps; a few numbers a direction come
// back.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gl/pass.hpp"
#include "mold/measure.hpp"
#include "mold/surface_samples.hpp"
#include "render/shadow_maps.hpp"

namespace moldlight {

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

}  // namespace moldlight
