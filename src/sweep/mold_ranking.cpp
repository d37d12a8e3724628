#include "sweep/mold_ranking.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "mold/direction.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_together = 4;     // between two looks at what is certain to be heavier
constexpr double k_same_place_deg = 3.0;  // beside a canonical direction that costs no more nothing is listed
constexpr double k_hopeless = 2.0;        // of the least undercut that is known: beside many it is no gain
constexpr std::size_t k_most_overtaken = 6;  // whose bodies are found beside those of the listed ones

double angle_deg(const Contender& a, const Contender& b) {
  return line_angle_deg(a.candidate.direction, b.candidate.direction);
}

/// Its side actions are known but for what their bodies allow.
bool is_open(const Contender& contender) {
  return contender.cost && !contender.actions->whole && contender.actions->weight > 0.0;
}

}  // namespace

MoldCost mold_cost(const PartModel& model, const Classification& regions, const DirectionActions& actions,
                   const LineFigures& line) {
  const double area = std::max(model.geometry.total_area, std::numeric_limits<double>::min());
  const double diagonal = model.frame.diagonal;
  MoldCost cost;
  cost.counts = actions.totals.counts;
  cost.weight = actions.weight;
  cost.in_vain = actions.in_vain;
  cost.beyond = actions.beyond / area;
  cost.of(MoldCriterion::unreleased) = actions.totals.unreleased_area / area + cost.beyond;
  cost.formed = actions.formed_area / area;
  cost.of(MoldCriterion::line) = (line.outer_climb + line.steep_length) / diagonal;
  cost.of(MoldCriterion::draft) = (regions.near_vertical_area + regions.reverse_draft.area) / area;
  // Specks are no undercut.
  cost.of(MoldCriterion::undercut) =
      actions.undercuts.count == 0 ? 0.0 : regions.areas[Region::undercut] / area;
  cost.of(MoldCriterion::support) = 1.0;
  cost.of(MoldCriterion::effort) = mold_effort(cost);
  return cost;
}

MoldCost MoldRanking::cost(const Contender& contender) const {
  // Where no line is known it counts as one that climbs as far as any is held against a direction.
  const LineFigures unknown{.outer_climb = k_most_of_line * tools_.model.frame.diagonal};
  MoldCost cost = mold_cost(tools_.model, contender.measured->classification, *contender.actions,
                            contender.measured->parting.value_or(unknown));
  cost.of(MoldCriterion::depth) = contender.figures.draw_depth / tools_.model.frame.diagonal;
  cost.direction = contender.candidate.direction;
  cost.canonical = contender.canonical();
  if (cost.canonical) {
    cost.of(MoldCriterion::support) -= contender.candidate.canonical->share;
  } else {
    cost.of(MoldCriterion::effort) += k_effort_of_found;
  }
  return cost;
}

ActionLimit MoldRanking::limit(const Contender& contender) const {
  const double area = std::max(tools_.model.geometry.total_area, std::numeric_limits<double>::min());
  const Classification& known = contender.measured->classification;
  const double without_draft = (known.near_vertical_area + known.reverse_draft.area) / area;
  const double left = std::isfinite(least_left_) ? least_left_ : 0.0;
  const double band = mold_band(MoldCriterion::unreleased, left);
  // What is left unreleased is no more than what ties.
  const double formed = known.areas[Region::undercut] / area - left - band;
  const auto [least_effort, least_formed] = least_effort_and_formed();
  ActionLimit limit{.most = least_effort + mold_band(MoldCriterion::effort) -
                            k_effort_of_draft * without_draft - effort_on_its_side(formed, least_formed) -
                            (contender.canonical() ? 0.0 : k_effort_of_found),
                    .per_area = k_effort_of_formed / area,
                    .left = left * area,
                    .left_band = band * area,
                    .roughly = best_alone_};
  if (best_alone_) limit.most_of_many = k_hopeless * least_undercut_;
  if (contender.candidate.from_user()) return limit;
  // What is found beside it is listed for fewer side actions alone, and where walls stay upright not for
  // these.
  const double beside_deg = contender.canonical() ? k_same_place_deg : k_beside_deg;
  const double worth = 0.01 * tools_.settings.worth_pct * area;
  for (const Known& each : known_) {
    const double angle = line_angle_deg(each.direction, contender.candidate.direction);
    if (angle > beside_deg || (contender.canonical() && !each.released)) continue;
    const bool upright = !contender.canonical() && angle <= tools_.settings.method.tau_deg;
    limit.most_undercut = std::min(limit.most_undercut, each.undercuts.area + (upright ? -worth : worth));
    if (each.released && (!limit.beside || each.undercuts.area < limit.beside->area))
      limit.beside = each.undercuts;
  }
  return limit;
}

