// Two revisions of a part, compared for the mold: what of the surface is new or gone, and what that does to
// the regions.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "classify/classification.hpp"
#include "classify/option.hpp"
#include "compare/surface_change.hpp"

namespace moldlight {

struct CompareSettings {
  double same_within =
      0.0;  // surface that is no farther apart is the same, in A's unit; 0: 1e-4 of A's diagonal
};
[[nodiscard]] std::span<const Option<CompareSettings>> compare_options();

/// Which parting direction each part has: the same, or of each its best.
struct ComparedQuery {
  Direction former, fresh;
  MethodSettings method;
};

struct ComparedPart {
  std::shared_ptr<const PartModel> model;
  Classification result;  // with its split mesh
};

/// Lengths and areas are in A's unit.
struct Comparison {
  ComparedPart a, b;
  CompareSettings settings;
  SurfaceChange surface;
  std::vector<std::string> remarks;  // a sentence each
};

/// `b` in the unit of `a`, where the files of both name theirs and they differ; else `b` itself. Adds a
/// remark where it was converted, and where the parts' sizes are as far apart as two units.
[[nodiscard]] std::shared_ptr<const PartModel> in_unit_of(const std::shared_ptr<const PartModel>& a,
                                                          const std::shared_ptr<const PartModel>& b,
                                                          std::vector<std::string>& remarks,
                                                          const Progress& progress);

/// Compares parts as they lie. The same to the bit for any number of threads. Throws UsageError for a
/// tolerance greater than the part, Cancelled.
[[nodiscard]] Comparison compare_parts(const std::shared_ptr<const PartModel>& a,
                                       const std::shared_ptr<const PartModel>& b, const ComparedQuery& query,
                                       const CompareSettings& settings, const Progress& progress);

/// What changed, in a sentence or two.
[[nodiscard]] std::string comparison_verdict(const Comparison& comparison);

}  // namespace moldlight
