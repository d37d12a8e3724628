#include "session/classifier.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
#include "mold/measure.hpp"

namespace moldlight {

namespace {

/// Perturbation of near-vertical facets for the facet-id readback: 0.5 degrees at 512 pixels (paper,
/// section 2.4), and in proportion to the pixel's size otherwise.
constexpr double k_perturbation_deg_at_512 = 0.5;

void add_audit(const Audit& audit, Classification& result) {
  result.audited_samples = audit.audited;
  result.audited_wrong = audit.wrong;
  result.uncertainty.audit = std::abs(audit.undercut_bias) + 2.0 * audit.undercut_error;
}

using Clock = std::chrono::steady_clock;

double elapsed_ms(Clock::time_point since) {
  return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

}  // namespace

MapSettings map_settings(const MethodSettings& settings, double diagonal) {
  MapSettings map;
  map.resolution = settings.resolution;
  map.edge_thickness = settings.edge_thickness;
  map.symmetric_kernel = settings.kernel_shape == KernelShape::symmetric;
  const double texel = 1.0 / settings.resolution;
  map.lateral = settings.tolerance ? *settings.tolerance / diagonal : 0.5 * (settings.kernel - 1) * texel;
  map.kernel_radius =
      settings.tolerance ? static_cast<int>(std::lround(map.lateral / texel)) : (settings.kernel - 1) / 2;
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

Classifier::Classifier(const gl::Context& context, std::shared_ptr<const PartModel> model)
    : context_(&context),
      model_(std::move(model)),
      buffers_(context.functions(), model_->part.mesh, model_->geometry, model_->frame,
               model_->edges.concave),
      maps_(context.functions()) {}

void Classifier::draw_maps(const MethodSettings& settings) {
  const MapFrame frame = map_frame(settings.direction);
  classes_ = facet_classes(model_->geometry, frame.z, settings.tau_deg);
  buffers_.set_facet_classes(classes_);
  maps_.draw(buffers_, frame, map_settings(settings, model_->frame.diagonal));
}

Classification Classifier::classify(const MethodSettings& settings, const Progress& progress) {
  Classification result = start(settings, progress);
  finish(result, progress);
  return result;
}

Classification Classifier::start(const MethodSettings& settings, const Progress& progress) {
  const auto began = Clock::now();
  const double diagonal = model_->frame.diagonal;
  const double square = diagonal * diagonal;
  const MapFrame frame = map_frame(settings.direction);
  const MapSettings map = map_settings(settings, diagonal);
  Classification result;
  result.settings = settings;
  result.direction = frame.z;
  result.backend = context_->backend();
  result.renderer = context_->renderer();
  result.texel = diagonal / settings.resolution;
  result.lateral_tolerance = map.lateral * diagonal;
  result.total_area = model_->geometry.total_area;
  result.warnings = model_->warnings;

  progress.report("drawing the maps", 0.0);
  classes_ = facet_classes(model_->geometry, frame.z, settings.tau_deg);
  double projected_total = 0.0;
  for (FacetIndex facet = 0; facet < classes_.size(); ++facet) {
    if (classes_[facet] == FacetClass::near_vertical)
      result.near_vertical_area += model_->geometry.areas[facet];
    projected_total +=
        model_->geometry.areas[facet] * std::abs(glm::dot(model_->geometry.normals[facet], frame.z));
  }
  buffers_.set_facet_classes(classes_);
  const double shadow = maps_.draw_and_measure_shadow(buffers_, frame, map);
  result.shadow_area = shadow * square;
  result.projected.identity = projected_total - 2.0 * result.shadow_area;
  result.projected.gap_limit = shadow_error_share(settings.resolution) * result.total_area;
  result.timings.maps_ms = elapsed_ms(began);
  result.timings.load_ms = model_->load_ms;
  return result;
}

void Classifier::finish(Classification& result, const Progress& progress) {
  CHECK(maps_.frame().z == result.direction);
  const auto began = Clock::now();
  progress.report("measuring", 0.0);
  if (result.settings.readout == Readout::samples) {
    measure_samples(result, progress);
  } else {
    read_facet_ids(result);
  }
  result.projected.gap = result.projected.surface - result.projected.identity;
  if (!result.projected.agrees() && model_->health.closed && result.settings.readout == Readout::samples) {
    result.warnings.emplace_back(
        "The two ways to find the hidden surface disagree: bodies of the part overlap.");
  }
  result.timings.measure_ms = elapsed_ms(began);
  result.timings.total_ms = result.timings.load_ms + result.timings.maps_ms + result.timings.measure_ms;
}

const SurfaceSamples& Classifier::surface_samples(int wanted) {
  if (!samples_ || sample_target_ != wanted) {
    samples_ = sample_surface(model_->part.mesh, model_->geometry, model_->frame,
                              static_cast<std::uint64_t>(wanted));
    sample_target_ = wanted;
  }
  return *samples_;
}

void Classifier::measure_samples(Classification& result, const Progress& progress) {
  const MethodSettings& settings = result.settings;
  const SurfaceSamples& samples = surface_samples(settings.samples);
  if (!sample_pass_) sample_pass_.emplace(context_->functions());
  std::vector<std::uint8_t> verdicts = sample_pass_->run(samples.samples, buffers_, maps_);
  std::vector<std::uint8_t> doubtful(verdicts.size());
  std::transform(verdicts.begin(), verdicts.end(), doubtful.begin(),
                 [](std::uint8_t bits) { return static_cast<std::uint8_t>(bits & verdict::k_doubtful); });

  progress.report("settling doubtful samples", 0.0);
  const ExactAnswers exact = exact_answers(result);
  // The paper's kernel has its own answer near contours, which rays would replace by the true one.
  const bool settle = settings.exact_rays && !maps_.settings().symmetric_kernel;
  if (settle) settle_doubtful(samples, exact, verdicts, doubtful);

  const Measurement measured = measure(samples, verdicts, model_->geometry, result.direction, doubtful);
  result.facet_fractions = measured.facet_fractions;
  result.areas = measured.areas;
  result.projected.surface = measured.projected_undercut;
  result.projected.gap_limit += 2.0 * measured.projected_undercut_error;
  result.samples = samples.samples.size();
  result.doubtful_samples =
      doubtful.size() - static_cast<std::size_t>(std::count(doubtful.begin(), doubtful.end(), 0));
  result.settled_samples = settle ? result.doubtful_samples : 0;
  result.uncertainty.sampling = 2.0 * measured.undercut_error;
  result.uncertainty.unsettled = measured.doubtful_area;
  if (settings.exact_rays) add_audit(audit_undoubted(samples, exact, verdicts, doubtful), result);
  result.uncertainty.total =
      std::hypot(result.uncertainty.sampling, result.uncertainty.audit) + result.uncertainty.unsettled;
}

void Classifier::read_facet_ids(Classification& result) {
  const MapFrame& frame = maps_.frame();
  const PartModel& model = *model_;
  if (!facet_id_pass_) facet_id_pass_.emplace(context_->functions());
  float top[2] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  for (const auto& facet : model.part.mesh.facets) {
    for (const VertexIndex vertex : facet) {
      const auto height = static_cast<float>(
          glm::dot(glm::dvec3(model.frame.to_unit(model.part.mesh.vertices[vertex])), frame.z));
      top[0] = std::max(top[0], height);
      top[1] = std::max(top[1], -height);
    }
  }
  const std::vector<std::uint8_t> bits = facet_id_pass_->run(
      buffers_, frame, top,
      {.resolution = result.settings.resolution,
       .draft_perturbation_deg = k_perturbation_deg_at_512 * 512.0 / result.settings.resolution});
  result.facet_fractions.resize(bits.size());
  for (FacetIndex facet = 0; facet < bits.size(); ++facet) {
    const double area = model.geometry.areas[facet];
    if (area <= 0.0) continue;
    const Region region = verdict_region(bits[facet]);
    result.facet_fractions[facet][static_cast<std::size_t>(region)] = 1.0F;
    result.areas[region] += area;
    if (region == Region::undercut) {
      result.projected.surface += area * std::abs(glm::dot(model.geometry.normals[facet], frame.z));
    }
  }
  if (!result.settings.exact_rays) return;

  // Whole facets have no sampling error; what they are off by, exact rays tell.
  const SurfaceSamples& samples = surface_samples(result.settings.samples);
  std::vector<std::uint8_t> verdicts(samples.samples.size());
  std::transform(samples.samples.begin(), samples.samples.end(), verdicts.begin(),
                 [&](const SurfaceSample& sample) { return bits[sample.facet]; });
  const std::vector<std::uint8_t> doubtful(verdicts.size(), 0);
  result.samples = verdicts.size();
  add_audit(audit_undoubted(samples, exact_answers(result), verdicts, doubtful), result);
  result.uncertainty.total = result.uncertainty.audit;
}

ExactAnswers Classifier::exact_answers(const Classification& result) const {
  return {*model_->rays,
          model_->geometry,
          classes_,
          {.direction = result.direction, .lateral = result.lateral_tolerance / model_->frame.diagonal}};
}

}  // namespace moldlight
