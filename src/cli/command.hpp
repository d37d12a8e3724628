// Common parts of the subcommands, and the list in which each registers itself.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/progress.hpp"
#include "classify/json.hpp"
#include "cli/console.hpp"

namespace moldlight::cli {

/// What the command line comes to.
struct Request {
  std::function<int(Console&, const Progress&)> body;  // the command's work; returns the exit code
  /// Every setting that the result depends on with its value, of a command that can be the work of a batch.
  std::function<Json()> settings;
  std::vector<std::string> words;  // the command line, from the command's name on
  bool quiet = false, verbose = false;
};

/// A subcommand. Each stands in one file, <name>_command.cpp, and registers itself there.
struct CommandRow {
  int place = 0;  // in the help, rising
  std::string_view name;
  void (*add)(CLI::App& program, Request& request) = nullptr;
  int work_place = 0;  // among those that can be the work of a batch; 0: it cannot
};
/// In their places.
[[nodiscard]] std::vector<CommandRow>& commands();
struct RegisteredCommand {
  explicit RegisteredCommand(const CommandRow& row);
};

/// Where the command line asks for `command`, its work is `run` with these flags; `settings` gives what
/// Request::settings does, of a command that can be the work of a batch.
template <typename Flags>
void set_work(CLI::App& command, Request& request, const std::shared_ptr<Flags>& flags,
              int (*run)(const Flags&, Console&, const Progress&), Json (*settings)(const Flags&) = nullptr) {
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
void put_report(Console& console, const std::string& json_path, const std::function<Json()>& json,
                const std::function<std::string()>& text);

}  // namespace moldlight::cli
