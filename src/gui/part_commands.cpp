#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "classify/still_picture.hpp"
#include "gui/app.hpp"
#include "gui/jobs/batch_table.hpp"
#include "gui/jobs/study_finder.hpp"
#include "gui/store/files.hpp"
#include "gui/view/mold_view.hpp"
#include "gui/view/side_actions.hpp"
#include "mold/round_wall.hpp"
#include "parting/line_files.hpp"
#include "report/describe/describe.hpp"
#include "study/study.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

/// The part with its present questions, and with the answers that are there.
Study known_study(const AppState& state) {
  Study study = measured_study(state);
  Questions questions = study.questions();
  questions.with_actions = is_settled(state.actions);
  if (state.sweep.result) questions.sweep = state.sweep.result->settings;
  study.ask(questions);
  if (questions.with_actions) study.keep(state.actions.plan);
  if (state.sweep.result) study.keep(state.sweep.result);
  if (!is_settled(state.mold)) return study;
  study.keep<moldlight::MoldLine>(state.mold.line);
  study.keep(state.mold.solids->plain);
  if (questions.with_actions && state.mold.solids->pieces) study.keep(state.mold.solids->pieces);
  return study;
}

}  // namespace

std::string DraftChoices::finish() const {
  if (kind == "texture") return fmt::format("texture {} mm", real_text(texture_mm));
  return kind == "draft" ? fmt::format("draft {}", real_text(draft_deg)) : kind;
}

void Commands::open_part(const std::string& path) { app.open(path); }

void Commands::open_batch_part(std::size_t row) {
  BatchPart part = batch_part(*app.state_.batch, row);
  // How parts are looked at is not the batch's.
  part.notes.settings.look = app.state_.settings.look;
  app.load(part.path, part.reading, std::move(part.notes));
}

void Commands::cancel_loading() {
  app.loader_.give_up();
  app.state_.loading.reset();
}

void Commands::undo() { app.state_.settings = app.history_.undo(); }

void Commands::redo() { app.state_.settings = app.history_.redo(); }

void Commands::fit_view() {
  // In a flight: where that one goes, else the part would be left half turned.
  look_from(app.flight_.flying() ? app.fitted_->orientation : app.state_.camera.orientation);
}

void Commands::stop_opening() {
  if (app.opening_.moving(app.now_s_)) app.state_.settings.look.open_mold = app.opening_.at(app.now_s_);
}

void Commands::look_from(const glm::dquat& orientation) {
  app.fitted_points_.clear();
  app.turn_camera(orientation);
}

void Commands::look_along_direction() {
  look_from(looking_along(-app.state_.settings.direction.unit(), app.state_.camera.up()));
}

void Commands::look_at_undercuts() {
  const auto& split = app.state_.figures.split;
  if (!split) return;
  const PartModel& model = *app.state_.model;
  const glm::dvec3& direction = app.state_.settings.direction.unit();
  if (app.state_.figures.undercuts.value_or(UndercutTotals{}).count > 0)
    return look_from(revealing_orientation(model, std::span(&split, 1), direction));
  look_at_speck();
}

void Commands::look_at_speck() {
  const auto& split = app.state_.figures.split;
  const auto& plan = app.state_.actions.plan;
  if (!split || !plan || plan->specks.empty()) return;
  const PartModel& model = *app.state_.model;
  constexpr double k_reach = 0.1;  // unit frame
  const Speck& speck = plan->specks.front();
  const FigureStyle style(model);
  say(fmt::format("The largest tiny undercut: {}, {}", style.with_unit(FigureKind::area, speck.area),
                  speck_text(speck.reason)),
      false);
  app.fitted_points_ = points_around(model.frame.to_unit(speck.place), k_reach);
  app.turn_camera(revealing_orientation(model, std::span(&split, 1), app.state_.settings.direction.unit()));
}

