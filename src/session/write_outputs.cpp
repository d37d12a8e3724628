#include "session/write_outputs.hpp"

#include <filesystem>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/facet_csv.hpp"
#include "io/mesh_writer.hpp"
#include "session/classify_report.hpp"

namespace moldlight {

namespace {

void write_meshes(const OutputPaths& paths, const PartModel& model, const Classification& result,
                  Palette palette) {
  if (paths.mesh.empty() && paths.split_folder.empty()) return;
  std::vector<Region> regions;
  regions.reserve(result.facet_fractions.size());
  for (const auto& fractions : result.facet_fractions) regions.push_back(dominant_region(fractions));
  const ColouredMesh coloured{
      .mesh = model.part.mesh, .regions = regions, .palette = palette, .unit = model.part.unit};
  if (!paths.mesh.empty()) write_coloured_mesh(paths.mesh, coloured);
  if (!paths.split_folder.empty()) {
    write_region_stls(paths.split_folder, std::filesystem::path(model.part.file).stem().string(), coloured);
  }
}

}  // namespace

void write_outputs(const OutputPaths& paths, const PartModel& model, const Classification& result,
                   Palette palette) {
  write_meshes(paths, model, result, palette);
  if (!paths.facets.empty()) {
    write_facet_csv(paths.facets, {.areas = model.geometry.areas,
                                   .fractions = result.facet_fractions,
                                   .numbers = model.part.file_facets});
  }
  if (!paths.faces.empty()) write_face_csv(paths.faces, face_areas(model, result));
  if (!paths.json.empty()) write_file(paths.json, json_text(classify_json(model, result)));
}

}  // namespace moldlight
