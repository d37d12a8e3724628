#include "classify/picture_maps.hpp"

#include <algorithm>

namespace moldlight {

namespace {

constexpr int k_moving_resolution = 1024;
/// Half a texel's diagonal: the middle of the texel that is looked up beside a wall is then beside it, too.
constexpr double k_least_lateral_texels = 0.71;

}  // namespace

MethodSettings moving_method(const MethodSettings& settings, double diagonal) {
  MethodSettings moving = settings;
  moving.resolution = std::min(settings.resolution, k_moving_resolution);
  moving.edge_thickness = settings.edge_thickness * moving.resolution / settings.resolution;
  // A symmetric kernel is made of whole texels of its maps.
  if (settings.kernel_shape == KernelShape::symmetric) return moving;
  const double lateral = map_settings(settings, diagonal).lateral;
  moving.kernel = 0;
  moving.tolerance = diagonal * std::max(lateral, k_least_lateral_texels / moving.resolution);
  return moving;
}

void PictureMaps::draw_moving(const Query& query) {
  draw_quickly({query.direction, moving_method(query.method, model_->frame.diagonal)});
}

void PictureMaps::draw_quickly(const Query& query) {
  if (context_->draws_on_cpu() && query.method.kernel_shape == KernelShape::one_sided) {
    scan(query);
  } else {
    draw_resting(query);
  }
}

void PictureMaps::draw_resting(const Query& query) {
  draw_maps(query);
  direction_ = maps_.frame().z;
  lacks_depths_ = false;
}

void PictureMaps::take_split(const SplitMesh& split, const ViewGeometry& view, const Query& query) {
  direction_ = split_direction_ = query.direction.unit();
  split_.emplace(context_->functions(), split_geometry(split, model_->part.mesh, view, model_->frame),
                 facet_classes(model_->geometry, direction_, query.method.tau_deg));
}

ViewSubject PictureMaps::subject() const {
  const bool maps = maps_.revision() != 0 && maps_.frame().z == direction_;
  const bool split = split_ && split_direction_ == direction_;
  return {.part = buffers_,
          .direction = direction_,
          .maps = maps ? &maps_ : nullptr,
          .split = split ? &*split_ : nullptr};
}

void PictureMaps::scan(const Query& query) {
  const MethodSettings& settings = query.method;
  const TriangleMesh& mesh = model_->part.mesh;
  if (positions_.empty()) positions_ = unit_positions(mesh, model_->frame);
  if (!scanned_) scanned_.emplace(settings.resolution);
  if (scanned_->resolution() != settings.resolution) scanned_->set_resolution(settings.resolution);
  const MapFrame frame = map_frame(query.direction.unit());
  direction_ = frame.z;
  const MapSettings map = map_settings(settings, model_->frame.diagonal);
  const std::vector<FacetClass> classes = facet_classes(model_->geometry, frame.z, settings.tau_deg);
  scanned_->draw({mesh, positions_, model_->geometry.normals, model_->edges.concave}, frame, classes,
                 map.edge_thickness);
  maps_.load({buffers_, frame, classes}, map, *scanned_);
  lacks_depths_ = true;
}

void PictureMaps::complete_depths() {
  if (!lacks_depths_) return;
  maps_.load_depths(*scanned_);
  lacks_depths_ = false;
}

}  // namespace moldlight
