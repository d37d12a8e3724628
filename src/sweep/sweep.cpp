#include "sweep/sweep.hpp"

#include <algorithm>
#include <future>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "classify/figures.hpp"
#include "classify/method_options.hpp"
#include "mold/direction.hpp"
#include "mold/direction_words.hpp"
#include "mold/measure.hpp"
#include "sweep/axis_beside.hpp"
#include "sweep/basin_search.hpp"
#include "sweep/candidates/find_candidates.hpp"
#include "sweep/contender.hpp"
#include "sweep/direction_actions.hpp"
#include "sweep/direction_measurer.hpp"
#include "sweep/direction_rating.hpp"
#include "sweep/listing.hpp"
#include "sweep/mold_ranking.hpp"
#include "sweep/polish.hpp"
#include "sweep/proving.hpp"
#include "sweep/remarks.hpp"
#include "sweep/scoring_pools.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/sweep_stages.hpp"
#include "sweep/sweep_texts.hpp"
#include "sweep/tilt_margin.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_batch = 64;  // directions between two looks at the limit for giving up
constexpr std::size_t k_contenders_per_listed = 6;
constexpr std::size_t k_measured_together = 8;
// A direction of more undercut often asks for fewer actions, but seldom one of far more; and each may take
// seconds.
constexpr std::size_t k_with_actions_per_listed = 2;
constexpr std::size_t k_most_polished = 3;
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
      : model_(*model),
        settings_(settled(settings)),
        clock_(progress, settings.time_limit_s),
        listener_(listener),
        rating_(model_, settings_),
        pools_(std::move(model), settings_),
        measurer_(model_, settings_.method, ScoringPool::threads(settings.jobs), rating_.beside()),
        actions_(model_, settings_.method, settings_.action_settings, ScoringPool::threads(settings.jobs)),
        molds_(model_, settings_, rating_, clock_, measurer_, actions_),
        limit_(wanted(), settings.apart_deg) {
    validate(settings.method, model_.frame.diagonal);
  }

  /// `best_alone`: what cannot be recommended is not looked at.
  SweepResult run(bool best_alone) {
    result_.settings = settings_;
    result_.engine = pools_.description();
    result_.jobs = ScoringPool::threads(settings_.jobs);
    std::vector<Candidate> candidates = candidates_of_the_part();
    if (settings_.rank == SweepRank::mold) {
      look_at_named(candidates);
      if (!best_alone || !molds_.is_free()) look_at_others(candidates, best_alone);
      list_as_molds();
    } else {
      score_candidates(candidates);
      refine();
      keep_contenders();
      measure_contenders();
      polish_best();
      prove();
      choose();
      find_side_actions();
      list();
    }
    measure_axes();
    judge_proofs(result_);
    recommend();
    result_.remarks = sweep_remarks(model_, result_);
    result_.complete = !clock_.cut_short();
    result_.elapsed_s = clock_.elapsed_s();
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::vector<Candidate> candidates_of_the_part();
  void score_candidates(std::vector<Candidate>& candidates);
  void look_at_named(std::vector<Candidate>& candidates);
  void look_at_others(std::vector<Candidate>& candidates, bool best_alone);
  void list_as_molds();
  void recommend();
  void reset_limit();
  void score_batch(std::span<Candidate> batch, std::size_t before, std::size_t total);
  void refine();
  void tell(const EvaluatedDirection& evaluated);
  void keep_contenders();
  void measure_contenders();
  void measure_first();
  [[nodiscard]] bool surely_hidden(const Contender& contender) const;
  void measure_batch(std::span<Contender> batch, const std::function<bool()>& stop);
  [[nodiscard]] bool may_gain(const Contender& found) const;
  [[nodiscard]] Polishing polishing();
  void polish_best();
  [[nodiscard]] std::vector<std::size_t> contenders_to_polish() const;
  /// Looked at to the end, whatever its score.
  [[nodiscard]] bool is_named(const Candidate& candidate) const {
    return candidate.from_user() || (settings_.rank == SweepRank::mold && candidate.canonical);
  }
  void prove();
  void choose();
  void find_side_actions();
  void list();
  [[nodiscard]] std::vector<std::optional<TiltMargin>> tilts_of(std::span<const Contender> listed);
  void measure_axes();
  [[nodiscard]] SweepCandidate listed_candidate(const Contender& contender,
                                                const std::optional<TiltMargin>& tilt);
  void complete(std::vector<Contender>& listed);
  [[nodiscard]] std::vector<std::size_t> contender_order() const;
  /// Undercut area above which a direction is surely not among the listed ones, by what is scored so far.
  [[nodiscard]] double listing_limit() const;
  [[nodiscard]] std::size_t top() const { return static_cast<std::size_t>(settings_.top); }
  /// How many are chosen by what is known before side actions are.
  [[nodiscard]] std::size_t wanted() const {
    return rating_.by_actions() ? k_with_actions_per_listed * top() : top();
  }

  const PartModel& model_;
  const SweepSettings settings_;
  SweepClock clock_;
  const SweepListener& listener_;
  DirectionRating rating_;
  ScoringPools pools_;
  DirectionMeasurer measurer_;
  DirectionActionFinder actions_;
  MoldRanking molds_;
  ListingLimit limit_;           // by scores, then by measured areas
  std::vector<Candidate> axes_;  // of the part
  std::vector<Contender> contenders_;
  std::vector<Contender> named_;  // by the user or by the part's shape, where directions rank as molds go
  SweepResult result_;
};

