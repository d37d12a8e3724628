// Says that a part does not fit into memory before it is tried: a system that lends more than it has would
// end the program later, without a word.
#pragma once

#include <cstdint>
#include <string>

namespace moldlight {

/// Bytes that this process may still take: by the machine, by its control group, by its own limit.
[[nodiscard]] std::uint64_t available_memory_bytes();

/// Throws FileError for `path` where `bytes`, about to be taken, are not there. Cheap for small amounts.
void check_memory(const std::string& path, std::uint64_t bytes);

}  // namespace moldlight
