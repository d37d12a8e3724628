// The default sweep's best direction, but for the top three alone, against the best of 20,000 evenly spread
// ones by exact regions: a row a part. Parts are the arguments, or those found. Ends with 1 if the grid
// has a better direction anywhere.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/grid_search.hpp"
#include "support/shared_parts.hpp"
#include "sweep/candidates/candidate.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

constexpr std::size_t k_directions = 20'000;
constexpr double k_allowed_share = 5e-5;  // of the part's area

std::vector<std::string> usual_parts() {
  std::vector<std::string> parts;
  if (const auto shared = test::shared_folder()) {
    for (const char* name : {"lego_brick_2x4.stl", "m5_stackchan_basecover_tilted.stl", "so101_trigger.stl",
                             "numpystl_rear_case.stl", "so101_base.stl", "odri_pulley_t30_output.stl",
                             "screwcap_medical_bottle.stl", "trimesh_quadknot.obj",
                             "framework_expansion_card.stl", "trimesh_featuretype.ply"}) {
      parts.push_back((*shared / "parts" / name).string());
    }
  }
  for (const char* name : {"enclosure_lid.stl", "bottle_cap.stl", "cable_clip.stl", "tilted_bracket.stl"}) {
    parts.push_back((test::asset_folder() / "parts" / name).string());
  }
  return parts;
}

/// True if the sweep holds its own.
bool compare(const std::string& file) {
  const auto model = load_part(file, {}, Progress{});
  SweepSettings settings;
  settings.top = 3;
  const SweepResult sweep = run_sweep(model, settings, Progress{}, {});
  // Of directions that tie with the first, the one with the least undercut.
  const auto tie_end = std::find_if(sweep.candidates.begin(), sweep.candidates.end(),
                                    [](const SweepCandidate& candidate) { return candidate.tie_group > 1; });
  const Classification& best =
      std::min_element(sweep.candidates.begin(), tie_end, [](const auto& a, const auto& b) {
        return a.classification.areas[Region::undercut] < b.classification.areas[Region::undercut];
      })->classification;
  const test::GridBest grid = test::best_of_grid(*model, k_directions);
  const double found = best.areas[Region::undercut], share = 100.0 / model->geometry.total_area;
  const double slack = k_allowed_share * model->geometry.total_area;
  const bool holds = found <= grid.undercut + slack;
  std::printf("%-36s %10.4f %% %10.4f %% %+10.4f %% ± %.4f %% %7.2f°  %s\n",
              model->part.file.substr(model->part.file.find_last_of('/') + 1).c_str(), share * grid.undercut,
              share * found, share * (found - grid.undercut), share * slack,
              line_angle_deg(best.direction, grid.direction), holds ? "" : "MISSED");
  if (!holds) {
    std::printf("    grid (%.5f, %.5f, %.5f), sweep (%.5f, %.5f, %.5f)\n", grid.direction.x, grid.direction.y,
                grid.direction.z, best.direction.x, best.direction.y, best.direction.z);
  }
  std::fflush(stdout);
  return holds;
}

}  // namespace
}  // namespace moldlight

int main(int argc, char** argv) {
  using namespace moldlight;
  const std::vector<std::string> parts =
      argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : usual_parts();
  std::printf("undercut, share of the surface\n%-36s %12s %12s %12s %21s\n", "part", "best of grid", "sweep",
              "difference", "apart");
  bool all = true;
  for (const std::string& part : parts) all = compare(part) && all;
  return all ? EXIT_SUCCESS : EXIT_FAILURE;
}
