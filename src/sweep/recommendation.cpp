#include "sweep/recommendation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "classify/classification.hpp"
#include "classify/figure_table.hpp"
#include "mold/direction.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight {

namespace {

constexpr double k_wall_sine = 0.5;  // of the direction to the facet, at most: steeper than 60 degrees
constexpr double k_as_much = 5e-3;   // of the part's surface

/// Whether what stands across from the facet's middle, across the direction, is the part itself.
bool faces_a_wall(const PartModel& model, FacetIndex facet, const glm::dvec3& direction) {
  const glm::dvec3& normal = model.geometry.normals[facet];
  const double sine = glm::dot(normal, direction);
  if (std::abs(sine) > k_wall_sine) return false;
  const glm::dvec3 across = glm::normalize(normal - sine * direction);
  const TriangleMesh& mesh = model.part.mesh;
  const glm::dvec3 middle = mesh.middle(facet);
  return model.rays().first_hit(model.frame.to_unit(middle), glm::vec3(across), true).has_value();
}

struct Formed {
  double inner = 0.0, alone = 0.0;
};

struct CoreSide {
  bool along = true;  // the core is on the direction's side, else on the opposite one
  std::string why;
};

CoreSide core_side(const PartModel& model, const Query& query, const Progress& progress) {
  const Classification found = classify_exact(model, query, progress);
  Formed core, cavity;
  for (FacetIndex facet = 0; facet < found.facet_fractions.size(); ++facet) {
    const auto& fractions = found.facet_fractions[facet];
    const auto area = [&](Region region) {
      return fractions[static_cast<std::size_t>(region)] * model.geometry.areas[facet];
    };
    const double by_core = area(Region::core), by_cavity = area(Region::cavity);
    core.alone += by_core;
    cavity.alone += by_cavity;
    if (by_core + by_cavity <= 0.0 || !faces_a_wall(model, facet, found.direction)) continue;
    core.inner += by_core;
    cavity.inner += by_cavity;
  }
  const double as_much = k_as_much * model.geometry.total_area;
  const auto area = [style = FigureStyle(model)](double one) {
    return style.with_unit(FigureKind::area, one);
  };
  const auto made = [&](bool along, const std::string& why) {
    const glm::dvec3 side = along ? found.direction : -found.direction;
    return CoreSide{along, fmt::format("The core is on the side of {}: {}", direction_words(side), why)};
  };
  if (const double difference = core.inner - cavity.inner; std::abs(difference) > as_much) {
    const auto [less, more] = std::minmax(core.inner, cavity.inner);
    return made(difference > 0.0,
                fmt::format("the part shrinks onto {} of inner walls there, and onto {} on the other side",
                            area(more), area(less)));
  }
  if (const double difference = core.alone - cavity.alone; std::abs(difference) > as_much) {
    const auto [less, more] = std::minmax(core.alone, cavity.alone);
    return made(difference > 0.0, fmt::format("that half alone forms {} of the surface, the other half {}",
                                              area(more), area(less)));
  }
  return made(true, "either half may be the core, since both form the same area");
}

}  // namespace

Recommendation recommendation(const PartModel& model, const MethodSettings& method,
                              std::span<const SweepCandidate> candidates, const Progress& progress) {
  const SweepCandidate& best = candidates.front();
  const CoreSide core = core_side(model, {best.candidate.direction, method}, progress);
  Recommendation found{.direction = (core.along ? best.candidate.direction : -best.candidate.direction) + 0.0,
                       .why = mold_text(model, best),
                       .beside = best.beside};
  if (found.why.empty()) found.why = "its side actions were not computed";
  found.name = direction_words(found.direction);
  if (best.candidate.canonical && !nearest_axis(found.direction).is_met())
    found.name = best.candidate.canonical->name;
  if (candidates.size() > 1 && !candidates[1].rank_reasons.empty())
    found.why += fmt::format(". The next, {}, {}", direction_words(candidates[1].candidate.direction),
                             candidates[1].rank_reasons.front());
  found.why += ". " + core.why;
  return found;
}

}  // namespace moldlight
