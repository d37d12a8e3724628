#include "mold/sweep/scan_kernel.hpp"

// Only what follows is compiled for AVX2: inline functions of the headers above may be shared with the whole
// program.
#if defined(__x86_64__)
#pragma GCC target("avx2,bmi,bmi2")
#define MOLDLIGHT_SCAN_AVX2
#endif

namespace moldlight::scan {

namespace {
#pragma GCC diagnostic ignored "-Wpsabi"  // vectors pass between functions of this file alone
#include "mold/sweep/scan_kernel_body.hpp"
}  // namespace

const Kernel k_avx2_kernel = {classify, transform, rasterize, rasterize_back, "AVX2"};

}  // namespace moldlight::scan
