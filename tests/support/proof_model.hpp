// A part with what proofs over its directions are made of.
#pragma once

#include <memory>

#include "classify/part_model.hpp"
#include "proof/direction_proof.hpp"
#include "support/random.hpp"

namespace moldlight::test {

class ProofModel {
 public:
  explicit ProofModel(std::shared_ptr<const PartModel> model);

  [[nodiscard]] const PartModel& model() const { return *model_; }
  [[nodiscard]] const ProofPart& part() const { return part_; }
  /// tau of 1 degree and a lateral tolerance of 1/2048 of the diagonal.
  [[nodiscard]] ProofQuery query() const { return {.tau_deg = 1.0, .lateral = 1.0 / 2048.0}; }
  /// Undercut area by exact regions.
  [[nodiscard]] double undercut(const glm::dvec3& direction) const { return undercut(direction, query()); }
  [[nodiscard]] double undercut(const glm::dvec3& direction, const ProofQuery& query) const;
  [[nodiscard]] std::vector<SurfaceElement> samples(std::uint64_t count) const;
  /// At most a tenth of the diagonal long.
  [[nodiscard]] SurfacePieces pieces(std::uint64_t guides) const;

 private:
  std::shared_ptr<const PartModel> model_;
  ProofPart part_;
};

/// Anywhere within a cell.
[[nodiscard]] glm::dvec3 random_direction(const SphereCell& cell, Random& random);

}  // namespace moldlight::test
