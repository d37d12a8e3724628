#include "base/shown_text.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

namespace moldlight {

namespace {

constexpr char32_t k_replacement = 0xFFFD;

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const unsigned char second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool beyond = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return overlong || beyond ? 0 : length;
}

std::u32string letters_of(std::string_view utf8) {
  std::u32string letters;
  while (!utf8.empty()) {
    const std::size_t length = utf8_length(utf8);
    char32_t letter = static_cast<unsigned char>(utf8[0]) & (length < 2 ? 0x7FU : 0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i)
      letter = letter << 6 | (static_cast<unsigned char>(utf8[i]) & 0x3FU);
    letters += length == 0 ? k_replacement : letter;
    utf8.remove_prefix(std::max<std::size_t>(length, 1));
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

std::string lower_letters(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool has_words(std::string_view text, std::string_view words) {
  const std::string lower = lower_letters(text);
  std::istringstream each(lower_letters(words));
  for (std::string word; each >> word;)
    if (lower.find(word) == std::string::npos) return false;
  return true;
}

bool is_command_letter(char32_t letter) {
  const auto within = [&](char32_t first, char32_t last) { return letter >= first && letter <= last; };
  return letter < 0x20 || within(0x7F, 0x9F) || letter == 0x61C || within(0x200E, 0x200F) ||
         within(0x2028, 0x202E) || within(0x2066, 0x2069);
}

std::string letter_escape(char32_t letter) {
  return fmt::format("\\u{:04X}", static_cast<std::uint32_t>(letter));
}

std::string shown_text(std::string_view text, std::size_t most_bytes) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    std::string next;
    if (length == 0) {
      next = fmt::format("\\x{:02X}", static_cast<unsigned char>(text.front()));
    } else {
      const std::string_view bytes = text.substr(0, length);
      const char32_t letter = letters_of(bytes).front();
      next = is_command_letter(letter) ? letter_escape(letter) : std::string(bytes);
    }
    if (result.size() + next.size() > most_bytes) return result + "...";
    result += next;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::string one_line(std::string_view text) {
  std::string line(text);
  std::ranges::replace_if(
      line, [](char c) { return c >= '\t' && c <= '\r'; }, ' ');
  return shown_text(line);
}

std::string wrapped_text(std::string_view text, std::size_t width, std::size_t indent) {
  std::string lines;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    if (column > indent && column + 1 + word.size() > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

std::string shell_text(std::span<const std::string> words) {
  constexpr std::string_view k_plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += ' ';
    if (!word.empty() && word.find_first_not_of(k_plain) == std::string::npos) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

}  // namespace moldlight
