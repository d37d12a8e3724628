#include "cli/report_flags.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "classify/option_json.hpp"
#include "cli/console.hpp"
#include "compare/compare_figures.hpp"
#include "io/file_contents.hpp"

namespace moldlight::cli {

namespace {

Json read_report(const std::string& file) {
  const FileContents contents(file, Progress());
  auto json = Json::parse(contents.bytes(), nullptr, false);
  if (json.is_discarded()) throw FileError(file, "", "is not JSON, as --json writes it");
  return json;
}

/// What is sent names files without the folders that they lie in.
std::vector<std::string> without_folders(std::vector<std::string> words) {
  namespace fs = std::filesystem;
  for (std::string& word : words) {
    const std::size_t value = word.starts_with("--") ? word.find('=') + 1 : 0;  // 0 where there is no =
    const fs::path path = word.substr(value);
    std::error_code ignored;
    if (path.has_parent_path() && fs::is_directory(path.parent_path(), ignored))
      word = word.substr(0, value) + path.filename().string();
  }
  return words;
}

}  // namespace

void add_report_flags(CLI::App& command, ReportFlags& flags, const Request& request) {
  flags.request = &request;
  add_file_flag(command, flags.html,
                {"--html", "FILE.html",
                 "Write a report for any browser, without a network: verdict, figures, pictures, and the "
                 "part to turn, open and cut"});
  CLI::Option* pdf = add_file_flag(command, flags.pdf, {"--pdf", "FILE.pdf", "Write the same report as PDF"});
  add_option_flag(command, report::paper_options().front(), flags.paper)->needs(pdf);
  // An empty text is one that a script leaves empty.
  for (const Option<report::TitleFacts>& option : report::title_options())
    add_text_flag(command, {names_of(option.flag), value_text(option), std::string(option.help)},
                  [&option, &flags](const std::string& text) { set_option(option, flags.title, text); });
  flags.title = report::usual_title();
}

void add_live_flag(CLI::App& command, ReportFlags& flags) {
  command
      .add_flag("--live", flags.live,
                "Let the page of --html find the regions of any direction by itself, by shadow maps on the "
                "reader's graphics card")
      ->needs(command.get_option("--html"));
}

report::ReportContext report_context(const ReportFlags& flags, const gl::Context& context,
                                     std::shared_ptr<const PartModel> model, Palette palette,
                                     const Progress& progress) {
  return {.model = std::move(model),
          .progress = progress,
          .gl = &context,
          .palette = palette,
          .live = flags.live,
          .version = MOLDLIGHT_VERSION,
          .command = "moldlight " + shell_text(without_folders(flags.request->words)),
          .title = flags.title};
}

void write_reports(const ReportFlags& flags, const report::Report& report, Console& console) {
  if (!report.live_notice.empty()) console.warning(report.live_notice);
  if (!flags.html.empty()) report::write_html(flags.html, report);
  if (!flags.pdf.empty()) report::write_pdf(flags.pdf, report, flags.paper.paper);
}

void add_baseline_flags(CLI::App& command, BaselineFlags& flags, std::string_view name) {
  if (report_figure_names(name).empty()) return;
  add_file_flag(
      command, flags.file,
      {"--baseline", "FILE.json", "Compare the figures with an earlier --json report of this command"});
  add_gate_flags(command, flags.gate, report_figure_names(name));
}

Baseline::Baseline(const BaselineFlags& flags, std::string command, const std::string& part)
    : flags_(flags), command_(std::move(command)), part_(std::filesystem::path(part).filename().string()) {
  if (!flags.file.empty()) before_ = read_report(flags.file);
}

void Baseline::compare(const std::function<Json()>& report) {
  if (flags_.file.empty() && flags_.gate.criteria.empty()) return;
  if (flags_.file.empty()) require_no_change(flags_.gate.criteria);
  const Json now = report();
  figures_ = report_figures(command_, flags_.file.empty() ? now : before_, now, one_line(flags_.file));
  cases_ = gate_cases(part_, flags_.gate.criteria, figures_);
}

std::string Baseline::table() const {
  if (flags_.file.empty()) return {};
  return fmt::format("\nagainst {}:\n{}", one_line(flags_.file), figure_changes_table(figures_));
}

void Baseline::add_to(Json& report) const {
  if (flags_.file.empty()) return;
  Json figures = Json::object();
  for (const ComparedFigure& figure : figures_)
    figures[std::string(figure.name)] = {
        {"was", figure.before}, {"is", figure.after}, {"error", figure.error}};
  Json failed = Json::array();
  for (const GateCase& one : cases_)
    if (!one.failure.empty()) failed.push_back(one.failure);
  report["baseline"] = {{"file", flags_.file}, {"figures", figures}, {"failed", failed}};
}

void Baseline::put_report(Console& console, const std::string& json_path, const std::function<Json()>& json,
                          const std::function<std::string()>& text) const {
  cli::put_report(
      console, json_path,
      [&] {
        Json report = json();
        add_to(report);
        return report;
      },
      [&] { return text() + table(); });
}

int Baseline::exit_code(Console& console) const { return gate_outcome(flags_.gate, cases_, console); }

void add_study_flags(CLI::App& command, StudyFlags& flags, Request& request) {
  flags.command = command.get_name();
  add_part_flags(command, flags.part, request);
  add_direction_flag(command, {flags.query.direction, flags.best_direction}, "required")->required();
}

CLI::Option* add_study_outputs(CLI::App& command, StudyFlags& flags, const Request& request,
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
  written.push_back({"--step", flags.step});
  std::ranges::copy(flags.report.files(), std::back_inserter(written));
  written.push_back({"--junit", flags.baseline.gate.junit});
  check_outputs({.inputs = {{"PART", flags.part.part}, {"--baseline", flags.baseline.file}},
                 .files = written,
                 .folder = folder});
  if (!flags.step.empty() && flags.part.reading.repair.level >= RepairLevel::full)
    throw UsageError("--step writes the faces of the file as they are: leave out --repair");
}

Study asked_study(const StudyFlags& flags, Questions questions, Console& console, const Progress& progress) {
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  if (!flags.step.empty() && !model->part.has_cad_faces) {
    throw UsageError(
        fmt::format("--step: {} is {}, which has no exact faces; use --mesh, or a STEP file of it",
                    one_line(flags.part.part), model->part.format));
  }
  validate(flags.query.method, model->frame.diagonal);
  questions.query = flags.query;
  if (flags.best_direction) {
    questions.best = found_direction(model, flags.query.method, console, progress);
    questions.query.direction = questions.best->direction;
  }
  return Study(model, std::move(questions));
}

int put_report(const StudyFlags& flags, Study& study, const StudyReport& report, const gl::Context* context,
               Baseline& baseline, Console& console, const Progress& progress) {
  const auto json = [&] {
    Json found = report.json(study, progress);
    if (report.add) report.add(found);
    if (!report.step.is_null()) found["step"] = report.step;
    return found;
  };
  baseline.compare(json);
  if (flags.report.any()) {
    const auto for_report =
        report_context(flags.report, *context, study.shared_model(), flags.still.look.palette, progress);
    write_reports(flags.report, report.people(for_report, study), console);
  }
  baseline.put_report(console, flags.part.json, json, [&] {
    return to_text(report.people({study.shared_model(), progress}, study), {.colour = console.colour()});
  });
  return baseline.exit_code(console);
}

Json study_settings(const StudyFlags& flags) {
  Json json = query_json(flags.query, flags.best_direction);
  json.update(options_json(reading_options(), flags.part.reading));
  return json;
}

}  // namespace moldlight::cli
