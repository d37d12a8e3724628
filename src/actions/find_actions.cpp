// Pulls for each undercut, those that several can share, and the cheapest set of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <tbb/parallel_for.h>

#include "actions/action_feature.hpp"
#include "actions/body_figures.hpp"
#include "actions/chosen_action.hpp"
#include "actions/core_pins.hpp"
#include "actions/least_set.hpp"
#include "actions/rejected.hpp"
#include "actions/revolved_options.hpp"
#include "actions/sharing.hpp"
#include "actions/side_action.hpp"
#include "actions/undercut_part.hpp"
#include "actions/undercut_report.hpp"
#include "base/check.hpp"
#include "classify/map_comparison.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

namespace {

constexpr double k_samples = 6000.0;                              // over all undercuts
constexpr double k_least_samples = 48.0, k_most_samples = 600.0;  // of one of them
constexpr double k_rough = 0.25;                                  // of these
constexpr double k_across = 0.7;      // cosine, at most, between a way and one across it
constexpr double k_pin_reach = 0.02;  // of the diagonal, from a pin to its undercut

}  // namespace

class ActionSearch::Finder {
 public:
  Finder(const PartModel& model, const Classification& result, const ActionSettings& settings,
         const Progress& progress, bool roughly)
      : model_(model),
        split_(*result.split),
        settings_(in_sizes_of(model, settings)),
        progress_(progress),
        query_(exact_query(model, result.query())),
        undercuts_(find_undercuts(model, split_, query_, progress, settings.least_travel_mm)),
        pulls_(model, query_, undercuts_.axes, settings_, progress),
        unit_per_mm_(unit_per_mm(model.part)),
        lateral_(result.lateral_tolerance),
        roughly_(roughly),
        bodies_(model, result, progress) {}

  /// A small part whose file names no unit may be in another one than millimetres: how thick its steel is
  /// says nothing then, but where the user asks for it.
  [[nodiscard]] static ActionSettings in_sizes_of(const PartModel& model, ActionSettings settings) {
    constexpr double k_small_mm = 10.0;
    const ActionSettings usual;
    if (!model.part.unit.empty() || model.frame.diagonal >= k_small_mm) return settings;
    for (double ActionSettings::*const size :
         {&ActionSettings::lifter_section_mm, &ActionSettings::pin_diameter_mm})
      if (settings.*size == usual.*size) settings.*size = 0.0;
    return settings;
  }

  [[nodiscard]] const Undercuts& undercuts() const { return undercuts_; }

  ActionPlan plan(PlanDetail detail, double most_left) {
    CHECK((detail == PlanDetail::rough) == roughly_);
    if (!options_) find_what_is_possible();
    const ChosenContext context{model_,       split_,   undercuts_, pulls_,   settings_,
                                unit_per_mm_, lateral_, detail,     most_left};
    ActionPlan plan =
        least_set(context, undercut_parts_, *options_,
                  {.alternatives = [&](std::size_t undercut_part) { return alternatives(undercut_part); },
                   .measure = [&](ActionPlan& draft, bool fine) { measure(draft, fine); }},
                  progress_);
    plan.specks = undercuts_.specks;
    add_shallow_specks(plan);
    if (detail == PlanDetail::whole && plan.unreleased_area <= most_left) {
      keep_rejected(model_, undercut_parts_, revolved_.rejected, query_.direction, plan);
      report(plan);
    } else {
      for (const Undercut& undercut : undercuts_.counted) plan.undercuts.emplace_back().undercut = undercut;
    }
    return plan;
  }

 private:
  void find_what_is_possible() {
    sample();
    find_candidates();
    find_pulls();
    progress_.report("looking for threads", 0.4);
    revolved_ = revolved_options({model_, split_, undercuts_, query_, settings_, progress_}, undercut_parts_);
    set_shallow_apart();
    split_the_rest();
    find_steep_slides();
    find_inserts();
    options_ = find_options();
  }

  void sample() {
    double total = 0.0;
    for (const Undercut& undercut : undercuts_.counted) total += undercut.area;
    for (std::size_t k = 0; k < undercuts_.counted.size(); ++k) {
      const Undercut& undercut = undercuts_.counted[k];
      const double wanted = (roughly_ ? k_rough : 1.0) *
                            std::clamp(k_samples * undercut.area / total, k_least_samples, k_most_samples);
      undercut_parts_.push_back(
          {k, sample_undercut(model_, split_, undercut, static_cast<std::size_t>(wanted))});
      undercut_parts_.back().pin = pin_of(settings_.pins, {undercut_parts_.back().samples, undercut.area},
                                          model_.frame, k_pin_reach * model_.frame.diagonal);
    }
    if (model_.health.components > 1) set_covered_apart();
    find_thin_pins();
  }

