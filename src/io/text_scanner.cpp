#include "io/text_scanner.hpp"

#include <array>
#include <charconv>
#include <system_error>

#include <locale.h>

#include "base/numbers.hpp"
#include "base/shown_text.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_max_quoted_bytes = 40;
constexpr std::size_t k_max_name_bytes = 200;

enum class Kind : std::uint8_t { word, blank, line_end, maybe_word };

/// What each byte can be; a backslash or '#' is part of a word or not, depending on the rules.
constexpr std::array<Kind, 256> k_kinds = [] {
  std::array<Kind, 256> kinds{};
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) kinds[c] = Kind::blank;
  for (const unsigned char c : {'\n', '\r'}) kinds[c] = Kind::line_end;
  for (const unsigned char c : {'\\', '#'}) kinds[c] = Kind::maybe_word;
  return kinds;
}();

Kind kind_of(char c) { return k_kinds[static_cast<unsigned char>(c)]; }
bool is_line_end(char c) { return kind_of(c) == Kind::line_end; }
bool is_blank(char c) { return kind_of(c) == Kind::blank; }

/// The value of a number beyond the range of double: 0 or infinite.
double out_of_range_value(std::string_view word) {
  static const locale_t k_c_locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
  return ::strtod_l(std::string(word).c_str(), nullptr, k_c_locale);
}

}  // namespace

TextScanner::TextScanner(std::string_view text, TextRules rules) : text_(text), rules_(rules) {
  constexpr std::string_view k_byte_order_mark = "\xef\xbb\xbf";
  if (text_.starts_with(k_byte_order_mark)) position_ = k_byte_order_mark.size();
}

std::size_t TextScanner::continuation_length() const {
  if (!rules_.continuation || text_[position_] != '\\') return 0;
  const std::string_view after = text_.substr(position_ + 1, 2);
  if (after.starts_with("\r\n")) return 3;
  return !after.empty() && is_line_end(after.front()) ? 2 : 0;
}

void TextScanner::skip_line_end() {
  position_ += text_.substr(position_).starts_with("\r\n") ? 2 : 1;
  ++line_;
}

bool TextScanner::skip_space(bool across_lines) {
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (is_blank(c)) {
      ++position_;
    } else if (is_line_end(c)) {
      if (!across_lines) return false;
      skip_line_end();
    } else if (const std::size_t length = continuation_length(); length > 0) {
      position_ += length;
      ++line_;
    } else if (rules_.has_comments && c == '#') {
      while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
    } else {
      return true;
    }
  }
  return false;
}

std::string_view TextScanner::next_on_line() {
  const bool found = skip_space(false);
  token_line_ = line_;
  if (!found) return {};
  const std::size_t start = position_;
  while (position_ < text_.size()) {
    const Kind kind = kind_of(text_[position_]);
    if (kind != Kind::word) {
      if (kind != Kind::maybe_word || continuation_length() > 0) break;
      if (rules_.has_comments && text_[position_] == '#') break;
    }
    ++position_;
  }
  return text_.substr(start, position_ - start);
}

std::string_view TextScanner::next() {
  static_cast<void>(skip_space(true));
  return next_on_line();
}

std::string_view TextScanner::rest_of_line() {
  token_line_ = line_;
  const std::size_t start = position_;
  while (position_ < text_.size() && !is_line_end(text_[position_])) {
    if (const std::size_t length = continuation_length(); length > 0) {
      position_ += length;
      ++line_;
    } else {
      ++position_;
    }
  }
  std::string_view rest = text_.substr(start, position_ - start);
  if (position_ < text_.size()) skip_line_end();
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

bool TextScanner::at_end() { return !skip_space(true); }

std::optional<double> parse_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  return error == std::errc::result_out_of_range ? out_of_range_value(word) : value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  return number_from<std::int64_t>(word);
}

bool equals_ignoring_case(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = word[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != lower[i]) return false;
  }
  return true;
}

std::string in_quotes(std::string_view word) {
  if (word.empty()) return "nothing";
  return "'" + shown_text(word, k_max_quoted_bytes) + "'";
}

std::string clean_name(std::string_view name) { return shown_text(name, k_max_name_bytes); }

}  // namespace moldlight
