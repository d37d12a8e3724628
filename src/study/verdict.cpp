#include "study/verdict.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "actions/best_changes.hpp"
#include "base/numbers.hpp"
#include "classify/number_format.hpp"
#include "mesh/health.hpp"

namespace moldlight {

namespace {

/// "2 slides and 1 lifter".
std::string listed(const ActionCounts& counts) {
  std::string text = actions_text(counts);
  if (const std::size_t comma = text.rfind(", "); comma != std::string::npos) text.replace(comma, 2, " and ");
  return text;
}

/// A fault of the mesh that leaves regions in doubt: what, where, and what helps.
struct Fault {
  std::string what, remedy;
};

std::string near_text(const PartModel& model, const glm::dvec3& place) {
  const double least = 1e-4 * model.frame.diagonal;
  const auto text = [&](double value) { return std::abs(value) < least ? std::string("0") : rounded(value); };
  return fmt::format("near ({}, {}, {}) {}", text(place.x), text(place.y), text(place.z),
                     length_unit(model.part));
}

/// At the longest chain of such edges.
std::string near_text(const PartModel& model, EdgeDefect defect) {
  const std::vector<EdgeChain> chains = defect_chains(model.part.mesh, defect);
  if (chains.empty()) return {};
  return ", " + near_text(model, model.part.mesh.vertices[chains.front().vertices.front()]);
}

/// At the first facet that another one crosses.
std::string near_crossing(const PartModel& model) {
  const ExactPart& exact = model.exact(Progress());
  for (FacetIndex facet = 0; exact.any_crossings() && facet < model.part.mesh.facets.size(); ++facet)
    if (!exact.crossings(facet).empty()) return ", " + near_text(model, model.part.mesh.corner(facet, 0));
  return {};
}

Fault fault_of(const PartModel& model, const UndercutUncertainty& uncertainty) {
  const HealthReport& health = model.health;
  if (uncertainty.sampled_facets > 0 && uncertainty.readout >= uncertainty.mesh)
    return {
        fmt::format("too many facets cross {}, which {} sampled", plural(uncertainty.sampled_facets, "facet"),
                    uncertainty.sampled_facets == 1 ? "is" : "are"),
        "--repair union unites the bodies; else look at one with --body, or raise --effort"};
  if (health.open_edges > 0)
    return {fmt::format("the mesh is open at {}{}", plural(health.open_edges, "edge"),
                        near_text(model, EdgeDefect::open)),
            "--repair full closes small holes; else export the part as a closed solid"};
  if (health.inconsistent_edges > 0)
    return {
        fmt::format("neighbouring facets face opposite ways at {}{}",
                    plural(health.inconsistent_edges, "edge"), near_text(model, EdgeDefect::inconsistent)),
        "--repair full turns them"};
  if (const std::string place = near_crossing(model); !place.empty())
    return {"surfaces cross each other" + place,
            health.components > 1 ? "--repair union unites the bodies; --body looks at one"
                                  : "--repair union drops the surface inside; else repair it in CAD"};
  return {"the shadow found from both sides differs", "check the mesh with moldlight info"};
}

/// How much undercut may be none, or none may be undercut, for what is wrong with the mesh or the readout.
double doubt_of(const Classification& regions) {
  return regions.uncertainty.mesh + regions.uncertainty.readout;
}

class Judge {
 public:
  explicit Judge(const VerdictFacts& facts)
      : facts_(facts),
        lateral_(facts.regions.lateral_tolerance),
        area_unit_(powered_unit(facts.model.part, 2)) {
    verdict_.undercuts = facts.undercuts.count;
    verdict_.undercut_area = facts.undercuts.area;
    verdict_.specks = facts.undercuts.specks;
    verdict_.speck_area = facts.undercuts.speck_area;
    if (facts.actions) {
      verdict_.actions = facts.actions->counts;
      verdict_.unreleased_area = facts.actions->unreleased_area;
    }
  }

  Verdict judged() {
    if (!judged_by_health()) judge_by_undercuts();
    add_specks();
    add_sampled();
    add_bodies();
    return std::move(verdict_);
  }

 private:
  [[nodiscard]] std::string area(double value) const {
    return fmt::format("{} {}", rounded_area(value, facts_.regions.total_area), area_unit_);
  }
  void set(VerdictState state, std::string sentence) {
    verdict_.state = state;
    verdict_.sentence = std::move(sentence);
  }
  void add(std::string reason) { verdict_.reasons.push_back(std::move(reason)); }

  bool judged_by_health() {
    const HealthReport& health = facts_.model.health;
    if (!(facts_.regions.total_area > 0.0)) {
      set(VerdictState::unknown, "Not decided: the part has no area.");
      return true;
    }
    const double doubt = doubt_of(facts_.regions);
    if (doubt <= lateral_ * lateral_ && health.closed) return false;
    const Fault fault = fault_of(facts_.model, facts_.regions.uncertainty);
    const bool doubtful = doubt > lateral_ * lateral_;
    const bool decided = verdict_.undercuts > 0 && !(doubtful && doubt >= verdict_.undercut_area);
    if (decided) {
      add(doubtful ? fmt::format("± {} of it is in doubt: {}.", area(doubt), fault.what)
                   : fmt::format("The figures are in doubt: {}.", fault.what));
    } else {
      set(VerdictState::unknown,
          doubtful ? fmt::format("Not decided: {}, so {} may be undercut or not.", fault.what, area(doubt))
                   : fmt::format("Not decided: {}.", fault.what));
      if (verdict_.undercuts > 0) add(fmt::format("As it is: {}.", undercuts_text()));
    }
    add(fmt::format("{}: {}.", decided ? "To remove the doubt" : "To decide it", fault.remedy));
    return !decided;
  }

