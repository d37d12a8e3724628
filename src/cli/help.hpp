// Help on the command line: in groups, with an example a command.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace moldlight::cli {

/// Breaks the lines of descriptions, and puts the groups of flags in order.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(34); }
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override;
  /// What stands for the value, and nothing else beside the name.
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
  [[nodiscard]] std::string make_help(const CLI::App* command, std::string name,
                                      CLI::AppFormatMode mode) const override;
};

/// Puts every flag of every command into its group, and an example below each command's help.
void arrange_help(CLI::App& program);

/// Command lines to start from, as the manual page has them: what for, and what to type.
struct CommandExample {
  std::string_view command, what_for, line;
};
[[nodiscard]] const std::vector<CommandExample>& command_examples();

/// The command's flags, with their dashes.
[[nodiscard]] std::vector<std::string> flags_of(const CLI::App& command);
/// Names of its subcommands.
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& command);

/// One line: what is wrong with the command line that `program` has refused, and what to type instead.
[[nodiscard]] std::string fault_text(const CLI::App& program, const CLI::ParseError& error);

}  // namespace moldlight::cli
