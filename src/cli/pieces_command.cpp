// moldlight pieces: molds of more than two pieces.
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "classify/headless.hpp"
#include "classify/option_json.hpp"
#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "io/csv_tables.hpp"
#include "io/mesh_writer.hpp"
#include "io/png.hpp"
#include "parting/line_files.hpp"
#include "pieces/pieces_report.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

namespace {

struct PiecesFlags {
  PartFlags part;
  MethodSettings method;
  PiecesSettings settings;
  MoldSettings mold;
  StillSettings still;
  ReportFlags report;
  std::string directions_file, mesh, folder, image;
  std::vector<std::string> lines;
  MoldFileSettings solids;

  [[nodiscard]] bool drawn() const { return !image.empty() || report.any(); }
};

void write_picture(const PiecesFlags& flags, Study& study, const gl::Context& context,
                   const Progress& progress) {
  const PartModel& model = study.model();
  const PiecesResult& result = study.find<PiecesResult>(progress);
  const auto bodies = pulled_pieces(model, study.find<PieceSolids>(progress), flags.still.look.palette);
  StillSettings still = flags.still;
  still.legend = still.look.arrows = still.look.hatching = false;
  write_png(
      flags.image,
      StillPainter(context, study.shared_model()).draw(formed_part(model, result), still, progress, bodies));
}

int run(const PiecesFlags& flags, Console& console, const Progress& progress) {
  validate(flags.method);
  std::vector<NamedPath> written = {{"--json", flags.part.json_file()},
                                    {"--mesh", flags.mesh},
                                    {"--mesh (its colours)", material_library_path(flags.mesh)}};
  for (const std::string& path : flags.lines) written.push_back({"--lines", path});
  written.push_back({"--image", flags.image});
  std::ranges::copy(flags.report.files(), std::back_inserter(written));
  check_outputs({.inputs = {{"PART", flags.part.part}, {"--directions", flags.directions_file}},
                 .files = written,
                 .folder = {"--out", flags.folder}});
  // Before long work, which would be for nothing where there is none.
  const auto context = flags.drawn() ? create_context(flags.method.backend) : nullptr;
  PiecesSettings settings = flags.settings;
  if (!flags.directions_file.empty()) settings.proposed = read_directions(flags.directions_file, progress);
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  for (const std::string& warning : model->warnings) console.warning(warning);
  Study study(model, {.query = {{}, flags.method}, .mold = flags.mold, .pieces = std::move(settings)});
  const PiecesResult& result = study.find<PiecesResult>(progress);
  progress.report("writing", 0.0);
  if (!flags.mesh.empty()) write_pieces_mesh(flags.mesh, *model, result, flags.still.look.palette);
  for (const std::string& path : flags.lines) write_seams(path, *model, result);
  std::string refusal;
  if (!flags.folder.empty() || flags.drawn())
    refusal = solids_refusal(*model, study.find<PieceSolids>(progress));
  if (!flags.folder.empty() && refusal.empty()) write_pieces(study, flags.folder, flags.solids, progress);
  if (!flags.image.empty()) write_picture(flags, study, *context, progress);
  if (flags.report.any()) {
    const auto for_report = report_context(flags.report, *context, model, flags.still.look.palette, progress);
    write_reports(flags.report, report::pieces_report(for_report, study), console);
  }
  put_report(
      console, flags.part.json, [&] { return pieces_json(study, progress); },
      [&] {
        return to_text(report::pieces_report({model, progress}, study), {.colour = console.colour()});
      });
  if (flags.folder.empty() || refusal.empty()) return 0;
  console.failure(refusal);
  return k_criterion_failed;
}

Json settings(const PiecesFlags& flags) {
  Json json = options_json(pieces_options(), flags.settings);
  json.update(options_json(pieces_method_options(), flags.method));
  json.update(options_json(pieces_solid_options(), flags.mold));
  json.update(options_json(reading_options(), flags.part.reading));
  return json;
}

void add_pieces_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "pieces", "Find the fewest directions of a mold of several pieces, and which piece forms what");
  const auto flags = std::make_shared<PiecesFlags>();
  add_part_flags(*command, flags->part, request);
  add_option_flags(*command, pieces_options(), flags->settings);
  add_file_flag(*command, flags->directions_file,
                {"--directions", "FILE.csv", "Further directions to try from a file, one per line: x, y, z"});
  add_option_flags(*command, pieces_method_options(), flags->method);
  add_file_flag(*command, flags->mesh,
                {"--mesh", "FILE.(" + extensions_text(mesh_formats()) + ")",
                 "Write the split part, each facet in the colour of the piece that forms it. In OBJ and GLB, "
                 "each piece is a material"});
  CLI::Option* folder =
      add_file_flag(*command, flags->folder,
                    {"-o,--out", "DIR",
                     "Write the pieces to this folder as solids: piece_1.stl and so on, by their direction"});
  add_mold_file_flags(*command, flags->solids, folder);
  add_option_flags(*command, pieces_solid_options(), flags->mold);
  add_report_flags(*command, flags->report, request);
  CLI::Option* image =
      add_file_flag(*command, flags->image,
                    {"--image", "FILE.png", "Write a picture of the part between the opened pieces"});
  add_size_flag(*command, flags->still.size, "Width and height of the picture in pixels")->needs(image);
  add_still_flags(*command, flags->still, image);
  command
      ->add_option(
          "--lines", flags->lines,
          "Write the seams between the pieces: DXF or STEP for CAD, SVG in millimetres as seen along "
          "the first direction. May be given several times")
      ->option_text("FILE.(" + extensions_text(line_formats()) + ")")
      ->check(named_as(extensions_text(line_formats())))
      ->allow_extra_args(false);
  set_work(*command, request, flags, run, settings);
}

const RegisteredCommand k_pieces_command({45, "pieces", add_pieces_command, 5});

}  // namespace

}  // namespace moldlight::cli