void MoldRanking::find_costs(std::span<Contender> contenders, bool to_the_end) {
  std::vector<Contender*> open;
  for (Contender& contender : contenders) {
    if (contender.measured && !contender.cost) open.push_back(&contender);
  }
  for (std::size_t first = 0; first < open.size() && !tools_.clock.stopped();) {
    tools_.clock.report(sweep_stage::k_actions,
                        static_cast<double>(first) / static_cast<double>(open.size()));
    // The first sets a limit for others, but where it leaves something unreleased. It is the likeliest to be
    // the best, whose bodies are asked for in the end.
    const bool leads = costs_.empty() && first == 0;
    const auto batch = std::span(open).subspan(first, std::min(leads ? 1 : k_together, open.size() - first));
    first += batch.size();
    std::vector<glm::dvec3> directions;
    std::vector<ActionLimit> limits;
    for (const Contender* contender : batch) {
      directions.push_back(contender->candidate.direction);
      limits.push_back(limit(*contender));
    }
    if (to_the_end) limits.clear();
    const auto found =
        tools_.actions.find(directions, limits, tools_.clock, leads ? PlanDetail::whole : PlanDetail::rank);
    std::vector<Contender*> looked_at;
    std::vector<std::shared_ptr<MeasuredDirection>> with_line;
    std::vector<MeasuredDirection*> lines;
    for (std::size_t k = 0; k < batch.size(); ++k) {
      if (!found[k]) continue;
      batch[k]->actions = found[k];
      if (found[k]->given_up) continue;
      looked_at.push_back(batch[k]);
      with_line.push_back(std::make_shared<MeasuredDirection>(*batch[k]->measured));
      with_line.back()->undercuts = found[k]->undercuts;
      lines.push_back(with_line.back().get());
    }
    tools_.measurer.find_lines(lines, tools_.clock.until_cancelled());
    for (std::size_t k = 0; k < looked_at.size(); ++k) {
      if (!with_line[k]->parting && !with_line[k]->lineless) continue;
      Contender& contender = *looked_at[k];
      contender.measured = with_line[k];
      contender.figures = tools_.rating.measured(contender.candidate, *contender.measured, contender.actions);
      contender.cost = cost(contender);
      take_down(contender);
    }
  }
}

void MoldRanking::take_down(const Contender& contender) {
  const double left = contender.cost->of(MoldCriterion::unreleased);
  const double band = mold_band(MoldCriterion::unreleased);
  least_undercut_ = std::min(least_undercut_, contender.actions->undercuts.area);
  least_left_ = std::min(least_left_, left);
  costs_.push_back(*contender.cost);
  if (!contender.canonical()) return;
  const bool released = left - contender.cost->beyond <= band;
  known_.push_back({contender.candidate.direction, contender.actions->undercuts, released});
  free_ = free_ || (released && contender.cost->weight <= 0.0);
}

std::pair<double, double> MoldRanking::least_effort_and_formed() const {
  std::vector<MoldCost> costs = costs_;
  settle(costs);
  double effort = std::numeric_limits<double>::infinity(), formed = 1.0;
  for (const MoldCost& cost : costs) {
    if (cost.of(MoldCriterion::unreleased) > least_left_ + mold_band(MoldCriterion::unreleased, least_left_))
      continue;
    effort = std::min(effort, cost.of(MoldCriterion::effort));
    formed = std::min(formed, cost.formed);
  }
  return {effort, formed};
}

