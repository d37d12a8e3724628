// Time of the exact regions of one direction, against a million samples of the same part in turns with them.
#pragma once

#include <string>
#include <vector>

#include "bench/speed/bench_settings.hpp"
#include "bench/speed/parts.hpp"
#include "gl/context.hpp"

namespace moldlight::bench {

struct ExactFigures {
  std::string part;
  std::size_t facets = 0;
  double worst_ms = 0.0, mean_ms = 0.0;  // areas of a direction on all cores, by the clock
  /// How many times as long a million samples take, all directions together: by the clock, and in time that
  /// all cores together spend.
  double over_samples = 0.0, over_samples_on_cores = 0.0;
};

/// Prints a row a direction. Needs `context` current on this thread.
[[nodiscard]] ExactFigures print_exact_rows(const PartFile& file, const gl::Context& context,
                                            const BenchSettings& settings);

}  // namespace moldlight::bench
