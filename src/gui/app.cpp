#include "gui/app.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.hpp"
#include "classify/option.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_toast_s = 6.0, k_failure_toast_s = 15.0;

}  // namespace

App::App(const gl::Context& context, AppOptions options)
    : context_(&context),
      tools_(context.functions()),
      options_(std::move(options)),
      history_(EditedSettings{}),
      layout_(options_.user.layout),
      thumbnails_(context, options_.shipped_parts, options_.wake),
      loader_({.wake = options_.wake, .wake_for_progress = true}),
      export_({.wake = options_.wake, .wake_for_progress = true}),
      file_watch_(options_.wake),
      measurer_(options_.make_context, options_.wake),
      study_(options_.wake),
      comparer_(options_.wake),
      body_verdicts_(options_.wake),
      sweep_(options_.wake) {
  if (options_.rehearses) rehearsal_.emplace(context.functions());
  state_.window = begun_with_ = options_.window.value_or(options_.user.window);
  state_.sweep_choices.options = options_.user.sweep;
  state_.recent = options_.user.recent;
  state_.hints_done = options_.user.hints_done;
  state_.shipped = options_.shipped_parts;
  state_.camera.orientation = standard_orientation(StandardView::isometric);
}

App::~App() = default;

void App::say(std::string text, bool failure) {
  const int number = state_.toasts.empty() ? 0 : state_.toasts.back().number + 1;
  state_.toasts.push_back(
      {number, std::move(text), failure, now_s_ + (failure ? k_failure_toast_s : k_toast_s)});
  settle_frames_ = k_settle_frames;
  constexpr std::size_t k_most = 4;
  if (state_.toasts.size() > k_most) state_.toasts.erase(state_.toasts.begin());
}

bool App::attempt(const std::function<void()>& act) {
  try {
    act();
    return true;
  } catch (const Error& error) {
    say(error.what(), true);
    return false;
  }
}

void App::prepare(const FrameInput& input) {
  now_s_ = input.now_s;
  size_ = glm::max(input.size, glm::ivec2(1));
  scale_ = fitting_scale(size_, input.content_scale * static_cast<float>(state_.window.ui_scale));
  imgui_.prepare(state_.window.theme, scale_);
}

void App::frame(const FrameInput& input) {
  // A field that opens takes what is typed from its next frame on; what comes in between is no shortcut.
  const bool typing = ImGui::GetIO().WantTextInput || imgui_.memory().typing_id != 0;
  const KeyPress* const last = input.played.keys.empty() ? nullptr : &input.played.keys.back();
  const ControlKey key = last != nullptr && takes_key(*last, typing) ? control_key(*last) : ControlKey::none;
  const Ui& ui = imgui_.begin_frame(now_s_, key);
  // As the panels of the last frame stand: those of this one are drawn after what goes on in the scene.
  const FreeArea former_area = layout_.free_area(state_.dialogs.panels_hidden);
  layout_.begin_frame(size_, scale_);
  if (picture_wait_ > 0) --picture_wait_;
  poll_jobs();
  arrange_revisions();
  if (flight_.flying()) state_.camera = flight_.at(now_s_);
  if (presentation_) go_on_presenting();
  pick();
  std::erase_if(state_.toasts, [&](const Toast& toast) { return toast.until_s <= now_s_; });
  state_.can_undo = history_.can_undo();
  state_.can_redo = history_.can_redo();

  Edits edits(state_);
  edits.lit.reset();  // until the mouse is found on its line
  take_dropped(input.dropped, edits);
  for (const KeyPress& press : input.played.keys) {
    if (leaves(press) && close_innermost(typing, edits)) continue;
    if (presentation_ && !in_presentation(press)) continue;
    if ((!typing && !takes_key(press, false)) || ends_program(press)) apply_shortcut(press, state_, edits);
  }
  state_.cut =
      scene_ ? scene_->section(state_.settings.look, state_.settings.direction.unit()) : std::nullopt;
  const auto split = split_view();
  SceneFrame scene_frame{.size = size_,
                         .free = former_area.window == size_ ? former_area : layout_.free_area(true),
                         .open_mold = arrows_apart(opened().halves),
                         .line_shown = line_shown()};
  if (split && revision_) {
    scene_frame.second_from = split->left;
    scene_frame.second_shift = picture_shift(*split, size_, split_side());
  }
  if (!presentation_) viewport_.handle_mouse(ui, state_, scene_frame, edits);
  // One a frame, once the picture of the part is final: both would be a long frame.
  candidates_missing_ =
      pictures_ && !state_.dialogs.panels_hidden &&
      (refining_ || pictures_->draw_next(scene_settings().view.settings, candidate_picture_size(scale_)));
  const std::vector<unsigned> shipped = shipped_pictures(ui);
  if (batch_pictures_) batch_pictures_->begin_frame();
  if (body_pictures_) body_pictures_->begin_frame();
  workspace_.draw({ui, state_, edits, layout_},
                  {.maps = [this](int size_px) { return scene_->map_pictures(size_px); },
                   .shipped_parts = shipped,
                   .candidates = pictures_ ? pictures_->textures() : std::vector<unsigned>(),
                   .bodies = [this](std::size_t body) { return body_picture(body); },
                   .batch = [this](const Digest& part) { return batch_pictures_->texture(part); }});
  if (split && revision_) {
    draw_split(ui, *split, revision_->beside(split->size));
    draw_revision_names(ui, state_, *split, split_side());
  } else if (split) {
    draw_split(ui, *split, pictures_->beside(split->size));
  }
  if (!presentation_) {
    viewport_.draw_arrow_names(ui, state_, scene_frame);
    if (state_.toasts.empty()) draw_hints({ui, state_, edits, layout_});
  }
  apply(edits);
  // Maps that are looked at are compared with the split mesh even while one of their sliders moves.
  measurer_.update(state_, state_.figures, now_s_,
                   edits.dragging || turn_.flying() || (ImGui::IsAnyItemActive() && !maps_shown(state_)));
  follow_figures();
  find_actions(edits.dragging || ImGui::IsAnyItemActive());
  find_mold(edits.dragging || ImGui::IsAnyItemActive());
  compare_revisions(edits.dragging || turn_.flying() || ImGui::IsAnyItemActive());
  sweep_by_itself(edits.dragging);
  body_verdicts_.update(state_, state_.bodies, is_at(state_, Step::part) && !measuring() && !edits.dragging);
  study_.find_verdict(state_);
  // What appears after a rest, such as a tooltip, is laid out in the next frame, as what an event changes is.
  const bool woken = now_s_ >= controls_wake_s_;
  controls_wake_s_ = imgui_.wake_s();
  const bool event = input.played.any || !input.dropped.empty();
  settle_frames_ = event || woken ? k_settle_frames : settle_frames_ - 1;
  plan_next_frame();
  if ((batch_pictures_ && batch_pictures_->unfinished()) || (body_pictures_ && body_pictures_->unfinished()))
    next_frame_s_ = now_s_;
}

