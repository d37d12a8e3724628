// Pulls for each undercut, those that several can share, and the cheapest set of them.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/action_feature.hpp"
#include "actions/atom.hpp"
#include "actions/body_figures.hpp"
#include "actions/chosen_action.hpp"
#include "actions/least_set.hpp"
#include "actions/revolved_columns.hpp"
#include "actions/sharing.hpp"
#include "actions/side_action.hpp"
#include "actions/undercut_report.hpp"
#include "classify/map_comparison.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

namespace {

constexpr double k_samples = 6000.0;                              // over all undercuts
constexpr double k_least_samples = 48.0, k_most_samples = 600.0;  // of one of them
constexpr double k_rough = 0.25;                                  // of these
constexpr double k_across = 0.7;      // cosine, at most, between a way and one across it
constexpr double k_pin_reach = 0.02;  // of the diagonal, from a pin to its undercut

class Finder {
 public:
  Finder(const PartModel& model, const Classification& result, const ActionSettings& settings,
         const Progress& progress, PlanDetail detail)
      : model_(model),
        split_(*result.split),
        settings_(settings),
        progress_(progress),
        query_(exact_query(model, result.query())),
        undercuts_(find_undercuts(model, split_, query_, progress, settings.least_travel_mm)),
        pulls_(model, query_, undercuts_.axes, settings, progress),
        unit_per_mm_(unit_per_mm(model.part)),
        detail_(detail),
        bodies_(model, split_, query_, progress, {.stem = settings.lifter_section_mm * unit_per_mm_}) {}

  ActionPlan run() {
    sample();
    find_candidates();
    find_pulls();
    progress_.report("looking for threads", 0.4);
    revolved_ = revolved_columns({model_, split_, undercuts_, query_, settings_, progress_}, atoms_);
    set_shallow_apart();
    split_the_rest();
    find_inserts();
    std::vector<Column> columns = find_columns();
    const ChosenContext context{model_, split_, undercuts_, pulls_, settings_, unit_per_mm_, detail_};
    ActionPlan plan =
        least_set(context, atoms_, std::move(columns),
                  {.ways_round = [&](std::size_t atom) { return ways_round(atom); },
                   .faults = [&](ActionPlan& draft) { return faults_of(draft); },
                   .last_resort = [&](const std::vector<std::size_t>& which) { return inserts_for(which); }},
                  progress_);
    plan.specks = undercuts_.specks;
    add_shallow_specks(plan);
    keep_rejected(plan);
    if (detail_ == PlanDetail::whole) {
      report(plan);
    } else {
      plan.patches.clear();
      for (const Undercut& patch : undercuts_.patches) plan.patches.emplace_back().undercut = patch;
    }
    return plan;
  }

 private:
  void sample() {
    double total = 0.0;
    for (const Undercut& patch : undercuts_.patches) total += patch.area;
    for (std::size_t k = 0; k < undercuts_.patches.size(); ++k) {
      const Undercut& patch = undercuts_.patches[k];
      const double wanted = (detail_ == PlanDetail::rough ? k_rough : 1.0) *
                            std::clamp(k_samples * patch.area / total, k_least_samples, k_most_samples);
      atoms_.push_back({k, sample_undercut(model_, split_, patch, static_cast<std::size_t>(wanted))});
      atoms_.back().pin = pin_of(settings_.pins, {atoms_.back().samples, patch.area}, model_.frame,
                                 k_pin_reach * model_.frame.diagonal);
    }
    if (model_.health.components > 1) set_covered_apart();
    for_each_atom([&](std::size_t k) { mark_thin_hole(atoms_[k]); });
  }

  /// Its core pin would break.
  void mark_thin_hole(Atom& atom) const {
    const auto hole = round_hole(model_, split_, undercuts_.patches[atom.patch]);
    if (!hole || std::abs(elevation_deg(hole->axis, query_.direction)) > settings_.incline_deg ||
        hole->pin.diameter >= settings_.pin_diameter_mm * unit_per_mm_)
      return;
    atom.thin = true;
    Pull pull{.direction = hole->axis, .travel = hole->pin.length / model_.frame.diagonal};
    pull.lack = Pull::Lack{.reason = RejectReason::thin_pin,
                           .at = atom.samples.front(),
                           .room = hole->pin.diameter / model_.frame.diagonal};
    atom.rejected.push_back(pull);
  }

