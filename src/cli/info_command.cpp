// moldlight info: the health report of a part.
#include <memory>

#include <nlohmann/json.hpp>

#include "classify/info_report.hpp"
#include "cli/flags.hpp"

namespace moldlight::cli {

namespace {

int run(const PartFlags& flags, Console& console, const Progress& progress) {
  check_outputs({.inputs = {{"PART", flags.part}}, .files = {{"--json", flags.json_file()}}});
  const auto model = load_part(flags.part, flags.reading, progress);
  progress.report("looking for faulty edges", 0.0);
  const DefectPlaces places = defect_places(*model);
  progress.report("writing", 0.0);
  put_report(
      console, flags.json, [&] { return info_json(*model, places); },
      [&] { return info_text(*model, places); });
  return 0;
}

void add_info_command(CLI::App& program, Request& request) {
  CLI::App* command =
      program.add_subcommand("info", "Check a part's mesh and report its faults with their places");
  const auto flags = std::make_shared<PartFlags>();
  add_part_flags(*command, *flags, request);
  set_work(*command, request, flags, run);
}

const RegisteredCommand k_info_command({10, "info", add_info_command});

}  // namespace

}  // namespace moldlight::cli
