#include "batch/child_process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "io/descriptor.hpp"

namespace moldlight::batch {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int k_look_ms = 20;
constexpr int k_no_program = 127;
constexpr std::size_t k_most_text = std::size_t{1} << 28;  // bytes; a report is far smaller

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void check_pipe(const Pipe& pipe) {
  if (pipe.reading.number() < 0)
    throw Error(fmt::format("no pipe to a process of a part: {}", std::strerror(errno)));
}

/// Takes what is there; closes the end of the pipe.
void take(Descriptor& reading, std::string& text) {
  std::array<char, 65536> buffer;
  const ssize_t count = ::read(reading.number(), buffer.data(), buffer.size());
  if (count < 0 && errno == EINTR) return;
  if (count <= 0) return reading.close();
  if (text.size() < k_most_text) text.append(buffer.data(), static_cast<std::size_t>(count));
}

/// Resident bytes of a process and those it has started.
std::size_t resident_bytes(pid_t process) {
  static const auto k_page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  std::size_t total_pages = 0, pages = 0;
  std::ifstream memory(fmt::format("/proc/{}/statm", process));
  if (memory >> total_pages >> pages) total_pages = pages;
  std::size_t bytes = total_pages * k_page;
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", process));
  for (pid_t child = 0; children >> child;) bytes += resident_bytes(child);
  return bytes;
}

/// In the child, between fork and exec: system calls alone.
[[noreturn]] void become(char* const* arguments, char* const* environment, const Pipe& out, const Pipe& err,
                         pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(k_no_program);
  // Where memory runs short, the part goes rather than the run.
  if (const int score = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0) {
    static_cast<void>(!::write(score, "1000", 4));
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(out.writing.number(), STDOUT_FILENO);
  ::dup2(err.writing.number(), STDERR_FILENO);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::execve("/proc/self/exe", arguments, environment);
  ::_exit(k_no_program);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environment_with(int threads) {
  std::vector<std::string> environment;
  const std::string beginning = std::string(k_threads_variable) + "=";
  for (char** entry = ::environ; *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with(beginning)) environment.emplace_back(*entry);
  environment.push_back(fmt::format("{}{}", beginning, threads));
  return environment;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                      const Progress& progress) {
  Pipe out, err;
  for (const Pipe* pipe : {&out, &err}) check_pipe(*pipe);
  std::vector<std::string> words = {"moldlight"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environment_with(limits.threads);
  const std::vector<char*> argv = pointers(words), environment = pointers(variables);
  const pid_t parent = ::getpid();
  const auto start = Clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw Error(fmt::format("a part's process cannot be started: {}", std::strerror(errno)));
  if (child == 0) become(argv.data(), environment.data(), out, err, parent);
  out.writing.close();
  err.writing.close();

  ChildResult result;
  const auto end_it = [&](ChildEnd why) {
    if (result.end != ChildEnd::exited) return;
    result.end = why;
    ::kill(-child, SIGKILL);
    ::kill(child, SIGKILL);  // before it has a group of its own
  };
  while (out.reading.number() >= 0 || err.reading.number() >= 0) {
    std::array<pollfd, 2> waits = {pollfd{out.reading.number(), POLLIN, 0},
                                   pollfd{err.reading.number(), POLLIN, 0}};
    ::poll(waits.data(), waits.size(), k_look_ms);
    if (waits[0].revents != 0) take(out.reading, result.out);
    if (waits[1].revents != 0) take(err.reading, result.err);
    if (progress.cancelled()) end_it(ChildEnd::cancelled);
    if (limits.time_s > 0.0 && seconds_since(start) > limits.time_s) end_it(ChildEnd::out_of_time);
    if (limits.memory_bytes > 0 && resident_bytes(child) > limits.memory_bytes)
      end_it(ChildEnd::out_of_memory);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (result.end == ChildEnd::exited && WIFSIGNALED(status)) result.end = ChildEnd::signalled;
  result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  if (result.end == ChildEnd::exited && result.code == k_no_program && result.out.empty() &&
      result.err.empty())
    throw Error("a part's process cannot be started: the program itself is not to be read any more");
  return result;
}

}  // namespace moldlight::batch
