#include "sweep/direction_search.hpp"

#include <algorithm>
#include <utility>

#include "sweep/sweep_clock.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_batch = 64;  // directions between two looks at the limit for giving up
constexpr std::size_t k_contenders_per_listed = 6;
constexpr std::size_t k_measured_together = 8;
constexpr std::size_t k_most_polished = 3;

}  // namespace

void DirectionSearch::score(std::vector<Candidate>& candidates) {
  // Candidates of the part come first and set a low limit for those of the even set.
  for (std::size_t first = 0; first < candidates.size(); first += k_batch) {
    if (result_.evaluated.empty() ? tools_.clock.cancelled() : tools_.clock.stopped()) break;
    const std::size_t count = std::min(k_batch, candidates.size() - first);
    score_batch(std::span(candidates).subspan(first, count), first, candidates.size());
  }
}

void DirectionSearch::score_batch(std::span<Candidate> batch, std::size_t before, std::size_t total) {
  // The limit changes between batches only, so that it does not depend on which thread was faster.
  const double limit = tools_.settings.thorough ? k_no_limit : listing_limit();
  std::vector<ScoringTask> tasks;
  for (const Candidate& candidate : batch) {
    tasks.push_back({candidate.direction, is_named(candidate) ? k_no_limit : limit});
  }
  const auto evaluated = [&](std::size_t i, const DirectionScore& score) {
    return evaluated_direction(batch[i].direction, batch[i].kind(), score);
  };
  std::size_t done = before;
  const auto listener = [&](std::size_t i, const DirectionScore& score) {
    tools_.clock.report(sweep_stage::k_scoring, static_cast<double>(++done) / static_cast<double>(total));
    if (tools_.listener.evaluated) tools_.listener.evaluated(evaluated(i, score));
  };
  // The first directions are scored even when the time is over already: there is a best one to show.
  const bool is_first = result_.evaluated.empty();
  const auto scores = tools_.pools.engine().score(
      tasks, [&] { return is_first ? tools_.clock.cancelled() : tools_.clock.stopped(); }, listener);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!scores[i]) continue;
    result_.evaluated.push_back(evaluated(i, *scores[i]));
    const RankedFigures figures = tools_.rating.scored(batch[i], *scores[i]);
    limit_.add(batch[i].direction, scores[i]->pessimistic());
    contenders_.push_back({std::move(batch[i]), *scores[i], figures, {}});
  }
}

std::vector<std::size_t> DirectionSearch::contender_order() const {
  std::vector<RankedFigures> figures;
  for (const Contender& contender : contenders_) figures.push_back(contender.figures);
  return tools_.rating.rank(figures).order;
}

double DirectionSearch::listing_limit() const {
  // With another objective a direction of much undercut may still be listed.
  return tools_.rating.by_undercut_alone() ? limit_.undercut() : k_no_limit;
}

void DirectionSearch::note(const EvaluatedDirection& evaluated) {
  result_.evaluated.push_back(evaluated);
  if (tools_.listener.evaluated) tools_.listener.evaluated(evaluated);
}

void DirectionSearch::refine() {
  std::vector<Contender> found = refine_basins(descent(), contenders_, contender_order(),
                                               static_cast<std::size_t>(tools_.settings.refine));
  for (Contender& contender : found) {
    limit_.add(contender.candidate.direction, contender.score.pessimistic());
    contenders_.push_back(std::move(contender));
  }
}

void DirectionSearch::keep_contenders() {
  const double limit = listing_limit();
  const std::size_t before = contenders_.size();
  std::vector<std::size_t> possible;
  for (const std::size_t i : contender_order()) {
    if (contenders_[i].candidate.from_user() || contenders_[i].score.optimistic() <= limit)
      possible.push_back(i);
  }
  const ListingRules rules{.most = k_contenders_per_listed * tools_.top(),
                           .apart_deg = tools_.settings.apart_deg,
                           .tentative = true};
  contenders_ = contenders_to_list(tools_.rating, contenders_, possible, rules);
  result_.skipped = before - contenders_.size();
}

void DirectionSearch::measure_contenders() {
  std::vector<Contender> open = std::exchange(contenders_, {});
  reset_limit();
  for (std::size_t first = 0; first < open.size();) {
    tools_.clock.report(sweep_stage::k_measuring,
                        static_cast<double>(first) / static_cast<double>(open.size()));
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
    measure_batch(batch, [this] { return tools_.clock.stopped(); });
  }
  if (named_.empty()) measure_first();
}

