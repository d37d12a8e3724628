#include "support/proof_model.hpp"

#include <utility>

#include <glm/geometric.hpp>

#include "mold/exact/exact_regions.hpp"

namespace moldlight::test {

ProofModel::ProofModel(std::shared_ptr<const PartModel> model)
    : model_(std::move(model)),
      part_{.mesh = model_->part.mesh,
            .geometry = model_->geometry,
            .adjacency = model_->adjacency,
            .positions = model_->exact(Progress{}).positions(),
            .rays = model_->rays()} {}

double ProofModel::undercut(const glm::dvec3& direction, const ProofQuery& query) const {
  const ExactQuery exact{.direction = direction, .tau_deg = query.tau_deg, .lateral = query.lateral};
  return exact_areas(model_->exact(Progress{}), exact, Progress{}).areas[Region::undercut];
}

std::vector<SurfaceElement> ProofModel::samples(std::uint64_t count) const {
  return sample_elements(part_,
                         sample_surface_evenly(model_->part.mesh, model_->geometry, model_->frame, count));
}

SurfacePieces ProofModel::pieces(std::uint64_t guides) const {
  return surface_pieces(part_, 0.1, 100'000, samples(guides));
}

glm::dvec3 random_direction(const SphereCell& cell, Random& random) {
  const auto& [a, b, c] = cell.corners();
  const double u = random.between(0.0, 1.0), v = random.between(0.0, 1.0), w = random.between(0.0, 1.0);
  return glm::normalize(u * a + v * b + w * c);
}

}  // namespace moldlight::test
