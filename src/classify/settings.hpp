// The question: a parting direction, and everything a user can set about the method that answers,
// with its defaults. Options (option.hpp) describe each setting once for help, command line, JSON and window.
#pragma once

#include <cstdint>

#include "gl/headless_backend.hpp"
#include "mold/direction.hpp"

namespace moldlight {

/// How near-vertical surface looks into the shadow maps. One-sided: on the outer side only, at the lateral
/// tolerance. Symmetric: the paper's N x N neighbourhood, of which any lit sample suffices (section 2.2).
enum class KernelShape : std::uint8_t { one_sided, symmetric };

/// How regions become figures. Exact: computed, without maps. Samples: stratified surface samples looked up
/// in the maps. Facet-id: the paper's two-pass readback (section 2.4), one region a facet.
enum class Readout : std::uint8_t { exact, samples, facet_id };

using Backend = gl::HeadlessBackend;

/// How regions are found, whatever the direction.
struct MethodSettings {
  double tau_deg = 1.0;    // [0, 10]
  int kernel = 0;          // PCF kernel width of the maps in texels, odd, [1, 9]; 0: as the lateral tolerance
  double tolerance = 0.0;  // lateral tolerance in model units; 0: unset
  bool couple_kernel = false;  // the lateral tolerance is the kernel's radius, where that is set
  KernelShape kernel_shape = KernelShape::one_sided;
  double edge_thickness = 2.0;  // width of the thick concave contour edges in texels, [0, 8]
  int resolution = 2048;        // shadow maps are resolution x resolution texels, [64, 8192]
  Readout readout = Readout::exact;
  int samples = 1'000'000;  // surface samples over the whole part (at least four a facet), [1000, 100000000]
  Backend backend = Backend::automatic;

  bool operator==(const MethodSettings&) const = default;
};

/// The question: what becomes of the part when the mold opens along this direction?
struct Query {
  Direction direction;
  MethodSettings method;

  bool operator==(const Query&) const = default;
};

/// Radius of the kernel, which is set, as a share of the part's diagonal.
[[nodiscard]] double kernel_share(const MethodSettings& settings);

/// The lateral tolerance that the settings mean for a part of this diagonal, both in model units: where they
/// say nothing, 1/2048 of the diagonal, whatever the resolution; never more than the diagonal. The kernel's
/// radius where it is coupled to that, or where the maps are the readout.
[[nodiscard]] double lateral_tolerance(const MethodSettings& settings, double diagonal);

}  // namespace moldlight
