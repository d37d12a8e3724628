#include "picture/utf8.hpp"

namespace moldlight {

namespace {
constexpr char32_t k_replacement = 0xFFFD;
}

std::u32string letters_of(std::string_view utf8) {
  std::u32string letters;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i++]);
    const int more = first < 0x80                    ? 0
                     : first >= 0xF0 && first < 0xF8 ? 3
                     : first >= 0xE0                 ? 2
                     : first >= 0xC2                 ? 1
                                                     : -1;
    if (more < 0 || first >= 0xF8) {
      letters += k_replacement;
      continue;
    }
    char32_t letter = more == 0 ? first : first & (0x3FU >> more);
    int left = more;
    while (left > 0 && i < utf8.size() && (static_cast<unsigned char>(utf8[i]) & 0xC0U) == 0x80U) {
      letter = letter << 6 | (static_cast<unsigned char>(utf8[i++]) & 0x3FU);
      --left;
    }
    letters += left == 0 ? letter : k_replacement;
  }
  return letters;
}

std::string utf8_of(std::u32string_view letters) {
  std::string text;
  for (const char32_t letter : letters) {
    const auto byte = [&](char32_t bits) { text += static_cast<char>(static_cast<unsigned char>(bits)); };
    if (letter < 0x80) {
      byte(letter);
      continue;
    }
    const int more = letter < 0x800 ? 1 : letter < 0x10000 ? 2 : 3;
    byte((0xFF00U >> (more + 1) & 0xFFU) | letter >> 6 * more);
    for (int k = more - 1; k >= 0; --k) byte(0x80U | (letter >> 6 * k & 0x3FU));
  }
  return text;
}

}  // namespace moldlight
