#include "session/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "base/error.hpp"
#include "mold/candidates/find_candidates.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/sweep/patches.hpp"
#include "mold/sweep/sphere_search.hpp"
#include "session/method_options.hpp"
#include "session/sweep/basin_search.hpp"
#include "session/sweep/contender.hpp"
#include "session/sweep/direction_judge.hpp"
#include "session/sweep/listing.hpp"
#include "session/sweep/polish.hpp"
#include "session/sweep/remarks.hpp"
#include "session/sweep/scoring_engine.hpp"
#include "session/sweep/sweep_stages.hpp"
#include "session/sweep/sweep_watch.hpp"
#include "session/sweep/tilt_margin.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_batch = 64;  // directions between two looks at the limit for giving up
constexpr int k_fine_factor = 8;     // samples of the second scoring over those of the first
constexpr std::size_t k_contenders_per_listed = 6;
constexpr double k_first_exact_step_deg = 0.02, k_last_exact_step_deg = 2e-5;
constexpr int k_exact_probes = 6;
constexpr double k_across_cosine = 0.9999995;  // within 0.06 degrees
constexpr double k_no_limit = std::numeric_limits<double>::infinity();

class SweepRun {
 public:
  SweepRun(Classifier& classifier, const SweepSettings& settings, const Progress& progress,
           const SweepListener& listener)
      : classifier_(classifier),
        model_(classifier.model()),
        settings_(settings),
        watch_(progress, settings.time_limit_s),
        listener_(listener),
        judge_(model_, settings),
        engine_(classifier, settings_),
        limit_(static_cast<std::size_t>(settings.top), settings.apart_deg) {
    validate(settings.method);
  }

  SweepResult run() {
    result_.settings = settings_;
    result_.engine = engine_.description();
    result_.jobs = engine_.pool().jobs();
    score_candidates();
    refine();
    keep_contenders();
    score_closer();
    classify_best();
    rank();
    result_.remarks = sweep_remarks(model_, result_);
    result_.complete = !watch_.cut_short();
    result_.elapsed_s = watch_.elapsed_s();
    return std::move(result_);
  }

 private:
  void score_candidates();
  void score_batch(std::span<Candidate> batch, std::size_t before, std::size_t total);
  void refine();
  void tell(const EvaluatedDirection& evaluated);
  void keep_contenders();
  void score_closer();
  void classify_best();
  void rank();
  [[nodiscard]] std::vector<std::size_t> contender_order() const;
  /// Undercut area above which a direction is surely not among the listed ones, by what is scored so far.
  [[nodiscard]] double listing_limit() const;
  [[nodiscard]] std::size_t top() const { return static_cast<std::size_t>(settings_.top); }
  /// Both without the tilt margin. The first throws Cancelled, the second is by the contender's score alone.
  [[nodiscard]] SweepCandidate final_figures(const Contender& contender);
  [[nodiscard]] SweepCandidate scored_figures(const Contender& contender) const;
  void complete_figures(const Contender& contender, SweepCandidate& candidate) const;
  [[nodiscard]] SweepCandidate figures_for_list(const Contender& contender);
  void settle_exactly(Contender& contender) const;
  [[nodiscard]] std::vector<std::optional<TiltMargin>> tilt_margins(const std::vector<Contender>& listed);

  Classifier& classifier_;
  const PartModel& model_;
  const SweepSettings settings_;
  SweepWatch watch_;
  const SweepListener& listener_;
  DirectionJudge judge_;
  ScoringEngine engine_;
  ListingLimit limit_;
  std::vector<Contender> contenders_;
  SweepResult result_;
};

void SweepRun::score_candidates() {
  CandidateOptions options;
  options.kinds = settings_.kinds;
  options.uniform_count = static_cast<std::size_t>(settings_.directions);
  options.user = settings_.user_directions;
  watch_.report(sweep_stage::k_candidates, 0.0);
  std::vector<Candidate> candidates;
  try {
    candidates = find_candidates(model_.part.mesh, model_.geometry, model_.adjacency, options,
                                 watch_.until_cancelled());
  } catch (const Cancelled&) {
    return;
  }
  // Candidates of the part come first and set a low limit for those of the even set.
  for (std::size_t first = 0; first < candidates.size(); first += k_batch) {
    if (contenders_.empty() ? watch_.cancelled() : watch_.stopped()) break;
    const std::size_t count = std::min(k_batch, candidates.size() - first);
    score_batch(std::span(candidates).subspan(first, count), first, candidates.size());
  }
}

