// Classifies one part for one parting direction after another: by exact regions, or by one of the paper's
// readouts on one GL context.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/progress.hpp"
#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "gl/context.hpp"
#include "mold/surface_samples.hpp"
#include "render/part_buffers.hpp"
#include "render/readout_passes.hpp"
#include "render/shadow_maps.hpp"

namespace moldlight {

/// The settings of the maps that follow from the user's for a part of this diagonal (model units).
[[nodiscard]] MapSettings map_settings(const MethodSettings& settings, double diagonal);

/// The class of every facet for a unit direction.
[[nodiscard]] std::vector<FacetClass> facet_classes(const FacetGeometry& geometry,
                                                    const glm::dvec3& direction, double tau_deg);

/// The part on the GL.
[[nodiscard]] PartBuffers part_buffers(const gl::Context& context, const PartModel& model);

/// One part's buffers and its maps for one direction after another. `context` must be current at every call
/// and outlive it. It does not move.
class PartMaps {
 public:
  PartMaps(const gl::Context& context, std::shared_ptr<const PartModel> model);
  PartMaps(const PartMaps&) = delete;

  /// Throws UsageError for settings that make no sense, Error where the GL fails.
  void draw_maps(const Query& query);

  [[nodiscard]] const PartBuffers& buffers() const { return buffers_; }
  [[nodiscard]] const ShadowMaps& maps() const { return maps_; }
  [[nodiscard]] const PartModel& model() const { return *model_; }
  [[nodiscard]] const gl::Context& context() const { return *context_; }

 protected:
  const gl::Context* context_;
  std::shared_ptr<const PartModel> model_;
  PartBuffers buffers_;
  ShadowMaps maps_;
};

/// Keeps what several directions share, samples too.
class Classifier : public PartMaps {
 public:
  using PartMaps::PartMaps;

  /// classify_exact(), and for another readout its areas in place of the exact ones; their difference is part
  /// of the uncertainty. The split mesh is that of the exact regions. Throws UsageError for settings that
  /// make no sense, Error where the GL fails, Cancelled.
  [[nodiscard]] Classification classify(const Query& query, const Progress& progress,
                                        bool with_split = false);

  /// Adds to a result that has a split mesh how the maps of its settings differ from that, by as many samples
  /// as the settings say.
  void compare_maps(Classification& result, const Progress& progress);

 private:
  [[nodiscard]] std::vector<std::uint8_t> look_up(std::span<const SurfaceSample> samples);
  [[nodiscard]] FacetFractions fractions_by_samples(int wanted);
  [[nodiscard]] FacetFractions fractions_by_facet_id(const MethodSettings& settings);

  std::optional<SamplePass> sample_pass_;
  std::optional<FacetIdPass> facet_id_pass_;
  std::optional<SurfaceSamples> samples_;
  int sample_target_ = 0;
};

}  // namespace moldlight
