// Threads where the system allows few, or whoever started the program does.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/numbers.hpp"

namespace moldlight {

/// The environment variable by which a program that starts many of ours sets for each how many threads it may
/// compute with.
inline constexpr const char* k_threads_variable = "MOLDLIGHT_THREADS";

/// Cores that this process may compute with, at least 1.
[[nodiscard]] inline int usable_cores() {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const char* given = std::getenv(k_threads_variable);
  const auto allowed = number_from<int>(given != nullptr ? given : "");
  return allowed && *allowed > 0 ? std::min(cores, *allowed) : cores;
}

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
