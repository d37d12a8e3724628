// moldlight actions: the slides, lifters and other side actions that release the undercuts of one direction.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

#include <nlohmann/json.hpp>

#include "actions/actions_files.hpp"
#include "classify/headless.hpp"
#include "classify/option_json.hpp"
#include "cli/baseline.hpp"
#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_writer.hpp"
#include "io/png.hpp"
#include "study/study_reports.hpp"

namespace moldlight::cli {

namespace {

struct ActionsFlags {
  PartFlags part;
  Query query;
  bool best_direction = false;
  ActionSettings settings;
  std::string csv, mesh, bodies, image;
  StillSettings still;
  BaselineFlags baseline;
  ReportFlags report;
};

int run(const ActionsFlags& flags, Console& console, const Progress& progress) {
  Query query = flags.query;
  validate(query.method);
  if (!flags.mesh.empty()) check_mesh_extension(flags.mesh);
  std::vector<NamedPath> written = {{"--json", flags.part.json_file()},
                                    {"--csv", flags.csv},
                                    {"--mesh", flags.mesh},
                                    {"--mesh (its colours)", material_library_path(flags.mesh)},
                                    {"--image", flags.image}};
  std::ranges::copy(flags.report.files(), std::back_inserter(written));
  check_outputs({.inputs = {{"PART", flags.part.part}, {"--baseline", flags.baseline.file}},
                 .files = written,
                 .folder = {"--bodies", flags.bodies}});
  Baseline baseline(flags.baseline, "actions");
  // Before long work, which would be for nothing where there is none.
  std::unique_ptr<gl::Context> context;
  if (!flags.image.empty() || flags.report.any()) context = create_context(query.method.backend);
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  validate(query.method, model->frame.diagonal);
  std::optional<BestDirection> best;
  if (flags.best_direction) {
    best = found_direction(model, query.method, console, progress);
    query.direction = best->direction;
  }
  Study study(model, {.query = query, .best = best, .with_actions = true, .actions = flags.settings});
  const Classification& result = study.find<SplitRegions>(progress).result;
  for (const std::string& warning : result.warnings) console.warning(warning);
  const ActionsReport found = actions_report(study, progress);
  progress.report("writing", 0.0);
  if (!flags.csv.empty()) write_file(flags.csv, actions_csv(found));
  if (!flags.mesh.empty()) write_action_mesh(flags.mesh, found, flags.still.look.palette);
  if (!flags.bodies.empty())
    write_action_bodies(flags.bodies, std::filesystem::path(model->part.file).stem().string(), found);
  if (!flags.image.empty()) {
    const auto bodies = pulled_bodies(found);
    write_png(flags.image, StillPainter(*context, model).draw(result, flags.still, progress, bodies));
  }
  if (flags.report.any()) {
    const auto for_report = report_context(flags.report, *context, model, flags.still.look.palette, progress);
    write_reports(flags.report, report::actions_report(for_report, study));
  }
  const auto json_report = [&] { return actions_json(study, progress); };
  baseline.compare(json_report);
  baseline.put_report(console, flags.part.json, json_report, [&] {
    return to_text(report::actions_report({model, progress}, study), {.colour = console.colour()});
  });
  return baseline.exit_code(console);
}

nlohmann::ordered_json settings(const ActionsFlags& flags) {
  nlohmann::ordered_json json = query_json(flags.query, flags.best_direction);
  json.update(options_json(reading_options(), flags.part.reading));
  json.update(options_json(action_options(), flags.settings));
  return json;
}

}  // namespace

void add_actions_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "actions", "Find the slides, lifters and other side actions that release the undercuts");
  const auto flags = std::make_shared<ActionsFlags>();
  add_part_flags(*command, flags->part, request);
  add_direction_flag(*command, {flags->query.direction, flags->best_direction}, "required")->required();
  add_option_flags(*command, action_options(), flags->settings);
  add_method_flags(*command, flags->query.method);
  add_file_flag(*command, flags->csv, {"--csv", "FILE.csv", "Write a table of the undercuts"});
  add_file_flag(*command, flags->mesh,
                {"--mesh", "FILE.(" + extensions_text(mesh_formats()) + ")",
                 "Write the split part, each facet in the colour of the action that forms it; in OBJ each "
                 "action is a material"});
  add_file_flag(*command, flags->bodies,
                {"--bodies", "DIR", "Write the closed solid of each action to this folder, an STL each"});
  add_baseline_flags(*command, flags->baseline, "actions");
  add_report_flags(*command, flags->report, request);
  CLI::Option* image =
      add_file_flag(*command, flags->image,
                    {"--image", "FILE.png",
                     "Draw the part with the bodies of its actions, pulled out, and write the picture to "
                     "this file"});
  add_size_flag(*command, flags->still.size, "Width and height of the picture in pixels")->needs(image);
  add_still_flags(*command, flags->still, image);
  set_work(*command, request, flags, run, settings);
}

}  // namespace moldlight::cli
