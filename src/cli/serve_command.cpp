// moldlight serve: answers the questions of another program about the parts of a folder, until the input
// ends.
#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "cli/flags.hpp"
#include "cli/serve_tools.hpp"
#include "io/file_contents.hpp"
#include "serve/lines.hpp"
#include "serve/session.hpp"

namespace moldlight::cli {

namespace {

constexpr std::size_t k_most_message_bytes = std::size_t{1} << 20U;

struct ServeFlags {
  bool stdio = false;  // the one way so far
  std::string folder;
};

constexpr std::string_view k_instructions =
    "moldlight answers questions about injection-molded parts: which surface the core and the cavity form, "
    "which is an undercut, how the mold should open, and which side actions it needs. Paths are from "
    "the folder that is served. Give unit, such as mm, for files that state none, such as STL. "
    "Begin with recommend_direction, or with classify along a direction that the user names. State a figure "
    "with its unit, and with its uncertainty where there is one.";

/// Hands lines to the session until the input ends or nobody reads the answers.
void converse(serve::Session& session, const serve::LineWriter& writer, const Progress& progress) {
  using Got = serve::LineReader::Got;
  serve::LineReader reader(STDIN_FILENO, k_most_message_bytes);
  std::string line;
  while (!progress.cancelled() && !writer.broken()) {
    const Got got = reader.next(line);
    if (got == Got::line) session.take(line);
    if (got == Got::too_long)
      session.refuse_message(fmt::format("a message has more than {} bytes", k_most_message_bytes));
    if (got == Got::end) break;
  }
  // What was asked is answered, as long as somebody listens.
  while (!session.idle() && !progress.cancelled() && writer.is_read())
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

int run(const ServeFlags& flags, Console&, const Progress& progress) {
  serve::Server server{.name = "moldlight",
                       .version = MOLDLIGHT_VERSION,
                       .instructions = std::string(k_instructions),
                       .tools = serve_tools(flags.folder)};
  // Whatever else would be printed is no message of the protocol.
  const Descriptor out(::dup(STDOUT_FILENO));
  if (out.number() < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw Error("stdout: cannot be kept for answers");
  std::signal(SIGPIPE, SIG_IGN);
  serve::LineWriter writer(out.number(), [&progress] { return progress.cancelled(); });
  serve::Session session(std::move(server),
                         [&writer](std::string message) { writer.write(std::move(message)); });
  converse(session, writer, progress);
  if (writer.broken() && !progress.cancelled()) throw Error("stdout: nobody reads the answers");
  return 0;
}

void add_serve_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "serve", "Answer another program's questions about the parts of a folder (Model Context Protocol)");
  const auto flags = std::make_shared<ServeFlags>();
  command->add_flag("--stdio", flags->stdio, "Read messages from stdin and write answers to stdout")
      ->required();
  add_file_flag(*command, flags->folder,
                {"--folder", "DIR", "Answer about part files in this folder, and open no others"})
      ->required();
  set_work(*command, request, flags, run);
}

const RegisteredCommand k_serve_command({85, "serve", add_serve_command});

}  // namespace

}  // namespace moldlight::cli
