// The commands of a comparison with another revision of the part.
#include "gui/app.hpp"
#include "gui/view/revision_view.hpp"

namespace moldlight::gui {

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
  if (!app.state_.revisions.on()) say("The comparison was given up", false);
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
