// Failures of the environment (files, GL, usage). Thrown where they are met, caught once in main, shown as
// one line. Faults of geometry are no errors: they are values in the health report.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace moldlight {

/// A failure that ends the command with exit code 1. The text is one line: what, where, what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A command line that makes no sense: exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read or written; `place` is where in the file ("line 12", "byte 84", "facet 3"), may
/// be empty.
class FileError : public Error {
 public:
  FileError(const std::string& file, const std::string& place, const std::string& what)
      : Error(file + (place.empty() ? "" : ": " + place) + ": " + what) {}
};

/// The user (or a time limit) ended the work: exit code 130.
class Cancelled : public Error {
 public:
  Cancelled() : Error("interrupted") {}
};

inline constexpr int k_failure = 1, k_usage = 2, k_criterion_failed = 3, k_not_proved = 4, k_try_again = 75,
                     k_interrupted = 130;

struct ExitCode {
  int code;
  std::string_view meaning;
};
inline constexpr std::array<ExitCode, 7> k_exit_codes = {{
    {0, "done"},
    {k_failure, "something could not be read, written or found"},
    {k_usage, "the command line is wrong"},
    {k_criterion_failed, "a criterion failed (--fail-on, --fail-if-undercut, --fail-on-error)"},
    {k_not_proved, "the proof is not complete (--fail-unless-proved)"},
    // A full disk, parts that are out of reach, results that are still missing.
    {k_try_again, "parts of a batch are left; run it again"},
    {k_interrupted, "interrupted"},
}};

}  // namespace moldlight
