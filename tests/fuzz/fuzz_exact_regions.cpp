// The exact core against rays from inside its pieces, on meshes of a few facets that coincide, touch and
// cross.
//
// For any mesh: each facet's shares make up the facet, the pieces make up the mesh, areas with and without
// pieces are the same to the bit, and the opposite direction exchanges core and cavity. For a mesh whose
// inside is known (outward bodies, or one that is not closed): a ray from inside a piece finds the piece's
// region. Rays that start or pass within 1e-9 of the diagonal of another facet or its edge are not asked: of
// surfaces that coincide either may hide the other. Nor are pieces narrower than 1e-7, whose points are as
// near to a border as that. For bodies off the grid, so that no two facets lie in one plane: both shadows
// have one area.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "base/check.hpp"
#include "fuzz/small_mesh.hpp"
#include "mesh/health.hpp"
#include "support/exact_model.hpp"
#include "support/split_checks.hpp"

using namespace moldlight;

namespace {

constexpr double k_bound = 1e-10;  // of area, volume or diagonal: rounding
/// What borders are off by, 1e-12 of the diagonal, over the least sine of a facet that counts, 1e-4.
constexpr double k_shadow_bound = 1e-8;
constexpr double k_crossing_bound = 1e-11;
constexpr std::size_t k_rays = 24;

/// Prints what repeats it, and ends the program.
[[noreturn]] void fail(const fuzz::SmallMesh& part, const std::string& what) {
  fmt::print(stderr, "{}\n# tau {} deg, lateral tolerance {}, direction {:.17g},{:.17g},{:.17g}\n", what,
             part.settings.tau_deg, part.settings.lateral_tolerance, part.direction.x, part.direction.y,
             part.direction.z);
  for (const glm::dvec3& v : part.mesh.vertices)
    fmt::print(stderr, "v {:.17g} {:.17g} {:.17g}\n", v.x, v.y, v.z);
  for (const auto& facet : part.mesh.facets)
    fmt::print(stderr, "f {} {} {}\n", facet[0] + 1, facet[1] + 1, facet[2] + 1);
  std::abort();
}

void expect_at_most(const fuzz::SmallMesh& part, const char* what, double found, double bound) {
  if (!(found <= bound)) fail(part, fmt::format("{}: {} is more than {}", what, found, bound));
}

void check_shares(const fuzz::SmallMesh& part, const FacetGeometry& geometry, const ExactAreas& areas) {
  CHECK(areas.facet_fractions.size() == geometry.areas.size());
  for (std::size_t facet = 0; facet < geometry.areas.size(); ++facet) {
    double sum = 0.0;
    for (const double share : areas.facet_fractions[facet]) {
      if (!(share >= 0.0 && share <= 1.0 + 1e-12)) fail(part, fmt::format("a share of {}", share));
      sum += share;
    }
    if (geometry.areas[facet] > k_bound * geometry.total_area)
      expect_at_most(part, "shares of a facet", std::abs(sum - 1.0), k_bound);
  }
  expect_at_most(part, "total area", std::abs(areas.areas.total() - geometry.total_area),
                 k_bound * geometry.total_area);
}

void check_split(const fuzz::SmallMesh& part, const test::ExactModel& model, const ExactSplit& split) {
  const test::SplitFaults faults = test::split_faults(model, split);
  if (!faults.sentences.empty()) fail(part, faults.sentences.front());
  expect_at_most(part, "unmatched edges", static_cast<double>(faults.unmatched_edges), 0.0);
  expect_at_most(part, "length of open edges", faults.unmatched_length, k_bound);
  expect_at_most(part, "area of the pieces", faults.area, k_bound);
  // A facet and the same from behind are closed and have no volume to compare with.
  if (part.kind != fuzz::MeshKind::loose_facets)
    expect_at_most(part, "volume of the pieces", faults.volume, k_bound);
  expect_at_most(part, "area of a facet's pieces", faults.facet_area, k_bound);
  expect_at_most(part, "area of a region's pieces", faults.region_area, k_bound);
  expect_at_most(part, "a facet's shares by its pieces", faults.fractions, k_bound);
  expect_at_most(part, "corners outside", faults.outside, k_bound);
  expect_at_most(part, "pieces turned over", faults.turned, k_bound);
}

void check_opposite(const fuzz::SmallMesh& part, const test::ExactModel& model, const ExactAreas& areas) {
  const ExactAreas opposite = model.areas(-part.direction, part.settings);
  // Facets that are all but parallel cross in a line that is off by rounding over their angle.
  const double crossing = part.jitter > 0.0 ? k_crossing_bound / part.jitter : 0.0;
  const double bound = (k_bound + crossing) * model.geometry().total_area;
  expect_at_most(part, "the opposite direction's areas",
                 test::largest_difference(areas.areas, test::swapped_sides(opposite.areas)), bound);
  expect_at_most(part, "the opposite direction's shadow",
                 std::abs(areas.projected_core - opposite.projected_cavity), bound);
}

void check_part(fuzz::SmallMesh part) {
  const test::ExactModel model(part.mesh);
  if (model.geometry().total_area <= 0.0) return;  // bounds are shares of it
  part.settings.lateral_tolerance *= model.diagonal();
  const ExactAreas areas = model.areas(part.direction, part.settings);
  check_shares(part, model.geometry(), areas);
  const ExactSplit split = model.split(part.direction, part.settings);
  if (split.areas.areas.values != areas.areas.values) fail(part, "areas depend on the pieces");
  check_split(part, model, split);
  check_opposite(part, model, areas);

  const bool closed = model.part().closed();
  if (part.kind != fuzz::MeshKind::loose_facets || !closed) {
    const test::RayVerdicts verdicts =
        test::ray_verdicts(model, split.mesh, part.direction, part.settings, k_rays, 1);
    if (!verdicts.wrong.empty()) fail(part, verdicts.wrong.front());
  }
  const bool bodies = part.kind == fuzz::MeshKind::tetrahedra || part.kind == fuzz::MeshKind::boxes;
  if (bodies && part.jitter >= 1e-2 && health_report(part.mesh, model.geometry()).duplicate_facets == 0) {
    expect_at_most(part, "difference of the shadows", std::abs(areas.projected_core - areas.projected_cavity),
                   areas.projected_doubt + k_shadow_bound * model.geometry().total_area);
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  // So few facets are no work for several threads.
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::SmallMesh part = fuzz::small_mesh({data, size});
  if (!part.mesh.facets.empty()) check_part(std::move(part));
  return 0;
}