std::vector<Candidate> SweepRun::candidates_of_the_part() {
  CandidateOptions options;
  options.kinds = settings_.kinds;
  options.uniform_count = static_cast<std::size_t>(settings_.directions);
  options.user = settings_.user_directions;
  clock_.report(sweep_stage::k_candidates, 0.0);
  std::vector<Candidate> candidates;
  try {
    // Meanwhile another thread, if there may be one, makes what the later stages need of the part.
    std::future<void> prepared = std::async(std::launch::async | std::launch::deferred, [&] {
      (void)model_.exact(clock_.until_cancelled());
      (void)model_.rays();
    });
    candidates = find_candidates(model_, options, clock_.until_cancelled());
    axes_ = axes_of(candidates);
    prepared.get();
  } catch (const Cancelled&) {
    return {};
  }
  return candidates;
}

void SweepRun::score_candidates(std::vector<Candidate>& candidates) {
  // Candidates of the part come first and set a low limit for those of the even set.
  for (std::size_t first = 0; first < candidates.size(); first += k_batch) {
    if (result_.evaluated.empty() ? clock_.cancelled() : clock_.stopped()) break;
    const std::size_t count = std::min(k_batch, candidates.size() - first);
    score_batch(std::span(candidates).subspan(first, count), first, candidates.size());
  }
}

void SweepRun::score_batch(std::span<Candidate> batch, std::size_t before, std::size_t total) {
  // The limit changes between batches only, so that it does not depend on which thread was faster.
  const double limit = settings_.thorough ? k_no_limit : listing_limit();
  std::vector<ScoringTask> tasks;
  for (const Candidate& candidate : batch) {
    tasks.push_back({candidate.direction, is_named(candidate) ? k_no_limit : limit});
  }
  const auto evaluated = [&](std::size_t i, const DirectionScore& score) {
    return evaluated_direction(batch[i].direction, batch[i].kind(), score);
  };
  std::size_t done = before;
  const auto listener = [&](std::size_t i, const DirectionScore& score) {
    clock_.report(sweep_stage::k_scoring, static_cast<double>(++done) / static_cast<double>(total));
    if (listener_.evaluated) listener_.evaluated(evaluated(i, score));
  };
  // The first directions are scored even when the time is over already: there is a best one to tell.
  const bool is_first = result_.evaluated.empty();
  const auto scores = pools_.engine().score(
      tasks, [&] { return is_first ? clock_.cancelled() : clock_.stopped(); }, listener);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!scores[i]) continue;
    result_.evaluated.push_back(evaluated(i, *scores[i]));
    const RankedFigures figures = rating_.scored(batch[i], *scores[i]);
    limit_.add(batch[i].direction, scores[i]->pessimistic());
    contenders_.push_back({std::move(batch[i]), *scores[i], figures, {}});
  }
}

std::vector<std::size_t> SweepRun::contender_order() const {
  std::vector<RankedFigures> figures;
  for (const Contender& contender : contenders_) figures.push_back(contender.figures);
  return rating_.rank(figures).order;
}

double SweepRun::listing_limit() const {
  // With another objective a direction of much undercut may still be listed.
  return rating_.by_undercut_alone() ? limit_.undercut() : k_no_limit;
}

