#include "bench/speed/parts.hpp"

#include <fmt/format.h>

#include "io/mesh_writer.hpp"
#include "io/part_formats.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::bench {

namespace {
constexpr std::size_t k_facets_of_lid = 21'496;
}

PartFile part_file(const std::filesystem::path& folder, std::size_t facets) {
  const std::string name = facets < k_facets_of_lid ? "cable_clip" : fmt::format("lid_{}k", facets / 1000);
  return {name, (folder / (name + ".stl")).string()};
}

PartFile make_part(const std::filesystem::path& folder, std::size_t facets) {
  const PartFile file = part_file(folder, facets);
  const std::string source = facets < k_facets_of_lid ? "cable_clip.stl" : "enclosure_lid.stl";
  TriangleMesh mesh = read_part((test::asset_folder() / "parts" / source).string(), {}, {}).mesh;
  mesh = test::subdivided(std::move(mesh), facets);
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  write_coloured_mesh(file.path, {mesh, regions});
  return file;
}

std::vector<PartFile> real_parts() {
  const auto shared = test::shared_folder();
  std::vector<PartFile> files;
  if (!shared) return files;
  for (const char* name : {"m5_stamplc_face_shell.stl", "odri_hip_cover_64k.stl"}) {
    const std::filesystem::path path = *shared / "parts" / name;
    if (std::filesystem::exists(path)) files.push_back({path.stem().string(), path.string()});
  }
  return files;
}

}  // namespace moldlight::bench
