// The commands of the mold: what of it is looked at, which half forms a face, its files.
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "gui/app.hpp"
#include "gui/jobs/study_finder.hpp"
#include "gui/store/files.hpp"
#include "gui/view/mold_view.hpp"
#include "parting/line_files.hpp"
#include "study/study_reports.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

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

void Commands::unfold_mold() { app.layout_.fold_bottom("Mold", app.state_.mold_open); }

void Commands::export_mold(const MoldPaths& paths) {
  const MoldState& mold = app.state_.mold;
  if (app.export_.running() || !is_settled(mold)) return;
  Study study = measured_study(app.state_);
  Questions questions = study.questions();
  questions.with_actions = is_settled(app.state_.actions);
  study.ask(questions);
  if (questions.with_actions) study.keep(app.state_.actions.plan);
  app.export_.start([paths, study, line = mold.line, solids = mold.solids](const Progress& progress) mutable {
    for (const std::string& path : paths.lines) {
      fs::create_directories(fs::path(path).parent_path());
      write_lines(path, lines_to_write(study.model(), line->assignment, line->line));
    }
    WrittenMold written = solids->halves.written;
    if (!paths.folder.empty()) write_mold(paths.folder, paths.as_3mf, study.model().part.unit, written);
    if (!paths.json.empty()) {
      MoldHalves halves = solids->halves;
      halves.written = written;  // with the files' names
      study.keep<moldlight::MoldLine>(line);
      study.keep(std::make_shared<const MoldHalves>(std::move(halves)));
      write_text(paths.json, mold_json(study, progress).dump(2) + "\n");
    }
    std::vector<std::string> names = paths.lines;
    if (!paths.json.empty()) names.push_back(paths.json);
    for (const WrittenBody& body : written.bodies) {
      if (!body.file.empty()) names.push_back(body.file);
    }
    return fmt::format("Exported {} of the mold to {}", plural(names.size(), "file"),
                       names.empty() ? "" : fs::path(names.front()).parent_path().string());
  });
}

}  // namespace moldlight::gui
