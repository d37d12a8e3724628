#include "gui/scene.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "session/classifier.hpp"

namespace moldlight::gui {

Extent extent_along(const PartModel& model, const glm::dvec3& direction) {
  Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const glm::dvec3& vertex : model.part.mesh.vertices) {
    const double height = glm::dot(vertex, direction);
    extent.min = std::min(extent.min, height);
    extent.max = std::max(extent.max, height);
  }
  const double middle = glm::dot(model.frame.center, direction);
  return {(extent.min - middle) / model.frame.diagonal, (extent.max - middle) / model.frame.diagonal};
}

Scene::Scene(const gl::Context& context, const LoadedPart& part)
    : context_(&context),
      part_(part),
      maps_(context, part.model),
      view_(context.functions(), *part.geometry),
      map_picture_(context.functions()) {}

bool Scene::draw(const ViewTarget& target, const SceneSettings& settings) {
  const MethodSettings& method = settings.method;
  const MapInputs inputs{.direction = glm::normalize(method.direction),
                         .tau_deg = method.tau_deg,
                         .settings = map_settings(method, part_.model->frame.diagonal)};
  if (settings.split != split_) {
    split_ = settings.split;
    split_ ? maps_.take_split(*split_, *part_.geometry, method) : maps_.drop_split();
  }
  // Coarse maps do until the split mesh is there, which comes at once.
  const bool fine = settings.maps_looked_at && !settings.direction_moves;
  if (maps_of_ != inputs || (fine && maps_are_coarse_)) {
    fine ? maps_.draw_resting(method) : maps_.draw_moving(method);
    maps_of_ = inputs;
    maps_are_coarse_ = !fine;
    thumbnails_stale_ = true;
  }
  if (fine && settings.samples) compare_with(settings.samples);
  if (settings.view.contour_edges) find_contour_edges(inputs);
  drawn_ = true;
  return view_.draw(target, maps_.subject(), settings.camera, settings.view, settings.marks);
}

void Scene::compare_with(const std::shared_ptr<const PieceSamples>& samples) {
  const std::uint64_t revision = maps_.maps().revision();
  if (compared_samples_ == samples && compared_maps_ == revision) return;
  if (!sample_pass_) sample_pass_.emplace(context_->functions());
  comparison_ = std::make_shared<const MapComparison>(
      compare_maps(*samples, sample_pass_->run(samples->samples, maps_.buffers(), maps_.maps())));
  compared_samples_ = samples;
  compared_maps_ = revision;
}

void Scene::find_contour_edges(const MapInputs& inputs) {
  if (contour_of_ == inputs) return;
  const PartModel& model = *part_.model;
  const std::vector<FacetClass> classes = facet_classes(model.geometry, inputs.direction, inputs.tau_deg);
  const TriangleMesh& mesh = model.part.mesh;
  view_.set_contour_edges(contour_edges(mesh, model.edges.convex, classes, model.frame),
                          contour_edges(mesh, model.edges.concave, classes, model.frame));
  contour_of_ = inputs;
}

void Scene::choose_face(const ChosenFace* face) {
  view_.choose_facets(face != nullptr ? face->facets : std::vector<FacetIndex>());
  view_.set_outline(face != nullptr ? outline_of(*part_.model, *face) : std::vector<ViewSegment>());
}

std::optional<PickedPoint> Scene::pick(const glm::ivec2& pixel) const {
  if (!drawn_) return std::nullopt;
  return view_.pick(pixel);
}

Scene::Thumbnails Scene::thumbnails(int size_px) {
  if (!maps_of_) return {};
  if (!plus_ || plus_->size().x != size_px) {
    plus_.emplace(context_->functions(), glm::ivec2(size_px));
    minus_.emplace(context_->functions(), glm::ivec2(size_px));
    thumbnails_stale_ = true;
  }
  if (thumbnails_stale_) {
    maps_.complete_depths();
    map_picture_.draw(plus_->framebuffer(), plus_->size(), maps_.maps(), true);
    map_picture_.draw(minus_->framebuffer(), minus_->size(), maps_.maps(), false);
    thumbnails_stale_ = false;
  }
  return {plus_->texture(), minus_->texture()};
}

}  // namespace moldlight::gui