void Commands::look_at_subject(Subject subject) {
  using Of = Subject::Of;
  const auto& plan = app.state_.actions.plan;
  if (subject.of == Of::undercuts) return look_at_undercuts();
  if (subject.of == Of::tiny) return look_at_speck();
  if (subject.of == Of::unreleased) {
    const auto undercut = plan ? least_released(*plan) : std::nullopt;
    if (undercut) look_at_undercut(*undercut);
    app.state_.action_choices.chosen = undercut;
    return;
  }
  SplitMesh lit = surface_of(subject, *app.state_.model, app.state_.figures.split.get(), plan.get()).mesh;
  if (lit.pieces.empty()) return;
  const FacetIndex first = lit.pieces.front().facet;
  std::vector<glm::vec3> around;
  if (subject.of != Of::region) around = surroundings(*app.state_.model, std::span(&first, 1));
  app.look_at(std::move(lit), std::move(around));
}

void Commands::look_at_undercut(std::size_t undercut) {
  const auto& split = app.state_.figures.split;
  const auto& plan = app.state_.actions.plan;
  if (!split || !plan || undercut >= plan->undercuts.size()) return;
  const Undercut& found = plan->undercuts[undercut].undercut;
  SplitMesh alone{.vertices = split->vertices, .pieces = {}};
  for (const std::uint32_t piece : found.pieces) alone.pieces.push_back(split->pieces[piece]);
  app.look_at(std::move(alone), surroundings(app.state_, undercut));
}

void Commands::look_at_body(std::size_t body) {
  const auto& whole = app.state_.bodies.whole;
  if (!whole || body >= whole->model->part.bodies.size()) return;
  if (app.state_.reading.body != "all") {
    ReadOptions reading = app.state_.reading;
    reading.body = std::to_string(body + 1);
    return app.load(app.state_.path, reading, {});
  }
  const Body& found = whole->model->part.bodies[body];
  app.fitted_points_.clear();
  for (FacetIndex k = 0; k < found.facet_count; ++k)
    for (const VertexIndex corner : whole->geometry->facets[found.first_facet + k])
      app.fitted_points_.push_back(whole->geometry->vertices[corner].position);
  app.turn_camera(app.state_.camera.orientation);
}

void Commands::isolate_body(std::size_t body) {
  std::set<std::size_t>& hidden = app.state_.hidden_bodies;
  hidden.clear();
  for (std::size_t k = 0; k < app.state_.bodies.whole->model->part.bodies.size(); ++k)
    if (k != body) hidden.insert(k);
  app.scene_->hide(hidden);
  look_at_body(body);
}

void Commands::toggle_projection() {
  Projection& projection = app.state_.camera.projection;
  projection = projection == Projection::orthographic ? Projection::perspective : Projection::orthographic;
}

void Commands::take_normal() {
  if (app.state_.hover) app.set_direction(app.state_.model->geometry.normals[app.state_.hover->point.facet]);
}

void Commands::take_axis() {
  if (!app.state_.hover) return;
  const PartModel& model = *app.state_.model;
  const auto wall = round_wall(model.geometry, model.adjacency, app.state_.hover->point.facet);
  if (!wall) {
    say("There is no round wall under the cursor; point at a cylinder, a cone or a hole", false);
    return;
  }
  // Of its two senses the one that leaves the core where it is.
  app.set_direction(glm::dot(wall->axis, app.state_.settings.direction.unit()) < 0.0 ? -wall->axis
                                                                                     : wall->axis);
}

void Commands::fly_to_direction(const glm::dvec3& direction) {
  app.state_.hints_done.insert(Hint::verdict);
  if (app.state_.window.motion) {
    app.turn_.start(app.state_.settings.direction.unit(), direction, app.now_s_);
  } else {
    app.state_.settings.direction = direction;
    app.history_.settle(app.state_.settings);
  }
}

void Commands::choose_face(const std::optional<FacetIndex>& facet) {
  const auto face = facet ? std::optional(app.state_.faces->of_facet[*facet]) : std::nullopt;
  auto& chosen = app.state_.face;
  chosen = face ? std::optional(ChosenFace{*face, {}}) : std::nullopt;
  app.mark_faces();
  app.measure_face();
  if (facet && app.state_.bodies.whole && app.state_.reading.body == "all")
    app.state_.body = body_of(app.state_.model->part, *facet);
}

