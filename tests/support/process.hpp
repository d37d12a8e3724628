// Running the program as its users do: arguments in; exit code, stdout and stderr out; time and memory
// bounded.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include <sys/types.h>

namespace moldlight::test {

struct ProcessSettings {
  double time_limit_s = 120.0;                   // killed after that
  std::size_t address_space_limit = 0;           // bytes; 0: none. Not set under the address sanitizer
  std::size_t file_size_limit = 0;               // bytes; 0: none
  std::vector<std::string> environment;          // "NAME=value", in addition to ours
  std::vector<std::string> removed_environment;  // names
  std::string folder;                            // to run in; empty: ours
  std::vector<int> descriptors;                  // of ours, which it has as 3, 4 …
};

struct ProcessResult {
  int exit_code = -1;  // 128 + signal where a signal ended it
  bool timed_out = false;
  std::string out, err;
  double processor_s = 0.0;     // of all its threads, and of the programs that it started and waited for
  std::size_t peak_memory = 0;  // resident bytes

  [[nodiscard]] std::size_t error_lines() const;
};

/// Programs that it has started and that have not ended.
[[nodiscard]] std::vector<pid_t> children_of(pid_t program);
/// Processor time of a running program so far, of all its threads and of what it has started and still runs,
/// seconds; 0 for one that has ended.
[[nodiscard]] double processor_seconds(pid_t program);

/// A running program; finish() or the destructor ends it.
class Process {
 public:
  Process(const std::vector<std::string>& arguments, const ProcessSettings& settings);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// False when the program ends, or its time limit passes, before stderr holds the text.
  [[nodiscard]] bool wait_for_error_text(const std::string& text);
  /// The same for stdout.
  [[nodiscard]] bool wait_for_output_text(const std::string& text);
  /// What it has written so far, as far as it was waited for.
  [[nodiscard]] const std::string& output() const { return result_.out; }
  [[nodiscard]] pid_t id() const { return pid_; }
  void send_signal(int signal) const;
  [[nodiscard]] ProcessResult finish();

 private:
  /// Takes what the program has written; false once both pipes are closed or the time is up.
  bool pump();
  void close_pipes();

  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;
  double time_limit_s_;
  std::chrono::steady_clock::time_point start_;
  ProcessResult result_;
};

/// Runs the moldlight of this build to its end.
[[nodiscard]] ProcessResult run_moldlight(std::vector<std::string> arguments,
                                          const ProcessSettings& settings = {});

/// True where sanitizers slow the program down and take memory of their own.
[[nodiscard]] bool built_with_sanitizers();

}  // namespace moldlight::test
