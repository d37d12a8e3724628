#include "report/part_report.hpp"

#include <array>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "classify/number_format.hpp"
#include "report/describe/describe.hpp"
#include "report/writers.hpp"

namespace moldlight::report {

namespace {

std::string command_of(const PartReport& report, const std::vector<std::string>& outputs,
                       const Study& study) {
  const Part& part = study.model().part;
  const Questions& questions = study.questions();
  const glm::dvec3& d = questions.query.direction.given();
  std::vector<std::string> words = {"moldlight", std::string(report.command), part_name(part)};
  if (!part.unit.empty()) words.push_back("--unit=" + part.unit);
  if (report.command != "sweep") words.push_back(fmt::format("--direction={},{},{}", d.x, d.y, d.z));
  if (report.command == "mold" && questions.with_actions) words.emplace_back("--actions");
  words.insert(words.end(), outputs.begin(), outputs.end());
  return shell_text(words);
}

}  // namespace

std::span<const PartReport> part_reports() {
  static constexpr std::array<PartReport, 4> k_reports = {{{"classify", "Regions", true, classify_report},
                                                           {"sweep", "Directions", true, sweep_report},
                                                           {"actions", "Actions", false, actions_report},
                                                           {"mold", "Mold", false, mold_report}}};
  return k_reports;
}

std::string write_report(const ReportOrder& order, ReportContext context, Study& study) {
  const PartReport& row = part_reports()[static_cast<std::size_t>(order.of)];
  const std::string html = order.html ? order.path + ".html" : "", pdf = order.pdf ? order.path + ".pdf" : "";
  const std::string name = std::filesystem::path(order.path).filename().string();
  context.live = order.live && order.html && row.lives;
  std::vector<std::string> outputs;
  if (order.html) outputs.push_back("--html=" + name + ".html");
  if (context.live) outputs.emplace_back("--live");
  if (order.pdf) outputs.push_back("--pdf=" + name + ".pdf");
  context.command = command_of(row, outputs, study);
  Report report = row.describe(context, study);
  if (!order.views.empty()) {
    Section views{.title = "Views", .blocks = {}, .pages_only = true};
    views.add(Pictures{order.views});
    report.sections.insert(report.sections.begin(), std::move(views));
  }
  context.progress.report("writing", 0.0);
  if (order.html) write_html(html, report);
  if (order.pdf) write_pdf(pdf, report, Paper::a4);
  return fmt::format("Report written to {}{}{}", html, order.html && order.pdf ? " and " : "", pdf);
}

}  // namespace moldlight::report
