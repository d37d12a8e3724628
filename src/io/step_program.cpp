#include "io/step_program.hpp"

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
#include <sys/wait.h>

#include "base/error.hpp"
#include "base/own_files.hpp"
#include "io/file_contents.hpp"
#include "io/step_labels.hpp"

extern char** environ;

namespace moldlight {

namespace {

constexpr int k_poll_ms = 50;

/// Ends the child with the scope: no way out leaves it running or unwaited for.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  ~Child() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      wait();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void kill() const { ::kill(pid_, SIGKILL); }
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

 private:
  pid_t pid_;
};

/// The same under a number above those that the child uses, lest one is laid over another.
Descriptor above_the_childs(Descriptor low) {
  return Descriptor(low.number() < 0 ? -1
                                     : ::fcntl(low.number(), F_DUPFD_CLOEXEC, k_step_labels_descriptor + 1));
}

struct ChildResult {
  std::string bytes;  // what it wrote to the descriptor
  int exit_code = 0;
  int signal = 0;  // that ended it; 0 for none
  bool timed_out = false;
  bool too_long = false;  // it wrote more than it may
};

struct ChildCommand {
  std::string program;  // path
  std::vector<std::string> arguments;
  int file = -1;                 // open; the child finds it at k_step_file_descriptor
  int labels = -1;               // and this, where there is one, at k_step_labels_descriptor
  std::uint64_t most_bytes = 0;  // that it may hand back
  std::chrono::seconds time_limit{60};
};

pid_t start(const ChildCommand& command, int writing_end) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, writing_end, k_step_result_descriptor);
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

/// Runs the program with its standard streams closed off, until it ends, `time_limit` is over or `progress`
/// is cancelled (throws Cancelled). None where it cannot be started, for the reason in errno.
std::optional<ChildResult> run_child(const ChildCommand& command, const Progress& progress) {
  Pipe pipe;
  pipe.writing = above_the_childs(std::move(pipe.writing));
  if (pipe.writing.number() < 0) return std::nullopt;
  const pid_t pid = start(command, pipe.writing.number());
  if (pid < 0) return std::nullopt;
  Child child(pid);
  pipe.writing.close();

  ChildResult result;
  const auto deadline = std::chrono::steady_clock::now() + command.time_limit;
  std::vector<char> chunk(std::size_t{1} << 16);
  while (true) {
    progress.report("reading", 0.5);
    if (std::chrono::steady_clock::now() > deadline) {
      result.timed_out = true;
      child.kill();
      break;
    }
    pollfd waiting = {pipe.reading.number(), POLLIN, 0};
    if (::poll(&waiting, 1, k_poll_ms) <= 0) continue;
    const ssize_t got = ::read(pipe.reading.number(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    if (result.bytes.size() + static_cast<std::size_t>(got) > command.most_bytes) {
      result.too_long = true;
      child.kill();
      break;
    }
    result.bytes.append(chunk.data(), static_cast<std::size_t>(got));
  }
  const int status = child.wait();
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return result;
}

constexpr std::uint64_t k_base_memory_bytes = std::uint64_t{3} << 30;
constexpr std::uint64_t k_memory_bytes_a_byte = 100;
constexpr std::chrono::seconds k_base_time{120};
constexpr std::uint64_t k_bytes_a_second = 50'000;

[[noreturn]] void fail_for_signal(const ReadContext& context, int signal) {
  if (signal == SIGINT || signal == SIGTERM) throw Cancelled();  // went to both programs
  const bool limit = signal == SIGKILL || signal == SIGXCPU;
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

std::string run_step_program(const ReadContext& context, const StepTask& task) {
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
  const Descriptor labels = task.labels.empty() ? Descriptor() : above_the_childs(file_of(task.labels));
  if (!task.labels.empty() && labels.number() < 0)
    context.fail("", "cannot be split: {}", std::strerror(errno));
  ChildCommand command;
  command.program = *program;
  command.file = file.number();
  command.labels = labels.number();
  command.most_bytes = task.most_bytes;
  command.time_limit = k_base_time + std::chrono::seconds(task.file_bytes / k_bytes_a_second);
  command.arguments = {fmt::format("{}", context.options.linear_deflection),
                       fmt::format("{}", context.options.angular_deflection_deg),
                       std::to_string(context.options.max_facets),
                       std::to_string(k_base_memory_bytes + k_memory_bytes_a_byte * task.file_bytes),
                       task.format,
                       task.labels.empty() ? "read" : "write"};
  const auto child = run_child(command, context.progress);
  if (!child) {
    context.fail("", "cannot be read: {} does not start ({}); allow more processes and memory", *program,
                 std::strerror(errno));
  }
  if (child->timed_out) {
    context.fail("", "takes more than {} s to read; coarsen the deflection or export the part as STL",
                 command.time_limit.count());
  }
  if (child->too_long) context.fail("", "{}", k_step_breaks);
  if (child->signal != 0) fail_for_signal(context, child->signal);
  if (child->exit_code != 0) {
    context.fail("", "cannot be read: {} ends with exit code {}; it may need more memory than is allowed",
                 *program, child->exit_code);
  }
  return child->bytes;
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