void DirectionSearch::measure_all() {
  std::vector<Contender> open = std::exchange(contenders_, {});
  std::ranges::stable_sort(open, {}, [](const Contender& c) { return c.figures.undercut; });
  tools_.clock.report(sweep_stage::k_measuring, 0.0);
  measure_batch(open, [this] { return tools_.clock.stopped(); });
  measure_first();
}

/// Even when the time is over the best direction so far gets its figures.
void DirectionSearch::measure_first() {
  if (!contenders_.empty() && !contenders_.front().measured && !tools_.clock.cancelled()) {
    std::vector<Contender> scored = std::exchange(contenders_, {});
    measure_batch({scored.data(), 1}, [this] { return tools_.clock.cancelled(); });
  }
}

/// Beside a better one that is measured.
bool DirectionSearch::surely_hidden(const Contender& contender) const {
  return tools_.rating.by_undercut_alone() && std::ranges::any_of(contenders_, [&](const Contender& other) {
           return other.measured && contender.score.optimistic() > other.figures.undercut &&
                  line_angle_deg(contender.candidate.direction, other.candidate.direction) <=
                      tools_.settings.apart_deg;
         });
}

/// Puts what may still be listed among the contenders, measured if there was time.
void DirectionSearch::measure_batch(std::span<Contender> batch, const std::function<bool()>& stop) {
  const double limit = listing_limit();
  std::vector<ScoringTask> tasks;
  for (const Contender& contender : batch)
    tasks.push_back({contender.candidate.direction, is_named(contender.candidate) ? k_no_limit : limit});
  auto measured = tools_.measurer.measure(tasks, {}, tools_.clock.until_cancelled(), stop);
  const bool stopped = stop();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    Contender& contender = batch[i];
    if (measured[i]) {
      contender.figures = tools_.rating.measured(contender.candidate, *measured[i]);
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
std::vector<std::size_t> DirectionSearch::contenders_to_polish() const {
  const bool by_molds = tools_.settings.rank == SweepRank::mold;
  const std::size_t most =
      std::min(by_molds ? std::size_t{1} : k_most_polished, static_cast<std::size_t>(tools_.settings.refine));
  std::vector<std::size_t> chosen;
  double limit = k_no_limit;
  for (const std::size_t i : contender_order()) {
    if (chosen.size() == most) break;
    const Contender& contender = contenders_[i];
    if (!contender.measured || contender.figures.value > limit) continue;
    if (by_molds && !may_gain(contender)) continue;
    const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return line_angle_deg(contenders_[other].candidate.direction, contender.candidate.direction) >
             tools_.settings.apart_deg;
    });
    if (!apart) continue;
    if (chosen.empty())
      limit = contender.figures.value +
              tools_.rating.value_of_undercut(k_polished_share * tools_.model.geometry.total_area);
    chosen.push_back(i);
  }
  return chosen;
}

/// Less undercut than all that the shape names, by more than it is worth to leave that.
bool DirectionSearch::may_gain(const Contender& found) const {
  const double worth = 0.01 * tools_.settings.worth_pct * tools_.model.geometry.total_area;
  return std::ranges::none_of(named_, [&](const Contender& each) {
    return each.measured && each.figures.undercut <= found.figures.undercut + worth;
  });
}

Descent DirectionSearch::descent() {
  return {.model = tools_.model,
          .rating = tools_.rating,
          .rays = tools_.pools.rays(),
          .measurer = tools_.measurer,
          .clock = tools_.clock,
          .evaluated = [this](const EvaluatedDirection& evaluated) { note(evaluated); }};
}

void DirectionSearch::polish_best() {
  const Descent descent = this->descent();
  const std::vector<std::size_t> chosen = contenders_to_polish();
  for (std::size_t k = 0; k < chosen.size() && !tools_.clock.stopped(); ++k) {
    tools_.clock.report(sweep_stage::k_polishing,
                        static_cast<double>(k) / static_cast<double>(chosen.size()));
    Contender& start = contenders_[chosen[k]];
    std::optional<Contender> better = polish(descent, start);
    if (!better) continue;
    // A direction with other sources stands beside the one that it was found from.
    if (better->candidate.kind() == start.candidate.kind()) {
      start = std::move(*better);
    } else {
      contenders_.push_back(std::move(*better));
    }
  }
}

void DirectionSearch::reset_limit() {
  limit_ = ListingLimit(tools_.wanted(), tools_.settings.apart_deg);
  for (const Contender& each : named_) {
    if (each.measured)
      limit_.add(each.candidate.direction, each.figures.undercut + each.figures.undercut_uncertainty);
  }
}

}  // namespace moldlight
