#include "mold/sweep/engine_choice.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace moldlight {

namespace {

// Errors on real parts, over axes and slanted directions.
constexpr double k_ray_error_at = 0.0011, k_ray_samples = 10'000.0, k_ray_exponent = 0.75;
constexpr double k_scan_error_at = 0.0002, k_scan_resolution = 512.0, k_scan_exponent = 1.25;
constexpr double k_scan_samples_per_texel = 30'000.0 / 512.0;

// Smaller maps save little time, larger ones take too much memory for each thread.
constexpr double k_least_resolution = 256.0, k_most_resolution = 4096.0;

// Times on one core, in nanoseconds, as the speed suite measures them; only their ratios decide. A facet of
// many texels takes more than one of few, of which a large part consists.
constexpr double k_per_facet = 66.0, k_large_part = 50'000.0, k_small_facet_exponent = 0.37;
constexpr double k_per_texel = 9.0, k_per_wall_sample = 15.0;
// A ray's way through a larger tree takes longer, the more so as fewer rays share what they touch.
constexpr double k_per_ray = 150.0, k_ray_facets = 5'000.0, k_tree_exponent = 0.47, k_sharing_exponent = 0.2;

}  // namespace

double ray_error(double samples) {
  return k_ray_error_at * std::pow(k_ray_samples / samples, k_ray_exponent);
}

ScoringPlan choose_engine(std::size_t facets, double wanted_error, bool closed) {
  const auto count = static_cast<double>(facets);
  ScoringPlan plan;
  plan.ray_samples = k_ray_samples * std::pow(k_ray_error_at / wanted_error, 1.0 / k_ray_exponent);
  plan.rays_ms = 1e-6 * k_per_ray * plan.ray_samples * std::pow(count / k_ray_facets, k_tree_exponent) *
                 std::pow(k_ray_samples / plan.ray_samples, k_sharing_exponent);

  const double wanted = k_scan_resolution * std::pow(k_scan_error_at / wanted_error, 1.0 / k_scan_exponent);
  const double resolution = std::clamp(wanted, k_least_resolution, k_most_resolution);
  plan.resolution = static_cast<int>(std::lround(resolution / 8.0)) * 8;
  plan.scan_samples = k_scan_samples_per_texel * resolution;
  const double facet_time =
      k_per_facet * std::min(1.0, std::pow(k_large_part / count, k_small_facet_exponent));
  plan.scan_ms = 1e-6 * (facet_time * count + k_per_texel * resolution * resolution +
                         k_per_wall_sample * plan.scan_samples);
  plan.method = closed && plan.scan_ms <= plan.rays_ms ? ScoringMethod::scan : ScoringMethod::rays;
  return plan;
}

std::string ScoringPlan::reason() const {
  return method == ScoringMethod::scan
             ? fmt::format("maps of {} texels: about {:.2g} ms a direction and core, exact rays {:.2g} ms",
                           resolution, scan_ms, rays_ms)
             : fmt::format(
                   "{:.0f} samples by exact rays: about {:.2g} ms a direction and core, maps {:.2g} ms",
                   ray_samples, rays_ms, scan_ms);
}

}  // namespace moldlight
