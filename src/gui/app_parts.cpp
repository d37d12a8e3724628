// Parts in the window: they are read, come, and take the place of what was there; and what else goes on
// behind.
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "gui/app.hpp"
#include "mesh/length_unit.hpp"

namespace moldlight::gui {

namespace {

/// Of the file as one part; a repair is made of what is chosen.
ReadOptions of_whole(ReadOptions reading) {
  if (reading.repair.level == RepairLevel::none) reading.body = "all";
  return reading;
}

/// Settings that are lengths keep their size when the part's unit becomes another one.
void convert_lengths(MethodSettings& method, std::string_view from, std::string_view to) {
  const auto before = find_length_unit(from), after = find_length_unit(to);
  if (before && after) method.tolerance *= before->mm / after->mm;
}

}  // namespace

void App::open(const std::string& path) {
  const std::string part = absolute_path(path);
  state_.tour.reset();  // who has a part of their own needs no guide
  if (batch::is_batch(part)) return open_batch(part);
  const bool again = state_.model && part == state_.path;
  state_.bodies.whole.reset();  // the file may have changed
  PartNotes notes = again ? PartNotes() : notes_of(part);
  ReadOptions reading = again ? state_.reading : options_.reading;
  if (!again) {
    if (state_.model) reading.body = ReadOptions().body;  // another file has other bodies
    if (reading.unit.empty()) reading.unit = notes.unit;
  }
  load(part, reading, std::move(notes));
}

void App::open_batch(const std::string& path) {
  state_.loading = Loading{.path = path, .status = {"reading the batch", 0.0}, .notes = {}, .batch = true};
  loader_.start(
      [path](const Progress& progress) -> Loaded {
        return std::make_shared<const BatchTable>(load_batch_table(path, progress));
      },
      state_.loading->status);
}

void App::load(const std::string& path, const ReadOptions& reading, PartNotes notes) {
  compared_next_.reset();
  state_.loading =
      Loading{.path = path, .status = {"reading", 0.0}, .notes = std::move(notes), .since_s = now_s_};
  const auto whole = state_.bodies.whole;
  const bool known = whole && whole->path == path && whole->reading == of_whole(reading);
  loader_.start(
      [path, reading, whole = known ? whole : nullptr](const Progress& progress) -> Loaded {
        const auto body = number_from<std::size_t>(reading.body);
        if (whole && reading == whole->reading) return *whole;
        if (whole && body && *body > 0 && *body <= whole->model->part.bodies.size())
          return loaded_body(*whole, *body - 1, progress);
        return load_for_window(path, reading, progress);
      },
      state_.loading->status);
}

PartNotes App::notes_of(const std::string& path) {
  if (notes_to_set_) return *notes_to_set_;
  const std::string file = options_.persistent ? notes_path(path) : std::string();
  if (file.empty()) return {};
  try {
    if (const auto text = read_text(file)) return parse_part_notes(*text, {});
  } catch (const Error& error) {
    say(fmt::format("{}: {}; the part is shown with the usual settings", file, error.what()), true);
  }
  return {};
}

void App::set_notes(const PartNotes& notes) {
  notes_to_set_ = notes;
  state_.settings = notes.settings;
  if (!notes.bookmarks.empty()) state_.bookmarks = notes.bookmarks;
  history_.reset(state_.settings);
}

void App::poll_jobs() {
  if (auto outcome = loader_.take()) {
    const Loading loading = *std::exchange(state_.loading, std::nullopt);
    if (!outcome->error.empty()) {
      compared_next_.reset();
      say(outcome->error, true);
    } else if (!outcome->result) {
      // It was given up.
    } else if (auto* part = std::get_if<LoadedPart>(&*outcome->result)) {
      attempt([&] { install(std::move(*part), loading.notes); });
    } else {
      state_.batch = std::get<std::shared_ptr<const BatchTable>>(*outcome->result);
      state_.dialogs = Dialogs();
      state_.dialogs.batch = true;
      batch_pictures_ = std::make_unique<BatchPictures>(*context_, state_.batch->manifest.folder);
      settle_frames_ = k_settle_frames;
    }
  }
  if (loader_.running()) state_.loading->status = loader_.status();
  if (const auto outcome = export_.take()) {
    const bool failed = !outcome->error.empty();
    say(outcome->result.value_or(failed ? outcome->error : "Nothing was written"), failed);
    if (failed && export_dialog_ != nullptr) state_.dialogs.*export_dialog_ = true;  // another path may do
  }
  state_.exporting = export_.running() ? std::optional(export_.status()) : std::nullopt;
  sweep_.update(state_, state_.sweep, now_s_);
  // Not when a new sweep is asked for: the panels of that frame still show them.
  if (pictures_ && pictures_->result() != state_.sweep.result) pictures_.reset();
  if (auto result = sweep_.take_result()) {
    pictures_ =
        std::make_unique<CandidatePictures>(*context_, scene_->part(), std::move(result), options_.wake);
    settle_frames_ = k_settle_frames;
  }
  if (file_watch_.take() && state_.window.auto_reload && !loading_part()) {
    open(state_.path);
    say("The part's file has changed; reading it again", false);
  }
}

void App::install(LoadedPart part, const PartNotes& notes) {
  const bool again = state_.model && part.path == state_.path;
  const bool other_body = again && part.reading.body != state_.reading.body;
  if (!again) save();
  // Built beside the old one, which stays if the GL has no room for the new one.
  auto scene = std::make_unique<Scene>(*context_, part);
  scene_ = std::move(scene);
  if (again) convert_lengths(state_.settings.method, state_.model->part.unit, part.model->part.unit);
  state_.model = part.model;
  state_.faces = part.faces;
  state_.reading = part.reading;
  state_.extremes = part.geometry->extremes;
  state_.path = part.path;
  state_.features = part.features;
  pictures_.reset();
  state_.sweep_choices.compared.reset();
  turn_.stop();
  state_.hover.reset();
  state_.face.reset();
  state_.measuring.reset();
  state_.mold_choices = {};
  state_.draft_choices = {};
  state_.views.clear();
  state_.hidden_bodies.clear();
  if (part.reading.body == "all") {
    const bool several = part.model->part.bodies.size() > 1;
    state_.bodies.whole = several ? std::make_shared<const LoadedPart>(part) : nullptr;
  } else if (const auto& whole = state_.bodies.whole;
             whole && (whole->path != part.path || whole->reading != of_whole(part.reading))) {
    state_.bodies.whole.reset();
  }
  const auto body = number_from<std::size_t>(part.reading.body);
  state_.body = state_.bodies.whole && body ? std::optional(*body - 1) : std::nullopt;
  state_.revisions.hover.reset();
  file_watch_.watch(part.path);
  quick_sweep_due_ = state_.window.quick_sweep;
  options_.user.remember(part.path);
  state_.recent = options_.user.recent;
  if (other_body) {
    fitted_points_.clear();
    fit_frames_ = 3;
  }
  if (again) return;

  comparer_.leave(state_.revisions);
  state_.revision_choices = {};
  revision_.reset();
  before_revisions_.reset();

  notes_to_set_.reset();
  saved_notes_ = notes;
  noted_unit_ = notes.unit;
  state_.notes_beside = options_.persistent && notes_path(part.path) == notes_path_beside(part.path);
  state_.settings = notes.settings;
  // Of a part that was another one when they were noted.
  std::erase_if(state_.settings.required_draft.finishes, [&](const FaceFinish& one) {
    return one.face >= part.faces->count() || part.faces->facets(one.face).empty();
  });
  state_.bookmarks = notes.bookmarks;
  history_.reset(state_.settings);
  flight_.stop();
  state_.camera = Camera{};
  state_.camera.orientation = standard_orientation(StandardView::isometric);
  fit_frames_ = 3;
  if (const auto other = std::exchange(compared_next_, std::nullopt)) compare_with(*other);
}

}  // namespace moldlight::gui
