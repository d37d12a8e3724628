#include "gui/jobs/window_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <sys/resource.h>

#include "sweep/direction_figures.hpp"
#include "sweep/sweep.hpp"
#include "sweep/sweep_stages.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_no_wake = std::numeric_limits<double>::infinity();
/// Between two frames of a running sweep: often enough to look alive, seldom enough to leave it the cores.
constexpr double k_between_frames_s = 0.05;
/// Directions put on the map in one frame, so that the window stays quick.
constexpr std::size_t k_most_a_frame = 300;
constexpr double k_least_told_s = 0.5, k_least_told_share = 0.04;
constexpr int k_niceness = 5;

/// The window's own thread goes first. On Linux this is a matter of the calling thread and those it starts.
void stand_back() { static_cast<void>(setpriority(PRIO_PROCESS, 0, k_niceness)); }

/// For every direction: without what was said of single undercuts of one.
ActionSettings general(ActionSettings actions) {
  actions.pins.clear();
  actions.side_directions.clear();
  return actions;
}

}  // namespace

void SweepMap::add(const EvaluatedDirection& direction) {
  evaluated.push_back(direction);
  field.add(direction.direction, direction.undercut);
  worst = std::max(worst, direction.undercut);
}

const EvaluatedDirection* SweepMap::nearest(const glm::dvec3& direction, double reach_deg) const {
  const EvaluatedDirection* found = nullptr;
  double greatest = std::cos(glm::radians(reach_deg));
  for (const EvaluatedDirection& each : evaluated) {
    const double cosine = std::abs(glm::dot(each.direction, direction));
    if (cosine < greatest) continue;
    greatest = cosine;
    found = &each;
  }
  return found;
}

void WindowSweep::start(const AppState& state, SweepState& sweep, double now_s, bool by_itself) {
  give_up(sweep);
  if (!by_itself) sweep = {};
  if (!state.model) return;
  SweepSettings settings = state.sweep_choices.options;
  settings.method = method_ = state.settings.method;
  settings.action_settings = actions_ = general(state.settings.actions);
  if (by_itself) {
    settings.rank = SweepRank::mold;
    settings.prove_pct = settings.all_free_pct = std::nullopt;
  }
  sweep.by_itself = by_itself;
  with_actions_ = seeks_actions(settings);
  model_ = state.model;
  started_s_ = now_s;
  sweep.map.emplace(even_set_reach_deg(settings.directions));
  sweep.running.emplace();
  scored_by_job_ = std::make_shared<Scored>();
  job_.start([model = model_, settings, scored = scored_by_job_, by_itself](const Progress& progress) {
    stand_back();
    SweepListener listener{.evaluated = [&scored](const EvaluatedDirection& direction) {
      const std::lock_guard lock(scored->mutex);
      scored->directions.push_back(direction);
    }};
    if (by_itself) {
      listener.named = [&scored](SweepResult named) {
        const std::lock_guard lock(scored->mutex);
        scored->named = std::make_shared<const SweepResult>(std::move(named));
      };
    }
    return run_sweep(model, settings, progress, listener);
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
  waiting_.clear();
  put_ = 0;
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
    std::vector<EvaluatedDirection> more;
    {
      const std::lock_guard lock(scored_by_job_->mutex);
      more.swap(scored_by_job_->directions);
      if (auto named = std::exchange(scored_by_job_->named, nullptr)) pictured_ = sweep.result = named;
    }
    waiting_.insert(waiting_.end(), more.begin(), more.end());
    tell_progress(status, sweep, now_s);
    sweep.running->ending = ending;
    if (outcome) {
      sweep.running.reset();
      sweep.error = std::move(outcome->error);
      if (outcome->result)
        pictured_ = sweep.result = std::make_shared<const SweepResult>(std::move(*outcome->result));
    }
    wake_s_ = now_s + k_between_frames_s;
  }
  take_directions(sweep);
  if (put_ < waiting_.size()) wake_s_ = now_s;
  if (sweep.map || sweep.result)
    sweep.stale = state.settings.method != method_ || general(state.settings.actions) != actions_;
}

void WindowSweep::take_directions(SweepState& sweep) {
  if (!sweep.map) return;
  const std::size_t end = std::min(waiting_.size(), put_ + k_most_a_frame);
  for (; put_ < end; ++put_) sweep.map->add(waiting_[put_]);
  if (put_ < waiting_.size()) return;
  waiting_.clear();
  put_ = 0;
}

void WindowSweep::tell_progress(const JobStatus& status, SweepState& sweep, double now_s) {
  SweepProgress& progress = *sweep.running;
  progress.stage = status.stage;
  progress.share = std::max(progress.share, sweep_share_done(status.stage, status.fraction, with_actions_));
  const double elapsed_s = now_s - started_s_;
  progress.left_s.reset();
  if (elapsed_s > k_least_told_s && progress.share > k_least_told_share) {
    progress.left_s = elapsed_s * (1.0 - progress.share) / progress.share;
  }
}

}  // namespace moldlight::gui
