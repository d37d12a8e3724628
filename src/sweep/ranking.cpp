#include "sweep/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace moldlight {

namespace {

/// Figures closer than this share of the part's measure are equal: rounding of sums in double over millions
/// of facets.
constexpr double k_rounding = 1e-9;
constexpr double k_weight_step = 1e-6;
constexpr double k_travel_step = 0.01;  // of the diagonal: less says nothing about how well a mold is made

bool dominates(const RankedFigures& a, const RankedFigures& b, const PartMeasure& part) {
  const double undercut_slack = a.undercut_uncertainty + b.undercut_uncertainty + k_rounding * part.area;
  const double depth_slack = k_rounding * part.diagonal;
  if (a.undercut > b.undercut + undercut_slack) return false;
  if (a.undercuts > b.undercuts) return false;
  if (a.draw_depth > b.draw_depth + depth_slack) return false;
  return a.undercut < b.undercut - undercut_slack || a.undercuts < b.undercuts ||
         a.draw_depth < b.draw_depth - depth_slack;
}

}  // namespace

Ranking rank_directions(std::span<const RankedFigures> figures, const PartMeasure& part) {
  const std::size_t count = figures.size();
  Ranking ranking;
  ranking.order.resize(count);
  std::iota(ranking.order.begin(), ranking.order.end(), std::size_t{0});
  std::stable_sort(ranking.order.begin(), ranking.order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(!figures[a].decided, figures[a].value) <
           std::tuple(!figures[b].decided, figures[b].value);
  });

  ranking.tie_group.assign(count, 0);
  const double part_depth_step = k_rounding * part.diagonal, part_area_step = k_rounding * part.area;
  const auto tie_order = [&](std::size_t i) {
    return std::tuple(std::llround(figures[i].actions / k_weight_step),
                      std::llround(figures[i].travel / (k_travel_step * part.diagonal)), !figures[i].exact,
                      std::llround(figures[i].draw_depth / part_depth_step),
                      std::llround(figures[i].projected_area / part_area_step), i);
  };
  std::size_t group = 0;
  for (std::size_t first = 0; first < count; ++group) {
    const std::size_t best = ranking.order[first];
    // Members are not contiguous in the order of values when a later one is less certain; they are gathered.
    const auto ties = [&](std::size_t i) {
      return figures[i].decided == figures[best].decided &&
             figures[i].value - figures[best].value <=
                 figures[i].value_uncertainty + figures[best].value_uncertainty + k_rounding;
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
