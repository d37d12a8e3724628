// Text from files, names and other programs, made fit for people to look at.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace moldlight {

/// Bytes of the valid UTF-8 sequence at the start of `text`, which is not empty; 0 where there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);
/// The letters of UTF-8 text; bytes that make no sense become U+FFFD.
[[nodiscard]] std::u32string letters_of(std::string_view utf8);
/// With small letters for A to Z.
[[nodiscard]] std::string lower_letters(std::string_view text);
/// Whether all words of `words` stand in the text; small letters are as good as capitals, from A to Z.
[[nodiscard]] bool has_words(std::string_view text, std::string_view words);
[[nodiscard]] std::string utf8_of(std::u32string_view letters);

/// A letter that terminals, tables and pages obey rather than show: control characters (C0, DEL and C1),
/// marks that turn the direction of writing, separators of lines and paragraphs.
[[nodiscard]] bool is_command_letter(char32_t letter);
/// "\u202E"
[[nodiscard]] std::string letter_escape(char32_t letter);

/// One line of valid UTF-8 without such letters: they stand as escapes, bytes that are no UTF-8 as "\xFF". At
/// most `most_bytes`, and then "...".
[[nodiscard]] std::string shown_text(std::string_view text, std::size_t most_bytes = std::string_view::npos);

/// As shown_text() has it, with blanks for white space.
[[nodiscard]] std::string one_line(std::string_view text);

/// Lines of at most `width` columns, broken at blanks; all but the first are indented.
[[nodiscard]] std::string wrapped_text(std::string_view text, std::size_t width, std::size_t indent = 0);

/// Words in one line, as a shell takes them.
[[nodiscard]] std::string shell_text(std::span<const std::string> words);

}  // namespace moldlight
