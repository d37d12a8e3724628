#include "session/live_maps.hpp"

#include <algorithm>

namespace moldlight {

namespace {

constexpr int k_live_resolution = 1024;

}  // namespace

MethodSettings live_method(const MethodSettings& settings, double diagonal) {
  MethodSettings live = settings;
  live.resolution = std::min(settings.resolution, k_live_resolution);
  if (live.resolution == settings.resolution) return live;
  // A symmetric kernel is made of whole texels of its maps.
  if (!settings.tolerance && settings.kernel_shape == KernelShape::one_sided && settings.kernel > 1)
    live.tolerance = 0.5 * (settings.kernel - 1) * diagonal / settings.resolution;
  live.edge_thickness = settings.edge_thickness * live.resolution / settings.resolution;
  return live;
}

}  // namespace moldlight
