// The fewest directions that reach samples of a surface: an exact cover search with samples that may be left.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "pieces/bit_set.hpp"

namespace moldlight {

/// Samples of which some may be left over. Groups follow each other; each begins at a multiple of 64.
struct SampleGroup {
  std::size_t first = 0, count = 0;
  std::size_t spare = 0;  // so many may be left
};

struct CoverTask {
  std::span<const SampleGroup> groups;
  std::span<const BitSet> columns;  // the samples that each direction reaches, all of the same size
};

struct CoverChoice {
  std::vector<std::size_t> forced = {};   // columns that are chosen anyway
  std::size_t most = 1;                   // columns in all, at least those forced
  std::vector<std::size_t> without = {};  // columns that are not chosen
  std::size_t most_nodes = 20'000;        // of the search
};

struct DirectionCover {
  std::vector<std::size_t> columns;  // forced ones first; empty where nothing was found
  bool found = false;
  bool complete = true;   // the search came to its end: where nothing was found there is nothing
  std::size_t nodes = 0;  // of the search
};

/// Samples of all groups that none of the columns reaches.
[[nodiscard]] BitSet left_by(const CoverTask& task, std::span<const std::size_t> columns);
/// No group has more of these samples than it may leave.
[[nodiscard]] bool leaves_enough(const CoverTask& task, const BitSet& left);

/// Branches on the open sample that fewest columns reach: one of them is chosen, or the sample is given up
/// and with it all columns that reach it. A branch ends where the columns that reach most, as many as are
/// left to choose, do not reach enough in sum. The same for the same input.
class CoverSearch {
 public:
  /// `allowed` ascend; those that another is no worse than are left out. What the task looks at must outlive
  /// it. Throws Cancelled.
  CoverSearch(const CoverTask& task, std::span<const std::size_t> allowed, const Progress& progress);

  /// A cover with no more columns than asked for, if there is one. Throws Cancelled.
  [[nodiscard]] DirectionCover find(const CoverChoice& choice);

 private:
  struct State {
    BitSet open;                     // samples neither reached nor given up
    BitSet allowed;                  // columns
    std::vector<std::size_t> spare;  // of each group
  };
  [[nodiscard]] const BitSet& column(std::size_t c) const { return task_.columns[columns_[c]]; }
  [[nodiscard]] std::size_t group_of(std::size_t sample) const;
  [[nodiscard]] bool drop_unreachable(State& state, std::size_t& rarest) const;
  [[nodiscard]] bool satisfied(const State& state) const;
  [[nodiscard]] bool may_suffice(const State& state, std::size_t rest, std::vector<std::size_t>& gains) const;
  [[nodiscard]] bool branch(State state, std::size_t rest);
  [[nodiscard]] bool choose_last(const State& state);

  CoverTask task_;
  const Progress& progress_;
  std::vector<std::size_t> columns_;  // of the task
  std::vector<BitSet> rows_;          // the columns that reach each sample
  std::vector<std::size_t> chosen_;
  std::size_t nodes_ = 0, most_nodes_ = 0;
};

/// Columns one after the other, until nothing more is reached or there are `most`: of those that reach nine
/// tenths of what any does of what is left, the one of least `liking`, then that which reaches most. Or two
/// at a time, those that reach most together, where that leaves less. The first group goes before the others.
[[nodiscard]] DirectionCover greedy_cover(const CoverTask& task, const CoverChoice& choice,
                                          const std::function<int(std::size_t)>& liking);

}  // namespace moldlight
