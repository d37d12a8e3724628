#include "report/page_options.hpp"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/shown_text.hpp"
#include "io/png.hpp"

namespace moldlight::report {

namespace {

bool is_day(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const auto year = number_from<int>(text.substr(0, 4)), month = number_from<int>(text.substr(5, 2)),
             day = number_from<int>(text.substr(8, 2));
  if (!year || !month || !day || *year < 1 || *month < 1 || *day < 1) return false;
  namespace chrono = std::chrono;
  return (chrono::year(*year) / *month / *day).ok();
}

void set_date(TitleFacts& title, std::string_view text) {
  if (!is_day(text))
    throw UsageError(fmt::format("--date: '{}' is not a date such as 2026-11-25", one_line(text)));
  title.date = text;
}

template <std::string TitleFacts::*k_member>
TextKind<TitleFacts> line_of_title(std::string_view name) {
  return {.name = name,
          .get = [](const TitleFacts& title) { return title.*k_member; },
          .set = [](TitleFacts& title, std::string_view text) { title.*k_member = one_line(text); }};
}

}  // namespace

std::span<const Option<TitleFacts>> title_options() {
  using T = TitleFacts;
  constexpr std::string_view k_text = "TEXT";
  static const std::vector<Option<T>> k_options = {
      {"revision", "--revision", "Revision", "", "Revision of the part, in the report's title block",
       line_of_title<&T::revision>(k_text)},
      {"material", "--material", "Material", "", "Material of the part, in the report's title block",
       line_of_title<&T::material>(k_text)},
      {"company", "--company", "Company", "", "Company that sends the report",
       line_of_title<&T::company>(k_text)},
      {"author", "--author", "Author", "", "Author of the report", line_of_title<&T::author>(k_text)},
      {"note", "--note", "Note", "", "Note to the reader of the report", line_of_title<&T::note>(k_text)},
      {"date", "--date", "Date", "", "Date of the report [default that of SOURCE_DATE_EPOCH, else none]",
       TextKind<T>{"YYYY-MM-DD", [](const T& title) { return title.date; }, set_date}},
      {"logo", "--logo", "Logo", "", "Picture of the company's logo",
       TextKind<T>{"FILE.png", [](const T&) { return std::string(); },
                   [](T& title, std::string_view text) { title.logo = read_png(std::string(text)); }}},
  };
  return k_options;
}

TitleFacts usual_title() {
  TitleFacts title;
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = epoch == nullptr ? std::nullopt : number_from<std::int64_t>(epoch);
  if (!seconds) return title;
  const auto time = static_cast<std::time_t>(*seconds);
  std::tm parts = {};
  if (::gmtime_r(&time, &parts) != nullptr)
    title.date = fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
  return title;
}

std::span<const Option<PaperSettings>> paper_options() {
  static const std::vector<Option<PaperSettings>> k_options = {
      {"paper", "--paper", "Paper", "", "Paper size of the PDF",
       choice<&PaperSettings::paper>({"a4", "letter"})}};
  return k_options;
}

}  // namespace moldlight::report
