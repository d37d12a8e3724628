#include "cli/report_flags.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "cli/console.hpp"
#include "compare/compare_figures.hpp"
#include "io/file_contents.hpp"
#include "report/html_writer.hpp"

namespace moldlight::cli {

namespace {

nlohmann::ordered_json read_report(const std::string& file) {
  const FileContents contents(file, Progress());
  auto json = nlohmann::ordered_json::parse(contents.bytes(), nullptr, false);
  if (json.is_discarded()) throw FileError(file, "", "is not JSON, as --json writes it");
  return json;
}

}  // namespace

void add_report_flags(CLI::App& command, ReportFlags& flags, const Request& request) {
  flags.request = &request;
  add_file_flag(command, flags.html,
                {"--html", "FILE.html",
                 "Write a report for any browser, without a network: verdict, figures, pictures, and the "
                 "part to turn, open and cut"});
  CLI::Option* pdf = add_file_flag(command, flags.pdf, {"--pdf", "FILE.pdf", "Write the same report as PDF"});
  add_text_flag(command, {"--paper", "a4|letter", "Paper size of --pdf [default a4]"},
                [&flags](const std::string& text) {
                  if (text != "a4" && text != "letter")
                    throw UsageError(fmt::format("--paper: '{}' is not a4 or letter", one_line(text)));
                  flags.paper = text == "a4" ? report::Paper::a4 : report::Paper::letter;
                })
      ->needs(pdf);
}

report::ReportContext report_context(const ReportFlags& flags, const gl::Context& context,
                                     std::shared_ptr<const PartModel> model, Palette palette,
                                     const Progress& progress) {
  return {.model = std::move(model),
          .progress = progress,
          .gl = &context,
          .palette = palette,
          .version = MOLDLIGHT_VERSION,
          .command = "moldlight " + shell_text(flags.request->words)};
}

void write_reports(const ReportFlags& flags, const report::Report& report) {
  if (!flags.html.empty()) report::write_html(flags.html, report);
  if (!flags.pdf.empty()) report::write_pdf(flags.pdf, report, flags.paper);
}

void add_baseline_flags(CLI::App& command, BaselineFlags& flags, std::string_view name) {
  add_file_flag(
      command, flags.file,
      {"--baseline", "FILE.json", "Compare the figures with an earlier --json report of this command"});
  add_criteria_flag(command, flags.fail_on, report_figure_names(name));
}

Baseline::Baseline(const BaselineFlags& flags, std::string command)
    : flags_(flags), command_(std::move(command)) {
  if (!flags.file.empty()) before_ = read_report(flags.file);
}

void Baseline::compare(const std::function<nlohmann::ordered_json()>& report) {
  if (flags_.file.empty() && flags_.fail_on.empty()) return;
  for (const Criterion& criterion : flags_.fail_on)
    if (criterion.of_change && flags_.file.empty())
      throw UsageError(fmt::format("--fail-on: '{}' limits a change; give --baseline, too", criterion.text));
  const nlohmann::ordered_json now = report();
  figures_ = report_figures(command_, flags_.file.empty() ? now : before_, now, one_line(flags_.file));
  failed_ = met_criteria(flags_.fail_on, figures_);
}

std::string Baseline::table() const {
  if (flags_.file.empty()) return {};
  return fmt::format("\nagainst {}:\n{}", one_line(flags_.file), figure_changes_table(figures_));
}

void Baseline::add_to(nlohmann::ordered_json& report) const {
  if (flags_.file.empty()) return;
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();
  for (const ComparedFigure& figure : figures_)
    figures[std::string(figure.name)] = {
        {"was", figure.before}, {"is", figure.after}, {"error", figure.error}};
  report["baseline"] = {{"file", flags_.file}, {"figures", figures}, {"failed", failed_}};
}

void Baseline::put_report(Console& console, const std::string& json_path,
                          const std::function<nlohmann::ordered_json()>& json,
                          const std::function<std::string()>& text) const {
  cli::put_report(
      console, json_path,
      [&] {
        nlohmann::ordered_json report = json();
        add_to(report);
        return report;
      },
      [&] { return text() + table(); });
}

int Baseline::exit_code(Console& console) const {
  for (const std::string& sentence : failed_) console.failure(sentence);
  return failed_.empty() ? 0 : k_criterion_failed;
}

}  // namespace moldlight::cli
