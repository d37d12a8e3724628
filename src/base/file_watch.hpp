// Watches a file for changes by other programs.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "base/job.hpp"

namespace moldlight {

class FileWatch {
 public:
  /// `changed` is called from the watch's thread when the file was changed and has come to rest.
  explicit FileWatch(const std::function<void()>& changed) : job_({.wake = changed}) {}

  /// Watches this file from its present state on; an empty path watches nothing.
  void watch(const std::filesystem::path& file);
  /// True once after each change.
  [[nodiscard]] bool take();

 private:
  using Time = std::filesystem::file_time_type;
  static std::optional<Time> time_of(const std::filesystem::path& file);
  void wait(const std::optional<Time>& seen);

  std::filesystem::path file_;
  Job<Time> job_;  // until the file is another one
};

}  // namespace moldlight
