// UTF-8 text and its letters.
#pragma once

#include <string>
#include <string_view>

namespace moldlight {

/// The letters of UTF-8 text; bytes that make no sense become U+FFFD.
[[nodiscard]] std::u32string letters_of(std::string_view utf8);
[[nodiscard]] std::string utf8_of(std::u32string_view letters);

}  // namespace moldlight