void SweepRun::tell(const EvaluatedDirection& evaluated) {
  result_.evaluated.push_back(evaluated);
  if (listener_.evaluated) listener_.evaluated(evaluated);
}

void SweepRun::refine() {
  const BasinSearch search{.rating = rating_,
                           .rays = pools_.rays(),
                           .clock = clock_,
                           .evaluated = [this](const EvaluatedDirection& evaluated) { tell(evaluated); }};
  std::vector<Contender> found =
      refine_basins(search, contenders_, contender_order(), static_cast<std::size_t>(settings_.refine));
  for (Contender& contender : found) {
    limit_.add(contender.candidate.direction, contender.score.pessimistic());
    contenders_.push_back(std::move(contender));
  }
}

/// Keeps whatever may still be among the listed ones: its optimistic undercut is below the pessimistic one of
/// the last listed. Where more than a few times the list tie, those that the tie's order puts first are kept.
void SweepRun::keep_contenders() {
  const double limit = listing_limit();
  const std::size_t before = contenders_.size();
  std::vector<std::size_t> possible;
  for (const std::size_t i : contender_order()) {
    if (contenders_[i].candidate.from_user() || contenders_[i].score.optimistic() <= limit)
      possible.push_back(i);
  }
  const ListingRules rules{
      .most = k_contenders_per_listed * top(), .apart_deg = settings_.apart_deg, .tentative = true};
  contenders_ = contenders_to_list(rating_, contenders_, possible, rules);
  result_.skipped = before - contenders_.size();
}

/// Contenders come by their scores, so that what is measured soon tells of many others that they cannot be
/// listed.
void SweepRun::measure_contenders() {
  std::vector<Contender> open = std::exchange(contenders_, {});
  reset_limit();
  for (std::size_t first = 0; first < open.size();) {
    clock_.report(sweep_stage::k_measuring, static_cast<double>(first) / static_cast<double>(open.size()));
    const double limit = listing_limit();
    std::vector<Contender> batch;
    for (; first < open.size() && batch.size() < k_measured_together; ++first) {
      if (!open[first].candidate.from_user() &&
          (open[first].score.optimistic() > limit || surely_hidden(open[first]))) {
        ++result_.skipped;
      } else {
        batch.push_back(std::move(open[first]));
      }
    }
    measure_batch(batch, [this] { return clock_.stopped(); });
  }
  if (named_.empty()) measure_first();
}

/// Even when the time is over the best direction so far gets its figures.
void SweepRun::measure_first() {
  if (!contenders_.empty() && !contenders_.front().measured && !clock_.cancelled()) {
    std::vector<Contender> scored = std::exchange(contenders_, {});
    measure_batch({scored.data(), 1}, [this] { return clock_.cancelled(); });
  }
}

/// Beside a better one that is measured.
bool SweepRun::surely_hidden(const Contender& contender) const {
  return rating_.by_undercut_alone() && std::ranges::any_of(contenders_, [&](const Contender& other) {
           return other.measured && contender.score.optimistic() > other.figures.undercut &&
                  line_angle_deg(contender.candidate.direction, other.candidate.direction) <=
                      settings_.apart_deg;
         });
}

/// Puts what may still be listed among the contenders, measured if there was time.
void SweepRun::measure_batch(std::span<Contender> batch, const std::function<bool()>& stop) {
  const double limit = listing_limit();
  std::vector<ScoringTask> tasks;
  for (const Contender& contender : batch)
    tasks.push_back({contender.candidate.direction, is_named(contender.candidate) ? k_no_limit : limit});
  auto measured = measurer_.measure(tasks, {}, clock_.until_cancelled(), stop);
  const bool stopped = stop();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    Contender& contender = batch[i];
    if (measured[i]) {
      contender.figures = rating_.measured(contender.candidate, *measured[i]);
      contender.measured = std::make_shared<const MeasuredDirection>(std::move(*measured[i]));
      limit_.add(contender.candidate.direction,
                 contender.figures.undercut + contender.figures.undercut_uncertainty);
    } else if (!stopped) {
      ++result_.skipped;
      continue;
    }
    contenders_.push_back(std::move(contender));
  }
}