void Commands::take_picture() {
  if (!app.state_.model) return;
  const bool asks = app.saved_to_.empty();
  const fs::path folder = asks ? pictures_folder() : fs::path(app.saved_to_);
  const std::string path = free_name(folder, fs::path(app.state_.path).stem().string());
  if (asks) {
    app.state_.dialogs.picture = path;
  } else {
    save_picture(path);
  }
}

void Commands::save_picture(const std::string& path) {
  app.picture_request_ = path;
  app.picture_wait_ = 2;  // this frame shows the dialog that asks for it
}

void Commands::export_files(const OutputPaths& files, const std::string& picture) {
  const Figures& figures = app.state_.figures;
  if (app.export_.running() || !figures.shown || figures.measuring) return;
  std::string names;
  for (const std::string* path :
       {&files.json, &files.facets, &files.faces, &files.mesh, &files.split_folder, &files.borders}) {
    if (path->empty()) continue;
    app.saved_to_ = fs::path(*path).parent_path().string();
    names += (names.empty() ? " " : ", ") + fs::path(*path).filename().string();
  }
  app.export_dialog_ = &Dialogs::exporting;
  app.export_.start(
      [files, palette = app.state_.settings.look.palette, model = app.state_.model, result = *figures.shown,
       said = "Exported" + (names.empty() ? names : names + " to " + app.saved_to_)](const Progress&) {
        write_outputs(files, *model, result, palette);
        return said;
      });
  if (!picture.empty()) save_picture(picture);
}

void Commands::start_sweep() {
  app.state_.hints_done.insert(Hint::sweep);
  app.state_.sweep_choices.compared.reset();
  app.sweep_.start(app.state_, app.state_.sweep, app.now_s_);
}

void Commands::cancel_sweep() { app.sweep_.cancel(); }

void Commands::save_notes_beside(bool beside) {
  app.state_.notes_beside = beside;
  app.saved_notes_ = {};
  if (!beside) {
    std::error_code ignored;
    fs::remove(notes_path_beside(app.state_.path), ignored);
  }
  app.save();
}

void Commands::reset_layout() { app.layout_.reset(); }

void Commands::dismiss_toasts() { app.state_.toasts.clear(); }

void Commands::say(const std::string& text, bool failure) { app.say(text, failure); }

void Commands::quit() { app.quitting_ = true; }

void Commands::look_at_loop(std::size_t loop) {
  const auto& line = app.state_.mold.line;
  if (!line || loop >= line->loops.size()) return;
  app.fitted_points_ = surroundings(*line, loop);
  app.turn_camera(app.state_.camera.orientation);
}

void Commands::look_at_wall(std::size_t wall) {
  const auto& line = app.state_.mold.line;
  const auto& split = app.state_.figures.split;
  if (!line || !line->draft || !split || wall >= line->draft->walls.size()) return;
  const std::uint32_t face = line->draft->walls[wall].face;
  choose_face(app.state_.faces->facets(face).front());
  // As if it alone were what is looked for.
  SplitMesh alone{.vertices = split->vertices, .pieces = {}};
  for (const SplitPiece& piece : split->pieces) {
    if (app.state_.faces->of_facet[piece.facet] != face) continue;
    alone.pieces.push_back(piece);
    alone.pieces.back().region = Region::undercut;
  }
  app.look_at(std::move(alone), surroundings(*app.state_.model, app.state_.faces->facets(face)));
}

void Commands::look_at_finish(const std::string& finish) {
  const auto& line = app.state_.mold.line;
  if (line && line->draft) {
    const auto& walls = line->draft->walls;
    const auto worst = std::ranges::find(walls, finish, &WallDraft::finish);
    if (worst != walls.end()) return look_at_wall(static_cast<std::size_t>(worst - walls.begin()));
  }
  app.fitted_points_.clear();
  for (const FaceFinish& one : app.state_.settings.required_draft.finishes) {
    if (one.finish.name != finish) continue;
    const auto points = surroundings(*app.state_.model, app.state_.faces->facets(one.face));
    app.fitted_points_.insert(app.fitted_points_.end(), points.begin(), points.end());
  }
  app.turn_camera(app.state_.camera.orientation);
}

