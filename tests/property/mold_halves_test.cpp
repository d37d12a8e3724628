// Mold halves of real parts along their axes: how many come with their certificate, and why the others not.
#include "parting/mold_halves.hpp"

#include <filesystem>
#include <iostream>
#include <map>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/stopwatch.hpp"
#include "classify/part_model.hpp"
#include "parting/assignment.hpp"
#include "support/manifest.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> part_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(test::asset_folder() / "parts"))
    files.push_back(entry.path());
  if (const auto shared = test::shared_folder()) {
    for (const test::ManifestRow& row : test::read_manifest()) {
      if (!row.file.starts_with("bad/") && row.facets.value_or(0) > 0)
        files.push_back(*shared / "parts" / row.file);
    }
  }
  std::ranges::sort(files);
  return files;
}

TEST(MoldHalvesOfParts, ComeWithTheirCertificateOrAreRefused) {
  std::size_t rows = 0, made = 0, crowded = 0, steep = 0;
  std::map<std::string, std::size_t> reasons;
  for (const fs::path& file : part_files()) {
    const char* only = std::getenv("ONLY");
    if (only && file.string().find(only) == std::string::npos) continue;
    const auto model = load_part(file.string(), {}, Progress{});
    if (!model->health.closed) continue;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 d(0.0);
      d[axis] = 1.0;
      ++rows;
      static_cast<void>(model->exact(Progress{}));
      Stopwatch watch;
      const double height = glm::dot(model->frame.center, d);
      const MoldHalves halves = make_halves(*model, d, height, {}, Progress{});
      const double ms = watch.elapsed_ms();
      if (!halves.made()) {
        ++reasons[halves.refusal.substr(0, 40)];
        std::cout << fmt::format("{} {}: {} at {:.4f} {:.4f} {:.4f}  {:.0f} ms\n", file.filename().string(),
                                 "xyz"[axis], halves.refusal, halves.refused_at.x, halves.refused_at.y,
                                 halves.refused_at.z, ms);
        continue;
      }
      ++made;
      crowded += halves.core.crowded_edges + halves.cavity.crowded_edges > 0;
      steep += halves.steepest_deg > 60.001;
      std::cout << fmt::format(
          "{} {}: gap {:.1e} fold {:.1e} cover {:.1e} fill {:.3f} % in {} + {:.1e} contact {:.3f} % steepest "
          "{:.1f} crowded {} {} "
          "facets {} tol {:g}  {:.0f} ms\n",
          file.filename().string(), "xyz"[axis], halves.volume_gap, halves.fold_area, halves.cover_gap,
          100.0 * halves.insert_volume / halves.part_volume, halves.inserts.size(),
          halves.specks_volume / halves.part_volume, 100.0 * halves.contact_area / model->geometry.total_area,
          halves.steepest_deg, halves.core.crowded_edges, halves.cavity.crowded_edges,
          halves.core.mesh.facets.size() + halves.cavity.mesh.facets.size(), halves.tolerance, ms);
    }
  }
  std::cout << fmt::format("{} rows, {} made, {} with crowded edges, {} steeper than asked\n", rows, made,
                           crowded, steep);
  for (const auto& [reason, count] : reasons) std::cout << count << " " << reason << "\n";
}

}  // namespace
}  // namespace moldlight
