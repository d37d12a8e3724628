#include "classify/write_outputs.hpp"

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/check.hpp"
#include "classify/classify_report.hpp"
#include "io/atomic_file.hpp"
#include "io/facet_csv.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight {

namespace {

void write_split(const OutputPaths& paths, const Part& part, const SplitMesh& split, Palette palette) {
  const TriangleMesh mesh = piece_mesh(split);
  std::vector<Region> regions;
  regions.reserve(split.pieces.size());
  for (const SplitPiece& piece : split.pieces) regions.push_back(piece.region);
  const ColouredMesh coloured{.mesh = mesh, .regions = regions, .palette = palette, .unit = part.unit};
  if (!paths.mesh.empty()) write_coloured_mesh(paths.mesh, coloured);
  if (!paths.split_folder.empty())
    write_region_stls(paths.split_folder, std::filesystem::path(part.file).stem().string(), coloured);
  if (!paths.borders.empty()) write_borders(paths.borders, split);
}

}  // namespace

void write_outputs(const OutputPaths& paths, const PartModel& model, const Classification& result,
                   Palette palette) {
  if (paths.need_split()) {
    CHECK(result.split != nullptr);
    write_split(paths, model.part, *result.split, palette);
  }
  if (!paths.facets.empty()) {
    write_facet_csv(paths.facets, {.areas = model.geometry.areas,
                                   .fractions = result.facet_fractions,
                                   .numbers = model.part.file_facets});
  }
  if (!paths.faces.empty()) write_face_csv(paths.faces, face_areas(model, result));
  if (!paths.json.empty()) write_file(paths.json, json_text(classify_json(model, result)));
}

}  // namespace moldlight