/// Of the best those that lie apart.
std::vector<std::size_t> SweepRun::contenders_to_polish() const {
  const bool by_molds = settings_.rank == SweepRank::mold;
  const std::size_t most =
      std::min(by_molds ? std::size_t{1} : k_most_polished, static_cast<std::size_t>(settings_.refine));
  std::vector<std::size_t> chosen;
  double limit = k_no_limit;
  for (const std::size_t i : contender_order()) {
    if (chosen.size() == most) break;
    const Contender& contender = contenders_[i];
    if (!contender.measured || contender.figures.value > limit) continue;
    if (by_molds && !may_gain(contender)) continue;
    const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return line_angle_deg(contenders_[other].candidate.direction, contender.candidate.direction) >
             settings_.apart_deg;
    });
    if (!apart) continue;
    if (chosen.empty())
      limit =
          contender.figures.value + rating_.value_of_undercut(k_polished_share * model_.geometry.total_area);
    chosen.push_back(i);
  }
  return chosen;
}

/// Less undercut than all that the shape names, by more than it is worth to leave that.
bool SweepRun::may_gain(const Contender& found) const {
  const double worth = 0.01 * settings_.worth_pct * model_.geometry.total_area;
  return std::ranges::none_of(named_, [&](const Contender& each) {
    return each.measured && each.figures.undercut <= found.figures.undercut + worth;
  });
}

Polishing SweepRun::polishing() {
  return {.model = model_,
          .rating = rating_,
          .rays = pools_.rays(),
          .measurer = measurer_,
          .clock = clock_,
          .evaluated = [this](const EvaluatedDirection& evaluated) { tell(evaluated); }};
}

void SweepRun::polish_best() {
  const Polishing polishing = this->polishing();
  const std::vector<std::size_t> chosen = contenders_to_polish();
  for (std::size_t k = 0; k < chosen.size() && !clock_.stopped(); ++k) {
    clock_.report(sweep_stage::k_polishing, static_cast<double>(k) / static_cast<double>(chosen.size()));
    Contender& start = contenders_[chosen[k]];
    std::optional<Contender> better = polish(polishing, start);
    if (!better) continue;
    // A direction with other sources stands beside the one that it was found from.
    if (better->candidate.kind() == start.candidate.kind()) {
      start = std::move(*better);
    } else {
      contenders_.push_back(std::move(*better));
    }
  }
}

SweepCandidate SweepRun::listed_candidate(const Contender& contender, const std::optional<TiltMargin>& tilt) {
  SweepCandidate listed;
  listed.candidate = contender.candidate;
  listed.measured = contender.measured != nullptr;
  listed.tilt = tilt;
  listed.actions = contender.actions;
  listed.beside = contender.beside;
  Classification& classification = listed.classification;
  if (listed.measured) {
    classification = contender.measured->classification;
    listed.undercuts = contender.measured->undercuts;
    listed.line = contender.measured->parting;
  } else {
    classification = rating_.classification(contender.candidate.direction, contender.score);
    classification.near_vertical_area =
        near_vertical_area(model_.geometry, classification.direction, settings_.method.tau_deg);
    classification.warnings = model_.warnings;
  }
  DirectionFacts facts = rating_.facts(classification, contender.measured.get());
  facts.tilt = tilt;
  if (contender.actions) facts.actions = &*contender.actions;
  listed.figures = find_figures(facts);
  return listed;
}

void SweepRun::prove() {
  if (!settings_.prove_pct && !settings_.all_free_pct) return;
  prove_sweep({.polishing = polishing(), .settings = settings_, .jobs = result_.jobs}, contenders_, result_);
}

/// Those that are listed, or may be once their side actions are known.
void SweepRun::choose() {
  contenders_ = contenders_to_list(rating_, contenders_, contender_order(),
                                   {.most = wanted(), .apart_deg = settings_.apart_deg});
  if (clock_.stopped() && !clock_.cancelled())
    std::erase_if(contenders_, [](const Contender& contender) { return !contender.measured; });
}

