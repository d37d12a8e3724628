// moldlight mold: the parting line of one direction, and the two mold halves.
#include <memory>

#include <nlohmann/json.hpp>

#include "classify/headless.hpp"
#include "classify/json.hpp"
#include "classify/option_json.hpp"
#include "cli/report_flags.hpp"
#include "cli/step_output.hpp"
#include "io/png.hpp"
#include "mesh/length_unit.hpp"
#include "parting/line_files.hpp"
#include "parting/mold_picture.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

namespace {

struct MoldFlags : StudyFlags {
  MoldSettings settings;
  std::vector<std::string> lines;
  std::string folder;
  MoldFileSettings solids;
  bool with_actions = false;
};

/// The part with each face named by what forms it, and the parting line.
StepContent step_content(const PartModel& model, const Assignment& assignment, const PartingLine& line,
                         Palette palette) {
  StepContent content{.split = assignment.mesh, .groups = {}, .of_piece = {}};
  for (const MoldSide side : k_mold_sides)
    content.groups.push_back({std::string(side_name(side)), region_colour(region_of(side), palette)});
  for (const MoldSide side : assignment.sides) content.of_piece.push_back(static_cast<std::uint32_t>(side));
  const double mm = mm_per_unit(model.part.unit);
  for (const PartingLoop& loop : line.loops) {
    StepLine wire{fmt::format("parting line {}, {}", content.lines.size() + 1, loop_name(loop.kind)), {}};
    for (const glm::dvec3& point : loop.points)
      wire.points.push_back({mm * point.x, mm * point.y, mm * point.z});
    wire.points.push_back(wire.points.front());
    content.lines.push_back(std::move(wire));
  }
  return content;
}

int run(const MoldFlags& flags, Console& console, const Progress& progress) {
  validate(flags.query.method);
  std::vector<NamedPath> lines;
  for (const std::string& path : flags.lines) lines.push_back({"--lines", path});
  check_outputs(flags, lines, {"--out", flags.folder});
  Baseline baseline(flags.baseline, flags.command, flags.part.part);
  // Before long work, which would be for nothing where there is none.
  const auto context = flags.drawn() ? create_context(flags.query.method.backend) : nullptr;
  Study study =
      asked_study(flags, {.with_actions = flags.with_actions, .mold = flags.settings}, console, progress);
  const PartModel& model = study.model();
  for (const std::string& warning : model.warnings) console.warning(warning);
  const auto& [assignment, line] = study.find<MoldLine>(progress);
  for (const std::string& warning : assignment.warnings) console.warning(warning);
  progress.report("writing", 0.0);
  for (const std::string& path : flags.lines) write_lines(path, lines_to_write(model, assignment, line));
  Json step;
  if (!flags.step.empty()) {
    StepContent content = step_content(model, assignment, line, flags.still.look.palette);
    if (const MoldHalves& halves = mold_halves(study, progress); halves.made())
      content.surfaces = parting_surfaces(model, halves);
    step = write_step(flags, study, std::move(content), console, progress);
  }
  const std::string refusal = mold_refusal(study, progress);
  if (!flags.folder.empty() && refusal.empty()) {
    WrittenMold written = mold_halves(study, progress).written;
    write_mold(flags.folder, flags.solids, model.part.unit, written);
    keep_written(study, std::move(written), progress);
  }
  if (!flags.image.empty()) {
    const MoldScene scene{model, assignment, line, mold_halves(study, progress)};
    write_png(flags.image, mold_picture(*context, scene, flags.still, progress));
  }
  const int code = put_report(flags, study, {mold_json, report::mold_report, {}, std::move(step)},
                              context.get(), baseline, console, progress);
  if (flags.folder.empty() || refusal.empty()) return code;
  console.failure(refusal);
  return k_criterion_failed;
}

Json settings(const MoldFlags& flags) {
  Json json = study_settings(flags);
  json.update(options_json(mold_options(), flags.settings));
  json["actions"] = flags.with_actions;
  return json;
}

void add_mold_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "mold", "Find the parting line and shut-offs of a direction, and make the mold halves");
  const auto flags = std::make_shared<MoldFlags>();
  add_study_flags(*command, *flags, request);
  add_option_flags(*command, mold_options(), flags->settings);
  command
      ->add_option("--lines", flags->lines,
                   "Write the parting line: DXF or STEP for CAD, SVG in millimetres as seen along the "
                   "direction. May be given several times")
      ->option_text("FILE.(" + extensions_text(line_formats()) + ")")
      ->check(named_as(extensions_text(line_formats())))
      ->allow_extra_args(false);
  add_step_flag(
      *command, *flags,
      "Write the part of a STEP file as STEP: its exact faces, split at the parting line, each with "
      "the name, colour and layer of what forms it, the line as wires, and the parting surface");
  CLI::Option* folder = add_file_flag(
      *command, flags->folder,
      {"-o,--out", "DIR",
       "Write the bodies to this folder: core.stl, cavity.stl, with --actions slide_1.stl, lifter_1.stl and "
       "so on, and with --actions or --fill-undercut insert_1.stl and so on"});
  add_mold_file_flags(*command, flags->solids, folder);
  command->add_flag("--actions", flags->with_actions,
                    "Find the side actions, make solids of slides and lifters, and list the inserts that "
                    "move with other actions");
  CLI::Option* image = add_study_outputs(
      *command, *flags, request, "Write a picture of the part with its parting line and the opened halves");
  for (const std::string_view key : {"view", "theme"})
    add_option_flag(*command, option_named(still_options(), key), flags->still)->needs(image);
  add_option_flag(*command, option_named(look_options(), "palette"), flags->still.look);
  add_option_flags(*command, method_options(), flags->query.method);
  set_work(*command, request, flags, run, settings);
}

const RegisteredCommand k_mold_command({40, "mold", add_mold_command, 4});

}  // namespace

}  // namespace moldlight::cli