  /// Holes that take a thinner pin than is asked for; but where the user asks for an action.
  void find_thin_pins() {
    constexpr double k_of_facets = 0.95;  // of its diameter a round hole of ten sides is wide between flats
    const double least = settings_.pin_diameter_mm * unit_per_mm_ / model_.frame.diagonal;
    if (least <= 0.0) return;
    for_each_atom([&](std::size_t k) {
      UndercutPart& undercut_part = undercut_parts_[k];
      if (!undercut_part.covered && undercut_part.pin == nullptr)
        undercut_part.thin = core_pin_of(pulls_.release(), undercut_part.samples, k_of_facets * least);
    });
  }

  /// Bodies of a part may overlap. What of an undercut lies within another body becomes an undercut part of
  /// its own.
  void set_covered_apart() {
    for (std::size_t k = 0; k < undercuts_.counted.size(); ++k) {
      const auto is_covered = [&](const UndercutSample& sample) {
        return pulls_.release().is_covered(sample);
      };
      if (std::ranges::all_of(undercut_parts_[k].samples, is_covered)) {
        undercut_parts_[k].covered = true;
        undercut_parts_[k].whole = false;
        continue;
      }
      std::optional<UndercutPart> covered = taken_out(undercut_parts_[k], is_covered);
      if (!covered) continue;
      covered->covered = true;
      undercut_parts_.push_back(std::move(*covered));
    }
  }

  /// Takes the samples that `goes` says out of an undercut part, into one of their own that is returned; none
  /// where they are too few for one, or all of it.
  template <typename Goes>
  [[nodiscard]] std::optional<UndercutPart> taken_out(UndercutPart& undercut_part, const Goes& goes) const {
    UndercutPart taken{
        .undercut = undercut_part.undercut, .samples = {}, .whole = false, .pin = undercut_part.pin};
    std::vector<UndercutSample> rest;
    for (const UndercutSample& sample : undercut_part.samples)
      (goes(sample) ? taken.samples : rest).push_back(sample);
    if (rest.empty() || taken.area() <= k_blocked_share * undercut_part.area()) return std::nullopt;
    undercut_part.samples = std::move(rest);
    undercut_part.whole = false;
    return taken;
  }

  /// What nothing releases whole may be released but for what needs no release.
  void set_shallow_apart() {
    const std::vector<char> revolved = revolved_atoms();
    std::vector<std::vector<UndercutPart>> shallow(undercut_parts_.size());
    for_each_atom([&](std::size_t k) {
      UndercutPart& undercut_part = undercut_parts_[k];
      if (revolved[k] != 0 || !undercut_part.wanted()) return;
      const auto set_apart = [&](const auto& needs_none) {
        std::optional<UndercutPart> taken = taken_out(undercut_part, needs_none);
        if (!taken) return;
        taken->shallow = true;
        shallow[k].push_back(std::move(*taken));
        find_pulls_of(undercut_part);
      };
      if (undercut_part.pulls.empty())
        set_apart([&](const UndercutSample& sample) { return pulls_.is_shallow(sample); });
      if (!undercut_part.allows(ActionKind::slide) ||
          std::ranges::any_of(undercut_part.pulls, [](const Pull& pull) { return is_slide(pull.kind); }))
        return;
      if (const auto way = pulls_.nearly_freeing(undercut_part.samples, candidates(undercut_part)))
        set_apart([&](const UndercutSample& sample) {
          return pulls_.release().free_length(sample, *way) != k_never;
        });
    });
    for (std::vector<UndercutPart>& undercut_parts : shallow) {
      for (UndercutPart& undercut_part : undercut_parts) undercut_parts_.push_back(std::move(undercut_part));
    }
  }

  void add_shallow_specks(ActionPlan& plan) const {
    for (const UndercutPart& undercut_part : undercut_parts_) {
      if (!undercut_part.shallow) continue;
      const glm::dvec3 at(undercut_part.samples.front().position);
      plan.specks.push_back({undercut_part.area(), model_.frame.center + model_.frame.diagonal * at,
                             SpeckReason::shallow, true});
    }
    std::ranges::stable_sort(plan.specks, std::greater(), &Speck::area);
  }

