// Common parts of the subcommands. Each has one file and one function add_<name>_command, listed here.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include "base/exit_code.hpp"
#include "base/progress.hpp"
#include "cli/console.hpp"

namespace moldlight::cli {

/// What the command line comes to.
struct Request {
  std::function<int(Console&, const Progress&)> body;  // the command's work; returns the exit code
  /// Every setting that the result depends on with its value, of a command that can be the work of a batch.
  std::function<nlohmann::ordered_json()> settings;
  std::vector<std::string> words;  // the command line, from the command's name on
  bool quiet = false, verbose = false;
};

void add_info_command(CLI::App& program, Request& request);
void add_classify_command(CLI::App& program, Request& request);
void add_actions_command(CLI::App& program, Request& request);
void add_mold_command(CLI::App& program, Request& request);
void add_sweep_command(CLI::App& program, Request& request);
void add_compare_command(CLI::App& program, Request& request);
void add_view_command(CLI::App& program, Request& request);
void add_doctor_command(CLI::App& program, Request& request);
void add_manual_command(CLI::App& program, Request& request);
void add_batch_command(CLI::App& program, Request& request);
inline constexpr std::array k_add_commands = {
    add_info_command,    add_classify_command, add_actions_command, add_mold_command,   add_sweep_command,
    add_compare_command, add_view_command,     add_batch_command,   add_doctor_command, add_manual_command};

/// Where the command line asks for `command`, its work is `run` with these flags; `settings` gives what
/// Request::settings does, of a command that can be the work of a batch.
template <typename Flags>
void set_work(CLI::App& command, Request& request, const std::shared_ptr<Flags>& flags,
              int (*run)(const Flags&, Console&, const Progress&),
              nlohmann::ordered_json (*settings)(const Flags&) = nullptr) {
  command.callback([=, &request] {
    request.body = [=](Console& console, const Progress& progress) { return run(*flags, console, progress); };
    if (settings != nullptr) request.settings = [=] { return settings(*flags); };
  });
}

/// A file or folder that a flag names; an empty path is a flag not given.
struct NamedPath {
  std::string_view flag;
  std::string path;
};
// Where a command writes to is found out before the work, so that an hour of it is not lost to a typing
// error.

struct Outputs {
  std::vector<NamedPath> inputs;  // what is read, the part among them
  std::vector<NamedPath> files;   // without what goes to stdout
  NamedPath folder{};
};
/// Throws FileError for a file or folder that cannot be written, and UsageError for "-", where two flags name
/// one file, where a file would be put into the folder, and where something that is read would be
/// overwritten. Nothing is changed or left behind.
void check_outputs(const Outputs& outputs);

/// Writes the report as --json asks for it: to stdout in place of the text, or to a file beside it.
void put_report(Console& console, const std::string& json_path,
                const std::function<nlohmann::ordered_json()>& json,
                const std::function<std::string()>& text);

}  // namespace moldlight::cli
