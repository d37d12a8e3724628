#include "sweep/sweep.hpp"

#include <algorithm>
#include <future>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "classify/number_format.hpp"
#include "mold/direction.hpp"
#include "sweep/axis_beside.hpp"
#include "sweep/candidates/find_candidates.hpp"
#include "sweep/contender.hpp"
#include "sweep/direction_search.hpp"
#include "sweep/listed_directions.hpp"
#include "sweep/listing.hpp"
#include "sweep/mold_ranking.hpp"
#include "sweep/proving.hpp"
#include "sweep/recommendation.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/sweep_texts.hpp"
#include "sweep/sweep_tools.hpp"

namespace moldlight {

namespace {

// Of directions followed to their side actions: in all, and of those found by search.
constexpr std::size_t k_least_pool = 12, k_least_found = 4;

/// The regions of what is listed are exact, whatever the readout that one's classifications have; and what is
/// proved is the objective.
SweepSettings settled(SweepSettings settings) {
  settings.method.readout = Readout::exact;
  if (settings.prove_pct || settings.all_free_pct) settings.rank = SweepRank::objective;
  return settings;
}

class SweepRun {
 public:
  SweepRun(std::shared_ptr<const PartModel> model, const SweepSettings& settings, const Progress& progress,
           const SweepListener& listener)
      : settings_(settled(settings)),
        tools_(std::move(model), settings_, progress, listener),
        molds_(tools_),
        search_(tools_, result_) {}

