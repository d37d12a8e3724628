// Meaning of the program's exit codes: one table, for the manual page and for all that ends with one.
#pragma once

#include <array>
#include <string_view>

namespace moldlight {

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
