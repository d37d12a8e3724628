#include "cli/study_command.hpp"

#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>

#include "classify/headless.hpp"
#include "classify/option_json.hpp"

namespace moldlight::cli {

void add_study_flags(CLI::App& command, StudyFlags& flags, Request& request) {
  flags.command = command.get_name();
  add_part_flags(command, flags.part, request);
  add_direction_flag(command, {flags.query.direction, flags.best_direction}, "required")->required();
}

CLI::Option* add_report_flags(CLI::App& command, StudyFlags& flags, const Request& request,
                              const std::string& image_help) {
  add_baseline_flags(command, flags.baseline, flags.command);
  add_report_flags(command, flags.report, request);
  CLI::Option* image = add_file_flag(command, flags.image, {"--image", "FILE.png", image_help});
  add_size_flag(command, flags.still.size, "Width and height of the picture in pixels")->needs(image);
  return image;
}

void check_outputs(const StudyFlags& flags, const std::vector<NamedPath>& files, const NamedPath& folder) {
  std::vector<NamedPath> written = {{"--json", flags.part.json_file()}};
  std::ranges::copy(files, std::back_inserter(written));
  written.push_back({"--image", flags.image});
  std::ranges::copy(flags.report.files(), std::back_inserter(written));
  check_outputs({.inputs = {{"PART", flags.part.part}, {"--baseline", flags.baseline.file}},
                 .files = written,
                 .folder = folder});
}

AskedPart asked_part(const StudyFlags& flags, Console& console, const Progress& progress) {
  AskedPart asked{.model = load_part(flags.part.part, flags.part.reading, progress),
                  .questions = {.query = flags.query}};
  validate(flags.query.method, asked.model->frame.diagonal);
  if (flags.best_direction) {
    asked.questions.best = found_direction(asked.model, flags.query.method, console, progress);
    asked.questions.query.direction = asked.questions.best->direction;
  }
  return asked;
}

int put_report(const StudyFlags& flags, Study& study, const StudyReport& report, const gl::Context* context,
               Baseline& baseline, Console& console, const Progress& progress) {
  const auto json = [&] {
    nlohmann::ordered_json found = report.json(study, progress);
    if (report.add) report.add(found);
    return found;
  };
  baseline.compare(json);
  if (flags.report.any()) {
    const auto for_report =
        report_context(flags.report, *context, study.shared_model(), flags.still.look.palette, progress);
    write_reports(flags.report, report.people(for_report, study));
  }
  baseline.put_report(console, flags.part.json, json, [&] {
    return to_text(report.people({study.shared_model(), progress}, study), {.colour = console.colour()});
  });
  return baseline.exit_code(console);
}

nlohmann::ordered_json study_settings(const StudyFlags& flags) {
  nlohmann::ordered_json json = query_json(flags.query, flags.best_direction);
  json.update(options_json(reading_options(), flags.part.reading));
  return json;
}

}  // namespace moldlight::cli
