// Threads where the system allows few.
#pragma once

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace moldlight {

/// How many of the wanted threads could be started at once, beside those that run; tries it.
[[nodiscard]] inline int startable_threads(int wanted) {
  std::mutex mutex;
  std::condition_variable ended;
  bool end = false;
  std::vector<std::jthread> threads;
  try {
    while (static_cast<int>(threads.size()) < wanted) {
      threads.emplace_back([&] {
        std::unique_lock lock(mutex);
        ended.wait(lock, [&] { return end; });
      });
    }
  } catch (const std::system_error&) {  // no more than these
  }
  {
    const std::lock_guard lock(mutex);
    end = true;
  }
  ended.notify_all();
  return static_cast<int>(threads.size());
}

}  // namespace moldlight
