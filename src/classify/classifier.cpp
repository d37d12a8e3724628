#include "classify/classifier.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
#include "base/stopwatch.hpp"
#include "mold/measure.hpp"

namespace moldlight {

namespace {

/// Perturbation of near-vertical facets for the facet-id readback: 0.5 degrees at 512 pixels (paper,
/// section 2.4), and in proportion to the pixel's size otherwise.
constexpr double k_perturbation_deg_at_512 = 0.5;

}  // namespace

MapSettings map_settings(const MethodSettings& settings, double diagonal) {
  MapSettings map;
  map.resolution = settings.resolution;
  map.edge_thickness = settings.edge_thickness;
  map.symmetric_kernel = settings.kernel_shape == KernelShape::symmetric;
  map.lateral =
      settings.kernel > 0 ? kernel_share(settings) : lateral_tolerance(settings, diagonal) / diagonal;
  map.kernel_radius = static_cast<int>(std::lround(map.lateral * settings.resolution));
  // The paper's kernel is 3 x 3 where nobody says otherwise, however coarse the maps.
  if (settings.kernel == 0 && settings.tolerance <= 0.0) map.kernel_radius = std::max(1, map.kernel_radius);
  return map;
}

std::vector<FacetClass> facet_classes(const FacetGeometry& geometry, const glm::dvec3& direction,
                                      double tau_deg) {
  std::vector<FacetClass> classes;
  classes.reserve(geometry.normals.size());
  const double threshold = std::sin(glm::radians(tau_deg));
  for (const glm::dvec3& normal : geometry.normals) {
    classes.push_back(facet_class(glm::dot(normal, direction), threshold));
  }
  return classes;
}

PartBuffers part_buffers(const gl::Context& context, const PartModel& model) {
  return {context.functions(), {model.part.mesh, model.geometry, model.frame, model.edges.concave}};
}

PartMaps::PartMaps(const gl::Context& context, std::shared_ptr<const PartModel> model)
    : context_(&context),
      model_(std::move(model)),
      buffers_(part_buffers(context, *model_)),
      maps_(context.functions()) {}

void PartMaps::draw_maps(const Query& query) {
  const MapFrame frame = map_frame(query.direction.unit());
  const std::vector<FacetClass> classes = facet_classes(model_->geometry, frame.z, query.method.tau_deg);
  maps_.draw({buffers_, frame, classes}, map_settings(query.method, model_->frame.diagonal));
}

Classification Classifier::classify(const Query& query, const Progress& progress, bool with_split) {
  Classification result = classify_exact(*model_, query, progress, with_split);
  const MethodSettings& settings = query.method;
  if (settings.readout == Readout::exact) return result;
  const Stopwatch stopwatch;
  result.backend = context_->backend();
  result.renderer = context_->renderer();
  progress.report("drawing the maps", 0.0);
  draw_maps(query);
  progress.report("measuring", 0.0);
  result.facet_fractions = settings.readout == Readout::samples ? fractions_by_samples(settings.samples)
                                                                : fractions_by_facet_id(settings);
  const double exact_undercut = result.areas[Region::undercut];
  result.areas = region_areas(result.facet_fractions, model_->geometry);
  result.uncertainty.readout += std::abs(result.areas[Region::undercut] - exact_undercut);
  result.timings.readout_ms = stopwatch.elapsed_ms();
  result.timings.total_ms += result.timings.readout_ms;
  return result;
}

void Classifier::compare_maps(Classification& result, const Progress& progress) {
  CHECK(result.split != nullptr);
  progress.report("comparing the maps", 0.0);
  result.backend = context_->backend();
  result.renderer = context_->renderer();
  draw_maps(result.query());
  const PieceSamples samples =
      sample_pieces(*result.split, model_->frame, static_cast<std::size_t>(result.settings.samples));
  result.maps = moldlight::compare_maps(samples, look_up(samples.samples));
}

FacetFractions Classifier::fractions_by_samples(int wanted) {
  if (!samples_ || sample_target_ != wanted) {
    samples_ = sample_surface(model_->part.mesh, model_->geometry, model_->frame,
                              static_cast<std::uint64_t>(wanted));
    sample_target_ = wanted;
  }
  return sampled_fractions(*samples_, look_up(samples_->samples));
}

std::vector<std::uint8_t> Classifier::look_up(std::span<const SurfaceSample> samples) {
  if (!sample_pass_) sample_pass_.emplace(context_->functions());
  return sample_pass_->run(samples, maps_);
}

FacetFractions Classifier::fractions_by_facet_id(const MethodSettings& settings) {
  const MapFrame& frame = maps_.frame();
  if (!facet_id_pass_) facet_id_pass_.emplace(context_->functions());
  float top[2] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  for (const auto& facet : model_->part.mesh.facets) {
    for (const VertexIndex vertex : facet) {
      const auto height = static_cast<float>(
          glm::dot(glm::dvec3(model_->frame.to_unit(model_->part.mesh.vertices[vertex])), frame.z));
      top[0] = std::max(top[0], height);
      top[1] = std::max(top[1], -height);
    }
  }
  const std::vector<FacetClass> classes = facet_classes(model_->geometry, frame.z, settings.tau_deg);
  const std::vector<std::uint8_t> bits = facet_id_pass_->run(
      {buffers_, frame, classes}, top,
      {.resolution = settings.resolution,
       .draft_perturbation_deg = k_perturbation_deg_at_512 * 512.0 / settings.resolution});
  FacetFractions fractions(bits.size());
  for (FacetIndex facet = 0; facet < bits.size(); ++facet) {
    if (model_->geometry.areas[facet] <= 0.0) continue;
    fractions[facet][static_cast<std::size_t>(verdict_region(bits[facet]))] = 1.0;
  }
  return fractions;
}

}  // namespace moldlight
