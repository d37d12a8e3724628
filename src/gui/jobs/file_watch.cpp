#include "gui/jobs/file_watch.hpp"

#include <chrono>
#include <utility>

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

std::optional<fs::file_time_type> time_of(const fs::path& path) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(path, error);
  return error ? std::nullopt : std::optional(time);
}

}  // namespace

FileWatch::FileWatch(std::function<void()> changed, double interval_s)
    : notify_(std::move(changed)), interval_s_(interval_s), thread_([this] { run(); }) {}

FileWatch::~FileWatch() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void FileWatch::watch(const fs::path& file) {
  {
    const std::lock_guard lock(mutex_);
    file_ = file;
    seen_ = time_of(file);
    changing_.reset();
    changed_ = false;
  }
  wake_.notify_all();
}

void FileWatch::run() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    if (file_.empty()) {
      wake_.wait(lock);
    } else {
      wake_.wait_for(lock, std::chrono::duration<double>(interval_s_));
      look();
    }
  }
}

void FileWatch::look() {
  const auto time = time_of(file_);
  if (!time || time == seen_) {
    changing_.reset();
  } else if (changing_ != time) {
    changing_ = time;  // another program may still be writing
  } else {
    seen_ = time;
    changing_.reset();
    changed_ = true;
    notify_();
  }
}

}  // namespace moldlight::gui
