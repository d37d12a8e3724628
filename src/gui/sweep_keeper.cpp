#include "gui/sweep_keeper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.hpp"
#include "session/sweep/sweep_stages.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_never = std::numeric_limits<double>::infinity();
/// Between two frames of a running sweep: often enough to look alive, seldom enough to leave it the cores.
constexpr double k_frame_s = 0.05;
/// Directions put on the map in one frame, so that the window stays quick.
constexpr std::size_t k_most_a_frame = 300;
constexpr double k_least_told_s = 0.5, k_least_told_share = 0.04;

/// Stages of a sweep and the share of its time that each usually takes.
struct Stage {
  std::string_view name;
  double share;
};
constexpr std::array<Stage, 5> k_stages = {{{sweep_stage::k_candidates, 0.02},
                                            {sweep_stage::k_scoring, 0.3},
                                            {sweep_stage::k_refining, 0.2},
                                            {sweep_stage::k_closer, 0.13},
                                            {sweep_stage::k_final, 0.35}}};

double share_done(const JobStatus& status) {
  double before = 0.0;
  for (const Stage& stage : k_stages) {
    if (stage.name == status.stage) return before + stage.share * std::clamp(status.fraction, 0.0, 1.0);
    before += stage.share;
  }
  return 0.0;
}

}  // namespace

void SweepKeeper::start(const AppState& state, SweepState& sweep, double now_s) {
  drop();
  sweep = {};
  if (!state.model) return;
  SweepSettings settings = state.sweep_choices.options;
  settings.method = method_ = state.settings.method;
  model_ = state.model;
  scored_ = 0;
  started_s_ = scoring_s_ = now_s;
  sweep.map.emplace(even_set_reach_deg(settings.directions));
  sweep.running.emplace();
  job_ = std::make_unique<SweepJob>(model_, std::move(settings), make_context_, wake_);
}

void SweepKeeper::cancel() {
  if (job_) job_->cancel();
}

void SweepKeeper::drop() {
  pictured_.reset();
  waiting_.clear();
  put_ = 0;
  if (!job_) return;
  // Waiting for its thread here would freeze the window.
  job_->cancel();
  given_up_.push_back(std::move(job_));
}

void SweepKeeper::update(const AppState& state, SweepState& sweep, double now_s) {
  wake_s_ = k_never;
  given_up_.remove_if([](const auto& job) { return job->done(); });
  if (model_ != state.model) {
    drop();
    model_ = state.model;
    sweep = {};
  }
  if (job_) {
    const bool done = job_->done();  // asked first, so that no direction is left behind
    std::vector<EvaluatedDirection> more = job_->take_evaluated();
    scored_ += more.size();
    waiting_.insert(waiting_.end(), more.begin(), more.end());
    tell_progress(sweep, now_s);
    if (done) finish(sweep);
    wake_s_ = now_s + k_frame_s;
  }
  take_directions(sweep);
  if (put_ < waiting_.size()) wake_s_ = now_s;
  if (sweep.map) {
    // The direction is what is searched for.
    MethodSettings method = state.settings.method;
    method.direction = method_.direction;
    sweep.stale = !(method == method_);
  }
}

void SweepKeeper::take_directions(SweepState& sweep) {
  if (!sweep.map) return;
  const std::size_t end = std::min(waiting_.size(), put_ + k_most_a_frame);
  for (; put_ < end; ++put_) sweep.map->add(waiting_[put_]);
  if (put_ < waiting_.size()) return;
  waiting_.clear();
  put_ = 0;
}

void SweepKeeper::tell_progress(SweepState& sweep, double now_s) {
  const JobStatus status = job_->status();
  SweepProgress& progress = *sweep.running;
  progress.stage = status.stage;
  progress.share = std::max(progress.share, share_done(status));
  progress.ending = job_->cancelled();
  if (scored_ == 0) scoring_s_ = now_s;
  if (status.stage == sweep_stage::k_scoring) {
    progress.scored = scored_;
    if (status.fraction > 0.0) {
      progress.all = std::max(
          scored_, static_cast<std::size_t>(std::lround(static_cast<double>(scored_) / status.fraction)));
    }
    if (now_s > scoring_s_) progress.per_second = static_cast<double>(scored_) / (now_s - scoring_s_);
  } else {
    progress.scored = std::max(progress.scored, scored_);
  }
  const double elapsed_s = now_s - started_s_;
  progress.left_s.reset();
  if (elapsed_s > k_least_told_s && progress.share > k_least_told_share) {
    progress.left_s = elapsed_s * (1.0 - progress.share) / progress.share;
  }
}

void SweepKeeper::finish(SweepState& sweep) {
  const std::unique_ptr<SweepJob> job = std::move(job_);
  sweep.running.reset();
  try {
    sweep.result = std::make_shared<const SweepResult>(job->take());
    pictured_ = sweep.result;
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    sweep.error = error.what();
  }
}

}  // namespace moldlight::gui
