// Progress and cancelling of long work. The worker reports, the owner watches from any thread.
#pragma once

#include <atomic>
#include <functional>
#include <string_view>
#include <utility>

#include "base/error.hpp"

namespace moldlight {

/// Shared between the thread that works and the one that waits. Default-constructed: never cancelled, nobody
/// listens.
class Progress {
 public:
  /// Called from the working thread with a stage ("reading", "welding", …) and its done share in [0, 1].
  using Listener = std::function<void(std::string_view stage, double fraction)>;

  Progress() = default;
  explicit Progress(Listener listener) : listener_(std::move(listener)) {}
  /// Is cancelled with `parent`, which must outlive it, and informs nobody: for work whose stages the user is
  /// not to see.
  explicit Progress(const Progress* parent) : parent_(parent) {}

  /// Throws Cancelled once cancel() was called; call it at least every 50 ms of work.
  void report(std::string_view stage, double fraction) const {
    if (cancelled()) throw Cancelled();
    if (listener_) listener_(stage, fraction);
  }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const {
    return cancelled_.load(std::memory_order_relaxed) || (parent_ != nullptr && parent_->cancelled());
  }

 private:
  Listener listener_;
  const Progress* parent_ = nullptr;
  std::atomic<bool> cancelled_ = false;
};

}  // namespace moldlight
