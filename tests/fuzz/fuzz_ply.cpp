#include "fuzz/fuzz_reader.hpp"
#include "io/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return moldlight::fuzz::run_reader(moldlight::read_ply, data, size);
}
