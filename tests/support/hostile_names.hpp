// Names that somebody gave a part or a body to do harm where they are shown, and what must never be shown.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/shown_text.hpp"

namespace moldlight::test {

inline std::vector<std::string> hostile_names() {
  return {"\x1B[2J\x1B]0;title\x07",       // clears a terminal, names its window
          "C1 \u009B31m \u009D0;x\u009C",  // the same in single letters
          "raw \x9B\x9D C1",               // bytes that are no UTF-8
          "exe\u202Elts.trap",             // reads backwards
          "\u2066isolate\u2069\u200F\u061C",
          "two\u2028lines\u2029here\nand\rthere\tand\u0085so",
          "\x7F\x08\x08 erased",
          "=cmd|' /C calc'!A1.stl",
          "+1+1.stl",
          "-2-3.stl",
          "@SUM(1+1).stl",
          "\t=1+1.stl",
          "\r=1+1.stl",
          "<script>alert(1)</script>&\"'",
          "'; DROP TABLE parts; --"};
}

/// Valid UTF-8 in which no letter is obeyed but those of `allowed`.
inline bool is_harmless(std::string_view text, std::u32string_view allowed = {}) {
  const std::u32string letters = letters_of(text);
  return utf8_of(letters) == text && std::ranges::none_of(letters, [&](char32_t letter) {
           return is_command_letter(letter) && allowed.find(letter) == std::u32string_view::npos;
         });
}

}  // namespace moldlight::test
