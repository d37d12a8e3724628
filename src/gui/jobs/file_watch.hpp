// Watches one file for changes, on a thread that sleeps in between: the window itself need not wake up.
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace moldlight::gui {

class FileWatch {
 public:
  /// `changed` is called from the watch's thread when the file was changed and has come to rest.
  explicit FileWatch(std::function<void()> changed, double interval_s = 1.0);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Watches this file from its present state on; an empty path watches nothing.
  void watch(const std::filesystem::path& file);
  /// True once after each change.
  [[nodiscard]] bool take() { return changed_.exchange(false); }

 private:
  void run();
  void look();

  const std::function<void()> notify_;
  const double interval_s_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::filesystem::path file_;
  std::optional<std::filesystem::file_time_type> seen_, changing_;
  bool ending_ = false;
  std::atomic<bool> changed_ = false;
  std::thread thread_;
};

}  // namespace moldlight::gui
