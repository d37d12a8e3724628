// Real parts and what was done to them: what is told is what was done. The shipped parts and, where they are
// found, the shared ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "classify/part_model.hpp"
#include "compare/comparison.hpp"
#include "mesh/health.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/mold_rows.hpp"

namespace moldlight {
namespace {

struct RealPart {
  std::string name;
  TriangleMesh mesh;
};

/// Closed ones with a volume, of so many facets that all of them take seconds.
const std::vector<RealPart>& parts_to_revise() {
  constexpr std::size_t k_most = 3000;
  static const std::vector<RealPart> k_parts = [] {
    std::vector<RealPart> parts;
    std::size_t shared = 0;
    for (const test::PartRows& row : test::part_rows(k_most)) {
      const auto model = load_part(row.path.string(), {}, Progress());
      const bool shipped = row.path.string().find("/assets/") != std::string::npos;
      const std::size_t most = shipped ? 5000 : k_most;
      if (!model->health.closed || model->part.bodies.size() > 1 || model->part.mesh.facets.size() > most)
        continue;
      parts.push_back({row.path.filename().string(), model->part.mesh});
      shared += shipped ? 0 : 1;
    }
    fmt::print("{} parts, {} of them shared\n", parts.size(), shared);
    return parts;
  }();
  return k_parts;
}

Comparison told_of(const TriangleMesh& a, const TriangleMesh& b, bool aligned, bool with_mold = false) {
  CompareSettings settings;
  settings.align = aligned;
  settings.with_actions = false;
  settings.with_mold = with_mold;
  Comparison comparison = prepare_comparison(test::model_of(a), test::model_of(b), settings, Progress());
  const glm::dvec3 up(0, 0, 1);
  compare_parts(comparison, {.a = up, .b = up, .method = {}}, Progress());
  return comparison;
}

double undercut(const ComparedPart& part) { return part.result.areas[Region::undercut]; }

/// Cut less add.
double steel_told(const Comparison& comparison) {
  double sum = 0.0;
  for (const PlaceSteel& place : comparison.mold->places)
    sum += (place.cut ? place.cut->volume.volume : 0.0) - (place.add ? place.add->volume.volume : 0.0);
  return sum;
}

TEST(MadeRevision, ThatIsTheSamePartIsNone) {
  for (const RealPart& part : parts_to_revise()) {
    EXPECT_FALSE(told_of(part.mesh, test::permuted(part.mesh, 5), false).surface.any()) << part.name;
    const TriangleMesh turned = test::rounded_to_float(
        test::translated(test::rotated(part.mesh, test::random_rotation(11)), {5.0, -3.0, 8.0}));
    EXPECT_EQ(comparison_verdict(told_of(part.mesh, turned, true)).find("Nothing changed"), 0U) << part.name;
  }
}

TEST(MadeRevision, OfAnotherSizeIsNamed) {
  for (const RealPart& part : parts_to_revise()) {
    const TriangleMesh larger = test::rounded_to_float(test::scaled(part.mesh, 1.01));
    const Comparison lying = told_of(part.mesh, larger, false);
    const TriangleMesh turned =
        test::rounded_to_float(test::rotated(test::scaled(part.mesh, 1.01), test::random_rotation(3)));
    const Comparison aligned = told_of(part.mesh, turned, true);
    for (const Comparison* one : {&lying, &aligned}) {
      EXPECT_EQ(comparison_verdict(*one).find("B is A × 1.0100. "), 0U)
          << part.name << ": " << comparison_verdict(*one);
      // The same surface stands in the same shadow: 1.01 squared.
      const double allowed = one->a.result.uncertainty.total() + one->b.result.uncertainty.total() +
                             2e-4 * one->a.result.areas[Region::undercut] +
                             1e-5 * one->a.model->geometry.total_area;
      EXPECT_NEAR(undercut(one->b), 1.0201 * undercut(one->a), allowed) << part.name;
    }
  }
}

TEST(MadeRevision, ThatIsAMirrorImageIsTold) {
  for (const RealPart& part : parts_to_revise()) {
    const Comparison found = told_of(part.mesh, test::mirrored(part.mesh), true);
    // What is its own mirror image has not changed.
    EXPECT_EQ(!found.surface.places.empty(), found.alignment->mirrored) << part.name;
  }
}

TEST(MadeRevision, WithARaisedRimCutsAndAddsWhatWasDone) {
  for (const RealPart& part : parts_to_revise()) {
    double top = -INFINITY, bottom = INFINITY;
    for (const glm::dvec3& vertex : part.mesh.vertices) {
      top = std::max(top, vertex.z);
      bottom = std::min(bottom, vertex.z);
    }
    const double by = 0.02 * (top - bottom);
    TriangleMesh raised = part.mesh;
    for (glm::dvec3& vertex : raised.vertices)
      if (vertex.z > top - 1e-6 * (top - bottom)) vertex.z += by;
    const double came = signed_volume(raised) - signed_volume(part.mesh);
    const Comparison there = told_of(part.mesh, raised, false, true),
                     back = told_of(raised, part.mesh, false, true);
    const double exact = 1e-9 * std::abs(signed_volume(part.mesh));
    EXPECT_TRUE(there.surface.any()) << part.name;
    for (const auto& [one, sign] : {std::pair(&there, 1.0), std::pair(&back, -1.0)}) {
      double sum = one->surface.volume_elsewhere;
      for (const ChangedPlace& place : one->surface.places) sum += place.volume.volume;
      EXPECT_NEAR(sum, sign * came, exact) << part.name;
      EXPECT_NEAR(steel_told(*one) + one->surface.volume_elsewhere, sign * came, exact) << part.name;
    }
    EXPECT_NEAR(there.mold->to_cut.volume, back.mold->to_add.volume, 1e-3 * std::abs(came) + exact)
        << part.name;
    EXPECT_NEAR(there.mold->to_add.volume, back.mold->to_cut.volume, 1e-3 * std::abs(came) + exact)
        << part.name;
  }
}

}  // namespace
}  // namespace moldlight
