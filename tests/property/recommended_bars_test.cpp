// What is promised of every recommendation, on parts that no test was made for: shapes, straight and tilted,
// the shipped parts, and small shared ones where they are.
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"
#include "sweep/candidates/candidate_sources.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t k_small_part = 340'000, k_shipped_part = 1'400'000;  // bytes
constexpr double k_same_place_deg = 3.0, k_same_deg = 1e-6;

/// What the side actions of a canonical direction come to, found apart from any sweep.
class CanonicalCosts {
 public:
  explicit CanonicalCosts(std::shared_ptr<const PartModel> model) : model_(std::move(model)) {
    for (const Candidate& each : canonical_candidates(*model_)) {
      if (each.canonical) directions_.push_back(each.direction);
    }
    costs_.resize(directions_.size());
  }
  [[nodiscard]] const std::vector<glm::dvec3>& directions() const { return directions_; }
  /// Whether it leaves no more unreleased than these and weighs no more.
  [[nodiscard]] bool costs_no_more(std::size_t which, const DirectionActions& than) {
    if (!costs_[which]) {
      const Classification split = classify_exact(*model_, {directions_[which], {}}, Progress{}, true);
      costs_[which] = direction_actions(find_actions(*model_, split, {}, Progress{}), split);
    }
    return costs_[which]->totals.unreleased_area <= than.totals.unreleased_area &&
           costs_[which]->weight <= than.weight;
  }

 private:
  std::shared_ptr<const PartModel> model_;
  std::vector<glm::dvec3> directions_;
  std::vector<std::optional<DirectionActions>> costs_;
};

void expect_bars(const std::string& name, const std::shared_ptr<const PartModel>& model) {
  SweepSettings settings;
  settings.directions = 200;
  settings.refine = 4;
  const SweepResult result = run_sweep(model, settings, Progress{}, {});
  ASSERT_TRUE(result.recommended) << name;
  CanonicalCosts canonical(model);
  for (const SweepCandidate& listed : result.candidates) {
    const glm::dvec3& direction = listed.candidate.direction;
    const std::string what = name + ", " + direction_words(direction) + ": ";
    for (std::size_t k = 0; k < canonical.directions().size(); ++k) {
      const glm::dvec3& other = canonical.directions()[k];
      const double angle_deg = line_angle_deg(direction, other);
      const bool beside = angle_deg > k_same_deg && angle_deg < k_same_place_deg;
      if (!beside && (listed.rank > 1 || listed.candidate.canonical)) continue;
      if (!listed.actions) {
        ADD_FAILURE() << what << "listed beside " << direction_words(other) << ", with unknown side actions";
        continue;
      }
      EXPECT_FALSE(canonical.costs_no_more(k, *listed.actions))
          << what << direction_words(other) << " costs no more than " << listed.actions->text();
    }
  }
}

std::vector<test::Shape> shapes_in_need() {
  const test::ShapeSettings settings;
  return {test::cup_with_side_hole(settings),
          test::plate_with_side_pocket(settings),
          test::block_with_crossing_hole(settings),
          test::stepped_shaft(settings),
          test::snap_hook(settings),
          test::l_bracket(settings),
          test::t_slot(settings),
          test::dovetail_slot(settings),
          test::wide_ledge(settings)};
}

TEST(RecommendedBars, HoldForShapesStraightAndTilted) {
  std::uint32_t seed = 21;
  for (const test::Shape& known : shapes_in_need()) {
    expect_bars(known.name, test::model_of(known.mesh));
    expect_bars("tilted " + known.name,
                test::model_of(test::rotated(known.mesh, test::random_rotation(seed++))));
  }
}

TEST(RecommendedBars, ATiltedShapeHasItsDirectionTilted) {
  std::uint32_t seed = 41;
  for (const test::Shape& known : shapes_in_need()) {
    // Across the axis of a shaft one direction is as good as another; where nearly all walls are upright, as
    // of a profile drawn along a line, rounding decides how the parting line climbs.
    const std::array undecided{"stepped_shaft", "snap_hook", "dovetail_slot"};
    if (std::ranges::find(undecided, known.name) != undecided.end()) continue;
    const glm::dquat rotation = test::random_rotation(seed++);
    const BestDirection straight = best_direction(test::model_of(known.mesh), {}, Progress{});
    const BestDirection tilted =
        best_direction(test::model_of(test::rotated(known.mesh, rotation)), {}, Progress{});
    const glm::dvec3 expected = rotation * straight.direction;
    EXPECT_LT(glm::length(glm::cross(expected, tilted.direction)), 1e-6)
        << known.name << ": " << straight.why << "\ntilted: " << tilted.why;
  }
}

std::vector<fs::path> parts_up_to(std::uintmax_t most_bytes, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".stl" && entry.file_size() <= most_bytes)
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::size_t expect_bars_of(const fs::path& folder, std::uintmax_t most_bytes) {
  std::size_t used = 0;
  for (const fs::path& file : parts_up_to(most_bytes, folder)) {
    const auto model = load_part(file.string(), {}, Progress{});
    if (!model->health.closed) continue;
    expect_bars(file.filename().string(), model);
    ++used;
  }
  return used;
}

TEST(RecommendedBars, HoldForShippedParts) {
  EXPECT_GE(expect_bars_of(test::asset_folder() / "parts", k_shipped_part), 4U);
}

TEST(RecommendedBars, HoldForSmallSharedParts) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  std::cout << expect_bars_of(*shared / "parts", k_small_part) << " shared parts\n";
}

/// Along each direction more side actions are found than are built; across the axis of the gears they would
/// form most of the surface.
TEST(RecommendedBars, WhatNeedsTooManySideActionsIsMoldedWhereItHasLeastUndercut) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  const auto gears = load_part((*shared / "parts" / "3mf_cube_gears_17parts.3mf").string(), {}, Progress{});
  const BestDirection best = best_direction(gears, {}, Progress{});
  EXPECT_EQ(std::abs(best.direction.z), 1.0) << best.name << ": " << best.why;
}

}  // namespace
}  // namespace moldlight
