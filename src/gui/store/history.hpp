// Undo and redo as a history of values: no commands, no inverse operations.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace moldlight::gui {

/// Remembers the values that were settled on. `Value` must compare with ==.
template <typename Value>
class History {
 public:
  explicit History(Value value) : settled_(std::move(value)) {}

  /// Makes `value` the present one; nothing happens if it is already. What was undone is lost. A drag is one
  /// step if this is called when it ends.
  void settle(const Value& value) {
    if (value == settled_) return;
    past_.push_back(std::exchange(settled_, value));
    future_.clear();
    if (past_.size() > k_depth) past_.erase(past_.begin());
  }
  /// Starts afresh.
  void reset(Value value) {
    settled_ = std::move(value);
    past_.clear();
    future_.clear();
  }

  [[nodiscard]] bool can_undo() const { return !past_.empty(); }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  /// The value before the present one, or the present one where there is none.
  const Value& undo() { return step(past_, future_); }
  const Value& redo() { return step(future_, past_); }
  [[nodiscard]] const Value& settled() const { return settled_; }

 private:
  static constexpr std::size_t k_depth = 500;

  const Value& step(std::vector<Value>& from, std::vector<Value>& to) {
    if (!from.empty()) {
      to.push_back(std::exchange(settled_, from.back()));
      from.pop_back();
    }
    return settled_;
  }

  Value settled_;
  std::vector<Value> past_, future_;
};

}  // namespace moldlight::gui
