// How many threads a TBB arena may ask for.
#pragma once

#include <algorithm>

#include <tbb/global_control.h>

namespace moldlight {

/// The wanted number, but no more than TBB has: it prints a warning of its own on stderr for a greater one,
/// and starts no more for it.
[[nodiscard]] inline int arena_threads(int wanted) {
  const auto most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(wanted, static_cast<int>(most));
}

}  // namespace moldlight
