// moldlight actions: the slides, lifters and other side actions that release the undercuts of one direction.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "actions/actions_files.hpp"
#include "classify/headless.hpp"
#include "classify/json.hpp"
#include "classify/option_json.hpp"
#include "cli/report_flags.hpp"
#include "cli/step_output.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh_writer.hpp"
#include "io/png.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

namespace {

struct ActionsFlags : StudyFlags {
  ActionSettings settings;
  std::string csv, mesh, bodies;
  bool step_bodies = false;
};

int run(const ActionsFlags& flags, Console& console, const Progress& progress) {
  validate(flags.query.method);
  check_outputs(flags,
                {{"--csv", flags.csv},
                 {"--mesh", flags.mesh},
                 {"--mesh (its colours)", material_library_path(flags.mesh)}},
                {"--bodies", flags.bodies});
  Baseline baseline(flags.baseline, flags.command, flags.part.part);
  // Before long work, which would be for nothing where there is none.
  const auto context = flags.drawn() ? create_context(flags.query.method.backend) : nullptr;
  Questions questions;
  questions.with_actions = true;
  questions.actions = flags.settings;
  Study study = asked_study(flags, std::move(questions), console, progress);
  const Classification& result = study.find<SplitRegions>(progress).result;
  for (const std::string& warning : result.warnings) console.warning(warning);
  const ActionsReport found = actions_report(study, progress);
  progress.report("writing", 0.0);
  if (!flags.csv.empty()) write_file(flags.csv, actions_csv(found));
  if (!flags.mesh.empty()) write_action_mesh(flags.mesh, found, flags.still.look.palette);
  std::vector<std::string> bodies(found.plan.actions.size());
  if (!flags.bodies.empty())
    bodies = write_action_bodies(flags.bodies, std::filesystem::path(found.model.part.file).stem().string(),
                                 found, flags.step_bodies);
  Json step;
  if (!flags.step.empty()) {
    ActionGroups groups = action_groups(found, flags.still.look.palette);
    step = write_step(flags, study, {*result.split, std::move(groups.groups), std::move(groups.of_piece)},
                      console, progress);
  }
  if (!flags.image.empty()) {
    const auto pulled = pulled_bodies(found);
    write_png(flags.image,
              StillPainter(*context, study.shared_model()).draw(result, flags.still, progress, pulled));
  }
  const auto add_files = [&](Json& json) {
    for (std::size_t k = 0; k < bodies.size(); ++k)
      if (!bodies[k].empty()) json["actions"][k]["body"]["file"] = bodies[k];
  };
  return put_report(flags, study, {actions_json, report::actions_report, add_files, std::move(step)},
                    context.get(), baseline, console, progress);
}

Json settings(const ActionsFlags& flags) {
  Json json = study_settings(flags);
  json.update(options_json(action_options(), flags.settings));
  return json;
}

void add_actions_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "actions", "Find the slides, lifters and other side actions that release the undercuts");
  const auto flags = std::make_shared<ActionsFlags>();
  add_study_flags(*command, *flags, request);
  add_option_flags(*command, action_options(), flags->settings);
  add_option_flags(*command, method_options(), flags->query.method);
  add_file_flag(*command, flags->csv, {"--csv", "FILE.csv", "Write a table of the undercuts"});
  add_file_flag(
      *command, flags->mesh,
      {"--mesh", "FILE.(" + extensions_text(mesh_formats()) + ")",
       "Write the split part, each facet in the colour of the action that forms it. In OBJ and GLB, each "
       "action is a material. GLB also has the bodies, with the animation of their ways"});
  add_step_flag(
      *command, *flags,
      "Write the part of a STEP file as STEP: its exact faces, split where an action's surface ends, "
      "each with the name, colour and layer of its action or region");
  CLI::Option* folder =
      add_file_flag(*command, flags->bodies,
                    {"--bodies", "DIR", "Write the solid of each action to this folder, one STL each"});
  command
      ->add_flag("--step-bodies", flags->step_bodies,
                 "Write all these solids to PART_actions.step in that folder, too, for CAD: "
                 "solids with plane faces")
      ->needs(folder);
  CLI::Option* image = add_study_outputs(*command, *flags, request,
                                         "Write a picture of the part with its side actions pulled out");
  add_still_flags(*command, flags->still, image);
  set_work(*command, request, flags, run, settings);
}

const RegisteredCommand k_actions_command({30, "actions", add_actions_command, 3});

}  // namespace

}  // namespace moldlight::cli
