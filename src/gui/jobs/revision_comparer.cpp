#include "gui/jobs/revision_comparer.hpp"

#include <utility>

#include "mesh/length_unit.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::gui {

namespace {

/// What exact regions depend on, and nothing else, so that no other setting compares anew.
Query exact_alone(const Query& query, double diagonal) {
  Query kept;
  kept.direction = query.direction;
  kept.method.tau_deg = query.method.tau_deg;
  kept.method.tolerance = lateral_tolerance(query.method, diagonal);
  return kept;
}

}  // namespace

void RevisionComparer::start(const std::string& path, RevisionState& revisions) {
  leave(revisions);
  revisions.path = path;
  revisions.awaited = true;
  file_watch_.watch(path);
}

void RevisionComparer::leave(RevisionState& revisions) {
  end_jobs();
  preparing_.reset();
  prepared_of_.reset();
  comparing_.reset();
  result_of_.reset();
  best_.reset();
  file_watch_.watch({});
  revisions = {};
}

void RevisionComparer::end_jobs() {
  prepare_job_.give_up();
  compare_job_.give_up();
}

bool RevisionComparer::take_changed() {
  if (!file_watch_.take()) return false;
  ++version_;
  return true;
}

void RevisionComparer::cancel(RevisionState& revisions) {
  if (!revisions.result) return leave(revisions);
  end_jobs();
  revisions.given_up = true;
}

std::string RevisionComparer::failed(const std::string& why, RevisionState& revisions) {
  if (!revisions.result) leave(revisions);
  if (revisions.on()) revisions.error = why;
  return why;
}

PreparedRevision RevisionComparer::prepare(const Preparing& wanted, std::shared_ptr<const PartModel> as_read,
                                           const Progress& progress) {
  const Reading& reading = wanted.reading;
  if (!as_read) as_read = load_part(reading.path, reading.options, progress);
  CompareSettings settings;
  settings.align = wanted.align;
  PreparedRevision prepared{.as_read = as_read,
                            .comparison = prepare_comparison(wanted.a, as_read, settings, progress),
                            .part = {}};
  prepared.part = pictured_part(reading.path, reading.options, prepared.comparison.b.model, progress);
  return prepared;
}

RevisionComparer::Compared RevisionComparer::compare(const Comparing& wanted, std::optional<Best> best,
                                                     const Progress& progress) {
  Comparison comparison = wanted.prepared->comparison;
  const std::shared_ptr<const PartModel>&a = comparison.a.model, &b = comparison.b.model;
  comparison.settings = wanted.settings;
  require_within_part("Same within", wanted.settings.same_within, a->frame.diagonal);
  ComparedQuery query{wanted.query.direction, wanted.query.direction, wanted.query.method};
  if (wanted.settings.each_best) {
    if (!best || best->b != b || best->method != query.method)
      best = Best{b, query.method, best_direction(b, query.method, progress).direction};
    progress.report("comparing", 0.0);  // a sweep that is cancelled has a result
    query.fresh = best->direction;
  }
  compare_parts(comparison, query, progress);
  return {std::make_shared<const Revisions>(std::move(comparison)), best};
}

std::string RevisionComparer::update_prepared(const Preparing& wanted, RevisionState& revisions,
                                              bool moving) {
  if (preparing_ != wanted && !moving) {
    const bool same_file = prepared_of_ && prepared_of_->reading == wanted.reading;
    preparing_ = wanted;
    revisions.given_up = false;
    revisions.error.clear();
    prepare_job_.start([wanted, as_read = same_file ? revisions.prepared->as_read : nullptr](
                           const Progress& progress) { return prepare(wanted, as_read, progress); },
                       {"reading", 0.0});
  }
  auto outcome = prepare_job_.take();
  if (!outcome) return {};
  if (!outcome->error.empty()) return failed(outcome->error, revisions);
  if (outcome->result) {
    revisions.prepared = std::make_shared<const PreparedRevision>(std::move(*outcome->result));
    prepared_of_ = preparing_;
  }
  return {};
}

std::string RevisionComparer::update_result(const Comparing& wanted, RevisionState& revisions,
                                            bool may_start) {
  if (comparing_ && comparing_ != wanted) {
    compare_job_.give_up();
    comparing_.reset();
    revisions.given_up = false;
    revisions.error.clear();
  }
  if (!comparing_ && may_start && result_of_ != wanted) {
    comparing_ = wanted;
    compare_job_.start(
        [wanted, best = best_](const Progress& progress) { return compare(wanted, best, progress); });
  }
  if (auto outcome = compare_job_.take()) {
    if (!outcome->error.empty()) return failed(outcome->error, revisions);
    if (outcome->result) {
      revisions.result = outcome->result->result;
      best_ = outcome->result->best;
      result_of_ = comparing_;
    }
  }
  return {};
}

RevisionComparer::Comparing RevisionComparer::wanted_comparison(const AppState& state) {
  Comparing wanted{.prepared = state.revisions.prepared,
                   .query = exact_alone(state.settings, state.model->frame.diagonal),
                   .settings = state.settings.revision};
  wanted.settings.actions = state.settings.actions;
  return wanted;
}

std::string RevisionComparer::update(const AppState& state, RevisionState& revisions, bool moving) {
  if (!revisions.on() || !state.model) return {};
  const Preparing preparing{.a = state.model,
                            .reading = {revisions.path, state.reading, version_},
                            .align = state.settings.revision.align};
  if (std::string why = update_prepared(preparing, revisions, moving); !why.empty()) return why;
  const bool prepared = revisions.prepared && prepared_of_ == preparing;
  const Comparing wanted = wanted_comparison(state);
  if (prepared) {
    // The part's own figures come first.
    const bool rests = !moving && !state.figures.measuring;
    if (std::string why = update_result(wanted, revisions, rests); !why.empty()) return why;
  }
  revisions.stale = !prepared || result_of_ != wanted;
  revisions.awaited = revisions.stale && !revisions.given_up && revisions.error.empty();
  revisions.running.reset();
  if (compare_job_.running()) revisions.running = compare_job_.status();
  if (prepare_job_.running()) revisions.running = prepare_job_.status();
  return {};
}

}  // namespace moldlight::gui
