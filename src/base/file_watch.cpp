#include "base/file_watch.hpp"

#include <chrono>
#include <thread>

namespace moldlight {

namespace fs = std::filesystem;

std::optional<FileWatch::Time> FileWatch::time_of(const fs::path& file) {
  std::error_code error;
  const Time time = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}

void FileWatch::watch(const fs::path& file) {
  file_ = file;
  job_.give_up();
  if (!file.empty()) wait(time_of(file));
}

bool FileWatch::take() {
  const auto outcome = job_.take();
  if (!outcome || !outcome->result) return false;
  wait(*outcome->result);
  return true;
}

void FileWatch::wait(const std::optional<Time>& seen) {
  job_.start([file = file_, seen](const Progress& progress) {
    constexpr std::chrono::milliseconds k_nap(100);
    constexpr int k_naps = 10;  // between two looks
    for (Time changing = Time::min();;) {
      for (int nap = 0; nap < k_naps; ++nap) {
        progress.report({}, 0.0);
        std::this_thread::sleep_for(k_nap);
      }
      const auto time = time_of(file);
      if (!time || time == seen) {
        changing = Time::min();
      } else if (changing != *time) {
        changing = *time;  // another program may still be writing
      } else {
        return *time;
      }
    }
  });
}

}  // namespace moldlight