void SweepRun::score_batch(std::span<Candidate> batch, std::size_t before, std::size_t total) {
  // The limit changes between batches only, so that it does not depend on which thread was faster.
  const double limit = settings_.thorough ? k_no_limit : listing_limit();
  std::vector<ScoringTask> tasks;
  for (const Candidate& candidate : batch) {
    const bool from_user = candidate.sources.front().kind == CandidateKind::user;
    tasks.push_back({candidate.direction, from_user ? k_no_limit : limit});
  }
  const auto evaluated = [&](std::size_t i, const DirectionScore& score) {
    return evaluated_direction(batch[i].direction, batch[i].sources.front().kind, score);
  };
  std::size_t done = before;
  const auto listener = [&](std::size_t i, const DirectionScore& score) {
    watch_.report(sweep_stage::k_scoring, static_cast<double>(++done) / static_cast<double>(total));
    if (listener_.evaluated) listener_.evaluated(evaluated(i, score));
  };
  // The first directions are scored even when the time is over already: there is a best one to tell.
  const bool is_first = contenders_.empty();
  const auto scores = engine_.pool().score(
      tasks, [&] { return is_first ? watch_.cancelled() : watch_.stopped(); }, listener);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!scores[i]) continue;
    result_.evaluated.push_back(evaluated(i, *scores[i]));
    const DirectionFigures figures = judge_.scored(batch[i], *scores[i]);
    limit_.add(batch[i].direction, scores[i]->pessimistic());
    contenders_.push_back({std::move(batch[i]), *scores[i], figures});
  }
}

std::vector<std::size_t> SweepRun::contender_order() const {
  std::vector<DirectionFigures> figures;
  for (const Contender& contender : contenders_) figures.push_back(contender.figures);
  return judge_.rank(figures).order;
}

double SweepRun::listing_limit() const {
  // With another objective a direction of much undercut may still be listed.
  return judge_.by_undercut_alone() ? limit_.undercut() : k_no_limit;
}

void SweepRun::tell(const EvaluatedDirection& evaluated) {
  result_.evaluated.push_back(evaluated);
  if (listener_.evaluated) listener_.evaluated(evaluated);
}

