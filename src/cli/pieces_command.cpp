// moldlight pieces: molds of more than two pieces.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "io/csv_tables.hpp"
#include "io/mesh_writer.hpp"
#include "parting/line_files.hpp"
#include "pieces/pieces_report.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

namespace {

struct PiecesFlags {
  PartFlags part;
  MethodSettings method;
  PiecesSettings settings;
  LookSettings look;
  std::string directions_file, mesh;
  std::vector<std::string> lines;
};

int run(const PiecesFlags& flags, Console& console, const Progress& progress) {
  validate(flags.method);
  std::vector<NamedPath> written = {{"--json", flags.part.json_file()},
                                    {"--mesh", flags.mesh},
                                    {"--mesh (its colours)", material_library_path(flags.mesh)}};
  for (const std::string& path : flags.lines) written.push_back({"--lines", path});
  check_outputs(
      {.inputs = {{"PART", flags.part.part}, {"--directions", flags.directions_file}}, .files = written});
  PiecesSettings settings = flags.settings;
  if (!flags.directions_file.empty()) settings.proposed = read_directions(flags.directions_file, progress);
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  for (const std::string& warning : model->warnings) console.warning(warning);
  Study study(model, {.query = {{}, flags.method}, .pieces = std::move(settings)});
  const PiecesResult& result = study.find<PiecesResult>(progress);
  progress.report("writing", 0.0);
  if (!flags.mesh.empty()) write_pieces_mesh(flags.mesh, *model, result, flags.look.palette);
  for (const std::string& path : flags.lines) write_seams(path, *model, result);
  put_report(
      console, flags.part.json, [&] { return pieces_json(*model, result); },
      [&] {
        return to_text(report::pieces_report({model, progress}, result), {.colour = console.colour()});
      });
  return 0;
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
  add_option_flag(*command, option_named(look_options(), "palette"), flags->look);
  command
      ->add_option(
          "--lines", flags->lines,
          "Write the seams between the pieces: DXF or STEP for CAD, SVG in millimetres as seen along "
          "the first direction. May be given several times")
      ->option_text("FILE.(" + extensions_text(line_formats()) + ")")
      ->check(named_as(extensions_text(line_formats())))
      ->allow_extra_args(false);
  set_work(*command, request, flags, run);
}

const RegisteredCommand k_pieces_command({45, "pieces", add_pieces_command});

}  // namespace

}  // namespace moldlight::cli
