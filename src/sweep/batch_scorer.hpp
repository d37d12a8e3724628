// Scores directions by shadow maps on the GL, many at a time: maps are drawn and samples counted there, and a
// few numbers a direction come back. Surface that lies steep in the maps is asked of exact rays meanwhile.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "classify/part_model.hpp"
#include "classify/settings.hpp"
#include "gl/context.hpp"
#include "render/readout_passes.hpp"
#include "sweep/direction_scorer.hpp"
#include "sweep/sample_rays.hpp"

namespace moldlight {

/// What the scorers of one part share; it must outlive them. The samples are of equal weight.
struct BatchScorerPart {
  std::shared_ptr<const PartModel> model;
  const SurfaceSamples& samples;
};

struct BatchScorerSettings {
  Backend backend = Backend::automatic;
  double tau_deg = 1.0;
  MapSettings map;                     // one-sided look-ups
  std::size_t map_bytes = 512U << 20;  // for the maps of a batch; one direction's may take more
};

/// Owns a context of its own, current on the thread that made the scorer. No verdict of a sample comes back,
/// so no ray settles one: of what the maps leave in doubt a share is part of the error. Steep and
/// near-vertical facets, of which maps say least, are known beforehand. Nothing is given up early.
class BatchScorer : public DirectionScorer {
 public:
  BatchScorer(BatchScorerPart part, const BatchScorerSettings& settings);
  ~BatchScorer() override;

  [[nodiscard]] std::size_t batch_size() const override { return batch_size_; }
  [[nodiscard]] std::vector<DirectionScore> score(std::span<const ScoringTask> tasks) override;

 private:
  /// What lives in the context and goes before it does.
  struct OnGl {
    PartBuffers part;
    std::optional<ShadowMaps> maps;
    std::optional<SampleCounting> counting;
  };
  void make_room(std::size_t directions);
  /// Draws a direction's maps, and counts the samples on facets that the GL leaves out.
  [[nodiscard]] SampleCounts begin(const glm::dvec3& direction, int place);
  [[nodiscard]] SampleCounts ask_rays(const glm::dvec3& direction);

  BatchScorerPart part_;
  BatchScorerSettings settings_;
  std::unique_ptr<gl::Context> context_;
  std::size_t batch_size_ = 1;
  std::optional<OnGl> gl_;
  std::vector<FacetClass> classes_;
  SampleRays sample_rays_;
};

}  // namespace moldlight
