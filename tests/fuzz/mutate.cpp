#include "fuzz/mutate.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

namespace moldlight::fuzz {

namespace {

constexpr std::array<std::string_view, 27> k_words = {"nan",
                                                      "-inf",
                                                      "1e400",
                                                      "-1",
                                                      "0",
                                                      "4294967295",
                                                      "4294967296",
                                                      "18446744073709551616",
                                                      "1e-320",
                                                      "0x10",
                                                      "1,5",
                                                      "",
                                                      "\n",
                                                      "\r",
                                                      " ",
                                                      "\\\n",
                                                      "#",
                                                      "\xff\xfe",
                                                      "\xef\xbb\xbf",
                                                      "solid",
                                                      "endsolid",
                                                      "facet normal",
                                                      "vertex",
                                                      "f 1 2 3\n",
                                                      "<object>",
                                                      "</mesh>",
                                                      "&amp;"};

/// Uniform and the same on every machine, unlike the standard distributions.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  [[nodiscard]] std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
};

bool is_number_part(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
}

/// Replaces the number around or behind a place by another word.
void replace_number(std::string& bytes, std::size_t place, std::string_view word) {
  std::size_t begin = place;
  while (begin < bytes.size() && !is_number_part(bytes[begin])) ++begin;
  std::size_t end = begin;
  while (end < bytes.size() && is_number_part(bytes[end])) ++end;
  bytes.replace(begin, end - begin, word);
}

void change(std::string& bytes, Dice& dice) {
  const std::size_t place = dice.below(bytes.size());
  const std::size_t length = std::min(bytes.size() - place, dice.below(100) + 1);
  const std::string_view word = k_words[dice.below(k_words.size())];
  switch (dice.below(10)) {
    case 0:
      bytes[place] = static_cast<char>(bytes[place] ^ (1 << dice.below(8)));
      break;
    case 1:
      bytes[place] = static_cast<char>(dice.below(256));
      break;
    case 2:
      bytes.insert(place, word);
      break;
    case 3:
    case 4:
      replace_number(bytes, place, word);
      break;
    case 5:
      bytes.erase(place, length);
      break;
    case 6:
      bytes.insert(place, bytes.substr(dice.below(bytes.size()), length));
      break;
    case 7:
      bytes.resize(place);
      break;
    case 8:
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(place), std::min<std::size_t>(length, 4),
                  '\xff');
      break;
    default:
      std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(place),
                   bytes.begin() + static_cast<std::ptrdiff_t>(place + std::min<std::size_t>(length, 8)));
  }
}

}  // namespace

std::string mutate(std::string bytes, std::uint64_t seed) {
  Dice dice(seed);
  const std::size_t changes = dice.below(4) + 1;
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) change(bytes, dice);
  return bytes;
}

}  // namespace moldlight::fuzz
