#include "sweep/direction_measurer.hpp"

#include <utility>

#include <tbb/parallel_for.h>

#include "base/error.hpp"
#include "parting/planar_line.hpp"

namespace moldlight {

std::optional<MeasuredDirection> DirectionMeasurer::measure_one(const glm::dvec3& direction,
                                                                const UndercutLimit& limit,
                                                                const Progress& progress) const {
  std::optional<Classification> found = classify_exact_within(model_, {direction, method_}, limit, progress);
  if (!found) return std::nullopt;
  const FacetFractions fractions = std::exchange(found->facet_fractions, {});
  MeasuredDirection measured{.classification = std::move(*found), .undercut_facets = {}};
  for (FacetIndex facet = 0; facet < fractions.size(); ++facet) {
    if (fractions[facet][static_cast<std::size_t>(Region::undercut)] > 0.0)
      measured.undercut_facets.push_back(facet);
  }
  find_beside(measured, beside_, progress);
  return measured;
}

void DirectionMeasurer::find_beside(MeasuredDirection& measured, const MeasuredBeside& asked,
                                    const Progress& progress) const {
  const Query query{measured.classification.direction, method_};
  if (asked.undercuts && !measured.undercuts)
    measured.undercuts = count_undercuts(model_,
                                         {.query = exact_query(model_, query),
                                          .facets = measured.undercut_facets,
                                          .least_travel_mm = asked.least_travel_mm},
                                         progress);
  if (!asked.parting || measured.parting || measured.lineless) return;
  const MoldLine found = find_mold_line(model_, query, {}, progress);
  measured.lineless = found.assignment.lineless;
  if (!measured.lineless) measured.parting = line_figures(found.line);
}

void DirectionMeasurer::complete(MeasuredDirection& measured, const Progress& progress) {
  arena_.execute([&] {
    find_beside(measured, {.undercuts = true, .parting = true, .least_travel_mm = beside_.least_travel_mm},
                progress);
  });
}

void DirectionMeasurer::find_lines(std::span<MeasuredDirection* const> measured, const Progress& progress) {
  arena_.execute([&] {
    tbb::parallel_for(std::size_t{0}, measured.size(), [&](std::size_t k) {
      tbb::this_task_arena::isolate([&] {
        try {
          find_beside(*measured[k], {.parting = true}, progress);
        } catch (const Cancelled&) {
          measured[k]->parting.reset();
        }
      });
    });
  });
}

std::vector<std::optional<MeasuredDirection>> DirectionMeasurer::measure(std::span<const ScoringTask> tasks,
                                                                         std::span<const FacetIndex> first,
                                                                         const Progress& progress,
                                                                         const std::function<bool()>& stop) {
  std::vector<std::optional<MeasuredDirection>> measured(tasks.size());
  arena_.execute([&] {
    tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t k) {
      if (stop()) return;
      // A thread that waits for parts of this direction begins no other one, which would take more room.
      tbb::this_task_arena::isolate([&] {
        try {
          const UndercutLimit limit{.undercut = tasks[k].give_up_above, .first = first};
          measured[k] = measure_one(tasks[k].direction, limit, progress);
        } catch (const Cancelled&) {
          measured[k] = std::nullopt;
        }
      });
    });
  });
  return measured;
}

}  // namespace moldlight