  void find_candidates() {
    const auto fan = pull_fan(undercuts_.axes);
    tried_.resize(undercuts_.counted.size());
    tbb::parallel_for(std::size_t{0}, tried_.size(), [&](std::size_t k) {
      tried_[k] = own_pulls({model_, split_, undercuts_.axes}, undercuts_.counted[k], settings_);
      tried_[k].insert(tried_[k].end(), fan.begin(), fan.end());
    });
  }
  [[nodiscard]] const std::vector<PullCandidate>& candidates(const UndercutPart& undercut_part) const {
    return tried_[undercut_part.undercut];
  }

  /// Calls `work` for every undercut part, several at a time. Throws Cancelled.
  template <typename Work>
  void for_each_atom(const Work& work) {
    tbb::parallel_for(std::size_t{0}, undercut_parts_.size(), [&](std::size_t k) {
      if (!progress_.cancelled()) work(k);
    });
    if (progress_.cancelled()) throw Cancelled();
  }

  void find_pulls() {
    progress_.report("looking for side actions", 0.0);
    for_each_atom([&](std::size_t k) {
      UndercutPart& undercut_part = undercut_parts_[k];
      const auto own = std::ranges::find(candidates(undercut_part), true, &PullCandidate::of_hole);
      if (own != candidates(undercut_part).end()) undercut_part.axis = own->direction;
      if (undercut_part.wanted()) find_pulls_of(undercut_part);
    });
  }

  void find_pulls_of(UndercutPart& undercut_part) const {
    undercut_part.pulls = pulls_.find(undercut_part.samples, candidates(undercut_part), undercut_part.only());
    set_rejected_apart(undercut_part);
  }

  static void set_rejected_apart(UndercutPart& undercut_part) {
    const auto known = static_cast<std::ptrdiff_t>(undercut_part.rejected.size());
    std::erase_if(undercut_part.pulls, [&](const Pull& pull) {
      if (pull.lack) undercut_part.rejected.push_back(pull);
      return pull.lack.has_value();
    });
    std::ranges::stable_sort(undercut_part.rejected.begin() + known, undercut_part.rejected.end(), {},
                             &Pull::travel);
  }

  /// 1 for each undercut part that a thread or a ring releases.
  [[nodiscard]] std::vector<char> revolved_atoms() const {
    std::vector<char> revolved(undercut_parts_.size(), 0);
    for (const ActionOption& option : revolved_.options) {
      for (const std::size_t k : option.undercut_parts) revolved[k] = 1;
    }
    return revolved;
  }

  /// What nothing releases whole becomes an undercut part for each part that a pull frees, and one for what
  /// none does.
  void split_the_rest() {
    progress_.report("splitting undercuts that no single action releases", 0.6);
    const std::vector<char> revolved = revolved_atoms();
    std::vector<std::vector<FreedPart>> parts(undercut_parts_.size());
    for_each_atom([&](std::size_t k) {
      const UndercutPart& undercut_part = undercut_parts_[k];
      if (revolved[k] == 0 && undercut_part.pulls.empty() && undercut_part.wanted())
        parts[k] = pulls_.split(undercut_part.samples, candidates(undercut_part), undercut_part.only());
    });
    take_parts(parts);
  }

  /// For what no action of the mold releases: as the part's shape says, beyond the inclination permitted.
  void find_steep_slides() {
    constexpr double k_steepest_deg = 60.0;
    const std::vector<char> revolved = revolved_atoms();
    ActionSettings steep = settings_;
    steep.incline_deg = std::max(k_steepest_deg, settings_.incline_deg);
    for_each_atom([&](std::size_t k) {
      UndercutPart& undercut_part = undercut_parts_[k];
      if (revolved[k] != 0 || !undercut_part.pulls.empty() || !undercut_part.allows(ActionKind::inclined))
        return;
      for (const PullCandidate& tried :
           own_pulls({model_, split_, undercuts_.axes}, undercuts_.counted[undercut_part.undercut], steep)) {
        if (std::abs(elevation_deg(tried.direction, query_.direction)) <= settings_.incline_deg ||
            !pulls_.release().releases(undercut_part.samples, tried.direction, k_never))
          continue;
        undercut_part.steep =
            Pull{.kind = ActionKind::inclined, .direction = tried.direction, .source = tried.source};
        pulls_.estimate_travel(undercut_part.samples, *undercut_part.steep);
        return;
      }
    });
  }

