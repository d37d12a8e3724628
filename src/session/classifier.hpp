// Classifies one part for one parting direction after another, on one GL context.
#pragma once

#include <memory>
#include <optional>

#include "base/progress.hpp"
#include "gl/context.hpp"
#include "mold/settle.hpp"
#include "mold/surface_samples.hpp"
#include "render/facet_id_pass.hpp"
#include "render/part_buffers.hpp"
#include "render/sample_pass.hpp"
#include "render/shadow_maps.hpp"
#include "session/classification.hpp"
#include "session/part_model.hpp"

namespace moldlight {

/// The settings of the maps that follow from the user's for a part of this diagonal (model units).
[[nodiscard]] MapSettings map_settings(const MethodSettings& settings, double diagonal);

/// The class of every facet for a unit direction.
[[nodiscard]] std::vector<FacetClass> facet_classes(const FacetGeometry& geometry,
                                                    const glm::dvec3& direction, double tau_deg);

/// Keeps what several directions share: buffers, maps, samples. `context` must be current at every call and
/// outlive the classifier.
class Classifier {
 public:
  Classifier(const gl::Context& context, std::shared_ptr<const PartModel> model);

  /// Throws UsageError for settings that make no sense, Error where the GL fails, Cancelled.
  [[nodiscard]] Classification classify(const MethodSettings& settings, const Progress& progress);

  /// The two halves of classify(). The first draws the maps and finds what needs no samples: the shadow's
  /// area and with it the projected undercut, a lower bound of the undercut area. The second adds the rest;
  /// nothing may be drawn in between.
  [[nodiscard]] Classification start(const MethodSettings& settings, const Progress& progress);
  void finish(Classification& result, const Progress& progress);

  /// Draws the maps for the settings' direction, for pictures.
  void draw_maps(const MethodSettings& settings);

  [[nodiscard]] const PartBuffers& buffers() const { return buffers_; }
  [[nodiscard]] const ShadowMaps& maps() const { return maps_; }
  [[nodiscard]] const PartModel& model() const { return *model_; }
  [[nodiscard]] std::shared_ptr<const PartModel> shared_model() const { return model_; }
  [[nodiscard]] const gl::Context& context() const { return *context_; }

 private:
  void measure_samples(Classification& result, const Progress& progress);
  [[nodiscard]] const SurfaceSamples& surface_samples(int wanted);
  [[nodiscard]] ExactAnswers exact_answers(const Classification& result) const;
  void read_facet_ids(Classification& result);

  const gl::Context* context_;
  std::shared_ptr<const PartModel> model_;
  PartBuffers buffers_;
  ShadowMaps maps_;
  std::optional<SamplePass> sample_pass_;
  std::optional<FacetIdPass> facet_id_pass_;
  std::optional<SurfaceSamples> samples_;
  int sample_target_ = 0;
  std::vector<FacetClass> classes_;
};

}  // namespace moldlight
