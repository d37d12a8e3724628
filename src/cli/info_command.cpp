// moldlight info: the health report of a part.
#include <memory>

#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "io/atomic_file.hpp"
#include "session/classify_report.hpp"
#include "session/info_report.hpp"

namespace moldlight::cli {

namespace {

int run(const PartFlags& flags, Console& console, const Progress& progress) {
  const bool json_to_stdout = flags.json == "-";
  check_output_files(flags.part, {{"--json", json_to_stdout ? "" : flags.json}});
  const auto model = load_part(flags.part, flags.reading, progress);
  progress.report("finding the edges at fault", 0.0);
  const DefectPlaces places = defect_places(*model);
  progress.report("writing", 0.0);
  if (json_to_stdout) {
    console.result(json_text(info_json(*model, places)));
    return 0;
  }
  if (!flags.json.empty()) write_file(flags.json, json_text(info_json(*model, places)));
  console.result(info_text(*model, places));
  return 0;
}

}  // namespace

void add_info_command(CLI::App& program, Request& request) {
  CLI::App* command =
      program.add_subcommand("info", "Say what a part's mesh is like, what is wrong with it and where");
  const auto flags = std::make_shared<PartFlags>();
  add_part_flags(*command, *flags, request);
  command->callback([flags, &request] {
    request.body = [flags](Console& console, const Progress& progress) {
      return run(*flags, console, progress);
    };
  });
}

}  // namespace moldlight::cli
