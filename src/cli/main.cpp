// The program: reads the command line, runs the command, and turns every failure into one line and an exit
// code.
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"

namespace moldlight::cli {

namespace {

constexpr int k_failure = 1;
constexpr int k_usage = 2;
constexpr int k_interrupted = 130;

/// `moldlight PART` stands for `moldlight view PART`.
void insert_default_command(const CLI::App& program, std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    if (command->get_name() == arguments.front()) return;
  }
  // A mistyped command is not to open a window.
  const std::filesystem::path file(arguments.front());
  std::error_code ignored;
  const bool names_a_file =
      std::filesystem::exists(file, ignored) || file.has_extension() || file.has_parent_path();
  if (!names_a_file) {
    throw UsageError(arguments.front() +
                     ": there is no such command or file; moldlight --help lists the commands");
  }
  arguments.insert(arguments.begin(), "view");
}

int run_program(std::vector<std::string> arguments, Console& console) {
  CLI::App program(
      "Mold-piece regions of injection-molded parts: what the core forms, what the cavity, and "
      "what is an undercut",
      "moldlight");
  Request request;
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_version_flag("--version", "moldlight " MOLDLIGHT_VERSION, "Print the version and exit");
  program.require_subcommand(1);
  add_info_command(program, request);
  add_classify_command(program, request);
  add_sweep_command(program, request);
  add_view_command(program, request);
  insert_default_command(program, arguments);
  try {
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    const std::string command =
        program.get_subcommands().empty() ? "" : program.get_subcommands().front()->get_name() + " ";
    throw UsageError(std::string(error.what()) + "; see moldlight " + command + "--help");
  }
  console.set_verbosity(request.quiet     ? Verbosity::quiet
                        : request.verbose ? Verbosity::verbose
                                          : Verbosity::normal);
  Progress progress(
      [&console](std::string_view stage, double fraction) { console.progress(stage, fraction); });
  const InterruptGuard guard(progress);
  return request.body(console, progress);
}

}  // namespace

}  // namespace moldlight::cli

int main(int argc, char** argv) {
  using namespace moldlight;
  cli::Console console;
  try {
    return cli::run_program({argv + 1, argv + argc}, console);
  } catch (const Cancelled& cancelled) {
    console.failure(cancelled.what());
    return cli::k_interrupted;
  } catch (const UsageError& error) {
    console.failure(error.what());
    return cli::k_usage;
  } catch (const std::bad_alloc&) {
    console.failure("there is not enough memory; try fewer --samples or a smaller --resolution");
  } catch (const std::exception& error) {
    console.failure(error.what());
  }
  return cli::k_failure;
}
