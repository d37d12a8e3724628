#include "cli/title_flags.hpp"

#include <cstdint>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/shown_text.hpp"
#include "cli/flags.hpp"
#include "io/png.hpp"

namespace moldlight::cli {

namespace {

bool is_day(const std::string& text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const auto year = number_from<int>(text.substr(0, 4)), month = number_from<int>(text.substr(5, 2)),
             day = number_from<int>(text.substr(8, 2));
  if (!year || !month || !day || *year < 1 || *month < 1 || *month > 12 || *day < 1) return false;
  const bool leap = (*year % 4 == 0 && *year % 100 != 0) || *year % 400 == 0;
  const int days = *month == 2                                                 ? (leap ? 29 : 28)
                   : *month == 4 || *month == 6 || *month == 9 || *month == 11 ? 30
                                                                               : 31;
  return *day <= days;
}

}  // namespace

std::string day_of_environment() {
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = epoch == nullptr ? std::nullopt : number_from<std::int64_t>(epoch);
  if (!seconds) return {};
  const auto time = static_cast<std::time_t>(*seconds);
  std::tm parts = {};
  if (::gmtime_r(&time, &parts) == nullptr) return {};
  return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

void add_title_flags(CLI::App& command, report::TitleFacts& title) {
  title.date = day_of_environment();
  const auto add = [&](const char* flag, const char* value, const char* help, std::string& text) {
    add_text_flag(command, {flag, value, help},
                  [&text](const std::string& given) { text = one_line(given); });
  };
  add("--revision", "TEXT", "Revision of the part, for the title block of the report", title.revision);
  add("--material", "TEXT", "Material of the part, for the title block", title.material);
  add("--company", "TEXT", "Who sends the report, for the title block", title.company);
  add("--author", "TEXT", "Who made the report, for the title block", title.author);
  add("--note", "TEXT", "A note for who receives the report", title.note);
  add_text_flag(
      command, {"--date", "YYYY-MM-DD", "Date of the report [default that of SOURCE_DATE_EPOCH, else none]"},
      [&title](const std::string& given) {
        if (!is_day(given))
          throw UsageError(fmt::format("--date: '{}' is no day, such as 2026-11-25", one_line(given)));
        title.date = given;
      });
  add_text_flag(command, {"--logo", "FILE.png", "Picture for the title block"},
                [&title](const std::string& given) { title.logo = read_png(given); });
}

}  // namespace moldlight::cli