  /// Bodies of a part may overlap. What of an undercut lies within another body becomes an atom of its own.
  void set_covered_apart() {
    for (std::size_t k = 0; k < undercuts_.patches.size(); ++k) {
      const auto is_covered = [&](const UndercutSample& sample) {
        return pulls_.release().is_covered(sample);
      };
      if (std::ranges::all_of(atoms_[k].samples, is_covered)) {
        atoms_[k].covered = true;
        atoms_[k].whole = false;
        continue;
      }
      std::optional<Atom> covered = taken_out(atoms_[k], is_covered);
      if (!covered) continue;
      covered->covered = true;
      atoms_.push_back(std::move(*covered));
    }
  }

  /// Takes the samples that `goes` says out of an atom, into one of their own that is returned; none where
  /// they are too few for one, or all of it.
  template <typename Goes>
  [[nodiscard]] std::optional<Atom> taken_out(Atom& atom, const Goes& goes) const {
    Atom taken{.patch = atom.patch, .samples = {}, .whole = false, .pin = atom.pin};
    std::vector<UndercutSample> rest;
    for (const UndercutSample& sample : atom.samples) (goes(sample) ? taken.samples : rest).push_back(sample);
    if (rest.empty() || taken.area() <= k_blocked_share * atom.area()) return std::nullopt;
    atom.samples = std::move(rest);
    atom.whole = false;
    return taken;
  }

  /// What nothing releases whole may be released but for what needs no release.
  void set_shallow_apart() {
    const std::vector<char> revolved = revolved_atoms();
    std::vector<std::optional<Atom>> shallow(atoms_.size());
    for_each_atom([&](std::size_t k) {
      Atom& atom = atoms_[k];
      if (revolved[k] != 0 || !atom.pulls.empty() || !atom.wanted()) return;
      shallow[k] = taken_out(atom, [&](const UndercutSample& sample) { return pulls_.is_shallow(sample); });
      if (!shallow[k]) return;
      shallow[k]->shallow = true;
      find_pulls_of(atom);
    });
    for (std::optional<Atom>& atom : shallow) {
      if (atom) atoms_.push_back(std::move(*atom));
    }
  }

  void add_shallow_specks(ActionPlan& plan) const {
    for (const Atom& atom : atoms_) {
      if (!atom.shallow) continue;
      const glm::dvec3 at(atom.samples.front().position);
      plan.specks.push_back(
          {atom.area(), model_.frame.center + model_.frame.diagonal * at, SpeckReason::shallow, true});
    }
    std::ranges::stable_sort(plan.specks, std::greater(), &Speck::area);
  }

  void find_candidates() {
    const auto fan = pull_fan(undercuts_.axes);
    tried_.resize(undercuts_.patches.size());
    tbb::parallel_for(std::size_t{0}, tried_.size(), [&](std::size_t k) {
      tried_[k] = own_pulls({model_, split_, undercuts_.axes}, undercuts_.patches[k], settings_);
      tried_[k].insert(tried_[k].end(), fan.begin(), fan.end());
    });
  }
  [[nodiscard]] const std::vector<PullCandidate>& candidates(const Atom& atom) const {
    return tried_[atom.patch];
  }

  /// Calls `work` for every atom, several at a time. Throws Cancelled.
  template <typename Work>
  void for_each_atom(const Work& work) {
    tbb::parallel_for(std::size_t{0}, atoms_.size(), [&](std::size_t k) {
      if (!progress_.cancelled()) work(k);
    });
    if (progress_.cancelled()) throw Cancelled();
  }

  void find_pulls() {
    progress_.report("looking for side actions", 0.0);
    for_each_atom([&](std::size_t k) {
      if (atoms_[k].wanted()) find_pulls_of(atoms_[k]);
    });
  }

  void find_pulls_of(Atom& atom) const {
    atom.pulls = pulls_.find(atom.samples, candidates(atom), atom.only());
    set_rejected_apart(atom);
  }