bool MoldRanking::found_leads(std::span<const Contender> named, std::span<const Contender> found) const {
  std::vector<MoldCost> costs;
  for (const auto& contenders : {named, found}) {
    for (const Contender& contender : contenders) {
      if (contender.cost) costs.push_back(*contender.cost);
    }
  }
  settle(costs);
  return !costs.empty() && !costs[mold_order(costs).order.front()].canonical;
}

/// Within 10 degrees of the canonical one. Within what counts as upright it is no reason to lean that the one
/// set of side actions is lighter than the other, but that nothing is needed.
bool MoldRanking::is_worth(const Contender& found, const Contender& canonical) const {
  const double angle = angle_deg(found, canonical);
  MoldCost least = *canonical.cost;
  if (angle <= tools_.settings.method.tau_deg && found.cost->weight > 0.0) least.weight = least.in_vain = 0.0;
  if (!costs_no_more(least, *found.cost)) return true;
  if (angle <= k_same_place_deg) return false;
  const double saved = canonical.cost->of(MoldCriterion::undercut) - found.cost->of(MoldCriterion::undercut);
  return saved > 0.01 * tools_.settings.worth_pct ||
         (found.actions->undercuts.count == 0 && canonical.actions->undercuts.count > 0);
}

/// The canonical direction that is listed in its place; null for none. A canonical one gives way to those
/// alone that come before it.
const Contender* MoldRanking::stands_for(const std::vector<Contender>& contenders,
                                         const Contender& found) const {
  for (const Contender& other : contenders) {
    if (&other == &found) {
      if (found.canonical()) return nullptr;
      continue;
    }
    if (!other.canonical()) continue;
    const double angle = angle_deg(other, found);
    if (!other.cost) {
      // Given up: it weighs at least so much.
      if (angle <= k_same_place_deg && found.cost && !found.canonical() && other.actions &&
          found.cost->weight >= other.actions->weight)
        return &other;
      continue;
    }
    if (angle > (found.canonical() ? k_same_place_deg : k_beside_deg)) continue;
    if (found.canonical() ? !found.cost || costs_no_more(*other.cost, *found.cost)
                          : !found.cost || !is_worth(found, other))
      return &other;
  }
  return nullptr;
}

BesideDirection MoldRanking::beside(const Contender& contender, const Contender& of) const {
  const glm::dvec3& direction = contender.candidate.direction;
  const glm::dvec3 turned = glm::dot(direction, of.candidate.direction) < 0.0 ? -direction : direction;
  BesideDirection found{
      .direction = turned,
      .name = contender.canonical() ? contender.candidate.canonical->name : direction_words(turned),
      .angle_deg = angle_deg(contender, of),
      .undercut = contender.figures.undercut};
  if (contender.actions && !contender.actions->given_up) found.actions = contender.actions;
  if (contender.measured && contender.measured->parting)
    found.climb = contender.measured->parting->outer_climb;
  return found;
}

void MoldRanking::Listed::cut_to(std::size_t most) {
  if (contenders.size() <= most) return;
  contenders.erase(contenders.begin() + static_cast<std::ptrdiff_t>(most), contenders.end());
  ties.resize(most);
  reasons.resize(most);
}

MoldRanking::Listed MoldRanking::listed(std::vector<Contender> contenders) const {
  // What has a cost by what molds are ranked by, then the rest by undercut.
  std::vector<Contender> known, rest;
  for (Contender& contender : contenders) (contender.cost ? known : rest).push_back(std::move(contender));
  std::vector<MoldCost> costs;
  for (const Contender& contender : known) costs.push_back(*contender.cost);
  settle(costs);
  for (std::size_t k = 0; k < known.size(); ++k) known[k].cost = costs[k];
  std::vector<Contender> ordered;
  for (const std::size_t i : mold_order(costs).order) ordered.push_back(std::move(known[i]));
  std::ranges::stable_sort(
      rest, {}, [](const Contender& c) { return std::pair(c.measured == nullptr, c.figures.undercut); });
  std::ranges::move(rest, std::back_inserter(ordered));

  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    Contender& contender = ordered[i];
    const Contender* other = contender.candidate.from_user() ? nullptr : stands_for(ordered, contender);
    if (other != nullptr) {
      auto& stands = ordered[static_cast<std::size_t>(other - ordered.data())].beside;
      const bool better = contender.measured && contender.figures.undercut < other->figures.undercut &&
                          (!stands || contender.figures.undercut < stands->undercut);
      if (!contender.canonical() && better) stands = beside(contender, *other);
      continue;
    }
    const auto near = std::ranges::find_if(
        kept, [&](std::size_t k) { return angle_deg(ordered[k], contender) <= tools_.settings.apart_deg; });
    const bool room = kept.size() < static_cast<std::size_t>(tools_.settings.top) && near == kept.end();
    if (room || contender.candidate.from_user()) kept.push_back(i);
  }
  Listed list;
  for (const std::size_t i : kept) put(list, ordered, i);
  return list;
}

