#include "cli/command.hpp"

#include <algorithm>

#include "cli/reading_flags.hpp"

namespace moldlight::cli {

namespace {

constexpr std::size_t k_help_width = 104;

}  // namespace

CLI::Validator named() {
  return {[](std::string& name) { return name.empty() ? "the name is empty" : std::string(); }, ""};
}

void add_part_flags(CLI::App& command, PartFlags& flags, Request& request) {
  command.add_option("PART", flags.part, "Part file: STL, OBJ, PLY, OFF, 3MF or STEP, known by its content")
      ->required();
  command.add_option("--json", flags.json, "Write the report as JSON; - for stdout, in place of the table")
      ->option_text("FILE|-")
      ->check(named());
  add_reading_flags(command, flags.reading);
  CLI::Option* quiet = command.add_flag("-q,--quiet", request.quiet, "No warnings and no progress on stderr");
  command.add_flag("-v,--verbose", request.verbose, "Say on stderr what is being done")->excludes(quiet);
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  const std::string text = option->get_description();
  const std::size_t width = k_help_width - get_column_width();
  std::string wrapped;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (column > 0 && column + 1 + end - begin > width) {
      wrapped += '\n';
      column = 0;
    } else if (column > 0) {
      wrapped += ' ';
      ++column;
    }
    wrapped += text.substr(begin, end - begin);
    column += end - begin;
    begin = end + 1;
  }
  return wrapped;
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  return option->get_option_text().empty() ? "" : " " + option->get_option_text();
}

}  // namespace moldlight::cli
