// The reports of one part as a table, and what writes one of them: for who chooses among them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/report.hpp"
#include "study/study.hpp"

namespace moldlight::report {

struct ReportContext;

struct PartReport {
  std::string_view command;  // that writes it, too
  std::string_view subject;
  bool lives = false;  // its page can find the regions of any direction by itself
  Report (*describe)(const ReportContext& context, Study& study);
};
[[nodiscard]] std::span<const PartReport> part_reports();

/// Which of them, and what is written of it: files of this path with the format's extension.
struct ReportOrder {
  int of = 0;
  std::string path = {};
  bool html = true, pdf = true;
  bool live = false;                // where the page can be
  std::vector<Picture> views = {};  // that the user has chosen; before all else
};
/// Writes it, with the command that makes it again. Returns where it is, a sentence without its stop. Throws
/// FileError, Cancelled.
std::string write_report(const ReportOrder& order, ReportContext context, Study& study);

}  // namespace moldlight::report
