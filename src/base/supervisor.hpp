// A process that does the work, and its parent that lives on when that crashes: it begins the work anew, and
// hands over what the crashed process had noted.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace moldlight {

/// How the process that worked ended without being asked to.
struct WorkerDeath {
  std::string cause;   // "segmentation fault"
  std::string record;  // what it had noted last, as WorkRecord has it
};

/// A text that outlives the process which writes it.
class WorkRecord {
 public:
  /// Throws Error where there is no memory to share.
  WorkRecord();
  ~WorkRecord();
  WorkRecord(const WorkRecord&) = delete;
  WorkRecord& operator=(const WorkRecord&) = delete;

  static constexpr std::size_t k_most_bytes = 16384;

  /// Replaces the text; what is longer than k_most_bytes is not taken. A process that dies within leaves the
  /// former text.
  void write(std::string_view text);
  [[nodiscard]] std::string text() const;

 private:
  struct Shared;
  Shared* shared_;
};

/// Where supervise() returns.
struct Supervised {
  /// In the parent, once all is over: the code with which the child ended. None in a child, which goes on to
  /// do the work.
  std::optional<int> exit_code;
  /// In a child: what its forerunner died of.
  std::optional<WorkerDeath> forerunner;
};

/// Forks; the child returns at once and works, with a group of its own. The parent hands SIGINT, SIGTERM and
/// SIGHUP on to it, and forks again after each death by a signal that nobody asked for. After two in a row
/// that come within 10 s of the child's beginning it gives up: throws Error that says so. Called while the
/// process has no other thread. Throws Error where no process can be started.
[[nodiscard]] Supervised supervise(WorkRecord& record);

}  // namespace moldlight
