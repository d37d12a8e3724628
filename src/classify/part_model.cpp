#include "classify/part_model.hpp"

#include <utility>

#include <tbb/task_arena.h>

#include "base/stopwatch.hpp"
#include "mesh/orient.hpp"
#include "mesh/place_order.hpp"

namespace moldlight {

namespace {

/// Sets `made` once. Work of other tasks stays out of it, as one of them might ask for the same and wait for
/// its own thread.
template <typename T, typename Make>
const T& made_once(std::once_flag& once, std::unique_ptr<const T>& made, const Make& make) {
  std::call_once(once, [&] { tbb::this_task_arena::isolate([&] { made = make(); }); });
  return *made;
}

}  // namespace

const ExactPart& PartModel::exact(const Progress& progress) const {
  return made_once(exact_once_, exact_, [&] {
    return std::make_unique<const ExactPart>(part.mesh, geometry, frame, progress, part.effort);
  });
}

const ExactRays& PartModel::rays() const {
  return made_once(rays_once_, rays_, [&] {
    return std::make_unique<const ExactRays>(part.mesh, unit_positions(part.mesh, frame));
  });
}

std::shared_ptr<const PartModel> prepare_part(Part part, const Progress& progress) {
  const Stopwatch stopwatch;
  auto model = std::make_shared<PartModel>();
  model->part = std::move(part);
  const TriangleMesh& mesh = model->part.mesh;
  model->warnings = model->part.warnings;
  progress.report("orienting", 0.0);
  EdgeTable edges(mesh);
  const TurnedFacets turned = turn_if_inside_out(model->part.mesh, edges);
  if (turned.facets > 0) {
    edges = EdgeTable(mesh);
    model->warnings.push_back(turned_warning(turned));
  }
  progress.report("measuring facets", 0.0);
  model->geometry = facet_geometry(mesh);
  model->adjacency = build_adjacency(mesh, edges, progress);
  model->edges = bent_edges(mesh, model->geometry, model->adjacency);
  progress.report("checking health", 0.0);
  model->health = health_report(mesh, model->geometry, edges);
  model->frame = unit_frame(model->health.bounds);
  model->errors = part_errors(mesh, model->geometry, model->health, model->frame);
  for (std::string& warning : health_warnings(model->health)) model->warnings.push_back(std::move(warning));
  model->load_ms = stopwatch.elapsed_ms();
  return model;
}

namespace {

template <typename Read>
std::shared_ptr<const PartModel> loaded_part(const Read& read, const Progress& progress) {
  const Stopwatch stopwatch;
  Part part = read();
  put_in_place_order(part, progress);
  auto model = std::const_pointer_cast<PartModel>(prepare_part(std::move(part), progress));
  model->load_ms = stopwatch.elapsed_ms();
  return model;
}

}  // namespace

std::shared_ptr<const PartModel> load_part(const std::string& path, const ReadOptions& options,
                                           const Progress& progress) {
  return loaded_part([&] { return read_part(path, options, progress); }, progress);
}

std::shared_ptr<const PartModel> load_part_bytes(const std::string& name, std::string_view bytes,
                                                 const ReadOptions& options, const Progress& progress) {
  return loaded_part([&] { return read_part_bytes(name, bytes, options, progress); }, progress);
}

}  // namespace moldlight