void Commands::give_finish(FacetIndex facet) {
  RequiredDraft& draft = app.state_.settings.required_draft;
  const std::uint32_t face = app.state_.faces->of_facet[facet];
  auto given = parse_finish(app.state_.draft_choices.finish(), draft.texture_rule);
  const Finish* const present = finish_of(draft.finishes, face);
  if (given && present != nullptr && *present == *given) given.reset();
  set_finish(draft.finishes, face, std::move(given));
  app.history_.settle(app.state_.settings);
}

void Commands::load_finishes(const std::string& path) {
  RequiredDraft& draft = app.state_.settings.required_draft;
  const bool read =
      app.attempt([&] { draft.finishes = read_finishes(path, *app.state_.model, draft.texture_rule, {}); });
  if (!read) {
    app.state_.dialogs.finishes = false;  // another path may do
    return;
  }
  app.history_.settle(app.state_.settings);
  say(fmt::format("{} took the finishes of {}", plural(draft.finishes.size(), "face"), path), false);
}

void Commands::save_finishes(const std::string& path) {
  if (app.attempt([&] { write_finishes(path, app.state_.settings.required_draft.finishes); }))
    say("Saved to " + path, false);
  else
    app.state_.dialogs.finishes = true;
}

void Commands::move_face(FacetIndex facet) {
  if (!app.state_.mold.line) return;
  const std::uint32_t face = app.state_.faces->of_facet[facet];
  const FaceHalves halves = halves_of_face(app.state_, face);
  if (halves.core + halves.cavity <= 0.0) {
    const bool one = halves.action <= std::max(halves.fixed_core, halves.fixed_cavity);
    return say(one ? fmt::format("Only the {} can form this face",
                                 halves.fixed_core > halves.fixed_cavity ? "core" : "cavity")
                   : "Neither half can form this face",
               false);
  }
  std::string& cosmetic = app.state_.settings.mold.cosmetic;
  cosmetic = cosmetic_with(cosmetic, face, halves.core < halves.cavity);
  app.history_.settle(app.state_.settings);
}

void Commands::move_hovered_face() {
  if (app.state_.hover) move_face(app.state_.hover->point.facet);
}

void Commands::export_report(const report::ReportOrder& order) {
  const AppState& state = app.state_;
  if (app.export_.running() || !state.figures.split || state.figures.measuring) return;
  app.export_dialog_ = nullptr;
  app.export_.start([order, study = known_study(state), palette = state.settings.look.palette,
                     make_context = app.options_.make_context](const Progress& progress) mutable {
    const auto gl = make_context(study.questions().query.method.backend);
    return write_report(order,
                        {.model = study.shared_model(),
                         .progress = progress,
                         .gl = gl.get(),
                         .palette = palette,
                         .version = MOLDLIGHT_VERSION},
                        study);
  });
}

void Commands::cancel_export() { app.export_.cancel(); }

void Commands::export_mold(const MoldPaths& paths) {
  const MoldState& mold = app.state_.mold;
  if (app.export_.running() || !is_settled(mold)) return;
  Study study = known_study(app.state_);
  app.export_dialog_ = &Dialogs::exporting_mold;
  app.export_.start([=, line = mold.line, solids = mold.solids](const Progress& progress) mutable {
    for (const std::string& path : paths.lines) {
      fs::create_directories(fs::path(path).parent_path());
      write_lines(path, lines_to_write(study.model(), line->assignment, line->line));
    }
    WrittenMold written = solids->halves().written;
    if (!paths.folder.empty()) write_mold(paths.folder, paths.solids, study.model().part.unit, written);
    if (!paths.json.empty()) {
      keep_written(study, written, progress);  // with the files' names
      write_text(paths.json, mold_json(study, progress).dump(2) + "\n");
    }
    std::vector<std::string> names = paths.lines;
    if (!paths.json.empty()) names.push_back(paths.json);
    for (const WrittenBody& body : written.bodies)
      if (!body.file.empty()) names.push_back(body.file);
    return fmt::format("Exported {} of the mold to {}", plural(names.size(), "file"),
                       names.empty() ? "" : fs::path(names.front()).parent_path().string());
  });
}

}  // namespace moldlight::gui