void SweepRun::find_side_actions() {
  if (!seeks_actions(settings_)) return;
  clock_.report(sweep_stage::k_actions, 0.0);
  std::vector<Contender*> measured;
  std::vector<glm::dvec3> directions;
  for (Contender& contender : contenders_) {
    if (!contender.measured) continue;
    measured.push_back(&contender);
    directions.push_back(contender.candidate.direction);
  }
  std::mutex mutex;
  std::size_t done = 0;
  const auto found = actions_.find(
      directions, {}, clock_.until_cancelled(), [this] { return clock_.stopped(); },
      [&] {
        const std::lock_guard lock(mutex);
        clock_.report(sweep_stage::k_actions,
                      static_cast<double>(++done) / static_cast<double>(directions.size()));
      });
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (!found[k]) continue;
    Contender& contender = *measured[k];
    contender.actions = found[k];
    contender.figures = rating_.measured(contender.candidate, *contender.measured, *contender.actions);
    ++result_.with_actions;
  }
}

void SweepRun::list() {
  std::vector<Contender> listed = rating_.by_actions()
                                      ? contenders_to_list(rating_, contenders_, contender_order(),
                                                           {.most = top(), .apart_deg = settings_.apart_deg})
                                      : std::move(contenders_);
  complete(listed);
  const bool all_measured =
      std::ranges::all_of(listed, [](const Contender& c) { return c.measured != nullptr; });
  std::vector<RankedFigures> figures;
  for (const Contender& contender : listed) {
    figures.push_back(all_measured || !contender.measured
                          ? contender.figures
                          : rating_.measured(contender.candidate, *contender.measured, false));
  }
  // Ties are told by what is known of all.
  if (!std::ranges::all_of(listed, [](const Contender& c) { return c.actions.has_value(); })) {
    for (RankedFigures& each : figures) each.actions = each.travel = 0.0;
  }
  if (!std::ranges::all_of(listed, [](const Contender& c) { return c.measured && c.measured->undercuts; })) {
    for (RankedFigures& each : figures) each.patches = 0.0;
  }
  const Ranking ranking = rating_.rank(figures);
  const std::vector<std::optional<TiltMargin>> tilts = tilts_of(listed);
  for (const std::size_t i : ranking.order) {
    SweepCandidate candidate = listed_candidate(listed[i], tilts[i]);
    candidate.rank = result_.candidates.size() + 1;
    candidate.tie_group = ranking.tie_group[i] + 1;
    candidate.pareto = ranking.pareto[i];
    result_.candidates.push_back(std::move(candidate));
  }
  mark_ties(result_.candidates);
}

std::vector<std::optional<TiltMargin>> SweepRun::tilts_of(std::span<const Contender> listed) {
  std::vector<glm::dvec3> directions;
  for (const Contender& contender : listed) directions.push_back(contender.candidate.direction);
  return tilt_margins({.pools = pools_,
                       .clock = clock_,
                       .growth = settings_.tilt_growth_pct * 0.01 * model_.geometry.total_area,
                       .jobs = result_.jobs},
                      directions);
}

/// Directions that the part's shape names are followed to their side actions, whatever their undercut.
void SweepRun::look_at_named(std::vector<Candidate>& candidates) {
  const auto others = std::stable_partition(candidates.begin(), candidates.end(),
                                            [this](const Candidate& each) { return is_named(each); });
  std::vector<Candidate> named(std::make_move_iterator(candidates.begin()), std::make_move_iterator(others));
  candidates.erase(candidates.begin(), others);
  score_candidates(named);
  std::vector<Contender> open = std::exchange(contenders_, {});
  std::ranges::stable_sort(open, {}, [](const Contender& c) { return c.figures.undercut; });
  clock_.report(sweep_stage::k_measuring, 0.0);
  measure_batch(open, [this] { return clock_.stopped(); });
  measure_first();
  // What is likely to need nothing comes first.
  std::ranges::stable_sort(contenders_, {}, [](const Contender& c) { return c.figures.undercut; });
  molds_.find_costs(contenders_);
  named_ = std::exchange(contenders_, {});
}

/// Of the others those found by search, and what has least undercut.
void SweepRun::look_at_others(std::vector<Candidate>& candidates, bool best_alone) {
  reset_limit();
  score_candidates(candidates);
  // Search begins from those that are named, too.
  contenders_.insert(contenders_.end(), named_.begin(), named_.end());
  if (!molds_.is_free()) refine();
  std::erase_if(contenders_, [this](const Contender& contender) { return is_named(contender.candidate); });
  keep_contenders();
  measure_contenders();
  if (!molds_.is_free()) polish_best();
  const std::size_t most = best_alone
                               ? std::max(k_least_found, k_least_pool - std::min(k_least_pool, named_.size()))
                               : std::max(k_least_pool, top());
  contenders_ = contenders_to_list(rating_, contenders_, contender_order(),
                                   {.most = most, .apart_deg = settings_.apart_deg});
  molds_.find_costs(contenders_);
  // What was given up by what its actions form may yet weigh less than one found by search.
  if (molds_.found_leads(named_, contenders_)) molds_.find_costs(named_, true);
}