  static void set_rejected_apart(Atom& atom) {
    const auto known = static_cast<std::ptrdiff_t>(atom.rejected.size());
    std::erase_if(atom.pulls, [&](const Pull& pull) {
      if (pull.lack) atom.rejected.push_back(pull);
      return pull.lack.has_value();
    });
    std::ranges::stable_sort(atom.rejected.begin() + known, atom.rejected.end(), {}, &Pull::travel);
  }

  /// Whether actions of the mold release all of an undercut.
  [[nodiscard]] static bool is_well_released(const ActionPlan& plan, std::size_t patch) {
    return std::ranges::find(plan.unreleased, patch) == plan.unreleased.end() &&
           std::ranges::all_of(plan.actions, [&](const SideAction& action) {
             return std::ranges::find(action.patches, patch) == action.patches.end() ||
                    action.kind != ActionKind::insert;
           });
  }

  /// Of what was tried for undercuts that nothing of the mold releases: the shortest lifter without its room,
  /// and each kind whose body hits.
  void keep_rejected(ActionPlan& plan) const {
    std::vector<RejectedAction> hitting = std::move(plan.rejected);
    plan.rejected.clear();
    add_lifters_without_room(plan);
    for (RejectedAction& rejected : hitting) {
      const bool known = std::ranges::any_of(plan.rejected, [&](const RejectedAction& other) {
        return other.patch == rejected.patch && other.kind == rejected.kind &&
               other.reason == rejected.reason;
      });
      if (!known && !is_well_released(plan, rejected.patch)) plan.rejected.push_back(rejected);
    }
    std::ranges::stable_sort(plan.rejected, {}, &RejectedAction::patch);
  }

  void add_lifters_without_room(ActionPlan& plan) const {
    const double diagonal = model_.frame.diagonal;
    // Of the whole undercut before one of its parts.
    std::vector<const Pull*> first(undercuts_.patches.size(), nullptr);
    for (const Atom& atom : atoms_) {
      if (!atom.rejected.empty() && first[atom.patch] == nullptr) first[atom.patch] = &atom.rejected.front();
    }
    for (std::size_t patch = 0; patch < first.size(); ++patch) {
      if (first[patch] == nullptr || is_well_released(plan, patch)) continue;
      const Pull& pull = *first[patch];
      plan.rejected.push_back({.patch = patch,
                               .kind = pull.kind,
                               .direction = pull.direction,
                               .travel = pull.travel * diagonal,
                               .core_side = pull.core_side,
                               .reason = pull.lack->reason,
                               .place = model_.frame.center + diagonal * glm::dvec3(pull.lack->at.position),
                               .room = pull.lack->room * diagonal});
    }
  }

  /// 1 for each atom that a thread or a ring releases.
  [[nodiscard]] std::vector<char> revolved_atoms() const {
    std::vector<char> revolved(atoms_.size(), 0);
    for (const Column& column : revolved_) {
      for (const std::size_t k : column.atoms) revolved[k] = 1;
    }
    return revolved;
  }

  /// What nothing releases whole becomes an atom for each part that a pull frees, and one for what none does.
  void split_the_rest() {
    progress_.report("splitting what no single action releases", 0.6);
    const std::vector<char> revolved = revolved_atoms();
    std::vector<std::vector<FreedPart>> parts(atoms_.size());
    for_each_atom([&](std::size_t k) {
      const Atom& atom = atoms_[k];
      if (revolved[k] == 0 && atom.pulls.empty() && atom.wanted())
        parts[k] = pulls_.split(atom.samples, candidates(atom), atom.only());
    });
    take_parts(parts);
  }

  /// For what no action of the mold releases.
  void find_inserts() {
    const std::vector<char> revolved = revolved_atoms();
    std::vector<char> wanted;
    for (std::size_t k = 0; k < atoms_.size(); ++k)
      wanted.push_back(revolved[k] == 0 && atoms_[k].pulls.empty() ? 1 : 0);
    find_inserts(wanted);
  }
  /// For atoms that are wanted; those that are split become their parts.
  void find_inserts(const std::vector<char>& wanted) {
    progress_.report("looking for loose inserts", 0.7);
    ActionSettings all_round = settings_;
    all_round.incline_deg = 90.0;
    const std::vector<PullCandidate> sphere = pull_sphere(undercuts_.axes);
    std::vector<std::vector<FreedPart>> parts(atoms_.size());
    for_each_atom([&](std::size_t k) {
      const Atom& atom = atoms_[k];
      if (wanted[k] == 0 || !atom.allows(ActionKind::insert)) return;
      auto tried = own_pulls({model_, split_, undercuts_.axes}, undercuts_.patches[atom.patch], all_round);
      tried.insert(tried.end(), sphere.begin(), sphere.end());
      parts[k] = pulls_.find_inserts(atom.samples, tried, undercuts_.patches[atom.patch].area);
    });
    take_parts(parts);
  }