  /// For what no action of the mold releases.
  void find_inserts() {
    progress_.report("looking for loose inserts", 0.7);
    const std::vector<char> revolved = revolved_atoms();
    ActionSettings all_round = settings_;
    all_round.incline_deg = 90.0;
    const std::vector<PullCandidate> sphere = pull_sphere(undercuts_.axes);
    std::vector<std::vector<FreedPart>> parts(undercut_parts_.size());
    for_each_atom([&](std::size_t k) {
      const UndercutPart& undercut_part = undercut_parts_[k];
      if (revolved[k] != 0 || !undercut_part.pulls.empty() || !undercut_part.allows(ActionKind::insert))
        return;
      auto tried =
          own_pulls({model_, split_, undercuts_.axes}, undercuts_.counted[undercut_part.undercut], all_round);
      tried.insert(tried.end(), sphere.begin(), sphere.end());
      parts[k] =
          pulls_.find_inserts(undercut_part.samples, tried, undercuts_.counted[undercut_part.undercut].area);
    });
    take_parts(parts);
  }

  /// Undercut parts that were split become their parts, those after the first at the end; the others stay.
  void take_parts(std::vector<std::vector<FreedPart>>& parts) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool whole = undercut_parts_[k].whole && parts[k].size() == 1;
      for (std::size_t part = 0; part < parts[k].size(); ++part) {
        UndercutPart undercut_part{
            .undercut = undercut_parts_[k].undercut,
            .samples = std::move(parts[k][part].samples),
            .pulls = std::move(parts[k][part].pulls),
            .rejected = part == 0 ? std::move(undercut_parts_[k].rejected) : std::vector<Pull>(),
            .whole = whole,
            .pin = undercut_parts_[k].pin,
            .covered = undercut_parts_[k].covered,
            .thin = undercut_parts_[k].thin,
            .steep = part == 0 ? undercut_parts_[k].steep : std::nullopt};
        set_rejected_apart(undercut_part);
        if (part == 0) {
          undercut_parts_[k] = std::move(undercut_part);
        } else {
          undercut_parts_.push_back(std::move(undercut_part));
        }
      }
    }
  }

  [[nodiscard]] SharingReach sharing_reach() const {
    const double per_mm = unit_per_mm_ / model_.frame.diagonal;
    return {.across = settings_.bundle_across_mm * per_mm, .along = settings_.bundle_along_mm * per_mm};
  }

  std::vector<ActionOption> find_options() const {
    std::vector<ActionOption> options = pull_options(undercut_parts_, pulls_, sharing_reach());
    options.insert(options.begin(), revolved_.options.begin(), revolved_.options.end());
    return options;
  }

  /// What else releases an undercut part whose slide or lifter meets another: its own slides turned, inclined
  /// ones, lifters, those across its own ways, too.
  std::vector<ActionOption> alternatives(std::size_t number) const {
    const UndercutPart& undercut_part = undercut_parts_[number];
    std::vector<Pull> pulls = pulls_.turned(undercut_part.samples, undercut_part.pulls);
    for (const ActionKind kind : {ActionKind::inclined, ActionKind::lifter}) {
      if (!undercut_part.allows(kind)) continue;
      add_feasible(pulls_.find(undercut_part.samples, candidates(undercut_part), kind), pulls);
    }
    if (undercut_part.allows(ActionKind::lifter)) {
      std::vector<PullCandidate> across = candidates(undercut_part);
      std::erase_if(across, [&](const PullCandidate& tried) {
        return std::ranges::any_of(undercut_part.pulls, [&](const Pull& pull) {
          return std::abs(glm::dot(tried.direction, pull.direction)) > k_across;
        });
      });
      add_feasible(pulls_.find(undercut_part.samples, across, ActionKind::lifter), pulls);
    }
    return pull_options(undercut_parts_, pulls_, sharing_reach(), number, pulls);
  }

  static void add_feasible(const std::vector<Pull>& more, std::vector<Pull>& pulls) {
    std::ranges::copy_if(more, std::back_inserter(pulls), [](const Pull& pull) { return !pull.lack; });
  }

  void measure(ActionPlan& plan, bool fine) {
    if (!faces_) faces_ = part_faces(model_.part, model_.geometry, model_.adjacency);
    plan.undercuts.clear();
    for (std::size_t k = 0; k < undercuts_.counted.size(); ++k) {
      const SideAction* action = action_of(plan, k);
      FormedKey key = {static_cast<double>(k)};
      if (action != nullptr && !action->about) {
        const glm::dvec3& way = action->direction;
        key = {key[0], 1.0 + static_cast<double>(action->kind), way.x, way.y, way.z, action->travel};
      }
      const auto [known, is_new] = formed_.try_emplace(key);
      if (is_new) {
        known->second.undercut = undercuts_.counted[k];
        add_formed_surface({model_, split_, *faces_, pulls_.release()}, action, known->second);
      }
      plan.undercuts.push_back(known->second);
    }
    bodies_.measure(plan, fine);
  }

  void report(ActionPlan& plan) const {
    const std::vector<bool> in_void = plan.unreleased.empty()
                                          ? std::vector<bool>(model_.part.mesh.facets.size(), false)
                                          : void_facets(model_.part.mesh, model_.adjacency);
    for (std::size_t k = 0; k < undercuts_.counted.size(); ++k) {
      progress_.report("describing undercuts", 0.9);
      UndercutReport& noted = plan.undercuts[k];
      noted.blocked_by = blockers(model_, split_, noted.undercut, query_.direction);
      noted.closed_void = std::ranges::all_of(
          noted.undercut.pieces, [&](std::uint32_t piece) { return in_void[split_.pieces[piece].facet]; });
      place(k, noted);
      const SideAction* action = action_of(plan, k);
      if (action != nullptr) {
        const double depth =
            action->travel - (is_slide(action->kind) ? settings_.clearance_mm * unit_per_mm_ : 0.0);
        if (std::isfinite(depth)) noted.depth = depth;
        noted.core_side = action->core_side;
      }
    }
    for (SideAction& action : plan.actions)
      action.feature = feature_text({model_, split_, pulls_.release()}, plan, action);
    set_core_pins(model_, split_, pulls_.release(), undercuts_, undercut_parts_, plan);
  }

  /// Where a pin finds it, and the pin that did.
  void place(std::size_t undercut, UndercutReport& noted) const {
    const glm::vec3 centre = model_.frame.to_unit(noted.undercut.centre);
    float nearest = std::numeric_limits<float>::infinity();
    for (const UndercutPart& undercut_part : undercut_parts_) {
      if (undercut_part.undercut != undercut) continue;
      if (undercut_part.pin != nullptr) noted.pin = *undercut_part.pin;
      for (const UndercutSample& sample : undercut_part.samples) {
        const float distance = glm::distance(sample.position, centre);
        if (distance >= nearest) continue;
        nearest = distance;
        noted.point = model_.frame.center + model_.frame.diagonal * glm::dvec3(sample.position);
      }
    }
  }

  const PartModel& model_;
  const SplitMesh& split_;
  ActionSettings settings_;
  const Progress& progress_;
  ExactQuery query_;
  Undercuts undercuts_;
  PullFinder pulls_;
  double unit_per_mm_, lateral_;
  bool roughly_;
  std::vector<std::vector<PullCandidate>> tried_;  // by undercut
  std::vector<UndercutPart> undercut_parts_;
  RevolvedOptions revolved_;                          // threads and rings
  std::optional<std::vector<ActionOption>> options_;  // once they are found
  std::optional<Faces> faces_;
  using FormedKey = std::array<double, 6>;
  std::map<FormedKey, UndercutReport> formed_;  // by undercut, kind, direction and travel of its action
  BodyPlayer bodies_;
};

ActionSearch::ActionSearch(const PartModel& model, const Classification& result,
                           const ActionSettings& settings, const Progress& progress, bool roughly)
    : finder_(std::make_unique<Finder>(model, result, settings, progress, roughly)) {}

ActionSearch::~ActionSearch() = default;

const Undercuts& ActionSearch::undercuts() const { return finder_->undercuts(); }

ActionPlan ActionSearch::plan(PlanDetail detail, double most_left) {
  return finder_->plan(detail, most_left);
}

ActionPlan find_actions(const PartModel& model, const Classification& result, const ActionSettings& settings,
                        const Progress& progress, PlanDetail detail, double most_left) {
  return ActionSearch(model, result, settings, progress, detail == PlanDetail::rough).plan(detail, most_left);
}

}  // namespace moldlight
