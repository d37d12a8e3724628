// That so many directions are impossible, against random ones and those beside the directions that were
// found, by rays from the samples of the proof.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "mold/surface_samples.hpp"
#include "pieces/bit_set.hpp"
#include "pieces/find_pieces.hpp"
#include "support/proof_checks.hpp"
#include "support/proof_model.hpp"
#include "support/shared_parts.hpp"
#include "sweep/sample_rays.hpp"

namespace moldlight {
namespace {

constexpr std::size_t k_bound_samples = 800, k_bound_directions = 300, k_bound_checks = 10'000;

BitSet reached_by(const PartModel& model, const SurfaceSamples& samples, const ProofQuery& query,
                  const glm::dvec3& direction) {
  BitSet reached(samples.samples.size());
  SampleRays rays;
  rays.begin({direction, query.lateral});
  for (std::size_t k = 0; k < samples.samples.size(); ++k) {
    const glm::dvec3& normal = model.geometry.normals[samples.samples[k].facet];
    rays.add(k, samples.samples[k].position, normal,
             facet_class(glm::dot(normal, direction), std::sin(glm::radians(query.tau_deg))));
  }
  rays.ask(model.rays());
  rays.for_each([&](std::size_t k, bool plus, bool, float) {
    if (plus) reached.set(k);
  });
  return reached;
}

TEST(PiecesBound, RandomDirectionsNeverReachMoreThanWasExcluded) {
  std::vector<std::filesystem::path> paths = {test::asset_folder() / "parts" / "enclosure_lid.stl"};
  if (test::shared_folder())
    for (const char* name : {"framework_expansion_card.stl", "m5_stamplc_face_shell.stl"})
      paths.push_back(*test::shared_folder() / "parts" / name);
  for (const auto& path : paths) {
    const test::ProofModel proof(load_part(path.string(), {}, Progress{}));
    const PartModel& model = proof.model();
    const PiecesResult found = find_pieces(model, {}, {}, Progress());
    const std::size_t most = found.lower_bound - 1;
    ASSERT_GE(most, 2U) << path;
    const SurfaceSamples samples =
        sample_surface_evenly(model.part.mesh, model.geometry, model.frame, k_bound_samples);
    const auto spare = static_cast<std::size_t>(0.005 * static_cast<double>(samples.samples.size()));
    const CoverProof cover = prove_cover(proof.part(), sample_elements(proof.part(), samples),
                                         {.query = proof.query(), .most = most, .spare = spare}, Progress());
    ASSERT_EQ(cover.excluded, most) << path;
    test::Random random(3);
    std::vector<BitSet> reached;
    for (std::size_t k = 0; k < k_bound_directions; ++k) {
      // Every other one near one that was found, where the bound is close.
      const glm::dvec3 beside = found.directions[random.below(found.count())].direction;
      const glm::dvec3 direction =
          k < found.count() ? found.directions[k].direction
          : k % 2 == 0
              ? glm::normalize(beside + std::pow(10.0, random.between(-3.0, -0.5)) * random.in_cube(1.0))
              : glm::normalize(random.in_cube(1.0));
      reached.push_back(reached_by(model, samples, proof.query(), direction));
    }
    std::size_t wrong = 0, fewest = samples.samples.size();
    for (std::size_t k = 0; k < k_bound_checks; ++k) {
      BitSet all(samples.samples.size());
      // Half of them with one of those that were found.
      for (std::size_t one = 0; one < most; ++one)
        all.add(reached[random.below(one == 0 && k % 2 == 0 ? found.count() : reached.size())]);
      const std::size_t left = samples.samples.size() - all.count();
      wrong += left <= spare ? 1 : 0;
      fewest = std::min(fewest, left);
    }
    EXPECT_EQ(wrong, 0U) << path;
    std::cout << path.filename().string() << ": " << most << " directions leave at least " << fewest
              << " samples, " << spare << " may be left" << std::endl;
  }
}

}  // namespace
}  // namespace moldlight