void SweepRun::refine() {
  const BasinSearch search{.judge = judge_,
                           .pool = engine_.pool(),
                           .watch = watch_,
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
  const std::size_t before = contenders_.size(), most = k_contenders_per_listed * top();
  std::vector<std::size_t> possible;
  for (const std::size_t i : contender_order()) {
    if (contenders_[i].from_user() || contenders_[i].score.optimistic() <= limit) possible.push_back(i);
  }
  const ListingRules rules{.apart_deg = settings_.apart_deg, .tentative = true};
  contenders_ = contenders_to_list(judge_, contenders_, possible, most, rules);
  result_.skipped = before - contenders_.size();
}

void SweepRun::score_closer() {
  if (contenders_.size() <= 1 || watch_.stopped()) return;
  const std::unique_ptr<ScoringPool> pool =
      engine_.make_closer_pool(settings_.scoring_samples * k_fine_factor);
  std::vector<ScoringTask> tasks;
  for (const Contender& contender : contenders_)
    tasks.push_back({.direction = contender.candidate.direction});
  std::size_t done = 0;
  const auto listener = [&](std::size_t, const DirectionScore&) {
    watch_.report(sweep_stage::k_closer, static_cast<double>(++done) / static_cast<double>(tasks.size()));
  };
  const auto scores = pool->score(
      tasks, [this] { return watch_.stopped(); }, listener);
  for (std::size_t i = 0; i < contenders_.size(); ++i) {
    if (!scores[i]) continue;
    contenders_[i].score = *scores[i];
    contenders_[i].figures = judge_.scored(contenders_[i].candidate, *scores[i]);
  }
  if (watch_.stopped()) return;
  const Polishing polishing{.judge = judge_,
                            .engine = engine_,
                            .closer = *pool,
                            .watch = watch_,
                            .settings = settings_,
                            .total_area = model_.geometry.total_area,
                            .evaluated = [this](const EvaluatedDirection& evaluated) { tell(evaluated); }};
  polish(polishing, contenders_, contender_order());
}

SweepCandidate SweepRun::final_figures(const Contender& contender) {
  MethodSettings method = settings_.method;
  method.direction = contender.candidate.direction;
  SweepCandidate candidate;
  candidate.candidate = contender.candidate;
  candidate.classification = classifier_.classify(method, watch_.until_cancelled());
  candidate.patches =
      undercut_patches(candidate.classification.facet_fractions, model_.geometry, model_.adjacency).count;
  candidate.classification.facet_fractions = {};
  complete_figures(contender, candidate);
  return candidate;
}

SweepCandidate SweepRun::scored_figures(const Contender& contender) const {
  SweepCandidate candidate;
  candidate.candidate = contender.candidate;
  candidate.measured = false;
  Classification& scored = candidate.classification;
  scored.settings = settings_.method;
  scored.settings.direction = scored.direction = contender.candidate.direction;
  scored.areas = contender.score.areas;
  scored.total_area = model_.geometry.total_area;
  scored.near_vertical_area = judge_.near_vertical_area(scored.direction);
  scored.shadow_area = contender.score.shadow_area;
  scored.uncertainty.readout = contender.score.undercut_error;
  scored.warnings = model_.warnings;
  complete_figures(contender, candidate);
  return candidate;
}

void SweepRun::complete_figures(const Contender& contender, SweepCandidate& candidate) const {
  candidate.projected_area = candidate.classification.shadow_area;
  candidate.clamp_force = settings_.pressure * candidate.projected_area;
  candidate.draw_depth = contender.figures[Criterion::draw_depth];
  candidate.undraughted_area = candidate.classification.near_vertical_area;
}

SweepCandidate SweepRun::figures_for_list(const Contender& contender) {
  try {
    if (!watch_.cancelled()) return final_figures(contender);
  } catch (const Cancelled&) {
    static_cast<void>(watch_.cancelled());  // which notes that work was left undone
  }
  return scored_figures(contender);
}

std::vector<std::optional<TiltMargin>> SweepRun::tilt_margins(const std::vector<Contender>& listed) {
  const double growth = settings_.tilt_growth_pct * 0.01 * model_.geometry.total_area;
  std::vector<std::optional<TiltMargin>> margins;
  for (const Contender& contender : listed) {
    margins.push_back(tilt_margin(engine_.same_samples_pool(), contender.candidate.direction, growth,
                                  [this] { return watch_.stopped(); }));
  }
  return margins;
}

/// Follows the direction downhill by exact areas, in steps far below what the scores tell apart: an axis
/// found from facets is off by their rounding, and walls along it then tilt.
void SweepRun::settle_exactly(Contender& contender) const {
  if (contender.from_user() || !judge_.by_undercut_alone()) return;
  const ExactPart& part = model_.exact(Progress{});
  const auto areas_at = [&](const glm::dvec3& direction, double limit, std::span<const FacetIndex> first) {
    const ExactQuery query{
        .direction = direction,
        .tau_deg = settings_.method.tau_deg,
        .lateral = lateral_tolerance(settings_.method, model_.frame.diagonal) / model_.frame.diagonal};
    return exact_areas_within(part, query, {.undercut = limit, .first = first});
  };
  glm::dvec3 best = contender.candidate.direction;
  const auto start = areas_at(best, k_no_limit, {});
  double least = start->areas[Region::undercut];
  // Facets that are undercut here mostly are so beside it: they settle that a direction is no better.
  std::vector<FacetIndex> undercut;
  for (FacetIndex facet = 0; facet < start->facet_fractions.size(); ++facet) {
    if (start->facet_fractions[facet][static_cast<std::size_t>(Region::undercut)] > 0.0)
      undercut.push_back(facet);
  }
  // The mean normal of the planes across the pull is known far better than any one axis or plane's normal.
  glm::dvec3 across(0.0);
  for (std::size_t facet = 0; facet < model_.geometry.areas.size(); ++facet) {
    const double sine = glm::dot(model_.geometry.normals[facet], best);
    if (std::abs(sine) > k_across_cosine)
      across += std::copysign(model_.geometry.areas[facet], sine) * model_.geometry.normals[facet];
  }
  if (across != glm::dvec3(0.0)) {
    const glm::dvec3 mean = glm::normalize(across);
    const auto areas = areas_at(mean, least, undercut);
    if (areas && areas->areas[Region::undercut] < least) {
      least = areas->areas[Region::undercut];
      best = mean;
    }
  }
  // The surface of undercut areas is creased: a turned ring finds the way out of a crease that the first one
  // missed.
  for (double step_deg = k_first_exact_step_deg; step_deg > k_last_exact_step_deg; step_deg *= 0.5) {
    for (const double phase_deg : {0.0, 180.0 / k_exact_probes}) {
      if (least <= 0.0 || watch_.stopped()) return;
      const std::vector<glm::dvec3> ring = ring_around(best, step_deg, k_exact_probes, phase_deg);
      std::vector<double> found(ring.size(), k_no_limit);
      tbb::parallel_for(std::size_t{0}, ring.size(), [&](std::size_t k) {
        if (const auto areas = areas_at(ring[k], least, undercut)) found[k] = areas->areas[Region::undercut];
      });
      const auto lowest = std::min_element(found.begin(), found.end());
      if (*lowest >= least) continue;
      least = *lowest;
      best = ring[static_cast<std::size_t>(lowest - found.begin())];
      break;
    }
    contender.candidate.direction = best;
  }
}

void SweepRun::classify_best() {
  std::vector<Contender> listed =
      contenders_to_list(judge_, contenders_, contender_order(), top(), {.apart_deg = settings_.apart_deg});
  if (!listed.empty() && !watch_.stopped()) settle_exactly(listed.front());
  // The margins want rays and the figures mostly the GL: together they keep all cores at work.
  std::future<std::vector<std::optional<TiltMargin>>> margins =
      std::async(std::launch::async, [&] { return tilt_margins(listed); });
  for (const Contender& contender : listed) {
    // Even when the time is over the best direction so far gets its figures.
    if (watch_.stopped() && !watch_.cancelled() && !result_.candidates.empty()) break;
    watch_.report(sweep_stage::k_final,
                  static_cast<double>(result_.candidates.size()) / static_cast<double>(listed.size()));
    result_.candidates.push_back(figures_for_list(contender));
  }
  const std::vector<std::optional<TiltMargin>> found = margins.get();
  for (std::size_t i = 0; i < result_.candidates.size(); ++i) result_.candidates[i].tilt = found[i];
}

void SweepRun::rank() {
  const bool all_measured = std::ranges::all_of(result_.candidates, &SweepCandidate::measured);
  std::vector<DirectionFigures> figures;
  for (const SweepCandidate& candidate : result_.candidates) {
    figures.push_back(judge_.classified(candidate));
    if (!all_measured) figures.back()[Criterion::patches] = 0.0;
  }
  const Ranking ranking = judge_.rank(figures);
  std::vector<SweepCandidate> ranked;
  for (const std::size_t i : ranking.order) {
    SweepCandidate& candidate = result_.candidates[i];
    candidate.rank = ranked.size() + 1;
    candidate.tie_group = ranking.tie_group[i] + 1;
    candidate.pareto = ranking.pareto[i];
    ranked.push_back(std::move(candidate));
  }
  result_.candidates = std::move(ranked);
}

}  // namespace

SweepResult run_sweep(Classifier& classifier, const SweepSettings& settings, const Progress& progress,
                      const SweepListener& listener) {
  return SweepRun(classifier, settings, progress, listener).run();
}

}  // namespace moldlight