void SweepRun::list_as_molds() {
  contenders_.insert(contenders_.begin(), named_.begin(), named_.end());
  if (clock_.stopped() && !clock_.cancelled())
    std::erase_if(contenders_, [](const Contender& contender) { return !contender.measured; });
  MoldRanking::Listed listed = molds_.listed(std::move(contenders_));
  complete(listed.contenders);
  std::vector<RankedFigures> figures;
  for (const Contender& contender : listed.contenders) figures.push_back(contender.figures);
  const Ranking pareto = rating_.rank(figures);
  const std::vector<std::optional<TiltMargin>> tilts = tilts_of(listed.contenders);
  for (std::size_t k = 0; k < listed.contenders.size(); ++k) {
    SweepCandidate candidate = listed_candidate(listed.contenders[k], tilts[k]);
    candidate.rank = k + 1;
    candidate.tie_group = k == 0 ? 1 : result_.candidates.back().tie_group + (listed.ties[k] ? 0 : 1);
    candidate.pareto = pareto.pareto[k];
    candidate.rank_reasons = std::move(listed.reasons[k]);
    if (candidate.actions) ++result_.with_actions;
    result_.candidates.push_back(std::move(candidate));
  }
  mark_ties(result_.candidates);
}

void SweepRun::recommend() {
  if (settings_.rank != SweepRank::mold || result_.candidates.empty() || clock_.cancelled()) return;
  try {
    result_.recommended =
        recommendation(model_, settings_.method, result_.candidates, clock_.until_cancelled());
    result_.recommended->provisional = clock_.cut_short();
  } catch (const Cancelled&) {
  }
}

/// Those that are named have figures and count from the beginning.
void SweepRun::reset_limit() {
  limit_ = ListingLimit(wanted(), settings_.apart_deg);
  for (const Contender& each : named_) {
    if (each.measured)
      limit_.add(each.candidate.direction, each.figures.undercut + each.figures.undercut_uncertainty);
  }
}

/// Those that listed directions lean from by less than the required draft.
void SweepRun::measure_axes() {
  std::vector<ScoringTask> tasks;
  std::vector<SweepCandidate*> leaning;
  for (SweepCandidate& candidate : result_.candidates) {
    if (!candidate.measured) continue;
    candidate.axis = axis_beside(axes_, candidate.candidate.direction, settings_.method.tau_deg);
    if (!candidate.axis) continue;
    leaning.push_back(&candidate);
    tasks.push_back({candidate.axis->direction});
  }
  auto measured = measurer_.measure(tasks, {}, clock_.until_cancelled(), [this] { return clock_.stopped(); });
  for (std::size_t k = 0; k < leaning.size(); ++k) {
    if (measured[k]) {
      leaning[k]->axis->classification = std::move(measured[k]->classification);
    } else {
      leaning[k]->axis.reset();
    }
  }
}

/// Of every measured contender what is not known yet, as far as there is time.
void SweepRun::complete(std::vector<Contender>& listed) {
  clock_.report(sweep_stage::k_final, 0.0);
  for (Contender& contender : listed) {
    if (!contender.measured) continue;
    const auto measured = std::make_shared<MeasuredDirection>(*contender.measured);
    if (contender.actions) measured->undercuts = contender.actions->undercuts;
    try {
      if (!clock_.stopped()) measurer_.complete(*measured, clock_.until_cancelled());
    } catch (const Cancelled&) {
    }
    contender.figures.patches = static_cast<double>(measured->undercuts.value_or(UndercutTotals{}).count);
    contender.measured = measured;
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
  BestDirection best{.direction = direction, .why = result.recommended->why, .off_axis = {}};
  if (!nearest.is_met()) {
    best.off_axis_deg = nearest.angle_deg;
    best.off_axis = fmt::format("the best direction is no axis of the file: {}, {} from {}",
                                direction_text(direction), angle_text(nearest.angle_deg), nearest.name);
  }
  return best;
}

}  // namespace moldlight
