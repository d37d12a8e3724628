// What comes back from moldlight-step, which may have been broken by its file.
#include "fuzz/fuzz_reader.hpp"
#include "io/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto reader = [](const moldlight::ReadContext& context) {
    return moldlight::part_of_step_result(context, context.bytes());
  };
  return moldlight::fuzz::run_reader(reader, data, size);
}
