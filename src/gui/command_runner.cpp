#include "gui/command_runner.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "gui/direction.hpp"
#include "gui/store/state_folder.hpp"
#include "mold/round_wall.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

void App::CommandRunner::operator()(const OpenPart& command) const { app.open(command.path); }

void App::CommandRunner::operator()(const CancelLoading&) const {
  app.loader_.give_up();
  app.state_.loading.reset();
}

void App::CommandRunner::operator()(const Undo&) const { app.state_.settings = app.history_.undo(); }

void App::CommandRunner::operator()(const Redo&) const { app.state_.settings = app.history_.redo(); }

void App::CommandRunner::operator()(const FitView&) const {
  if (app.state_.model) app.fit(app.state_.camera, false);
}

void App::CommandRunner::operator()(const LookFrom& command) const {
  if (!app.state_.model) return;
  Camera camera = app.state_.camera;
  camera.orientation = command.orientation;
  app.fit(camera, false);
}

void App::CommandRunner::operator()(const LookAlongDirection&) const {
  if (!app.state_.model) return;
  Camera camera = app.state_.camera;
  camera.orientation = looking_along(-app.state_.settings.method.direction, camera.up());
  app.fit(camera, false);
}

void App::CommandRunner::operator()(const ToggleProjection&) const {
  Camera& camera = app.state_.camera;
  camera.projection =
      camera.projection == Projection::orthographic ? Projection::perspective : Projection::orthographic;
}

void App::CommandRunner::operator()(const TakeNormal&) const {
  if (!app.state_.hover) return;
  app.state_.settings.method.direction =
      tidy(app.state_.model->geometry.normals[app.state_.hover->point.facet]);
  app.history_.settle(app.state_.settings);
}

void App::CommandRunner::operator()(const TakeAxis&) const {
  if (!app.state_.hover) return;
  const PartModel& model = *app.state_.model;
  auto axis = round_wall_axis(model.geometry, model.adjacency, app.state_.hover->point.facet);
  if (!axis) {
    app.say("There is no round wall under the cursor; point at a cylinder, a cone or a hole", false);
    return;
  }
  // Of its two senses the one that leaves the core where it is.
  glm::dvec3& direction = app.state_.settings.method.direction;
  if (glm::dot(*axis, direction) < 0.0) *axis = -*axis;
  direction = tidy(*axis);
  app.history_.settle(app.state_.settings);
}

void App::CommandRunner::operator()(const TakePicture&) const {
  if (!app.state_.model) return;
  const fs::path part(app.state_.path);
  // A name of its own for each picture: none is ever overwritten.
  for (int number = 1; number < 10000; ++number) {
    const fs::path path = part.parent_path() / fmt::format("{}-{:02}.png", part.stem().string(), number);
    std::error_code ignored;
    if (fs::exists(path, ignored)) continue;
    app.picture_request_ = path.string();
    return;
  }
}

void App::CommandRunner::operator()(const SaveNotesBeside& command) const {
  app.state_.notes_beside = command.beside;
  app.saved_notes_ = {};
  if (!command.beside) {
    std::error_code ignored;
    fs::remove(notes_path_beside(app.state_.path), ignored);
  }
  app.save();
}

void App::CommandRunner::operator()(const ResetLayout&) const { app.layout_.reset(); }

void App::CommandRunner::operator()(const DismissToasts&) const { app.state_.toasts.clear(); }

void App::CommandRunner::operator()(const Say& command) const { app.say(command.text, command.failure); }

void App::CommandRunner::operator()(const Export& command) const {
  const Figures& figures = app.state_.figures;
  if (app.export_.running() || !figures.shown || figures.measuring) return;
  app.export_.start([files = command.files, palette = app.state_.settings.look.palette,
                     model = app.state_.model, result = *figures.shown](const Progress&) {
    write_outputs(files, *model, result, palette);
    return std::string("Exported");
  });
  if (!command.picture.empty()) app.picture_request_ = command.picture;
}

void App::CommandRunner::operator()(const StartSweep&) const {
  app.state_.sweep_choices.compared.reset();
  app.pictures_.reset();
  app.sweep_.start(app.state_, app.state_.sweep, app.now_s_);
}

void App::CommandRunner::operator()(const CancelSweep&) const { app.sweep_.cancel(); }

void App::CommandRunner::operator()(const ChooseFace& command) const {
  app.choose_face(command.facet ? face_of(*app.state_.model, *command.facet) : std::nullopt);
}

void App::CommandRunner::operator()(const Quit&) const { app.quitting_ = true; }

void App::CommandRunner::operator()(const FlyToDirection& command) const {
  glm::dvec3& direction = app.state_.settings.method.direction;
  if (app.state_.window.motion) {
    app.turn_.start(direction, command.direction, app.now_s_);
  } else {
    direction = command.direction;
    app.history_.settle(app.state_.settings);
  }
}

}  // namespace moldlight::gui
