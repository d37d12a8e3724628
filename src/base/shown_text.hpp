// Text from files, names and other programs, made fit for people to look at.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace moldlight {

/// A letter that terminals, tables and pages obey rather than show: control characters (C0, DEL and C1),
/// marks that turn the direction of writing, separators of lines and paragraphs.
[[nodiscard]] bool is_command_letter(char32_t letter);
/// "\u202E"
[[nodiscard]] std::string letter_escape(char32_t letter);

/// One line of valid UTF-8 without such letters: they stand as escapes, bytes that are no UTF-8 as "\xFF". At
/// most `most_bytes`, and then "...".
[[nodiscard]] std::string shown_text(std::string_view text, std::size_t most_bytes = std::string_view::npos);

/// Lines of at most `width` columns, broken at blanks; all but the first are indented.
[[nodiscard]] std::string wrapped_text(std::string_view text, std::size_t width, std::size_t indent = 0);

/// Words in one line, as a shell takes them.
[[nodiscard]] std::string shell_text(std::span<const std::string> words);

}  // namespace moldlight
