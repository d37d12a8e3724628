// moldlight mold: the parting line of one direction, and the two mold halves.
#include <algorithm>
#include <iterator>
#include <memory>

#include <nlohmann/json.hpp>

#include "classify/headless.hpp"
#include "classify/option_json.hpp"
#include "cli/baseline.hpp"
#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "io/png.hpp"
#include "parting/line_files.hpp"
#include "parting/mold_picture.hpp"
#include "study/study_reports.hpp"

namespace moldlight::cli {

namespace {

struct MoldFlags {
  PartFlags part;
  Query query;
  bool best_direction = false;
  MoldSettings settings;
  std::vector<std::string> lines;
  std::string folder;
  bool as_3mf = false, with_actions = false;
  std::string image;
  StillSettings still;
  BaselineFlags baseline;
  ReportFlags report;
};

int run(const MoldFlags& flags, Console& console, const Progress& progress) {
  Query query = flags.query;
  validate(query.method);
  std::vector<NamedPath> files = {{"--json", flags.part.json_file()}};
  for (const std::string& path : flags.lines) {
    check_line_extension(path);
    files.push_back({"--lines", path});
  }
  files.push_back({"--image", flags.image});
  std::ranges::copy(flags.report.files(), std::back_inserter(files));
  check_outputs({.inputs = {{"PART", flags.part.part}, {"--baseline", flags.baseline.file}},
                 .files = files,
                 .folder = {"--out", flags.folder}});
  Baseline baseline(flags.baseline, "mold");
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  validate(query.method, model->frame.diagonal);
  std::optional<BestDirection> best;
  if (flags.best_direction) {
    best = found_direction(model, query.method, console, progress);
    query.direction = best->direction;
  }
  for (const std::string& warning : model->warnings) console.warning(warning);
  Questions questions;
  questions.query = query;
  questions.best = best;
  questions.with_actions = flags.with_actions;
  questions.mold = flags.settings;
  Study study(model, questions);
  const auto& [assignment, line] = study.find<MoldLine>(progress);
  for (const std::string& warning : assignment.warnings) console.warning(warning);
  progress.report("writing", 0.0);
  for (const std::string& path : flags.lines) write_lines(path, lines_to_write(*model, assignment, line));
  const std::string refusal = mold_refusal(study, progress);
  if (!flags.folder.empty() && refusal.empty()) {
    MoldHalves halves = study.find<MoldHalves>(progress);
    write_mold(flags.folder, flags.as_3mf, model->part.unit, halves.written);
    study.keep(std::make_shared<const MoldHalves>(std::move(halves)));  // with the files' names
  }
  std::unique_ptr<gl::Context> context;
  if (!flags.image.empty() || flags.report.any()) context = create_context(query.method.backend);
  if (!flags.image.empty()) {
    const MoldScene scene{*model, assignment, line, study.find<MoldHalves>(progress)};
    write_png(flags.image, mold_picture(*context, scene, flags.still, progress));
  }
  if (flags.report.any()) {
    const auto for_report = report_context(flags.report, *context, model, flags.still.look.palette, progress);
    write_reports(flags.report, report::mold_report(for_report, study));
  }
  const auto json_report = [&] { return mold_json(study, progress); };
  baseline.compare(json_report);
  baseline.put_report(console, flags.part.json, json_report, [&] {
    return to_text(report::mold_report({model, progress}, study), {.colour = console.colour()});
  });
  if (flags.folder.empty() || refusal.empty()) return baseline.exit_code(console);
  console.failure(refusal);
  return k_criterion_failed;
}

nlohmann::ordered_json settings(const MoldFlags& flags) {
  nlohmann::ordered_json json = query_json(flags.query, flags.best_direction);
  json.update(options_json(reading_options(), flags.part.reading));
  json.update(options_json(mold_options(), flags.settings));
  json["actions"] = flags.with_actions;
  return json;
}

}  // namespace

void add_mold_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "mold",
      "Find the parting line of a direction: where the mold's halves meet, and what closes its holes");
  const auto flags = std::make_shared<MoldFlags>();
  add_part_flags(*command, flags->part, request);
  add_direction_flag(*command, {flags->query.direction, flags->best_direction}, "required")->required();
  add_option_flags(*command, mold_options(), flags->settings);
  command
      ->add_option("--lines", flags->lines,
                   "Write the parting line; may be given several times. DXF and STEP for CAD, SVG seen along "
                   "the direction in millimetres")
      ->option_text("FILE.(" + extensions_text(line_formats()) + ")")
      ->check(named())
      ->allow_extra_args(false);
  CLI::Option* folder = add_file_flag(*command, flags->folder,
                                      {"-o,--out", "DIR",
                                       "Write the halves to this folder: core.stl, cavity.stl, and with "
                                       "--fill-undercut insert_1.stl and so on"});
  command->add_flag("--3mf", flags->as_3mf, "Write all of them to mold.3mf in that folder, too")
      ->needs(folder);
  command->add_flag("--actions", flags->with_actions,
                    "Find the side actions, and list which inserts they move instead of leaving them loose");
  add_baseline_flags(*command, flags->baseline, "mold");
  add_report_flags(*command, flags->report, request);
  CLI::Option* image = add_file_flag(
      *command, flags->image,
      {"--image", "FILE.png",
       "Draw the part with its parting line and the opened halves, and write the picture to this file"});
  add_size_flag(*command, flags->still.size, "Width and height of the picture in pixels")->needs(image);
  for (const std::string_view key : {"view", "theme"})
    add_option_flag(*command, option_named(still_options(), key), flags->still)->needs(image);
  add_option_flag(*command, option_named(look_options(), "palette"), flags->still.look);
  add_method_flags(*command, flags->query.method);
  set_work(*command, request, flags, run, settings);
}

}  // namespace moldlight::cli
