// Sweep throughput of every engine and of what it is measured against, at the error each has.
#pragma once

#include <string>
#include <vector>

#include "bench/speed/bench_settings.hpp"
#include "bench/speed/contenders.hpp"
#include "gl/context.hpp"

namespace moldlight::bench {

/// Ratios are of the time that all cores together spend, which holds on a machine that others use too.
struct SweepFigures {
  std::string part;
  std::size_t facets = 0;
  double ms = 0.0, core_ms = 0.0;  // a direction on all cores: by the clock, and spent by them together
  double error = 0.0;
  double over_paper = 0.0, over_exact = 0.0;  // how many times as long the others take
  /// One thread over all threads: by the clock, and what it would be if every thread had a core for itself.
  double threads_gain = 0.0, threads_gain_undisturbed = 0.0;
};

/// Prints a row an engine. Needs `context` current on this thread.
[[nodiscard]] SweepFigures print_sweep_rows(const std::string& name, Contenders& contenders,
                                            const gl::Context& context, const BenchSettings& settings);

}  // namespace moldlight::bench
