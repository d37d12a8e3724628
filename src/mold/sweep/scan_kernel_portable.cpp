#include "mold/sweep/scan_kernel.hpp"

namespace moldlight::scan {

namespace {
#include "mold/sweep/scan_kernel_body.hpp"
}  // namespace

const Kernel k_portable_kernel = {classify, transform, rasterize, rasterize_back, "portable"};

const Kernel& best_kernel() {
#if defined(__x86_64__)
  static const bool k_has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi") != 0 &&
                                 __builtin_cpu_supports("bmi2") != 0;
  return k_has_avx2 ? k_avx2_kernel : k_portable_kernel;
#else
  return k_portable_kernel;
#endif
}

}  // namespace moldlight::scan
