// The straightforward sweep on the GL, as in the paper: for each direction two depth passes and the readback
// of facet numbers from both sides (section 2.4), one region a facet.
#pragma once

#include <memory>
#include <vector>

#include "classify/part_model.hpp"
#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "render/part_buffers.hpp"
#include "render/readout_passes.hpp"

namespace moldlight::bench {

/// Takes no short cut the wrong way: the part stays on the GL, the depth passes write depth alone and shared
/// vertices are transformed once. `context` must be current at every call.
class PaperSweep {
 public:
  PaperSweep(const gl::Context& context, std::shared_ptr<const PartModel> model, int resolution,
             double tau_deg);

  /// Area in model units squared of the facets that are seen from neither side.
  [[nodiscard]] double undercut(const glm::dvec3& direction);

 private:
  const gl::Functions* gl_;
  std::shared_ptr<const PartModel> model_;
  int resolution_;
  double tau_deg_;
  PartBuffers buffers_;
  gl::Program depth_program_;
  FacetIdPass facet_id_pass_;
  gl::Texture depths_[2];
  gl::Framebuffer framebuffers_[2];
  std::vector<glm::vec3> positions_;
};

}  // namespace moldlight::bench
