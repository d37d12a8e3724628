#include <vector>

#include "mold/scan/kernel/kernel.hpp"

namespace moldlight::scan {

std::span<const Kernel* const> kernels() {
  static const std::vector<const Kernel*> k_kernels = [] {
    std::vector<const Kernel*> all = {&k_portable_kernel};
#if defined(__x86_64__)
    const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi") != 0 &&
                          __builtin_cpu_supports("bmi2") != 0;
    if (has_avx2) all.push_back(&k_avx2_kernel);
    if (has_avx2 && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
        __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512dq") != 0)
      all.push_back(&k_avx512_kernel);
#endif
    return all;
  }();
  return k_kernels;
}

const Kernel& best_kernel() { return *kernels().back(); }

}  // namespace moldlight::scan
