// A part with everything that the sweep engines and their rivals need, and the engines ready to run.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "bench/speed/bench_settings.hpp"
#include "bench/speed/truth.hpp"
#include "classify/part_model.hpp"
#include "mold/surface_samples.hpp"
#include "sweep/scoring.hpp"

namespace moldlight::bench {

class Contenders {
 public:
  Contenders(const std::string& path, const BenchSettings& settings);

  [[nodiscard]] const std::shared_ptr<const PartModel>& model() const { return model_; }
  [[nodiscard]] const Truth& truth() const { return truth_; }
  [[nodiscard]] std::size_t facets() const { return model_->part.mesh.facets.size(); }

  /// Pools on `jobs` threads (0: all cores); none may outlive this.
  [[nodiscard]] std::unique_ptr<ScoringPool> ray_pool(std::uint64_t samples, int jobs);
  [[nodiscard]] std::unique_ptr<ScoringPool> gl_pool(int resolution, int samples, int jobs);
  /// On all cores.
  [[nodiscard]] double exact_undercut(const glm::dvec3& direction) const;

  static constexpr double k_tau_deg = 1.0;
  /// Lateral tolerance in the unit frame: the default of the final figures.
  static constexpr double k_lateral = 1.0 / 2048.0;

 private:
  std::shared_ptr<const PartModel> model_;
  std::deque<SurfaceSamples> sample_sets_;  // of the pools; their places do not change
  Truth truth_;
};

}  // namespace moldlight::bench
