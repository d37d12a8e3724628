#include "io/step_program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include "base/error.hpp"
#include "base/own_files.hpp"
#include "io/file_contents.hpp"
#include "io/step_labels.hpp"

extern char** environ;

namespace moldlight {

namespace {

constexpr int k_poll_ms = 50;

/// The same under a number above those that the child uses, lest one is laid over another.
Descriptor above_the_childs(Descriptor low) {
  return Descriptor(low.number() < 0 ? -1
                                     : ::fcntl(low.number(), F_DUPFD_CLOEXEC, k_step_labels_descriptor + 1));
}

struct ChildCommand {
  std::string program;  // path
  std::vector<std::string> arguments;
  int answers = -1;  // the child finds it at k_step_result_descriptor
  int file = -1;     // and this at k_step_file_descriptor
  int labels = -1;   // and this, where there is one, at k_step_labels_descriptor
};

/// With its standard streams closed off; -1 where it cannot be started, for the reason in errno.
pid_t started(const ChildCommand& command) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, command.answers, k_step_result_descriptor);
  posix_spawn_file_actions_adddup2(&actions, command.file, k_step_file_descriptor);
  if (command.labels >= 0)
    posix_spawn_file_actions_adddup2(&actions, command.labels, k_step_labels_descriptor);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  std::vector<std::string> words = {command.program};
  words.insert(words.end(), command.arguments.begin(), command.arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t pid = -1;
  const int error = ::posix_spawn(&pid, command.program.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return pid;
  errno = error;
  return -1;
}

constexpr std::uint64_t k_base_memory_bytes = std::uint64_t{3} << 30;
constexpr std::uint64_t k_memory_bytes_a_byte = 100;
constexpr std::chrono::seconds k_base_time{120};
constexpr std::uint64_t k_bytes_a_second = 50'000;

/// OpenCASCADE does not survive everywhere that it gets none.
bool has_little_memory() {
  constexpr rlim_t k_little = rlim_t{1} << 30;
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < k_little;
}

[[noreturn]] void fail_for_signal(const ReadContext& context, int signal) {
  if (signal == SIGINT || signal == SIGTERM) throw Cancelled();  // went to both programs
  const bool limit = signal == SIGKILL || signal == SIGXCPU || has_little_memory();
  context.fail("", "{} (signal {}); {} export the part as STL",
               limit ? "cannot be read within the system's limits of memory and time"
                     : "breaks the STEP reader OpenCASCADE",
               signal, limit ? "raise them, coarsen the deflection or" : "repair it in the CAD program or");
}

/// Bytes as a file that has no name.
Descriptor file_of(std::string_view bytes) {
  Descriptor file(::memfd_create("part", MFD_CLOEXEC));
  for (std::string_view left = bytes; file.number() >= 0 && !left.empty();) {
    const ssize_t done = ::write(file.number(), left.data(), left.size());
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return {};
    left.remove_prefix(static_cast<std::size_t>(done));
  }
  if (file.number() >= 0) ::lseek(file.number(), 0, SEEK_SET);
  return file;
}

}  // namespace

void StepProgram::start(const ReadContext& context, const StepTask& task) {
  const auto program = step_reading_program();
  if (!program) {
    context.fail("",
                 "is a {} file, and this build has no STEP support (the program moldlight-step is "
                 "missing); export the part as STL",
                 task.format);
  }
  const Descriptor file =
      above_the_childs(task.from_memory ? file_of(context.bytes())
                                        : Descriptor(::open(context.path.c_str(), O_RDONLY | O_CLOEXEC)));
  if (file.number() < 0) context.fail("", "cannot be opened again: {}", std::strerror(errno));
  end();
  path_ = *program;
  file_bytes_ = task.file_bytes;
  limit_time(task.file_bytes);
  // Labels have as much memory as the file.
  const std::uint64_t memory_bytes =
      k_base_memory_bytes + (task.stays ? 2 : 1) * k_memory_bytes_a_byte * task.file_bytes;
  Pipe pipe;
  pipe.writing = above_the_childs(std::move(pipe.writing));
  std::array<int, 2> ends = {-1, -1};
  const bool made = !task.stays || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0;
  const Descriptor childs = above_the_childs(Descriptor(ends[1]));
  labels_ = Descriptor(ends[0]);
  if (made && pipe.writing.number() >= 0 && (!task.stays || childs.number() >= 0)) {
    pid_ = started({.program = path_,
                    .arguments = {fmt::format("{}", context.options.linear_deflection),
                                  fmt::format("{}", context.options.angular_deflection_deg),
                                  std::to_string(context.options.max_facets), std::to_string(memory_bytes),
                                  task.format, task.stays ? "stay" : "read"},
                    .answers = pipe.writing.number(),
                    .file = file.number(),
                    .labels = childs.number()});
  }
  if (!running()) {
    context.fail("", "cannot be read: {} does not start ({}); allow more processes and memory", path_,
                 std::strerror(errno));
  }
  answers_ = std::move(pipe.reading);
}

void StepProgram::ask(const ReadContext& context, std::string_view labels) {
  stage_ = "writing";
  limit_time(file_bytes_ + labels.size());
  while (!labels.empty()) {
    wait_for(context, labels_.number(), POLLOUT);
    const ssize_t sent = ::send(labels_.number(), labels.data(), labels.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno != EINTR && errno != EAGAIN) break;  // answer() finds out why
    labels.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
  }
  labels_.close();
}

std::string StepProgram::answer(const ReadContext& context, std::uint64_t most_bytes) {
  std::string bytes;
  std::optional<std::uint64_t> length;
  std::vector<char> chunk(std::size_t{1} << 16);
  while (!length || bytes.size() < *length) {
    wait_for(context, answers_.number(), POLLIN);
    const std::size_t missing = length ? *length - bytes.size() : sizeof *length - bytes.size();
    const ssize_t got = ::read(answers_.number(), chunk.data(), std::min(missing, chunk.size()));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail_for_end(context);
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
    if (length || bytes.size() < sizeof *length) continue;
    std::memcpy(&length.emplace(), bytes.data(), sizeof *length);
    bytes.clear();
    if (*length > most_bytes) context.fail("", "{}", k_step_breaks);
  }
  return bytes;
}

void StepProgram::wait_for(const ReadContext& context, int descriptor, short event) {
  for (pollfd waiting = {descriptor, event, 0}; true;) {
    context.progress.report(stage_, 0.5);
    if (std::chrono::steady_clock::now() > deadline_) {
      context.fail("", "takes more than {} s to read; coarsen the deflection or export the part as STL",
                   time_limit_.count());
    }
    if (::poll(&waiting, 1, k_poll_ms) > 0) return;
  }
}

void StepProgram::limit_time(std::uint64_t bytes) {
  time_limit_ = k_base_time + std::chrono::seconds(bytes / k_bytes_a_second);
  deadline_ = std::chrono::steady_clock::now() + time_limit_;
}

void StepProgram::fail_for_end(const ReadContext& context) {
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFSIGNALED(status)) fail_for_signal(context, WTERMSIG(status));
  if (WEXITSTATUS(status) == 0) context.fail("", "{}", k_step_breaks);
  context.fail("", "cannot be read: {} ends with exit code {}; it may need more memory than is allowed",
               path_, WEXITSTATUS(status));
}

void StepProgram::end() {
  if (!running()) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
}

std::optional<std::string> step_reading_program() {
  // Beside the program or the module, in a build folder, or installed with either.
  constexpr const char* k_places[] = {
      "moldlight-step",
      "../libexec/moldlight/moldlight-step",
      "../../bin/moldlight-step",
      "../../../../libexec/moldlight/moldlight-step",
  };
  const auto program = own_file(k_places);
  if (!program || ::access(program->c_str(), X_OK) != 0) return std::nullopt;
  return program->string();
}

}  // namespace moldlight
