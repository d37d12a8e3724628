// What the subcommands have in common. Each has one file and one function add_<name>_command, listed here.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "base/progress.hpp"
#include "cli/console.hpp"
#include "io/read_options.hpp"

namespace moldlight::cli {

/// The work of the command that the command line asks for; returns the exit code.
using CommandBody = std::function<int(Console&, const Progress&)>;

/// What the command line comes to.
struct Request {
  CommandBody body;
  bool quiet = false, verbose = false;
};

void add_info_command(CLI::App& program, Request& request);
void add_classify_command(CLI::App& program, Request& request);
void add_sweep_command(CLI::App& program, Request& request);
void add_view_command(CLI::App& program, Request& request);

/// Part file and the flags that every command takes.
struct PartFlags {
  std::string part;
  ReadOptions reading;
  std::string json;  // file, "-" for stdout, or empty
};

/// Refuses an empty name of a file or folder, such as a script's unset variable gives.
[[nodiscard]] CLI::Validator named();

/// Adds PART, --json, --quiet, --verbose and how the part is read.
void add_part_flags(CLI::App& command, PartFlags& flags, Request& request);

/// Breaks the lines of descriptions.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(34); }
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override;
  /// What stands for the value, and nothing else beside the name.
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
};

}  // namespace moldlight::cli
