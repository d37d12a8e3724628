#include "cli/batch_work.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/similar_word.hpp"
#include "batch/part_result.hpp"
#include "classify/json.hpp"
#include "cli/console.hpp"
#include "cli/flags.hpp"
#include "cli/help.hpp"

namespace moldlight::cli {

namespace {

/// What becomes of a command line of the work.
struct ParsedWork {
  std::vector<batch::NamedValue> given;  // a switch has an empty value
  Json settings;
};

/// Flags that the run sets itself.
bool is_runs_own(const std::string& flag) { return flag == "quiet" || flag == "verbose"; }

ParsedWork parse(const std::string& command, const std::vector<std::string>& flags) {
  const CommandRow& row = work_row(command);
  CLI::App program("", "moldlight");
  Request request;
  row.add(program, request);
  std::vector<std::string> words = {command, "part"};
  words.insert(words.end(), flags.begin(), flags.end());
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    throw UsageError(fault_text(program, error));
  }
  ParsedWork parsed;
  for (const CLI::Option* option : program.get_subcommands().front()->get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    const std::string name = option->get_lnames().front();
    if (is_runs_own(name)) continue;
    const std::string value = option->get_option_text();
    if (value.find("FILE") != std::string::npos || value.find("DIR") != std::string::npos) {
      throw UsageError(
          fmt::format("--{} names one file for all parts; leave it out, and collect the results with "
                      "moldlight batch merge",
                      name));
    }
    const bool is_switch = option->get_expected_max() == 0;
    for (const std::string& text : option->results()) parsed.given.emplace_back(name, is_switch ? "" : text);
  }
  parsed.settings = request.settings();
  for (const std::string_view key : batch::settings_without_effect()) parsed.settings.erase(std::string(key));
  return parsed;
}

std::vector<std::string> words_of(const std::vector<batch::NamedValue>& given) {
  std::vector<std::string> words;
  for (const auto& [name, value] : given) words.push_back("--" + name + (value.empty() ? "" : "=" + value));
  return words;
}

/// Commands that can be the work, in the order in which the help has them.
std::vector<std::string> works() {
  std::vector<CommandRow> rows = commands();
  std::erase_if(rows, [](const CommandRow& row) { return row.work_place == 0; });
  std::ranges::sort(rows, {}, &CommandRow::work_place);
  std::vector<std::string> names;
  for (const CommandRow& row : rows) names.emplace_back(row.name);
  return names;
}

/// Flags that `classify` has as well, whatever the work.
bool is_of_every_work(const std::string& name) {
  const auto names = [&](const auto& option) { return option.flag == "--" + name; };
  return std::ranges::any_of(reading_options(), names) || std::ranges::any_of(method_options(), names);
}

}  // namespace

std::string work_names() {
  const std::vector<std::string> names = works();
  std::string text;
  for (const std::string& name : names)
    text += fmt::format("{}{}", &name == &names.front() ? "" : &name == &names.back() ? " or " : ", ", name);
  return text;
}

const CommandRow& work_row(std::string_view command) {
  const auto row = std::ranges::find(commands(), command, &CommandRow::name);
  if (row == commands().end() || row->work_place == 0)
    throw UsageError(fmt::format(
        "{} cannot be the work of a batch{}", one_line(command),
        did_you_mean(command, works(),
                     fmt::format("choose {}, and put a pattern of parts in quotes", work_names()))));
  return *row;
}

BatchWork::BatchWork(std::string command, const std::vector<std::string>& flags)
    : command_(std::move(command)), common_(parse(command_, flags).given) {}

batch::RowSettings BatchWork::settings(const std::vector<batch::NamedValue>& row) const {
  std::vector<batch::NamedValue> given = common_;
  for (const auto& [column, value] : row) {
    std::string name = column;
    std::ranges::replace(name, '_', '-');
    std::erase_if(given, [&](const batch::NamedValue& one) { return one.first == name; });
    given.emplace_back(name, value);
  }
  ParsedWork parsed = parse(command_, words_of(given));
  batch::RowSettings settings;
  settings.arguments = words_of(parsed.given);
  std::erase_if(parsed.given, [](const batch::NamedValue& one) { return !is_of_every_work(one.first); });
  settings.picture = words_of(parsed.given);
  settings.effective = std::move(parsed.settings);
  return settings;
}

}  // namespace moldlight::cli
