#include "pieces/bit_set.hpp"

namespace moldlight {

namespace {

std::size_t plain_common_bits(const std::uint64_t* one, const std::uint64_t* other, std::size_t words) {
  std::size_t sum = 0;
  for (std::size_t k = 0; k < words; ++k) sum += static_cast<std::size_t>(std::popcount(one[k] & other[k]));
  return sum;
}

// The searches do little else, and the instruction, which not every x86-64 has, is six times as fast.
#if defined(__x86_64__) && defined(__GNUC__)
__attribute__((target("popcnt"))) std::size_t fast_common_bits(const std::uint64_t* one,
                                                               const std::uint64_t* other,
                                                               std::size_t words) {
  std::size_t sum = 0;
  for (std::size_t k = 0; k < words; ++k)
    sum += static_cast<std::size_t>(__builtin_popcountll(one[k] & other[k]));
  return sum;
}
#endif

}  // namespace

std::size_t common_bits(const std::uint64_t* one, const std::uint64_t* other, std::size_t words) {
#if defined(__x86_64__) && defined(__GNUC__)
  static const bool k_has_instruction = __builtin_cpu_supports("popcnt") != 0;
  if (k_has_instruction) return fast_common_bits(one, other, words);
#endif
  return plain_common_bits(one, other, words);
}

}  // namespace moldlight
