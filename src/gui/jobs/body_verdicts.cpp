#include "gui/jobs/body_verdicts.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/stopwatch.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_at_a_time_ms = 200.0;  // then those that are there are shown
constexpr std::size_t k_most_bodies_at_a_time = 64;

}  // namespace

BodyVerdicts::Found BodyVerdicts::found(const LoadedPart& whole, const Questions& questions,
                                        const std::vector<std::size_t>& asked, const Progress& progress) {
  const Stopwatch stopwatch;
  Found found;
  for (const std::size_t body : asked) {
    Verdict& verdict = found.emplace_back(body, Verdict()).second;
    try {
      Study study(body_model(*whole.model, body, progress), questions);
      const ActionPlan& plan = study.find<ActionPlan>(progress);
      verdict = verdict_of(study.model(), study.find<SplitRegions>(progress).result, plan);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {  // of this body alone
      verdict.sentence = error.what();
    }
    if (stopwatch.elapsed_ms() > k_at_a_time_ms) break;
  }
  return found;
}

void BodyVerdicts::update(const AppState& state, BodiesState& bodies, bool wanted) {
  // What is said of single undercuts is of the part that is shown.
  ActionSettings actions = state.settings.actions;
  actions.pins.clear();
  const std::pair<Query, ActionSettings> asked{state.settings, actions};
  if (of_ != bodies.whole || (wanted && asked_ != asked)) {
    job_.give_up();
    of_ = bodies.whole;
    asked_.reset();
    bodies.verdicts.assign(of_ ? of_->model->part.bodies.size() : 0, std::nullopt);
  }
  if (auto outcome = job_.take(); outcome && outcome->result)
    for (auto& [body, verdict] : *outcome->result) bodies.verdicts[body] = std::move(verdict);
  if (!of_ || !wanted || job_.running()) return;
  asked_ = asked;
  std::vector<std::size_t> missing;
  for (std::size_t k = 0; k < bodies.verdicts.size() && missing.size() < k_most_bodies_at_a_time; ++k)
    if (!bodies.verdicts[k]) missing.push_back(k);
  if (missing.empty()) return;
  Questions questions;
  questions.query = state.settings;
  questions.with_actions = true;
  questions.actions = actions;
  job_.start([whole = of_, questions, missing](const Progress& progress) {
    return found(*whole, questions, missing, progress);
  });
}

}  // namespace moldlight::gui