bool App::takes_key(const KeyPress& press, bool typing) const {
  const ControlKey key = control_key(press);
  if (key == ControlKey::next || key == ControlKey::former) return true;
  if (key == ControlKey::none) return false;
  if (typing) {  // the browser's filter, beside which its list goes by keys
    return (state_.dialogs.browser || state_.dialogs.batch) && key != ControlKey::left &&
           key != ControlKey::right && press.key != ' ';
  }
  const UiMemory& memory = imgui_.memory();
  const Dialogs& dialogs = state_.dialogs;
  const bool asked = dialogs.browser || dialogs.exporting || dialogs.exporting_mold || dialogs.settings ||
                     dialogs.picture || dialogs.finishes || dialogs.dropped || dialogs.film;
  return memory.keyboard.focused() || memory.popups.any() || asked;
}

bool App::close_innermost(bool typing, Edits& edits) {
  if (presentation_) return end_presenting(), true;
  UiMemory& memory = imgui_.memory();
  if (memory.typing_id != 0 || memory.popups.close_one()) return true;
  Dialogs& dialogs = edits.dialogs;
  if (const Dialogs none = dialogs.none(); std::exchange(dialogs, none) != none) return true;
  if (typing || !memory.keyboard.focused()) return typing;
  memory.keyboard.give_to(0);
  return true;
}

