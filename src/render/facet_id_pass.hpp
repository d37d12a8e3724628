// The paper's readback (section 2.4): facet numbers rendered from both sides; a facet seen from a side is
// accessible from there, as a whole.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/pass.hpp"
#include "gl/program.hpp"
#include "render/shadow_maps.hpp"

namespace moldlight {

struct FacetIdSettings {
  int resolution = 2048;                // pixels along a side; the side is the part's diagonal
  double draft_perturbation_deg = 0.0;  // by which near-vertical facets are opened, so that they can be seen
};

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
