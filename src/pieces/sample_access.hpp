// Which samples of the surface a pull along each direction releases, by exact rays.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/surface_samples.hpp"
#include "pieces/direction_cover.hpp"
#include "pieces/pull_lines.hpp"

namespace moldlight {

/// Column 2k is line k in its own sense, 2k + 1 against it.
[[nodiscard]] inline glm::dvec3 column_direction(std::span<const PullLine> lines, std::size_t column) {
  return column % 2 == 0 ? lines[column / 2].direction : -lines[column / 2].direction;
}
[[nodiscard]] inline std::size_t opposite_column(std::size_t column) { return column ^ 1U; }

/// Grows by groups of samples. All must outlive it.
class SampleAccess {
 public:
  /// Of the query the direction does not count.
  SampleAccess(const PartModel& model, const ExactQuery& query, std::span<const PullLine> lines);

  /// Asks for all lines on all cores of the calling thread's TBB arena; the same for any number of threads.
  /// `blocked`: columns that are known not to reach any of them, whatever the rays say. None of the group may
  /// be left until set_spare(). Throws Cancelled.
  void add(std::span<const SurfaceSample> samples, std::span<const std::size_t> blocked,
           const Progress& progress);

  [[nodiscard]] CoverTask task() const { return {groups_, columns_}; }
  /// Of the samples of a group those that some direction reaches.
  [[nodiscard]] std::size_t reachable(std::size_t group) const { return reachable_[group]; }
  [[nodiscard]] std::size_t groups() const { return groups_.size(); }
  void set_spare(std::size_t group, std::size_t spare) { groups_[group].spare = spare; }

 private:
  const PartModel& model_;
  ExactQuery query_;
  std::span<const PullLine> lines_;
  std::vector<SampleGroup> groups_;
  std::vector<std::size_t> reachable_;
  std::vector<BitSet> columns_;
};

}  // namespace moldlight