  /// `best_alone`: what cannot be recommended is not looked at.
  SweepResult run(bool best_alone) {
    result_.settings = settings_;
    result_.engine = tools_.pools.description();
    result_.jobs = ScoringPool::threads(settings_.jobs);
    std::vector<Candidate> candidates = candidates_of_the_part();
    if (settings_.rank == SweepRank::mold) {
      if (best_alone) molds_.seek_best_alone();
      look_at_named(candidates);
      report_named();
      if (!best_alone || !molds_.is_free()) look_at_others(candidates, best_alone);
      list_as_molds(best_alone);
    } else {
      search_.score(candidates);
      search_.refine();
      search_.keep_contenders();
      search_.measure_contenders();
      search_.polish_best();
      prove_sweep(search_.descent(), settings_, search_.contenders(), result_);
      choose(tools_.wanted());
      drop_unmeasured();
      find_side_actions();
      if (tools_.rating.by_actions()) choose(tools_.top());
      tools_.clock.report(sweep_stage::k_final, 0.0);
      result_.candidates = listed_by_objective(tools_, std::move(search_.contenders()));
    }
    if (!best_alone) measure_axes(tools_, axes_, result_.candidates);
    judge_proofs(result_);
    recommend(result_, tools_.clock.cut_short());
    result_.remarks = sweep_remarks(tools_.model, result_);
    result_.complete = !tools_.clock.cut_short();
    result_.elapsed_s = tools_.clock.elapsed_s();
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::vector<Candidate> candidates_of_the_part();
  void look_at_named(std::vector<Candidate>& candidates);
  void report_named();
  void look_at_others(std::vector<Candidate>& candidates, bool best_alone);
  void list_as_molds(bool best_alone);
  void choose(std::size_t most);
  void drop_unmeasured();
  void find_side_actions();
  void recommend(SweepResult& result, bool provisional) const;

  const SweepSettings settings_;
  SweepTools tools_;
  SweepResult result_;
  MoldRanking molds_;
  DirectionSearch search_;
  std::vector<Candidate> axes_;  // of the part
};

std::vector<Candidate> SweepRun::candidates_of_the_part() {
  CandidateOptions options;
  options.kinds = settings_.kinds;
  options.uniform_count = static_cast<std::size_t>(settings_.directions);
  options.user = settings_.user_directions;
  tools_.clock.report(sweep_stage::k_candidates, 0.0);
  std::vector<Candidate> candidates;
  try {
    // Meanwhile another thread, if there may be one, makes what the later stages need of the part.
    std::future<void> prepared = std::async(std::launch::async | std::launch::deferred, [&] {
      (void)tools_.model.exact(tools_.clock.until_cancelled());
      (void)tools_.model.rays();
    });
    candidates = find_candidates(tools_.model, options, tools_.clock.until_cancelled());
    axes_ = axes_of(candidates);
    prepared.get();
  } catch (const Cancelled&) {
    return {};
  }
  return candidates;
}

/// Directions that the part's shape names are followed to their side actions, whatever their undercut.
void SweepRun::look_at_named(std::vector<Candidate>& candidates) {
  const auto others = std::stable_partition(candidates.begin(), candidates.end(),
                                            [this](const Candidate& each) { return search_.is_named(each); });
  std::vector<Candidate> named(std::make_move_iterator(candidates.begin()), std::make_move_iterator(others));
  candidates.erase(candidates.begin(), others);
  search_.score(named);
  search_.measure_all();
  // What is likely to need nothing comes first.
  std::ranges::stable_sort(search_.contenders(), {}, [](const Contender& c) { return c.figures.undercut; });
  molds_.find_costs(search_.contenders());
  search_.named() = std::exchange(search_.contenders(), {});
}

/// What needs no side action stays the best, whatever the others are.
void SweepRun::report_named() {
  constexpr std::size_t k_reported = 3;
  if (!tools_.listener.named || tools_.clock.stopped()) return;
  MoldRanking::Listed listed = molds_.listed(search_.named());
  listed.cut_to(k_reported);
  SweepResult so_far;
  so_far.settings = settings_;
  so_far.complete = false;
  so_far.candidates = listed_as_molds(tools_, std::move(listed), false);
  recommend(so_far, !molds_.is_free());
  tools_.listener.named(std::move(so_far));
}

/// Of the others those found by search, and what has least undercut.
void SweepRun::look_at_others(std::vector<Candidate>& candidates, bool best_alone) {
  search_.reset_limit();
  search_.score(candidates);
  // Search begins from those that are named, too.
  search_.contenders().insert(search_.contenders().end(), search_.named().begin(), search_.named().end());
  if (!molds_.is_free()) search_.refine();
  std::erase_if(search_.contenders(),
                [this](const Contender& contender) { return search_.is_named(contender.candidate); });
  search_.keep_contenders();
  search_.measure_contenders();
  if (!molds_.is_free()) search_.polish_best();
  const std::size_t most =
      best_alone ? std::max(k_least_found, k_least_pool - std::min(k_least_pool, search_.named().size()))
                 : std::max(k_least_pool, tools_.top());
  choose(most);
  molds_.find_costs(search_.contenders());
  // What was given up by what its actions form may yet weigh less than one found by search.
  if (molds_.found_leads(search_.named(), search_.contenders())) molds_.find_costs(search_.named(), true);
}

/// The best alone is listed with the next, beside which it is best, if that is known for sure.
void SweepRun::list_as_molds(bool best_alone) {
  std::vector<Contender>& contenders = search_.contenders();
  contenders.insert(contenders.begin(), search_.named().begin(), search_.named().end());
  drop_unmeasured();
  MoldRanking::Listed listed = molds_.confirmed(std::move(contenders), best_alone ? 1 : tools_.top());
  if (best_alone) listed.cut_to(listed.is_confirmed(1) ? 2 : 1);
  tools_.clock.report(sweep_stage::k_final, 0.0);
  result_.candidates = listed_as_molds(tools_, std::move(listed), !best_alone);
  result_.with_actions = static_cast<std::size_t>(std::ranges::count_if(
      result_.candidates, [](const SweepCandidate& each) { return each.actions.has_value(); }));
}

/// Those that are listed, or may be once more is known of them.
void SweepRun::choose(std::size_t most) {
  search_.contenders() = contenders_to_list(tools_.rating, search_.contenders(), search_.contender_order(),
                                            {.most = most, .apart_deg = settings_.apart_deg});
}

/// Once the time is over, what has no figures is not listed.
void SweepRun::drop_unmeasured() {
  if (tools_.clock.stopped() && !tools_.clock.cancelled())
    std::erase_if(search_.contenders(), [](const Contender& contender) { return !contender.measured; });
}

void SweepRun::find_side_actions() {
  if (!seeks_actions(settings_)) return;
  tools_.clock.report(sweep_stage::k_actions, 0.0);
  std::vector<Contender*> measured;
  std::vector<glm::dvec3> directions;
  for (Contender& contender : search_.contenders()) {
    if (!contender.measured) continue;
    measured.push_back(&contender);
    directions.push_back(contender.candidate.direction);
  }
  std::mutex mutex;
  std::size_t done = 0;
  const auto found = tools_.actions.find(directions, {}, tools_.clock, PlanDetail::whole, [&] {
    const std::lock_guard lock(mutex);
    tools_.clock.report(sweep_stage::k_actions,
                        static_cast<double>(++done) / static_cast<double>(directions.size()));
  });
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (!found[k]) continue;
    Contender& contender = *measured[k];
    contender.actions = found[k];
    contender.figures = tools_.rating.measured(contender.candidate, *contender.measured, contender.actions);
    ++result_.with_actions;
  }
}

void SweepRun::recommend(SweepResult& result, bool provisional) const {
  if (settings_.rank != SweepRank::mold || result.candidates.empty() || tools_.clock.cancelled()) return;
  try {
    result.recommended =
        recommendation(tools_.model, settings_.method, result.candidates, tools_.clock.until_cancelled());
    result.recommended->provisional = provisional;
  } catch (const Cancelled&) {
  }
}

}  // namespace

SweepResult run_sweep(std::shared_ptr<const PartModel> model, const SweepSettings& settings,
                      const Progress& progress, const SweepListener& listener) {
  return SweepRun(std::move(model), settings, progress, listener).run(false);
}

BestDirection best_direction(const std::shared_ptr<const PartModel>& model, const MethodSettings& method,
                             const Progress& progress) {
  SweepSettings settings;
  settings.method = method;
  const SweepResult result = SweepRun(model, settings, progress, {}).run(true);
  if (progress.cancelled()) throw Cancelled();
  CHECK(result.recommended);
  const glm::dvec3& direction = result.recommended->direction;
  const NearestAxis nearest = nearest_axis(direction);
  BestDirection best{direction, result.recommended->name, result.recommended->why, 0.0, {}};
  if (!nearest.is_met()) {
    best.off_axis_deg = nearest.angle_deg;
    best.off_axis = fmt::format("the best direction is not an axis of the file: {}, {} from {}",
                                direction_text(direction), angle_text(nearest.angle_deg), nearest.name);
  }
  return best;
}

}  // namespace moldlight
