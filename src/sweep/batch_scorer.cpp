#include "sweep/batch_scorer.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
#include "classify/classifier.hpp"
#include "classify/headless.hpp"
#include "mold/measure.hpp"

namespace moldlight {

namespace {

/// Up and down facets of less draft than this are left to rays: one texel of a map spans more than eleven
/// texels of their height.
constexpr double k_steep_deg = 5.0;

/// A software GL draws from the processor's cache, which the maps of a large batch would not fit in.
constexpr std::size_t k_software_map_bytes = 8U << 20;

}  // namespace

BatchScorer::BatchScorer(BatchScorerPart part, const BatchScorerSettings& settings)
    : part_(std::move(part)), settings_(settings), context_(create_context(settings.backend)) {
  const PartModel& model = *part_.model;
  const std::size_t bytes =
      context_->draws_on_cpu() ? std::min(settings.map_bytes, k_software_map_bytes) : settings.map_bytes;
  batch_size_ = static_cast<std::size_t>(fitting_places(settings.map, model.part.mesh.facets.size(), bytes));
  gl_.emplace(OnGl{part_buffers(*context_, model), {}, {}});
  classes_.resize(model.part.mesh.facets.size());
}

BatchScorer::~BatchScorer() {
  gl_.reset();
  context_->release_current();
}

void BatchScorer::make_room(std::size_t directions) {
  if (gl_->maps && static_cast<std::size_t>(gl_->maps->places()) >= directions) return;
  const auto capacity = static_cast<int>(directions);
  gl_->maps.reset();
  gl_->counting.reset();
  gl_->maps.emplace(context_->functions(), capacity);
  gl_->counting.emplace(context_->functions(), part_.samples.samples, capacity);
}

SampleCounts BatchScorer::begin(const glm::dvec3& direction, int place) {
  const FacetGeometry& geometry = part_.model->geometry;
  const MapFrame frame = map_frame(direction);
  const double sine_of_tau = std::sin(glm::radians(settings_.tau_deg));
  const double steep_sine = std::max(sine_of_tau, std::sin(glm::radians(k_steep_deg)));
  for (std::size_t facet = 0; facet < classes_.size(); ++facet) {
    const double sine = glm::dot(geometry.normals[facet], frame.z);
    const FacetClass own = facet_class(sine, sine_of_tau);
    const bool by_rays = own == FacetClass::near_vertical || std::abs(sine) < steep_sine;
    classes_[facet] = by_rays ? left_out(own) : own;
  }
  gl_->maps->draw({gl_->part, frame, classes_}, settings_.map, place);
  return ask_rays(frame.z);
}

SampleCounts BatchScorer::ask_rays(const glm::dvec3& direction) {
  const PartModel& model = *part_.model;
  sample_rays_.begin({.direction = direction, .lateral = settings_.map.lateral});
  for (const SurfaceSample& sample : part_.samples.samples) {
    const FacetClass own = counted(classes_[sample.facet]);
    if (own == classes_[sample.facet]) continue;
    const glm::dvec3& normal = model.geometry.normals[sample.facet];
    sample_rays_.add(0, sample.position, normal, own);
  }
  sample_rays_.ask(model.rays());
  SampleCounts counts;
  sample_rays_.for_each([&](std::size_t, bool plus, bool minus, float) {
    ++counts.regions[static_cast<std::size_t>(region_of(plus, minus))];
  });
  return counts;
}

std::vector<DirectionScore> BatchScorer::score(std::span<const ScoringTask> tasks) {
  if (tasks.empty()) return {};
  CHECK(tasks.size() <= batch_size_);
  make_room(tasks.size());
  std::vector<SampleCounts> steep;
  for (const ScoringTask& task : tasks)
    steep.push_back(begin(task.direction, static_cast<int>(steep.size())));

  const double total_area = part_.model->geometry.total_area;
  const double square = part_.model->frame.diagonal * part_.model->frame.diagonal;
  std::vector<DirectionScore> scores;
  for (SampleCounts counts : gl_->counting->run(*gl_->maps, static_cast<int>(tasks.size()))) {
    const std::size_t i = scores.size();
    counts.add(steep[i]);
    DirectionScore& score = scores.emplace_back();
    score.areas = counts.areas(total_area);
    score.undercut_error = 2.0 * counts.undercut(total_area).error;
    score.shadow_area = gl_->maps->shadow(static_cast<int>(i)) * square;
  }
  return scores;
}

}  // namespace moldlight
