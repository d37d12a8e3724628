// Sets of small numbers as bits, for covers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace moldlight {

/// How many bits are set in both of two runs of so many words.
[[nodiscard]] std::size_t common_bits(const std::uint64_t* one, const std::uint64_t* other,
                                      std::size_t words);

class BitSet {
 public:
  explicit BitSet(std::size_t size = 0) : words_((size + 63) / 64, 0) {}

  void set(std::size_t k) { words_[k / 64] |= std::uint64_t{1} << (k % 64); }
  void reset(std::size_t k) { words_[k / 64] &= ~(std::uint64_t{1} << (k % 64)); }
  [[nodiscard]] bool has(std::size_t k) const { return ((words_[k / 64] >> (k % 64)) & 1U) != 0; }
  void resize(std::size_t size) { words_.resize((size + 63) / 64, 0); }

  [[nodiscard]] const std::vector<std::uint64_t>& words() const { return words_; }
  /// The sets have the same size in all of these.
  void remove(const BitSet& other) {
    for (std::size_t k = 0; k < words_.size(); ++k) words_[k] &= ~other.words_[k];
  }
  void add(const BitSet& other) {
    for (std::size_t k = 0; k < words_.size(); ++k) words_[k] |= other.words_[k];
  }
  [[nodiscard]] bool contains(const BitSet& other) const {
    for (std::size_t k = 0; k < words_.size(); ++k) {
      if ((other.words_[k] & ~words_[k]) != 0) return false;
    }
    return true;
  }
  [[nodiscard]] std::size_t count() const { return common_bits(words_.data(), words_.data(), words_.size()); }
  [[nodiscard]] std::size_t count_with(const BitSet& other) const {
    return common_bits(words_.data(), other.words_.data(), words_.size());
  }
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t k = 0; k < words_.size(); ++k) {
      for (std::uint64_t word = words_[k]; word != 0; word &= word - 1)
        visit(64 * k + static_cast<std::size_t>(std::countr_zero(word)));
    }
  }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace moldlight
