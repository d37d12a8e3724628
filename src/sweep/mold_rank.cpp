#include "sweep/mold_rank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "mold/direction.hpp"

namespace moldlight {

namespace {

using enum MoldCriterion;

struct CriterionFacts {
  double band;
  std::string_view words;  // of the difference in per cent, and whether it is more or less
};

constexpr std::array<CriterionFacts, k_mold_criteria> k_facts = {{
    {0.5, ""},
    {1e-2, "leaves {} % {} of the surface unreleased"},
    {0.05, ""},
    {0.02, "its parting line climbs {} % of the diagonal {}"},
    {0.02, "has {} % {} of the surface with too little draft"},
    {5e-3, "has {} % {} of the surface undercut"},
    {0.02, "has {} % of the diagonal {} draw depth"},
    {0.02, ""},
}};

MoldCriterion criterion(std::size_t place) { return static_cast<MoldCriterion>(place); }

std::optional<MoldCriterion> deciding(const MoldCost& worse, const MoldCost& better) {
  for (std::size_t k = 0; k < k_mold_criteria; ++k) {
    if (worse.values[k] > better.values[k] + mold_band(criterion(k), better.values[k])) return criterion(k);
  }
  return std::nullopt;
}

/// "1 lifter more, 2 slides less"
std::string actions_difference(const MoldCost& one, const MoldCost& other) {
  std::string more, less;
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind) {
    const std::size_t a = one.counts[kind], b = other.counts[kind], count = a > b ? a - b : b - a;
    if (count == 0) continue;
    const ActionFacts& words = facts(static_cast<ActionKind>(kind));
    std::string& text = a > b ? more : less;
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : ", ", count, count == 1 ? words.singular : words.plural);
  }
  if (!more.empty()) more += " more";
  if (!less.empty()) less += " less";
  return more + (more.empty() || less.empty() ? "" : ", ") + less;
}

std::string per_cent(double share) {
  return fmt::format(fmt::runtime(share < 0.095 ? "{:.2g}" : "{:.0f}"), 100.0 * share);
}

constexpr double k_weight_of_rest = 4;  // what nothing releases: more than any one side action
constexpr double k_least_left = 1e-4;   // of the surface: less is a speck
constexpr double k_least_climb = 5e-3;  // of the diagonal, by which a line is worse, to be named
constexpr double k_least_gain = 0.02;   // of surface or diagonal: a reason to turn

/// A figure in which two directions may differ, as shown for the one.
struct Difference {
  double by = 0.0;  // in bands; less is better
  std::string text;
  double noted = 1.0;  // bands from which on a trade mentions it
};

Difference difference(MoldCriterion criterion, const MoldCost& one, const MoldCost& other,
                      std::optional<double> noted = std::nullopt) {
  const CriterionFacts& facts = k_facts[static_cast<std::size_t>(criterion)];
  const double by = one.of(criterion) - other.of(criterion);
  if (criterion == found && one.canonical && other.canonical)
    return {by / facts.band, by > 0.0 ? "is within 10° of a direction that more of the walls follow"
                                      : "has more walls that follow it"};
  if (criterion == found)
    return {by / facts.band, by > 0.0 ? "is not an axis or a face normal of the part"
                                      : "is an axis or a face normal of the part"};
  return {by / facts.band,
          fmt::format(fmt::runtime(facts.words), per_cent(std::abs(by)), by > 0.0 ? "more" : "less"),
          noted.value_or(facts.band) / facts.band};
}

std::vector<Difference> differences(const MoldCost& one, const MoldCost& other) {
  const double by_formed = one.formed - other.formed;
  Difference released = difference(unreleased, one, other, k_least_left);
  if (std::max(one.beyond, other.beyond) > k_least_left)
    released.text += fmt::format(" with {} side actions", k_most_actions);
  return {difference(found, one, other),
          released,
          {(one.weight - other.weight) / mold_band(effort), "needs " + actions_difference(one, other), 1e-6},
          {k_effort_of_formed * by_formed / mold_band(effort),
           fmt::format("its side actions form {} % {} of the surface", per_cent(std::abs(by_formed)),
                       by_formed > 0.0 ? "more" : "less")},
          difference(line, one, other, k_least_climb),
          difference(draft, one, other),
          difference(undercut, one, other),
          difference(depth, one, other)};
}

}  // namespace

double mold_effort(const MoldCost& cost) {
  const double rest = cost.of(unreleased) > k_least_left ? k_weight_of_rest : 0.0;
  return rest + cost.weight - cost.in_vain + k_effort_of_formed * cost.formed + cost.on_its_side +
         k_effort_of_draft * cost.of(draft) + std::min(k_most_of_line, cost.of(line));
}

double effort_on_its_side(double formed, double least_formed) {
  const double usual = std::max(k_on_its_side, least_formed + k_beyond_the_least);
  return k_effort_on_its_side * std::max(0.0, formed - usual);
}

