// The columns of the table of directions: what they show and how they sort.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gui/app_state.hpp"

namespace moldlight::gui {

struct SweepColumn {
  std::string_view name, help;
  float width = 0.0F;  // layout units; 0: what is left
  bool right = true;   // set to the right
  std::string (*text)(const AppState& state, const SweepCandidate& candidate);
  double (*key)(const SweepCandidate& candidate);  // null: cannot be sorted by
};
[[nodiscard]] std::span<const SweepColumn> sweep_columns();

/// The order of a result's candidates in the table; at first by rank.
class SweepOrder {
 public:
  /// Sorts the candidates of a result that is not the one of the last call; true if it was not.
  bool follow(std::shared_ptr<const SweepResult> result);
  /// Sorts by a column, or the other way round where it is the present one. Needs a result.
  void sort_by(std::size_t column);

  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }
  [[nodiscard]] std::size_t column() const { return column_; }
  [[nodiscard]] bool descending() const { return descending_; }

 private:
  void sort();

  std::shared_ptr<const SweepResult> result_;  // kept, so that no later one has its address
  std::vector<std::size_t> rows_;
  std::size_t column_ = 1;
  bool descending_ = false;
};

/// How far the undercut area may be off, in two digits as `classify` writes it: rounding alone shows, too.
[[nodiscard]] std::string uncertainty_text(const Classification& result);
/// Whether another candidate of the result is in the same tie group.
[[nodiscard]] bool ties(const SweepResult& result, const SweepCandidate& candidate);
/// "axis of 4 cylinders or cones, 3.1 % of the surface"; the first of the sources, or all of them, a line
/// each.
[[nodiscard]] std::string first_reason(const SweepCandidate& candidate);
[[nodiscard]] std::string all_reasons(const SweepCandidate& candidate);

}  // namespace moldlight::gui
