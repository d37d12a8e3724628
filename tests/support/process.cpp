#include "support/process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace moldlight::test {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return ends;
}

[[noreturn]] void become(const std::vector<std::string>& arguments, const ProcessSettings& settings) {
  if (settings.address_space_limit > 0 && !built_with_sanitizers()) {
    const rlimit limit{settings.address_space_limit, settings.address_space_limit};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  if (settings.file_size_limit > 0) {
    const rlimit limit{settings.file_size_limit, settings.file_size_limit};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  // Away from the numbers that they get, first.
  std::vector<int> aside;
  for (const int descriptor : settings.descriptors) aside.push_back(::fcntl(descriptor, F_DUPFD_CLOEXEC, 64));
  for (std::size_t k = 0; k < aside.size(); ++k) ::dup2(aside[k], 3 + static_cast<int>(k));
  for (const std::string& name : settings.removed_environment) ::unsetenv(name.c_str());
  for (const std::string& entry : settings.environment) {
    const std::size_t equals = entry.find('=');
    ::setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
  }
  if (!settings.folder.empty() && ::chdir(settings.folder.c_str()) != 0) ::_exit(127);
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

/// Appends what can be read; false at the end of the pipe.
bool read_some(int descriptor, std::string& text) {
  std::array<char, 65536> buffer;
  const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

}  // namespace

std::vector<pid_t> children_of(pid_t program) {
  const std::string id = std::to_string(program);
  std::ifstream list("/proc/" + id + "/task/" + id + "/children");
  return {std::istream_iterator<pid_t>(list), {}};
}

double processor_seconds(pid_t program) {
  std::ifstream stat("/proc/" + std::to_string(program) + "/stat");
  std::string text;
  std::getline(stat, text);
  // After the program's name in brackets: state, then ten numbers, then user and system time in ticks.
  const std::size_t after_name = text.rfind(')');
  if (after_name == std::string::npos) return 0.0;
  std::istringstream fields(text.substr(after_name + 1));
  std::string word;
  double ticks = 0.0;
  for (int field = 3; fields >> word && field <= 15; ++field)
    if (field >= 14) ticks += std::stod(word);
  double seconds = ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
  for (const pid_t child : children_of(program)) seconds += processor_seconds(child);
  return seconds;
}

std::size_t ProcessResult::error_lines() const {
  // A slow machine has time for lines of progress.
  static const std::regex k_progress(R"(^ *[0-9]+ %  .*)");
  std::size_t count = 0;
  std::istringstream lines(err);
  for (std::string line; std::getline(lines, line);) count += std::regex_match(line, k_progress) ? 0 : 1;
  return count;
}

Process::Process(const std::vector<std::string>& arguments, const ProcessSettings& settings)
    : time_limit_s_(settings.time_limit_s), start_(Clock::now()) {
  const auto out = make_pipe(), err = make_pipe();
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("no child process");
  if (pid_ == 0) {
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(out[1], STDOUT_FILENO);
    ::dup2(err[1], STDERR_FILENO);
    become(arguments, settings);
  }
  ::close(nothing);
  ::close(out[1]);
  ::close(err[1]);
  out_ = out[0];
  err_ = err[0];
}

Process::~Process() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  close_pipes();
}

void Process::close_pipes() {
  for (int* descriptor : {&out_, &err_}) {
    if (*descriptor >= 0) ::close(*descriptor);
    *descriptor = -1;
  }
}

bool Process::pump() {
  std::array<pollfd, 2> waits = {pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
  const double left_s = time_limit_s_ - seconds_since(start_);
  if (left_s <= 0.0) {
    result_.timed_out = true;
    return false;
  }
  if (::poll(waits.data(), waits.size(), static_cast<int>(1000.0 * left_s) + 1) < 0) return errno == EINTR;
  if (waits[0].revents != 0 && !read_some(out_, result_.out)) {
    ::close(out_);
    out_ = -1;
  }
  if (waits[1].revents != 0 && !read_some(err_, result_.err)) {
    ::close(err_);
    err_ = -1;
  }
  return out_ >= 0 || err_ >= 0;
}

bool Process::wait_for_error_text(const std::string& text) {
  while (result_.err.find(text) == std::string::npos) {
    if (!pump()) return result_.err.find(text) != std::string::npos;
  }
  return true;
}

bool Process::wait_for_output_text(const std::string& text) {
  while (result_.out.find(text) == std::string::npos) {
    if (!pump()) return result_.out.find(text) != std::string::npos;
  }
  return true;
}

void Process::send_signal(int signal) const { ::kill(pid_, signal); }

ProcessResult Process::finish() {
  while (pump()) {
  }
  if (result_.timed_out) ::kill(pid_, SIGKILL);
  int status = 0;
  rusage usage{};
  ::wait4(pid_, &status, 0, &usage);
  pid_ = -1;
  result_.processor_s = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  result_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result_.peak_memory = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  close_pipes();
  return std::move(result_);
}

ProcessResult run_moldlight(std::vector<std::string> arguments, const ProcessSettings& settings) {
  arguments.insert(arguments.begin(), MOLDLIGHT_BINARY);
  return Process(arguments, settings).finish();
}

bool built_with_sanitizers() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

}  // namespace moldlight::test
