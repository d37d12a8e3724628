#include "gui/jobs/loaded_part.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/place_order.hpp"
#include "sweep/candidates/find_candidates.hpp"

namespace moldlight::gui {

namespace {

std::vector<FeatureDirection> feature_directions(const PartModel& model, const Progress& progress) {
  CandidateOptions options;
  options.kinds = {CandidateKind::axis, CandidateKind::revolution, CandidateKind::plane,
                   CandidateKind::perpendicular};
  options.most_per_kind = 12;
  options.merge_deg = 0.2;
  std::vector<FeatureDirection> features;
  for (const Candidate& candidate : find_candidates(model, options, progress))
    features.push_back({candidate.direction, candidate.sources.front().reason});
  return features;
}

}  // namespace

LoadedPart pictured_part(const std::string& path, const ReadOptions& options,
                         std::shared_ptr<const PartModel> part, const Progress& progress) {
  progress.report("preparing the picture", 0.0);
  const PartModel& model = *part;
  return {.path = path,
          .reading = options,
          .model = part,
          .geometry = std::make_shared<const ViewGeometry>(
              view_geometry(model.part.mesh, model.geometry, model.adjacency, model.frame)),
          .faces = std::make_shared<const Faces>(part_faces(model.part, model.geometry, model.adjacency)),
          .features = {}};
}

LoadedPart load_for_window(const std::string& path, const ReadOptions& options, const Progress& progress) {
  LoadedPart loaded = pictured_part(path, options, load_part(path, options, progress), progress);
  loaded.features = feature_directions(*loaded.model, progress);
  progress.report("ready", 1.0);
  return loaded;
}

std::shared_ptr<const PartModel> body_model(const PartModel& whole, std::size_t body,
                                            const Progress& progress) {
  Part part = extract_body(whole.part, body);
  part.effort = whole.part.effort;
  put_in_place_order(part, progress);
  return prepare_part(std::move(part), progress);
}

LoadedPart loaded_body(const LoadedPart& whole, std::size_t body, const Progress& progress) {
  ReadOptions reading = whole.reading;
  reading.body = std::to_string(body + 1);
  LoadedPart loaded = pictured_part(whole.path, reading, body_model(*whole.model, body, progress), progress);
  loaded.features = feature_directions(*loaded.model, progress);
  return loaded;
}

glm::dvec3 snapped_to(const std::vector<FeatureDirection>& features, const glm::dvec3& direction) {
  glm::dvec3 best = direction;
  double best_cosine = 0.0;
  for (const FeatureDirection& feature : features) {
    const double cosine = glm::dot(feature.direction, direction);
    if (std::abs(cosine) <= best_cosine) continue;
    best_cosine = std::abs(cosine);
    best = cosine > 0.0 ? feature.direction : -feature.direction;
  }
  return best;
}

}  // namespace moldlight::gui
