#include "classify/classification.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/stopwatch.hpp"

namespace moldlight {

namespace {

/// Of a part whose shadow has two areas, or whose facets cross: what the figures mean then.
void add_warnings(const PartModel& model, const ExactPart& part, Classification& result) {
  std::size_t crossed = 0;
  for (FacetIndex facet = 0; facet < part.mesh().facets.size(); ++facet) {
    crossed += part.crossings(facet).empty() ? 0 : 1;
  }
  if (crossed > 0) {
    result.warnings.push_back(fmt::format(
        "{} facets cross others: bodies of the part overlap. Surface inside the material counts as undercut.",
        crossed));
  }
  if (model.health.closed && !result.identity.agrees()) {
    result.warnings.push_back(fmt::format(
        "The part's shadow has different areas from the two sides: {}a body of the part is inside out.",
        crossed > 0 ? "bodies overlap, or " : ""));
  }
}

Classification classification_of(const PartModel& model, const Query& asked, const ExactPart& part,
                                 ExactAreas found) {
  const ExactQuery query = exact_query(model, asked);
  const MethodSettings& settings = asked.method;
  Classification result;
  result.settings = settings;
  result.direction = query.direction;
  result.texel = model.frame.diagonal / settings.resolution;
  result.lateral_tolerance = lateral_tolerance(settings, model.frame.diagonal);
  result.total_area = model.geometry.total_area;
  result.warnings = model.warnings;
  result.areas = found.areas;
  result.near_vertical_area = found.near_vertical_area;
  result.reverse_draft = reverse_draft(found.facet_fractions, model.geometry, query.direction);
  result.identity = {.core = found.projected_core,
                     .cavity = found.projected_cavity,
                     .gap = found.projected_core - found.projected_cavity,
                     .gap_limit = model.errors.shadow_gap + found.projected_doubt};
  result.shadow_area = std::max(found.projected_core, found.projected_cavity);
  result.projected_undercut = std::max(
      0.0, projected_area(model.geometry, result.direction) - found.projected_core - found.projected_cavity);
  result.uncertainty.rounding = rounding_bound(part, query, found, model.errors);
  result.uncertainty.mesh = mesh_doubt(part, found, model.adjacency, model.errors);
  result.uncertainty.readout = found.sampling_error;
  result.uncertainty.sampled_facets = found.sampled_facets;
  result.facet_fractions = std::move(found.facet_fractions);
  add_warnings(model, part, result);
  return result;
}

Timings timings_of(const PartModel& model, double regions_ms) {
  return {.load_ms = model.load_ms, .regions_ms = regions_ms, .total_ms = model.load_ms + regions_ms};
}

}  // namespace

ExactQuery exact_query(const PartModel& model, const Query& query) {
  return {.direction = query.direction.unit(),
          .tau_deg = query.method.tau_deg,
          .lateral = lateral_tolerance(query.method, model.frame.diagonal) / model.frame.diagonal};
}

Classification classify_exact(const PartModel& model, const Query& query, const Progress& progress,
                              bool with_split) {
  if (!with_split) return *classify_exact_within(model, query, {}, progress);
  const Stopwatch stopwatch;
  const ExactPart& part = model.exact(progress);
  ExactSplit split = exact_split(part, exact_query(model, query), progress);
  Classification result = classification_of(model, query, part, std::move(split.areas));
  result.timings = timings_of(model, stopwatch.elapsed_ms());
  result.split = std::make_shared<const SplitMesh>(std::move(split.mesh));
  return result;
}

std::optional<Classification> classify_exact_within(const PartModel& model, const Query& query,
                                                    const UndercutLimit& limit, const Progress& progress) {
  const Stopwatch stopwatch;
  const ExactPart& part = model.exact(progress);
  std::optional<ExactAreas> found = exact_areas_within(part, exact_query(model, query), limit, progress);
  if (!found) return std::nullopt;
  Classification result = classification_of(model, query, part, std::move(*found));
  result.timings = timings_of(model, stopwatch.elapsed_ms());
  return result;
}

}  // namespace moldlight
