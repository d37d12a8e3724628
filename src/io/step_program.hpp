// Runs moldlight-step, in which OpenCASCADE reads and writes, within bounds of time, memory and output.
#pragma once

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "io/file_contents.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace moldlight {

struct StepTask {
  const char* format = "STEP";  // or "IGES": of the part file
  std::uint64_t file_bytes = 0;
  bool from_memory = false;  // the part file is the context's bytes, else it is opened anew
  bool stays = false;        // it can be asked for more once it has read
};

/// One run of moldlight-step, which ends with this value: no way out leaves it running or unwaited for.
class StepProgram {
 public:
  StepProgram() = default;
  ~StepProgram() { end(); }
  StepProgram(const StepProgram&) = delete;
  StepProgram& operator=(const StepProgram&) = delete;

  /// Has it read a part. Throws FileError where it is missing or does not start.
  void start(const ReadContext& context, const StepTask& task);
  /// Hands it StepLabels, as bytes, once it has read and stays. Throws Cancelled.
  void ask(const ReadContext& context, std::string_view labels);
  /// The StepResult, or after ask() the StepWritten, as bytes that are not trusted, `most_bytes` of them at
  /// most. Throws FileError where it breaks, Cancelled.
  [[nodiscard]] std::string answer(const ReadContext& context, std::uint64_t most_bytes);

  [[nodiscard]] bool running() const { return pid_ > 0; }
  [[nodiscard]] std::uint64_t file_bytes() const { return file_bytes_; }

 private:
  /// Waits until the descriptor can be written to, or read from. Throws as answer().
  void wait_for(const ReadContext& context, int descriptor, short event);
  void limit_time(std::uint64_t bytes);
  [[noreturn]] void fail_for_end(const ReadContext& context);
  void end();

  pid_t pid_ = -1;
  Descriptor answers_, labels_;
  std::uint64_t file_bytes_ = 0;
  std::string path_;  // of the program
  std::string_view stage_ = "reading";
  std::chrono::seconds time_limit_{0};
  std::chrono::steady_clock::time_point deadline_;
};

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
