// Holds work beside the window where it reports, so that it is under way for sure.
#pragma once

#include <condition_variable>
#include <mutex>

namespace moldlight::gui::test {

/// Holds every thread that wakes the window, until released.
class Barrier {
 public:
  void pass() {
    std::unique_lock lock(mutex_);
    passable_.wait(lock, [this] { return open_; });
  }
  void set_open(bool open) {
    {
      const std::lock_guard lock(mutex_);
      open_ = open;
    }
    passable_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable passable_;
  bool open_ = true;
};

}  // namespace moldlight::gui::test
