// What the subcommands have in common. Each has one file and one function add_<name>_command, listed here.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/progress.hpp"
#include "cli/console.hpp"

namespace moldlight::cli {

/// Exit codes that are not 0.
inline constexpr int k_failure = 1, k_usage = 2, k_criterion_failed = 3, k_interrupted = 130;

/// What the command line comes to.
struct Request {
  std::function<int(Console&, const Progress&)> body;  // the command's work; returns the exit code
  bool quiet = false, verbose = false;
};

void add_info_command(CLI::App& program, Request& request);
void add_classify_command(CLI::App& program, Request& request);
void add_sweep_command(CLI::App& program, Request& request);
void add_view_command(CLI::App& program, Request& request);

/// Where the command line asks for `command`, its work is `run` with these flags.
template <typename Flags>
void set_work(CLI::App& command, Request& request, const std::shared_ptr<Flags>& flags,
              int (*run)(const Flags&, Console&, const Progress&)) {
  command.callback([=, &request] {
    request.body = [=](Console& console, const Progress& progress) { return run(*flags, console, progress); };
  });
}

/// A file that a flag names; an empty path is a flag not given.
struct OutputFile {
  std::string_view flag;
  std::string path;
};
// Where a command writes to is found out before the work, so that an hour of it is not lost to a typing
// error.

/// Throws FileError for a file that cannot be written, and UsageError where two flags name one file, where
/// the part itself would be overwritten, and for "-" (commands that write to stdout leave it out of `files`).
/// Nothing is changed or left behind.
void check_output_files(const std::string& part, const std::vector<OutputFile>& files);

/// Throws FileError for a folder that is none, or that cannot be made or written to.
void check_output_folder(const std::string& folder);

/// Writes the report as --json asks for it: to stdout in place of the text, or to a file beside it.
void put_report(Console& console, const std::string& json_path,
                const std::function<nlohmann::ordered_json()>& json,
                const std::function<std::string()>& text);

}  // namespace moldlight::cli
