#include "gui/jobs/window_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <sys/resource.h>

#include "study/study.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep_clock.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_no_wake = std::numeric_limits<double>::infinity();
/// Between two frames of a running sweep: often enough to look alive, seldom enough to leave it the cores.
constexpr double k_between_frames_s = 0.05;
/// Directions put on the map in one frame, so that the window stays quick.
constexpr std::size_t k_most_a_frame = 300;
constexpr double k_least_known_s = 0.5, k_least_known_share = 0.04;
constexpr int k_niceness = 5;

/// For every direction: without what was said of single undercuts of one.
ActionSettings general(ActionSettings actions) {
  actions.pins.clear();
  actions.side_directions.clear();
  return actions;
}

}  // namespace

void WindowSweep::start(const AppState& state, SweepState& sweep, double now_s, bool by_itself) {
  give_up(sweep);
  if (!by_itself) sweep = {};
  if (!state.model) return;
  settings_ = state.sweep_choices.options;
  settings_.method = state.settings.method;
  settings_.action_settings = general(state.settings.actions);
  if (by_itself) {
    settings_.rank = SweepRank::mold;
    settings_.prove_pct = settings_.all_free_pct = std::nullopt;
  }
  sweep.by_itself = by_itself;
  model_ = state.model;
  started_s_ = now_s;
  sweep.map.emplace(even_set_reach_deg(settings_.directions));
  sweep.running.emplace();
  job_.start(
      [model = model_, settings = settings_, scored = scored_by_job_, by_itself](const Progress& progress) {
        // The window's own thread goes first: on Linux this is a matter of the calling thread and those it
        // starts.
        static_cast<void>(setpriority(PRIO_PROCESS, 0, k_niceness));
        Questions questions{.sweep = settings};
        questions.sweep_shows.evaluated = [&scored](const EvaluatedDirection& direction) {
          const std::lock_guard lock(scored->mutex);
          scored->directions.push_back(direction);
        };
        if (by_itself) {
          questions.sweep_shows.named = [&scored](SweepResult named) {
            const std::lock_guard lock(scored->mutex);
            scored->named = std::make_shared<const SweepResult>(std::move(named));
          };
        }
        Study study(model, std::move(questions));
        study.find<SweepResult>(progress);
        return study.known<SweepResult>();
      });
}

void WindowSweep::give_up(SweepState& sweep) {
  drop();
  sweep.running.reset();
  sweep.map.reset();
  sweep.error.clear();
}

void WindowSweep::drop() {
  pictured_.reset();
  scored_by_job_ = std::make_shared<Scored>();
  job_.give_up();
}

void WindowSweep::update(const AppState& state, SweepState& sweep, double now_s) {
  wake_s_ = k_no_wake;
  if (model_ != state.model) {
    drop();
    model_ = state.model;
    sweep = {};
  }
  const bool runs = job_.running(), ending = job_.cancelled();
  const JobStatus status = job_.status();
  auto outcome = job_.take();  // before its last directions, so that none is left behind
  if (runs) {
    note_progress(status, sweep, now_s);
    sweep.running->ending = ending;
    if (outcome) {
      sweep.running.reset();
      sweep.error = std::move(outcome->error);
      if (outcome->result) pictured_ = sweep.result = std::move(*outcome->result);
    }
    wake_s_ = now_s + k_between_frames_s;
  }
  if (take_scored(sweep)) wake_s_ = now_s;
  if (sweep.map || sweep.result)
    sweep.stale = state.settings.method != settings_.method ||
                  general(state.settings.actions) != settings_.action_settings;
}

bool WindowSweep::take_scored(SweepState& sweep) {
  std::vector<EvaluatedDirection> some;
  std::unique_lock lock(scored_by_job_->mutex);
  // The result of a sweep that has ended knows more.
  if (auto named = std::exchange(scored_by_job_->named, nullptr); named && (sweep.running || !sweep.result))
    pictured_ = sweep.result = named;
  auto& directions = scored_by_job_->directions;
  for (; sweep.map && some.size() < k_most_a_frame && !directions.empty(); directions.pop_front())
    some.push_back(std::move(directions.front()));
  const bool more = sweep.map && !directions.empty();
  lock.unlock();
  for (const EvaluatedDirection& direction : some) sweep.map->add(direction);
  return more;
}

void WindowSweep::note_progress(const JobStatus& status, SweepState& sweep, double now_s) {
  SweepProgress& progress = *sweep.running;
  progress.stage = status.stage;
  progress.share =
      std::max(progress.share, sweep_share_done(status.stage, status.fraction, seeks_actions(settings_)));
  const double elapsed_s = now_s - started_s_;
  progress.left_s.reset();
  if (elapsed_s > k_least_known_s && progress.share > k_least_known_share)
    progress.left_s = elapsed_s * (1.0 - progress.share) / progress.share;
}

}  // namespace moldlight::gui
