// Sweep throughput of every engine and of what it is measured against, at the error each has.
#pragma once

#include <string>
#include <vector>

#include "bench/speed/bench_settings.hpp"
#include "bench/speed/contenders.hpp"
#include "gl/context.hpp"

namespace moldlight::bench {

/// What the bars are about; ratios are of times, the larger the better for the maps on the CPU, save
/// `of_limit`.
struct SweepFigures {
  std::string part;
  std::size_t facets = 0;
  double ms = 0.0;  // a direction, all cores
  double error = 0.0;
  double over_paper = 0.0, over_rays = 0.0, of_limit = 0.0, map_pair_of_limit = 0.0, threads_gain = 0.0;
};

/// Prints a row an engine. Needs `context` current on this thread.
[[nodiscard]] SweepFigures print_sweep_rows(const std::string& name, Contenders& contenders,
                                            const gl::Context& context, const BenchSettings& settings);

/// Prints for each error wanted what maps and rays take and which of them `auto` chooses.
void print_choice_rows(const std::string& name, Contenders& contenders, const BenchSettings& settings);

}  // namespace moldlight::bench
