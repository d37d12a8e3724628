// The targets of parts whose coordinates differ by up to forty orders of magnitude: what they begin with.
#pragma once

#include <cstddef>
#include <cstdint>

#include <tbb/global_control.h>

#include "fuzz/wide_mesh.hpp"

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  // So few facets are no work for several threads.
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  return 0;
}