  /// For atoms whose other actions cannot be built, once each.
  std::vector<Column> inserts_for(const std::vector<std::size_t>& which) {
    std::vector<char> wanted(atoms_.size(), 0);
    for (const std::size_t k : which) {
      const bool had =
          std::ranges::find(atoms_[k].pulls, ActionKind::insert, &Pull::kind) != atoms_[k].pulls.end();
      wanted[k] = insisted_.insert(k).second && !had ? 1 : 0;
    }
    const std::size_t end = atoms_.size();
    find_inserts(wanted);
    std::vector<Column> columns;
    for (std::size_t k = 0; k < atoms_.size(); ++k) {
      if (k < end && wanted[k] == 0) continue;
      for (const Pull& pull : atoms_[k].pulls) {
        if (pull.kind == ActionKind::insert) columns.push_back({pull, {k}});
      }
    }
    return columns;
  }

  /// Atoms that were split become their parts, those after the first at the end; the others, which have none,
  /// stay.
  void take_parts(std::vector<std::vector<FreedPart>>& parts) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool whole = atoms_[k].whole && parts[k].size() == 1;
      for (std::size_t part = 0; part < parts[k].size(); ++part) {
        Atom atom{.patch = atoms_[k].patch,
                  .samples = std::move(parts[k][part].samples),
                  .pulls = std::move(parts[k][part].pulls),
                  .rejected = part == 0 ? std::move(atoms_[k].rejected) : std::vector<Pull>(),
                  .whole = whole,
                  .pin = atoms_[k].pin,
                  .covered = atoms_[k].covered};
        set_rejected_apart(atom);
        if (part == 0) {
          atoms_[k] = std::move(atom);
        } else {
          atoms_.push_back(std::move(atom));
        }
      }
    }
  }

  [[nodiscard]] SharingReach sharing_reach() const {
    const double per_mm = unit_per_mm_ / model_.frame.diagonal;
    return {.across = settings_.bundle_across_mm * per_mm,
            .along = settings_.bundle_along_mm * per_mm,
            .stem = settings_.lifter_section_mm * per_mm};
  }

  std::vector<Column> find_columns() const {
    std::vector<Column> columns = pull_columns(atoms_, pulls_, sharing_reach());
    columns.insert(columns.begin(), revolved_.begin(), revolved_.end());
    return columns;
  }

  /// What else releases an atom whose slide or lifter meets another: its own slides turned, inclined ones,
  /// lifters, those across its own ways, too.
  std::vector<Column> ways_round(std::size_t number) const {
    const Atom& atom = atoms_[number];
    std::vector<Pull> pulls = pulls_.turned(atom.samples, atom.pulls);
    for (const ActionKind kind : {ActionKind::inclined, ActionKind::lifter}) {
      if (!atom.allows(kind)) continue;
      add_feasible(pulls_.find(atom.samples, candidates(atom), kind), pulls);
    }
    if (atom.allows(ActionKind::lifter)) {
      std::vector<PullCandidate> across = candidates(atom);
      std::erase_if(across, [&](const PullCandidate& tried) {
        return std::ranges::any_of(atom.pulls, [&](const Pull& pull) {
          return std::abs(glm::dot(tried.direction, pull.direction)) > k_across;
        });
      });
      add_feasible(pulls_.find(atom.samples, across, ActionKind::lifter), pulls);
    }
    std::vector<Column> columns;
    for (const Pull& pull : pulls) add_pull_columns(atoms_, pulls_, sharing_reach(), number, pull, columns);
    return columns;
  }

  static void add_feasible(const std::vector<Pull>& more, std::vector<Pull>& pulls) {
    std::ranges::copy_if(more, std::back_inserter(pulls), [](const Pull& pull) { return !pull.lack; });
  }

  std::vector<ActionFault> faults_of(ActionPlan& plan) {
    if (!faces_) faces_ = part_faces(model_.part, model_.geometry, model_.adjacency);
    plan.patches.resize(undercuts_.patches.size());
    tbb::parallel_for(std::size_t{0}, plan.patches.size(), [&](std::size_t k) {
      plan.patches[k].undercut = undercuts_.patches[k];
      add_formed_surface({model_, split_, *faces_, pulls_.release()}, action_of(plan, k), plan.patches[k]);
    });
    bodies_.measure(plan);
    std::vector<ActionFault> faults;
    for (std::size_t k = 0; k < plan.actions.size(); ++k) {
      const SideAction& action = plan.actions[k];
      if (action.kind == ActionKind::strip) continue;
      if (!action.body) {
        faults.push_back({.action = k, .reason = RejectReason::no_body});
        faults.back().hit.place = plan.patches[action.patches.front()].undercut.centre;
      } else if (const std::optional<BodyHit>& hit = action.body->hit;
                 hit && action.kind != ActionKind::unscrew && bodies_.is_grave(k)) {
        // Facets of a thread leave its helix by more than the tolerance; that it turns out is known.
        faults.push_back({k, hit->action ? RejectReason::hits_body : RejectReason::hits_part, *hit});
      }
    }
    return faults;
  }

  void report(ActionPlan& plan) const {
    for (std::size_t k = 0; k < undercuts_.patches.size(); ++k) {
      progress_.report("describing undercuts", 0.9);
      UndercutReport& noted = plan.patches[k];
      noted.blocked_by = blockers(model_, split_, noted.undercut, query_.direction);
      place(k, noted);
      const SideAction* action = action_of(plan, k);
      if (action != nullptr) {
        noted.depth = action->travel - (is_slide(action->kind) ? settings_.clearance_mm * unit_per_mm_ : 0.0);
        noted.core_side = action->core_side;
      }
    }
    for (SideAction& action : plan.actions) {
      action.feature = feature_text({model_, split_, pulls_.release()}, plan, action);
      if (is_slide(action.kind)) action.pin = longest_pin(action);
    }
  }

  /// For its diameter.
  [[nodiscard]] std::optional<CorePin> longest_pin(const SideAction& action) const {
    std::optional<CorePin> longest;
    for (const std::size_t patch : action.patches) {
      const auto hole = round_hole(model_, split_, undercuts_.patches[patch]);
      if (hole && (!longest || hole->pin.length * longest->diameter > longest->length * hole->pin.diameter))
        longest = hole->pin;
    }
    return longest;
  }

  /// Where a pin finds it, and the pin that did.
  void place(std::size_t patch, UndercutReport& noted) const {
    const glm::vec3 centre = model_.frame.to_unit(noted.undercut.centre);
    float nearest = std::numeric_limits<float>::infinity();
    for (const Atom& atom : atoms_) {
      if (atom.patch != patch) continue;
      if (atom.pin != nullptr) noted.pin = *atom.pin;
      for (const UndercutSample& sample : atom.samples) {
        const float distance = glm::distance(sample.position, centre);
        if (distance >= nearest) continue;
        nearest = distance;
        noted.point = model_.frame.center + model_.frame.diagonal * glm::dvec3(sample.position);
      }
    }
  }

  const PartModel& model_;
  const SplitMesh& split_;
  const ActionSettings& settings_;
  const Progress& progress_;
  ExactQuery query_;
  Undercuts undercuts_;
  PullFinder pulls_;
  double unit_per_mm_;
  PlanDetail detail_;
  std::vector<std::vector<PullCandidate>> tried_;  // by patch
  std::vector<Atom> atoms_;
  std::vector<Column> revolved_;  // threads and rings
  std::optional<Faces> faces_;
  BodyPlayer bodies_;
  std::set<std::size_t> insisted_;  // atoms for which inserts were looked for last
};

}  // namespace

ActionPlan find_actions(const PartModel& model, const Classification& result, const ActionSettings& settings,
                        const Progress& progress, PlanDetail detail) {
  return Finder(model, result, settings, progress, detail).run();
}

}  // namespace moldlight
