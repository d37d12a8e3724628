// Damages the bytes of a file in the ways in which files get damaged, or are damaged on purpose.
#pragma once

#include <cstdint>
#include <string>

namespace moldlight::fuzz {

/// One to four changes, given by the seed alone: bits, bytes, numbers, words, runs cut out, doubled or
/// swapped, ends cut.
[[nodiscard]] std::string mutate(std::string bytes, std::uint64_t seed);

}  // namespace moldlight::fuzz
