#include "mold/scan/kernel/kernel.hpp"

// Only what follows is compiled for AVX2: inline functions of the headers above may be shared with the whole
// program.
#if defined(__x86_64__)
#define MOLDLIGHT_SCAN_AVX2
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,bmi,bmi2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,bmi,bmi2")
#endif
#endif

namespace moldlight::scan {

namespace {
#include "mold/scan/kernel/body.hpp"
}  // namespace

#if defined(__clang__) && defined(MOLDLIGHT_SCAN_AVX2)
#pragma clang attribute pop
#elif defined(MOLDLIGHT_SCAN_AVX2)
#pragma GCC pop_options
#endif

const Kernel k_avx2_kernel = {classify, transform, rasterize, rasterize_back, "AVX2"};

}  // namespace moldlight::scan
