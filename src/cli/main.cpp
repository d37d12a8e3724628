// The program: reads the command line, runs the command, and turns every failure into one line and an exit
// code.
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/similar_word.hpp"
#include "base/threads.hpp"
#include "cli/flags.hpp"
#include "cli/help.hpp"

namespace moldlight::cli {

namespace {

// A signal handler can reach nothing but what is global.
std::atomic<Progress*> interrupted_progress = nullptr;
static_assert(std::atomic<Progress*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void cancel_progress(int) {
  if (Progress* progress = interrupted_progress.load()) progress->cancel();
}

/// Ctrl-C and a polite kill end the work at its next report of progress, so that nothing is left half done:
/// while it lives, SIGINT and SIGTERM cancel the progress; a second signal ends the program at once. One at a
/// time.
class InterruptGuard {
 public:
  explicit InterruptGuard(Progress& progress) {
    CHECK(interrupted_progress.exchange(&progress) == nullptr);
    struct sigaction action = {};
    action.sa_handler = cancel_progress;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM}) {
      struct sigaction former = {};
      // Who started the program may want it to outlive an interrupt (nohup, a background job).
      if (sigaction(signal, nullptr, &former) == 0 && former.sa_handler != SIG_IGN)
        sigaction(signal, &action, nullptr);
    }
  }
  ~InterruptGuard() {
    for (const int signal : {SIGINT, SIGTERM}) {
      struct sigaction former = {};
      if (sigaction(signal, nullptr, &former) == 0 && former.sa_handler == cancel_progress)
        std::signal(signal, SIG_DFL);
    }
    interrupted_progress.store(nullptr);
  }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// `moldlight PART` stands for `moldlight view PART`, and so does `moldlight` alone, which asks for one;
/// `moldlight help sweep` for `moldlight sweep --help`.
void insert_default_command(const CLI::App& program, std::vector<std::string>& arguments) {
  if (arguments.empty()) arguments = {"view"};
  if (arguments.front() == "version") arguments.front() = "--version";
  if (arguments.front() == "help") {
    std::rotate(arguments.begin(), arguments.begin() + 1, arguments.end());
    arguments.back() = "--help";
  }
  if (arguments.front().starts_with('-')) return;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    if (command->get_name() != arguments.front()) continue;
    const std::vector<std::string> parts = command_names(*command);
    if (parts.empty() || arguments.size() == 1 || arguments[1].starts_with('-') ||
        std::ranges::count(parts, arguments[1]) > 0)
      return;
    throw UsageError(
        fmt::format("{} {}: no such command{}", arguments[0], one_line(arguments[1]),
                    did_you_mean(arguments[1], parts,
                                 fmt::format("moldlight {} --help lists the commands", arguments[0]))));
  }
  // A mistyped command is not to open a window.
  const std::filesystem::path file(arguments.front());
  std::error_code ignored;
  const bool names_a_file =
      std::filesystem::exists(file, ignored) || file.has_extension() || file.has_parent_path();
  if (!names_a_file) {
    throw UsageError(
        arguments.front() + ": no such command or file" +
        did_you_mean(arguments.front(), command_names(program), "moldlight --help lists the commands"));
  }
  arguments.insert(arguments.begin(), "view");
}

int run_program(std::vector<std::string> arguments, Console& console) {
  CLI::App program("Mold-piece regions of injection-molded parts: core, cavity, both and undercut",
                   "moldlight");
  Request request;
  program.formatter(std::make_shared<HelpFormatter>());
  program.set_version_flag("--version", "moldlight " MOLDLIGHT_VERSION, "Print the version and exit");
  program.require_subcommand(1);
  for (const CommandRow& command : commands()) command.add(program, request);
  arrange_help(program);
  insert_default_command(program, arguments);
  request.words = arguments;
  try {
    program.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    const int code = program.exit(help, text);
    console.result(text.str());
    return code;
  } catch (const CLI::ParseError& error) {
    throw UsageError(fault_text(program, error));
  }
  console.set_verbosity(request.quiet     ? Verbosity::quiet
                        : request.verbose ? Verbosity::verbose
                                          : Verbosity::normal);
  Progress progress(
      [&console](std::string_view stage, double fraction) { console.progress(stage, fraction); });
  const InterruptGuard guard(progress);
  // TBB counts on a thread a core, and fails where it cannot have them beside those of a sweep.
  const int cores = usable_cores(), wanted = 2 * cores + 1;
  const bool alone = cores == 1 || startable_threads(wanted) < wanted;
  // Never taken back: TBB would start its threads then. Volatile, since it is never read, and yet to be
  // found.
  [[maybe_unused]] static const tbb::global_control* volatile k_limit = new tbb::global_control(
      tbb::global_control::max_allowed_parallelism, alone ? 1 : static_cast<std::size_t>(cores));
  const int code = request.body(console, progress);
  console.log_stages();
  return code;
}

}  // namespace

}  // namespace moldlight::cli

int main(int argc, char** argv) {
  using namespace moldlight;
  // A file beyond the limit of size is to be an error of writing, whose temporary file is cleared away.
  std::signal(SIGXFSZ, SIG_IGN);
  cli::Console console;
  try {
    return cli::run_program({argv + 1, argv + argc}, console);
  } catch (const Cancelled& cancelled) {
    console.failure(cancelled.what());
    return k_interrupted;
  } catch (const UsageError& error) {
    console.failure(error.what());
    return k_usage;
  } catch (const std::exception& error) {
    console.failure(cli::failure_text(error));
  }
  return k_failure;
}
