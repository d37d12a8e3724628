// The model document of a 3MF package, put into a package that is sound otherwise: zip checksums stop nearly
// every mutation of a packed one.
#include "fuzz/fuzz_reader.hpp"
#include "io/readers.hpp"
#include "support/zip_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string model(reinterpret_cast<const char*>(data), size);
  const std::string package = moldlight::test::threemf_bytes(model);
  return moldlight::fuzz::run_reader(moldlight::read_threemf,
                                     reinterpret_cast<const std::uint8_t*>(package.data()), package.size());
}
