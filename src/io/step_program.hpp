// Runs moldlight-step, in which OpenCASCADE reads and writes, within bounds of time, memory and output.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

struct StepTask {
  const char* format = "STEP";  // or "IGES": of the part file
  std::uint64_t file_bytes = 0;
  bool from_memory = false;      // the part file is the context's bytes, else it is opened anew
  std::string_view labels = {};  // StepLabels, to have the part written; empty: it is read
  std::uint64_t most_bytes = 0;  // that may come back
};

/// The StepResult or StepWritten as bytes, not trusted. Throws FileError for a program that is missing or
/// breaks, Cancelled.
[[nodiscard]] std::string run_step_program(const ReadContext& context, const StepTask& task);

/// What is said of a file where what comes back makes no sense.
inline constexpr const char* k_step_breaks =
    "breaks the STEP reader OpenCASCADE; repair it in the CAD program or export STL";

/// What the program handed back: StepResult or StepWritten. Throws FileError for bytes that are none, and for
/// the error that it reports.
template <typename Answer>
[[nodiscard]] Answer step_answer(const ReadContext& context, std::string_view bytes) {
  Answer answer;
  try {
    answer = Answer::from_bytes(bytes);
  } catch (const std::out_of_range&) {
    context.fail("", "{}", k_step_breaks);
  }
  if (!answer.error.empty()) context.fail("", "{}", clean_name(answer.error));
  return answer;
}

}  // namespace moldlight