/// What leaves more cannot be the best beside what is known already.
double MoldRanking::most_left(std::span<const Contender> contenders) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Contender& each : contenders) {
    if (best_alone_ && each.cost && !is_open(each))
      least = std::min(least, each.cost->of(MoldCriterion::unreleased));
  }
  return (least + 2.0 * mold_band(MoldCriterion::unreleased, least)) * tools_.model.geometry.total_area;
}

bool MoldRanking::Listed::is_confirmed(std::size_t place) const {
  return place < contenders.size() && contenders[place].cost && !is_open(contenders[place]) &&
         !contenders[place].actions->given_up;
}

MoldRanking::Listed MoldRanking::confirmed(std::vector<Contender> contenders, std::size_t most) {
  for (std::size_t looked_at = 0;;) {
    Listed list = listed(contenders);
    const auto leading = std::span(list.contenders).first(std::min(most, list.contenders.size()));
    // Several at a time; of those behind the first only so many more than are listed.
    const std::size_t room = most + k_most_overtaken - std::min(most + k_most_overtaken, looked_at);
    std::vector<glm::dvec3> open;
    for (const Contender& contender : leading) {
      if (is_open(contender) && (open.size() < room || &contender == leading.data()))
        open.push_back(contender.candidate.direction);
    }
    if (open.empty()) return list;
    looked_at += open.size();
    const std::vector<ActionLimit> limits(open.size(), {.most_left = most_left(contenders)});
    const auto found = tools_.actions.find(open, limits, tools_.clock, PlanDetail::whole);
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (!found[k]) continue;
      Contender& contender = *std::ranges::find_if(contenders, [&](const Contender& each) {
        return is_open(each) && each.candidate.direction == open[k];
      });
      contender.actions = found[k];
      contender.figures = tools_.rating.measured(contender.candidate, *contender.measured, contender.actions);
      contender.cost = cost(contender);
    }
    const auto is_found = [](const auto& actions) { return actions.has_value(); };
    if (!std::ranges::all_of(found, is_found)) return listed(std::move(contenders));
  }
}

void MoldRanking::put(Listed& list, std::vector<Contender>& contenders, std::size_t which) const {
  Contender contender = contenders[which];
  if (!contender.canonical() && contender.cost) {
    // What it is worth more than.
    for (const Contender& other : contenders) {
      if (contender.beside || !other.canonical() || angle_deg(other, contender) > k_beside_deg) continue;
      contender.beside = beside(other, contender);
    }
  }
  std::vector<std::string> reasons;
  bool ties = false;
  if (!contender.cost) {
    reasons = {contender.actions
                   ? fmt::format("needs side actions for {:.2g} % of the surface",
                                 100.0 * contender.actions->formed_area / tools_.model.geometry.total_area)
                   : "its side actions were not computed"};
    contender.actions.reset();
  } else if (!list.contenders.empty() && list.contenders.back().cost) {
    reasons = rank_reasons(*contender.cost, *list.contenders.back().cost);
    ties = mold_order(std::array{*list.contenders.back().cost, *contender.cost}).decided_by.back() ==
           std::nullopt;
  }
  list.contenders.push_back(std::move(contender));
  list.ties.push_back(ties);
  list.reasons.push_back(std::move(reasons));
}

}  // namespace moldlight
