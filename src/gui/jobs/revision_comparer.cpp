#include "gui/jobs/revision_comparer.hpp"

#include <utility>

#include "mesh/length_unit.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::gui {

void RevisionComparer::start(const std::string& path, RevisionState& revisions) {
  leave(revisions);
  revisions.path = path;
  revisions.awaited = true;
  file_watch_.watch(path);
}

void RevisionComparer::leave(RevisionState& revisions) {
  end_jobs();
  asked_ = {};
  file_watch_.watch({});
  revisions = {};
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
  if (!as_read) as_read = load_part(wanted.file.path, wanted.file.options, progress);
  CompareSettings settings;
  settings.align = wanted.align;
  PreparedRevision prepared{.as_read = as_read,
                            .comparison = prepare_comparison(wanted.a, as_read, settings, progress),
                            .part = {}};
  prepared.part = pictured_part(wanted.file.path, wanted.file.options, prepared.comparison.b.model, progress);
  return prepared;
}

RevisionComparer::Compared RevisionComparer::compare(const Comparing& wanted, const Query& asked,
                                                     std::optional<Best> best, const Progress& progress) {
  Comparison comparison = wanted.prepared->comparison;
  const std::shared_ptr<const PartModel>&a = comparison.a.model, &b = comparison.b.model;
  comparison.settings = wanted.settings;
  require_within_part("Same within", wanted.settings.same_within, a->frame.diagonal);
  ComparedQuery query{asked.direction, asked.direction, asked.method};
  query.method.tolerance = lateral_tolerance(asked.method, a->frame.diagonal);
  query.method.couple_kernel = false;
  if (wanted.settings.each_best) {
    if (!best || best->b != b || best->method != query.method)
      best = Best{b, query.method, best_direction(b, query.method, progress).direction};
    progress.report("comparing", 0.0);  // a sweep that is cancelled has a result
    query.b = best->direction;
  }
  compare_parts(comparison, query, progress);
  return {std::make_shared<const Revisions>(std::move(comparison)), best};
}

std::string RevisionComparer::update_prepared(const Preparing& wanted, RevisionState& revisions,
                                              bool moving) {
  if (asked_.preparing != wanted && !moving) {
    const bool same_file = asked_.prepared && asked_.prepared->file == wanted.file;
    asked_.preparing = wanted;
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
    asked_.prepared = asked_.preparing;
  }
  return {};
}

std::string RevisionComparer::update_result(const Comparing& wanted, const Query& query,
                                            RevisionState& revisions, bool may_start) {
  if (asked_.comparing && asked_.comparing != wanted) {
    compare_job_.give_up();
    asked_.comparing.reset();
    revisions.given_up = false;
    revisions.error.clear();
  }
  if (!asked_.comparing && may_start && asked_.compared != wanted) {
    asked_.comparing = wanted;
    compare_job_.start([wanted, query, best = asked_.best](const Progress& progress) {
      return compare(wanted, query, best, progress);
    });
  }
  auto outcome = compare_job_.take();
  if (!outcome) return {};
  if (!outcome->error.empty()) return failed(outcome->error, revisions);
  if (outcome->result) {
    revisions.result = outcome->result->result;
    asked_.best = outcome->result->best;
    asked_.compared = asked_.comparing;
  }
  return {};
}

std::string RevisionComparer::update(const AppState& state, RevisionState& revisions, bool moving) {
  if (!revisions.on() || !state.model) return {};
  const Preparing preparing{.a = state.model,
                            .file = {revisions.path, state.reading, version_},
                            .align = state.settings.revision.align};
  if (std::string why = update_prepared(preparing, revisions, moving); !why.empty()) return why;
  const bool prepared = revisions.prepared && asked_.prepared == preparing;
  Comparing wanted{.prepared = revisions.prepared,
                   .query = exact_query(*state.model, state.settings),
                   .settings = state.settings.revision};
  wanted.settings.actions = state.settings.actions;
  // The part's own figures come first.
  const bool rests = !moving && !state.figures.measuring;
  if (prepared) {
    std::string why = update_result(wanted, state.settings, revisions, rests);
    if (!why.empty()) return why;
  }
  revisions.stale = !prepared || asked_.compared != wanted;
  revisions.awaited = revisions.stale && !revisions.given_up && revisions.error.empty();
  revisions.running.reset();
  if (compare_job_.running()) revisions.running = compare_job_.status();
  if (prepare_job_.running()) revisions.running = prepare_job_.status();
  return {};
}

}  // namespace moldlight::gui
