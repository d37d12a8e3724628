#include "cli/gate.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "cli/console.hpp"
#include "cli/flags.hpp"
#include "io/atomic_file.hpp"
#include "page/page.hpp"

namespace moldlight::cli {

CLI::Option* add_gate_flags(CLI::App& command, Gate& gate, const std::vector<std::string_view>& figures) {
  const std::string help = fmt::format(
      "Exit with 3 if one of these criteria holds, such as \"undercut > +1%, actions > 0\". A value with a "
      "sign limits the change, without a sign the figure itself. Per cent is of the old figure, or of the "
      "part's surface. Figures: {}",
      fmt::join(figures, ", "));
  CLI::Option* criteria = add_text_flag(
      command, {"--fail-on", "CRITERIA", help},
      [&gate, figures](const std::string& text) { gate.criteria = parse_criteria(text, figures); });
  add_file_flag(
      command, gate.junit,
      {"--junit", "FILE.xml", "Write the outcome as a JUnit report: a test for each criterion and part"})
      ->needs(criteria);
  return criteria;
}

void require_no_change(std::span<const Criterion> criteria) {
  for (const Criterion& criterion : criteria)
    if (criterion.of_change)
      throw UsageError(fmt::format("--fail-on: '{}' limits a change; give --baseline, too", criterion.text));
}

std::vector<GateCase> gate_cases(std::string_view part, std::span<const Criterion> criteria,
                                 std::span<const ComparedFigure> figures) {
  std::vector<GateCase> cases;
  for (std::size_t k = 0; k < criteria.size(); ++k) {
    std::vector<std::string> met = met_criteria(criteria.subspan(k, 1), figures);
    cases.push_back(
        {std::string(part), criteria[k].text, met.empty() ? std::string() : std::move(met.front())});
  }
  return cases;
}

namespace {

std::string junit_text(std::span<const GateCase> cases) {
  const auto text = [](std::string_view raw) { return page::html_text(one_line(raw)); };
  const auto failures = [](std::span<const GateCase> some) {
    return std::ranges::count_if(some, [](const GateCase& one) { return !one.failure.empty(); });
  };
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"moldlight\" tests=\"{}\" "
      "failures=\"{}\">\n",
      cases.size(), failures(cases));
  for (auto begin = cases.begin(); begin != cases.end();) {
    const auto end =
        std::find_if(begin, cases.end(), [&](const GateCase& one) { return one.part != begin->part; });
    const std::string part = text(begin->part);
    xml += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n", part, end - begin,
                       failures({begin, end}));
    for (; begin != end; ++begin) {
      xml += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", part, text(begin->criterion));
      xml += begin->failure.empty()
                 ? std::string("/>\n")
                 : fmt::format("><failure message=\"{}\"/></testcase>\n", text(begin->failure));
    }
    xml += "  </testsuite>\n";
  }
  return xml + "</testsuites>\n";
}

}  // namespace

void write_junit(const Gate& gate, std::span<const GateCase> cases) {
  if (!gate.junit.empty()) write_file(gate.junit, junit_text(cases));
}

int gate_outcome(const Gate& gate, std::span<const GateCase> cases, Console& console) {
  write_junit(gate, cases);
  int code = 0;
  for (const GateCase& one : cases) {
    if (one.failure.empty()) continue;
    console.failure(one.failure);
    code = k_criterion_failed;
  }
  return code;
}

}  // namespace moldlight::cli
