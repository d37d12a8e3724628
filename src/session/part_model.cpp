#include "session/part_model.hpp"

#include <chrono>
#include <utility>

#include "mesh/orient.hpp"

namespace moldlight {

namespace {

double elapsed_ms(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since).count();
}

}  // namespace

std::shared_ptr<const PartModel> prepare_part(Part part, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  auto model = std::make_shared<PartModel>();
  model->part = std::move(part);
  const TriangleMesh& mesh = model->part.mesh;
  model->warnings = model->part.warnings;
  progress.report("orienting", 0.0);
  const TurnedFacets turned = turn_if_inside_out(model->part.mesh);
  if (turned.facets > 0) model->warnings.push_back(turned_warning(turned));
  progress.report("measuring facets", 0.0);
  model->geometry = facet_geometry(mesh);
  progress.report("finding neighbours", 0.0);
  model->adjacency = build_adjacency(mesh);
  model->edges = bent_edges(mesh, model->geometry, model->adjacency);
  progress.report("checking health", 0.0);
  model->health = health_report(mesh, model->geometry);
  model->frame = unit_frame(model->health.bounds);
  progress.report("building the ray tree", 0.0);
  model->rays = std::make_unique<ExactRays>(mesh, unit_positions(mesh, model->frame));
  for (std::string& warning : health_warnings(model->health)) model->warnings.push_back(std::move(warning));
  model->load_ms = elapsed_ms(start);
  return model;
}

std::shared_ptr<const PartModel> load_part(const std::string& path, const ReadOptions& options,
                                           const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Part part = read_part(path, options, progress);
  auto model = std::const_pointer_cast<PartModel>(prepare_part(std::move(part), progress));
  model->load_ms = elapsed_ms(start);
  return model;
}

}  // namespace moldlight
