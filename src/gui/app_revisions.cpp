// Two revisions beside each other in the window: when the other one comes and goes, and what gives way to it.
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "batch/manifest.hpp"
#include "gui/app.hpp"
#include "gui/view/revision_view.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

void App::compare_with(const std::string& path) {
  const std::string other = absolute_path(path);
  if (loading_part()) {
    compared_next_ = other;
  } else if (state_.model) {
    state_.revision_choices = {};
    comparer_.start(other, state_.revisions);
    settle_frames_ = k_settle_frames;
  }
}

void App::take_dropped(const std::vector<std::string>& paths, Edits& edits) {
  const bool one = paths.size() == 1 && state_.model && !batch::is_batch(paths.front());
  std::error_code ignored;
  if (one && !fs::equivalent(paths.front(), state_.path, ignored)) {
    edits.dialogs = edits.dialogs.none();
    edits.dialogs.dropped = paths.front();
    return;
  }
  for (const std::string& path : paths) edits.ask(&Commands::open_part, path);
}

void App::compare_revisions(bool moving) {
  RevisionState& revisions = state_.revisions;
  if (comparer_.take_changed() && state_.window.auto_reload)
    say("The other revision's file has changed; reading it again", false);
  // A direction that is chosen from others takes the place beside the part.
  if (revisions.on() && (state_.sweep_choices.compared || state_.sweep_choices.large_ball) &&
      before_revisions_) {
    before_revisions_->sweep = state_.sweep_choices;
    comparer_.leave(revisions);
  }
  const auto former = revisions.result;
  if (const std::string why = comparer_.update(state_, revisions, moving); !why.empty()) say(why, true);
  if (revisions.result != former) {
    auto& chosen = state_.revision_choices.chosen;
    if (chosen && !(revisions.result && former &&
                    (chosen = nearest_change(*revisions.result, former->changes[*chosen]))))
      chosen.reset();
    if (revisions.result)
      for (const std::string& remark : revisions.result->comparison.remarks)
        if (!former) say(remark, false);
    settle_frames_ = k_settle_frames;
  }
  // In the next frame: this one's panels show the picture that is there.
  if (revisions.prepared != (revision_ ? revision_->of() : nullptr)) settle_frames_ = k_settle_frames;
}

void App::arrange_revisions() {
  const auto& prepared = state_.revisions.prepared;
  if (prepared != (revision_ ? revision_->of() : nullptr)) {
    const bool first = !revision_;
    revision_.reset();
    if (prepared) {
      if (!attempt([&] { revision_ = std::make_unique<RevisionPicture>(*context_, prepared); }))
        comparer_.leave(state_.revisions);
    }
    state_.revisions.hover.reset();
    if (revision_ && first) {
      before_revisions_ = Before{.camera = state_.camera,
                                 .fitted = fitted_.has_value(),
                                 .sweep = state_.sweep_choices,
                                 .undercut = std::exchange(state_.action_choices.chosen, std::nullopt),
                                 .loop = std::exchange(state_.mold_choices.loop, std::nullopt),
                                 .plan = state_.actions.plan,
                                 .line = state_.mold.line};
      state_.sweep_choices.compared.reset();
      state_.sweep_choices.large_ball = false;
      fitted_points_.clear();
    }
    if (first || fitted_) fit_frames_ = 3;
    settle_frames_ = k_settle_frames;
  }
  layout_.keep_sides_folded(revision_ != nullptr);
  if (revision_ || !before_revisions_) return;
  lit_ = {};
  const Before before = *std::exchange(before_revisions_, std::nullopt);
  state_.sweep_choices.compared = before.sweep.compared;
  state_.sweep_choices.large_ball = before.sweep.large_ball;
  // What is chosen is of a plan and a line, which another direction has not.
  if (before.plan == state_.actions.plan) state_.action_choices.chosen = before.undercut;
  if (before.line == state_.mold.line) state_.mold_choices.loop = before.loop;
  flight_.stop();
  fitted_points_.clear();
  state_.camera = before.camera;
  fit_frames_ = before.fitted ? 3 : 0;
}

// What the commands do.

void Commands::compare_with(const std::string& path) { app.compare_with(path); }

void Commands::compare_or_leave() {
  if (app.state_.revisions.on()) return leave_revisions();
  if (!app.state_.model) return;
  app.state_.dialogs.browser = app.state_.dialogs.browser_compares = true;
}

void Commands::leave_revisions() {
  app.comparer_.leave(app.state_.revisions);
  app.state_.revision_choices = {};
}

void Commands::cancel_revisions() {
  app.comparer_.cancel(app.state_.revisions);
  if (!app.state_.revisions.on()) say("The comparison was cancelled", false);
}

void Commands::exchange_revisions() {
  const std::string other = app.state_.revisions.path;
  if (other.empty()) return;
  // The direction that both are looked at along stays.
  app.load(other, app.state_.reading, {app.state_.settings, app.state_.bookmarks, app.noted_unit_});
  app.compared_next_ = app.state_.path;
}

void Commands::look_at_change(std::size_t change) {
  if (!is_lit(app.state_) || change >= app.state_.revisions.result->changes.size()) return;
  const RevisionChange& looked_at = app.state_.revisions.result->changes[change];
  if (looked_at.bounds.min.x > looked_at.bounds.max.x) return;  // it has no surface
  app.fitted_points_ = surroundings(app.state_, looked_at);
  app.turn_camera(seen_from(app.state_, change));
}

}  // namespace moldlight::gui
