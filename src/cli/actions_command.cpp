// moldlight actions: the slides, lifters and other side actions that release the undercuts of one direction.
#include <memory>

#include "actions/actions_report.hpp"
#include "classify/option_table.hpp"
#include "cli/flags.hpp"
#include "io/atomic_file.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::cli {

namespace {

struct ActionsFlags {
  PartFlags part;
  Query query;
  bool best_direction = false;
  ActionSettings settings;
  std::string csv;
};

int run(const ActionsFlags& flags, Console& console, const Progress& progress) {
  Query query = flags.query;
  validate(query.method);
  check_outputs({.inputs = {{"PART", flags.part.part}},
                 .files = {{"--json", flags.part.json_file()}, {"--csv", flags.csv}}});
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  validate(query.method, model->frame.diagonal);
  if (flags.best_direction) query.direction = best_direction(model, query.method, progress);
  const Classification result = classify_exact(*model, query, progress, true);
  for (const std::string& warning : result.warnings) console.warning(warning);
  const ActionPlan plan = find_actions(*model, result, flags.settings, progress);
  const ActionsReport report{*model, result, flags.settings, plan};
  if (!flags.csv.empty()) write_file(flags.csv, actions_csv(report));
  put_report(
      console, flags.part.json, [&] { return actions_json(report); }, [&] { return actions_table(report); });
  return 0;
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
  CLI::Option* direction =
      add_direction_flag(*command, {flags->query.direction, flags->best_direction})->required();
  direction->description(direction->get_description() + " [required]");
  add_option_flags(*command, action_options(), flags->settings);
  add_method_flags(*command, flags->query.method);
  add_file_flag(*command, flags->csv, {"--csv", "FILE.csv", "Write a table of the undercuts"});
  set_work(*command, request, flags, run, settings);
}

}  // namespace moldlight::cli
