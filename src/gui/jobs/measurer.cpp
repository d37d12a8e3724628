#include "gui/jobs/measurer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "classify/classifier.hpp"
#include "classify/picture_maps.hpp"
#include "study/study.hpp"

namespace moldlight::gui {

constexpr double k_rest_s = 0.15;  // without a change, after which a hand that holds something still rests
constexpr double k_pale_s = 0.3;   // after which figures of other settings are shown as such
/// By which shadow maps are compared with exact regions: a look-up of some milliseconds without a graphics
/// card.
constexpr std::size_t k_map_samples = 20'000;

/// Context and classifier for readouts that need them, kept from one request to the next. Lives on the job's
/// thread only.
class Measurer::Worker {
 public:
  explicit Worker(MakeContext make_context) : make_context_(std::move(make_context)) {}

  Outcome measure(const Request& request, const Progress& progress) {
    Study study(request.model, {.query = request.query});
    if (request.query.method.readout != Readout::exact)
      study.keep(std::make_shared<const Classification>(
          classifier(request).classify(request.query, progress, request.with_split)));
    if (!request.with_split)
      return {.request = request, .classification = study.find<Classification>(progress)};
    Outcome outcome{.request = request, .classification = study.find<SplitRegions>(progress).result};
    outcome.undercuts = study.find<UndercutTotals>(progress);
    outcome.samples = std::make_shared<const PieceSamples>(
        sample_pieces(*outcome.classification.split, request.model->frame, k_map_samples));
    return outcome;
  }

 private:
  Classifier& classifier(const Request& request) {
    if (!context_ || backend_ != request.query.method.backend) {
      classifier_.reset();
      context_.reset();
      context_ = make_context_(request.query.method.backend);
      backend_ = request.query.method.backend;
    }
    context_->make_current();
    if (!classifier_ || &classifier_->model() != request.model.get()) {
      classifier_.reset();
      classifier_.emplace(*context_, request.model);
    }
    return *classifier_;
  }

  const MakeContext make_context_;
  Backend backend_ = Backend::automatic;
  std::unique_ptr<gl::Context> context_;
  std::optional<Classifier> classifier_;
};

Measurer::Measurer(MakeContext make_context, std::function<void()> wake)
    : worker_(new Worker(std::move(make_context))),
      job_({.wake = std::move(wake), .pause_s = figure_pause_s, .at_end = [worker = worker_] {
              delete worker;
            }}) {}

void Measurer::update(const AppState& state, Figures& figures, double now_s, bool moving) {
  wake_s_ = std::numeric_limits<double>::infinity();
  if (wanted_.model != state.model) {
    job_.give_up();
    requested_.reset();
    figures = {.revision = figures.revision};
  }
  if (wanted_.model != state.model || wanted_.query != state.settings) {
    wanted_ = {.model = state.model, .query = state.settings, .with_split = false};
    changed_s_ = now_s;
    figures.error.clear();
  }
  if (!state.model) return;

  if (auto outcome = job_.take()) {
    figures.error = std::move(outcome->error);
    figures.shown.reset();
    ++figures.revision;
    if (outcome->result) take(std::move(*outcome->result), figures);
    fresh_s_ = now_s;
  }
  if (split_of_ != exact_query(*state.model, wanted_.query)) {
    figures.split.reset();
    figures.samples.reset();
  }
  const bool still = now_s >= changed_s_ + k_rest_s;
  if (!still) wake_s_ = changed_s_ + k_rest_s;
  wanted_.with_split = !figures.split && (still || !moving);
  if (wanted_.query.method.readout == Readout::exact || (still && !moving)) {
    if (!requested_ || !requested_->covers(wanted_)) {
      requested_ = wanted_;
      job_.follow([worker = worker_, request = wanted_](const Progress& progress) {
        return worker->measure(request, progress);
      });
    }
  } else if (requested_) {
    job_.give_up();
    requested_.reset();
  }
  figures.stale = figures.error.empty() && !(figures.shown && figures.shown->answers(wanted_.query));
  figures.measuring = figures.error.empty() && (figures.stale || !figures.split);
  if (!figures.stale) fresh_s_ = now_s;
  figures.pale = figures.stale && now_s >= fresh_s_ + k_pale_s;
  if (figures.stale && !figures.pale) wake_s_ = std::min(wake_s_, fresh_s_ + k_pale_s);
}

void Measurer::take(Outcome outcome, Figures& figures) {
  figures.shown = std::move(outcome.classification);
  const ExactQuery inputs = exact_query(*outcome.request.model, outcome.request.query);
  if (figures.shown->split) {
    figures.split = figures.shown->split;
    figures.samples = std::move(outcome.samples);
    figures.undercuts = outcome.undercuts;
    split_of_ = inputs;
  } else if (split_of_ == inputs) {
    figures.shown->split = figures.split;
  } else {
    figures.undercuts.reset();
  }
}

}  // namespace moldlight::gui
