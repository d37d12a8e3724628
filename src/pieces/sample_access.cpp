#include "pieces/sample_access.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "mold/draft.hpp"
#include "sweep/sample_rays.hpp"

namespace moldlight {

SampleAccess::SampleAccess(const PartModel& model, const ExactQuery& query, std::span<const PullLine> lines)
    : model_(model), query_(query), lines_(lines), columns_(2 * lines.size()) {}

void SampleAccess::add(std::span<const SurfaceSample> samples, std::span<const std::size_t> blocked,
                       const Progress& progress) {
  const std::size_t first =
      groups_.empty() ? 0 : (groups_.back().first + groups_.back().count + 63) / 64 * 64;
  for (BitSet& column : columns_) column.resize(first + samples.size());
  const double sine_of_tau = std::sin(glm::radians(query_.tau_deg));
  tbb::enumerable_thread_specific<SampleRays> rooms;
  tbb::parallel_for(std::size_t{0}, lines_.size(), [&](std::size_t line) {
    if (progress.cancelled()) return;
    const glm::dvec3& direction = lines_[line].direction;
    SampleRays& rays = rooms.local();
    rays.begin({.direction = direction, .lateral = query_.lateral});
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const glm::dvec3& normal = model_.geometry.normals[samples[k].facet];
      rays.add(first + k, samples[k].position, normal, facet_class(glm::dot(normal, direction), sine_of_tau));
    }
    rays.ask(model_.rays());
    rays.for_each([&](std::size_t sample, bool plus, bool minus, float) {
      if (plus) columns_[2 * line].set(sample);
      if (minus) columns_[2 * line + 1].set(sample);
    });
  });
  if (progress.cancelled()) throw Cancelled();
  for (const std::size_t column : blocked) {
    for (std::size_t k = 0; k < samples.size(); ++k) columns_[column].reset(first + k);
  }
  BitSet reached(first + samples.size());
  for (const BitSet& column : columns_) reached.add(column);
  std::size_t count = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) count += reached.has(first + k) ? 1 : 0;
  reachable_.push_back(count);
  groups_.push_back({.first = first, .count = samples.size()});
}

}  // namespace moldlight