  [[nodiscard]] std::string undercuts_text() const {
    return fmt::format("{}, {} ({} of the surface)", plural(verdict_.undercuts, "undercut"),
                       area(verdict_.undercut_area),
                       share_text(verdict_.undercut_area, facts_.regions.total_area));
  }

  void judge_by_undercuts() {
    if (verdict_.undercuts == 0) return set(VerdictState::two_plate, "Two-plate mold: no undercut.");
    if (!facts_.actions) {
      set(VerdictState::undercuts, undercuts_text() + ".");
      return;
    }
    const ActionTotals& actions = *facts_.actions;
    const std::size_t number = number_of(actions.counts);
    if (actions.stuck > 0) {
      set(VerdictState::not_releasable,
          fmt::format("Not releasable: no action that was tried releases {} in {}{}.",
                      area(actions.stuck_area),
                      actions.stuck == verdict_.undercuts
                          ? plural(actions.stuck, "undercut")
                          : fmt::format("{} of {} undercuts", actions.stuck, verdict_.undercuts),
                      number == 0 ? std::string()
                                  : fmt::format("; {} {} the rest", listed(actions.counts),
                                                number == 1 ? "releases" : "release")));
    } else {
      const std::string undercuts = verdict_.undercuts == 1 ? "the undercut"
                                    : verdict_.undercuts == 2
                                        ? "both undercuts"
                                        : fmt::format("all {} undercuts", verdict_.undercuts);
      const std::string what = fmt::format("{} ({})", undercuts, area(verdict_.undercut_area));
      if (number > k_most_actions) {
        set(VerdictState::side_actions,
            fmt::format("Too many side actions: {} are needed to release {}.", listed(actions.counts), what));
      } else {
        set(VerdictState::side_actions,
            fmt::format("{} {} {}.", listed(actions.counts), number == 1 ? "releases" : "release", what));
      }
    }
    if (facts_.plan != nullptr) add_plan(*facts_.plan);
  }

  void add_plan(const ActionPlan& plan) {
    const auto meeting =
        std::ranges::count_if(plan.actions, [](const SideAction& action) { return !action.meets.empty(); });
    std::string voids;
    std::size_t count = 0;
    for (std::size_t k = 0; k < plan.undercuts.size(); ++k)
      if (plan.undercuts[k].closed_void) voids += fmt::format("{}{}", ++count > 1 ? ", " : "", k + 1);
    if (count > 0)
      add(fmt::format("{} {} {}, which no mold forms. Fill {}, or open {} to the outside.",
                      count == 1 ? "Undercut" : "Undercuts", voids,
                      count == 1 ? "is a closed void" : "are closed voids", count == 1 ? "it" : "them",
                      count == 1 ? "it" : "them"));
    if (meeting > 0)
      add(fmt::format("The paths of {} cross.", plural(static_cast<std::size_t>(meeting), "action")));
  }

  void add_specks() {
    if (verdict_.specks == 0) return;
    add(fmt::format("{} {} ignored, smaller or shallower than {} {} ({}).",
                    plural(verdict_.specks, "tiny undercut"), verdict_.specks == 1 ? "is" : "are",
                    rounded(lateral_, 0.0, 3), length_unit(facts_.model.part), area(verdict_.speck_area)));
  }

  void add_sampled() {
    const UndercutUncertainty& uncertainty = facts_.regions.uncertainty;
    if (uncertainty.sampled_facets == 0) return;
    add(fmt::format("{} sampled, since too many facets cross {}: ± {}. --effort raises the limit.",
                    uncertainty.sampled_facets == 1
                        ? "1 facet is"
                        : fmt::format("{} facets are", uncertainty.sampled_facets),
                    uncertainty.sampled_facets == 1 ? "it" : "them", area(uncertainty.readout)));
  }

  /// What is often a plate of parts, or an assembly.
  void add_bodies() {
    const std::size_t bodies = facts_.model.part.bodies.size();
    if (bodies < 2 || verdict_.state == VerdictState::two_plate || verdict_.state == VerdictState::unknown)
      return;
    add(fmt::format("{} of the file share one mold here; --body takes one of them.",
                    bodies == 2 ? "Both bodies" : fmt::format("All {} bodies", bodies)));
  }

  const VerdictFacts& facts_;
  double lateral_;
  std::string area_unit_;
  Verdict verdict_;
};

}  // namespace

Verdict verdict_of(const VerdictFacts& facts) { return Judge(facts).judged(); }

Verdict verdict_of(const PartModel& model, const Classification& regions, const ActionPlan& plan) {
  return verdict_of({.model = model,
                     .regions = regions,
                     .undercuts = undercut_totals(plan),
                     .actions = totals_of(plan, regions.lateral_tolerance),
                     .plan = &plan});
}

std::optional<Verdict> verdict_of(const PartModel& model, const SweepCandidate& candidate) {
  if (!candidate.undercuts) return std::nullopt;
  return verdict_of({.model = model,
                     .regions = candidate.classification,
                     .undercuts = *candidate.undercuts,
                     .actions = candidate.actions ? std::optional(candidate.actions->totals) : std::nullopt});
}

Json verdict_json(const Verdict& verdict) {
  Json actions = Json::object();
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind) {
    if (verdict.actions[kind] > 0)
      actions[std::string(facts(static_cast<ActionKind>(kind)).name)] = verdict.actions[kind];
  }
  return {{"state", state_name(verdict.state)},
          {"sentence", verdict.sentence},
          {"undercuts", verdict.undercuts},
          {"undercut_area", verdict.undercut_area},
          {"unreleased_area", verdict.unreleased_area},
          {"specks", {{"number", verdict.specks}, {"area", verdict.speck_area}}},
          {"actions", actions},
          {"reasons", verdict.reasons}};
}

}  // namespace moldlight