void App::apply(const Edits& edits) {
  const Editable former = state_;
  static_cast<Editable&>(state_) = edits;
  if (const ReadOptions wanted = std::exchange(state_.reading, former.reading); wanted != former.reading) {
    if (wanted.unit != former.reading.unit) noted_unit_ = wanted.unit;
    load(state_.path, wanted, {});
  }
  if (!(state_.camera == former.camera)) flight_.stop();
  if (state_.action_choices.chosen != former.action_choices.chosen) action_loop_.start(now_s_);
  if (!(state_.window == former.window)) settle_frames_ = k_settle_frames;
  SweepChoices& choices = state_.sweep_choices;
  // The large ball would cover one of the two pictures.
  if (choices.large_ball && !former.sweep_choices.large_ball) choices.compared.reset();
  if (choices.compared && !former.sweep_choices.compared) choices.large_ball = false;
  if (choices.compared || revision_) state_.divider.reset();
  if (edits.dragging) state_.hints_done.insert(Hint::arrow);
  const bool held = edits.dragging || ImGui::IsAnyItemActive();
  if (edits.give_up_drag && (held || viewport_.dragging())) {
    state_.settings = history_.settled();
    state_.action_choices.wish.reset();
    viewport_.give_up_drag();
    workspace_.give_up_drag();
  } else if (!held && !turn_.flying()) {
    history_.settle(state_.settings);
    save_notes();  // not lost with the window, however that ends
  }
  const bool turning = edits.dragging || turn_.flying();
  turn_direction(held);
  direction_moves_ = turning && state_.settings.direction != former.settings.direction;
  Commands commands{*this};
  // Another step begins with the whole part, where one before has flown to a detail of it.
  if (state_.step != former.step && fitted_ && !fitted_points_.empty()) commands.fit_view();
  for (const auto& command : edits.commands) {
    command(commands);
    settle_frames_ = k_settle_frames;
  }
  if (!state_.model) return;
  if (state_.hidden_bodies != former.hidden_bodies) scene_->hide(state_.hidden_bodies);
  if (!(state_.draft_choices == former.draft_choices) ||
      !(state_.settings.required_draft == former.settings.required_draft))
    mark_faces();
  if (const bool split = split_view().has_value() && !revision_; split != was_split_) {
    was_split_ = split;
    commands.fit_view();
  }
  opening_.aim(wanted_opening(), now_s_, held || !state_.window.motion);
  if (fit_frames_ > 0) {
    --fit_frames_;
    fit(state_.camera, true);
  }
  keep_fitted();
}

void App::sweep_by_itself(bool dragging) {
  SweepState& sweep = state_.sweep;
  const bool outdated = sweep.by_itself && sweep.stale;
  if (outdated || (dragging && sweep.running && sweep.by_itself)) {
    sweep_.give_up(sweep);
    if (outdated) sweep = {};
    quick_sweep_due_ = state_.window.quick_sweep;
  }
  if (!quick_sweep_due_ || dragging || turn_.flying() || measuring()) return;
  quick_sweep_due_ = false;
  if (!state_.figures.shown || sweep.running || (sweep.result && !sweep.by_itself)) return;
  sweep_.start(state_, sweep, now_s_, true);
}

void App::plan_next_frame() {
  next_frame_s_ = std::min(
      {controls_wake_s_, measurer_.wake_s(), sweep_.wake_s(), std::numeric_limits<double>::infinity()});
  for (const Toast& toast : state_.toasts) next_frame_s_ = std::min(next_frame_s_, toast.until_s);
  if (settle_frames_ > 0 || fit_frames_ > 0 || flight_.flying() || turn_.flying() || candidates_missing_ ||
      opening_.moving(now_s_) || (presentation_ && !state_.presented->paused) || glow_.at(now_s_) > 0.0)
    next_frame_s_ = now_s_;
  // The chosen action's body moves out and back; in an opened mold nothing goes on moving.
  const bool loops = chosen_action(state_) != nullptr && open_now() == 0.0 && !shown_pieces(state_);
  if (state_.window.motion && loops && !body_places(state_, 0.0, 0.0, false).empty())
    next_frame_s_ = std::min(next_frame_s_, now_s_ + Loop::k_frame_s);
}

void App::picture_saved(const std::string& path) {
  saved_to_ = std::filesystem::path(path).parent_path().string();
  say(fmt::format("Picture saved as {}", path), false);
}

void App::end_jobs() {
  loader_.cancel();
  export_.cancel();
  sweep_.cancel();
  measurer_.cancel();
  study_.cancel();
  comparer_.end_jobs();
  body_verdicts_.cancel();
}

void App::save() {
  if (!options_.persistent) return;
  attempt([this] {
    for (const Option<WindowSettings>& option : window_options()) {
      const std::string text = option_text(option, state_.window);
      if (text != option_text(option, begun_with_)) set_option(option, options_.user.window, text);
    }
    options_.user.sweep = state_.sweep_choices.options;
    options_.user.hints_done = state_.hints_done;
    options_.user.layout = layout_.text();
    save_user_state(options_.user);
  });
  save_notes();
}

void App::save_notes() {
  if (!options_.persistent || !state_.model) return;
  PartNotes notes{state_.settings, state_.bookmarks, noted_unit_};
  if (is_at(state_, Step::draft)) notes.settings.look.colour_mode = ColourMode::regions;  // the step's own
  if (notes == saved_notes_) return;
  saved_notes_ = std::move(notes);  // also where it fails, which is said once
  const std::string path = state_.notes_beside ? notes_path_beside(state_.path) : notes_path(state_.path);
  if (!path.empty()) attempt([&] { write_text(path, part_notes_json(saved_notes_, state_.path)); });
}

}  // namespace moldlight::gui
