// Split meshes of parts whose coordinates differ by up to forty orders of magnitude.
#include <cstddef>
#include <cstdint>

#include <tbb/global_control.h>

#include "fuzz/wide_mesh.hpp"

using namespace moldlight;

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  // So few facets are no work for several threads.
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::try_split_mesh(fuzz::wide_part({data, size}));
  return 0;
}
