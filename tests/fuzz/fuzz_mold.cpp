// Mold halves of parts whose coordinates differ by up to forty orders of magnitude.
#include "fuzz/fuzz_wide.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  moldlight::fuzz::try_mold(moldlight::fuzz::wide_part({data, size}));
  return 0;
}
