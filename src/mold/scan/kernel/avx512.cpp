#include "mold/scan/kernel/kernel.hpp"

// Only what follows is compiled for AVX-512, in vectors of 256 bits: inline functions of the headers above
// may be shared with the whole program.
#if defined(__x86_64__)
#define MOLDLIGHT_SCAN_AVX2
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,bmi,bmi2,avx512f,avx512vl,avx512bw,avx512dq"))), \
                             apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,bmi,bmi2,avx512f,avx512vl,avx512bw,avx512dq")
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

const Kernel k_avx512_kernel = {classify, transform, rasterize, rasterize_back, "AVX-512"};

}  // namespace moldlight::scan
