// The measuring pass: looks every surface sample up in the shadow maps, one fragment a sample.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gl/pass.hpp"
#include "mold/measure.hpp"
#include "mold/surface_samples.hpp"
#include "render/shadow_maps.hpp"

namespace moldlight {

/// Needs its context current.
class SamplePass {
 public:
  explicit SamplePass(const gl::Functions& gl);

  /// One verdict (mold/measure.hpp) a sample, in order. Uploads and reads back in blocks, so that memory
  /// stays bounded.
  [[nodiscard]] std::vector<std::uint8_t> run(std::span<const SurfaceSample> samples, const ShadowMaps& maps);

 private:
  gl::Tools tools_;
  gl::Texture samples_, verdicts_;
  gl::Framebuffer framebuffer_;
};

}  // namespace moldlight
