// UTF-8 text and its letters.
#pragma once

#include <string>
#include <string_view>

namespace moldlight {

/// Bytes of the valid UTF-8 sequence at the start of `text`, which is not empty; 0 where there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);
/// The letters of UTF-8 text; bytes that make no sense become U+FFFD.
[[nodiscard]] std::u32string letters_of(std::string_view utf8);
/// With small letters for A to Z.
[[nodiscard]] std::string lower_letters(std::string_view text);
[[nodiscard]] std::string utf8_of(std::u32string_view letters);

}  // namespace moldlight
