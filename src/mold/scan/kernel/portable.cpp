#include "mold/scan/kernel/kernel.hpp"

namespace moldlight::scan {

namespace {
#include "mold/scan/kernel/body.hpp"
}  // namespace

const Kernel k_portable_kernel = {classify, transform, rasterize, rasterize_back, "portable"};

}  // namespace moldlight::scan