double mold_band(MoldCriterion criterion, double least) {
  constexpr double k_band_of_left = 0.2;  // of what nothing releases: how sure one is of it
  const double band = k_facts[static_cast<std::size_t>(criterion)].band;
  return criterion == unreleased ? std::max(band, k_band_of_left * least) : band;
}

bool costs_no_more(const MoldCost& one, const MoldCost& other) {
  const double most = other.weight + mold_band(effort);
  const auto left = [](const MoldCost& cost) { return cost.of(unreleased) - cost.beyond; };
  return left(one) <= left(other) + mold_band(unreleased, left(other)) &&
         (one.weight <= most || one.weight - one.in_vain <= most - other.in_vain);
}

void settle(std::span<MoldCost> costs) {
  const auto left = [](const MoldCost& cost) { return cost.of(unreleased); };
  const double least_left = costs.empty() ? 0.0 : left(*std::ranges::min_element(costs, {}, left));
  double least_formed = 1.0;
  for (const MoldCost& cost : costs) {
    if (left(cost) <= least_left + mold_band(unreleased, least_left))
      least_formed = std::min(least_formed, cost.formed);
  }
  for (MoldCost& cost : costs) {
    const double before = cost.on_its_side;
    cost.on_its_side = effort_on_its_side(cost.formed, least_formed);
    cost.of(effort) += cost.on_its_side - before;
  }
  // Of the surface, where a part has to be changed, or changing it saves a heap of side actions; and where
  // half of it speaks for the other direction.
  constexpr double k_worth_a_tilt = 0.05, k_worth_a_clear_tilt = 0.2, k_clear = 0.5;
  const auto worth = [&](const MoldCost& other) {
    return other.of(support) <= 1.0 - k_clear ? k_worth_a_clear_tilt : k_worth_a_tilt;
  };
  const auto beats = [&](const MoldCost& other, const MoldCost& cost) {
    if (!other.canonical) return false;
    if (cost.canonical)
      return other.of(support) < cost.of(support) - mold_band(support) &&
             line_angle_deg(other.direction, cost.direction) <= k_beside_deg && costs_no_more(other, cost);
    const bool changed =
        cost.of(unreleased) > mold_band(unreleased) || cost.weight >= other.weight + k_weight_of_rest;
    return costs_no_more(other, cost) ||
           (changed && other.of(unreleased) <= cost.of(unreleased) + worth(other));
  };
  for (MoldCost& cost : costs) {
    const bool beaten = std::ranges::any_of(costs, [&](const MoldCost& other) { return beats(other, cost); });
    cost.of(found) = beaten ? 1.0 : 0.0;
  }
}

MoldOrder mold_order(std::span<const MoldCost> costs) {
  std::vector<std::size_t> left(costs.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  MoldOrder found;
  while (!left.empty()) {
    std::vector<std::size_t> tied = left;
    for (std::size_t k = 0; k < k_mold_criteria; ++k) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t i : tied) least = std::min(least, costs[i].values[k]);
      const double most = least + mold_band(criterion(k), least);
      std::erase_if(tied, [&](std::size_t i) { return costs[i].values[k] > most; });
    }
    const std::size_t first = tied.front();
    found.decided_by.push_back(found.order.empty() ? std::nullopt
                                                   : deciding(costs[first], costs[found.order.back()]));
    found.order.push_back(first);
    std::erase(left, first);
  }
  return found;
}

std::vector<std::string> rank_reasons(const MoldCost& one, const MoldCost& other) {
  std::vector<std::string> against, in_favour;
  for (const Difference& each : differences(one, other)) {
    if (each.by > 1.0) {
      against.push_back(each.text);
    } else if (each.by < -1.0) {
      in_favour.push_back("but " + each.text);
    }
  }
  against.insert(against.end(), in_favour.begin(), in_favour.end());
  return against;
}

MoldTrade mold_trade(MoldCost one, const MoldCost& other) {
  one.of(found) = other.of(found);
  one.of(depth) = other.of(depth);
  const auto less = [&](MoldCriterion criterion) { return other.of(criterion) - one.of(criterion); };
  const double heavier = one.weight - other.weight, band = mold_band(effort);
  const double released = one.of(unreleased) <= k_least_left ? k_least_left : k_least_gain;
  MoldTrade trade;
  trade.worth = less(unreleased) >= -k_least_left &&
                (less(unreleased) >= released || heavier <= -band ||
                 (less(line) >= k_least_gain && heavier <= facts(ActionKind::slide).weight + band) ||
                 (std::max(less(draft), less(undercut)) >= k_least_gain && heavier <= band));
  for (const Difference& each : differences(one, other)) {
    if (each.by > each.noted) trade.costs.push_back(each.text);
    if (each.by < -each.noted) trade.wins.push_back(each.text);
  }
  return trade;
}

}  // namespace moldlight
