#include "mold/sweep/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace moldlight {

namespace {

constexpr std::array<std::string_view, k_criterion_count> k_names = {"undercut", "patches", "draw-depth",
                                                                     "projected-area", "undraughted-area"};

/// Figures closer than this share of the part's measure are equal: rounding of sums in double over millions
/// of facets.
constexpr double k_rounding = 1e-9;

double measure_of(Criterion criterion, const PartMeasure& part) {
  switch (criterion) {
    case Criterion::patches:
      return 1.0;
    case Criterion::draw_depth:
      return part.diagonal;
    case Criterion::undercut:
    case Criterion::projected_area:
    case Criterion::undraughted_area:
      return part.area;
  }
  return 1.0;
}

/// Width of the objective's interval from the undercut's uncertainty.
double objective_uncertainty(const Objective& objective, const DirectionFigures& figures,
                             const PartMeasure& part) {
  const double weight = objective.weights[static_cast<std::size_t>(Criterion::undercut)];
  return std::abs(weight) * figures.undercut_uncertainty / part.area;
}

bool dominates(const DirectionFigures& a, const DirectionFigures& b, const PartMeasure& part) {
  const double undercut_slack = a.undercut_uncertainty + b.undercut_uncertainty + k_rounding * part.area;
  const double depth_slack = k_rounding * part.diagonal;
  if (a[Criterion::undercut] > b[Criterion::undercut] + undercut_slack) return false;
  if (a[Criterion::patches] > b[Criterion::patches]) return false;
  if (a[Criterion::draw_depth] > b[Criterion::draw_depth] + depth_slack) return false;
  return a[Criterion::undercut] < b[Criterion::undercut] - undercut_slack ||
         a[Criterion::patches] < b[Criterion::patches] ||
         a[Criterion::draw_depth] < b[Criterion::draw_depth] - depth_slack;
}

}  // namespace

std::string_view criterion_name(Criterion criterion) { return k_names[static_cast<std::size_t>(criterion)]; }

Objective parse_objective(std::string_view text) {
  Objective objective;
  objective.weights.fill(0.0);
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view term = rest.substr(0, comma);
    const std::size_t colon = term.find(':');
    const std::string_view name = term.substr(0, colon);
    const auto found = std::find(k_names.begin(), k_names.end(), name);
    if (found == k_names.end()) {
      throw UsageError(fmt::format("--objective: '{}' is none of {}", name, fmt::join(k_names, ", ")));
    }
    double weight = 1.0;
    if (colon != std::string_view::npos) {
      const std::string_view number = term.substr(colon + 1);
      weight = number_from<double>(number).value_or(-1.0);
      if (!(weight >= 0.0) || !std::isfinite(weight)) {
        throw UsageError(fmt::format("--objective: the weight '{}' is not a number of at least 0", number));
      }
    }
    objective.weights[static_cast<std::size_t>(found - k_names.begin())] += weight;
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (std::all_of(objective.weights.begin(), objective.weights.end(), [](double w) { return w == 0.0; })) {
    throw UsageError("--objective: all weights are 0");
  }
  return objective;
}

double objective_value(const Objective& objective, const DirectionFigures& figures, const PartMeasure& part) {
  double value = 0.0;
  for (std::size_t i = 0; i < k_criterion_count; ++i) {
    if (objective.weights[i] == 0.0) continue;
    value += objective.weights[i] * figures.values[i] / measure_of(static_cast<Criterion>(i), part);
  }
  return value;
}

Ranking rank_directions(std::span<const DirectionFigures> figures, const Objective& objective,
                        const PartMeasure& part) {
  const std::size_t count = figures.size();
  std::vector<double> values(count), slack(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = objective_value(objective, figures[i], part);
    slack[i] = objective_uncertainty(objective, figures[i], part);
  }
  Ranking ranking;
  ranking.order.resize(count);
  std::iota(ranking.order.begin(), ranking.order.end(), std::size_t{0});
  std::stable_sort(ranking.order.begin(), ranking.order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });

  ranking.tie_group.assign(count, 0);
  const double part_depth_step = k_rounding * part.diagonal, part_area_step = k_rounding * part.area;
  const auto tie_order = [&](std::size_t i) {
    return std::tuple(!figures[i].exact, std::llround(figures[i][Criterion::draw_depth] / part_depth_step),
                      std::llround(figures[i][Criterion::projected_area] / part_area_step), i);
  };
  std::size_t group = 0;
  for (std::size_t first = 0; first < count; ++group) {
    const std::size_t best = ranking.order[first];
    // Members are not contiguous in the order of values when a later one is less certain; they are gathered.
    const auto ties = [&](std::size_t i) {
      return values[i] - values[best] <= slack[i] + slack[best] + k_rounding;
    };
    const auto begin = ranking.order.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = std::stable_partition(begin, ranking.order.end(), ties);
    std::sort(begin, end, [&](std::size_t a, std::size_t b) { return tie_order(a) < tie_order(b); });
    for (auto member = begin; member != end; ++member) ranking.tie_group[*member] = group;
    first = static_cast<std::size_t>(end - ranking.order.begin());
  }

  ranking.pareto.assign(count, true);
  for (std::size_t b = 0; b < count; ++b) {
    for (std::size_t a = 0; a < count && ranking.pareto[b]; ++a) {
      if (a != b && dominates(figures[a], figures[b], part)) ranking.pareto[b] = false;
    }
  }
  return ranking;
}

}  // namespace moldlight
