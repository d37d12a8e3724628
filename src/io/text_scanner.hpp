// Words and numbers of a text file, with the line that each stands in. Line ends may be LF, CR LF or CR.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace moldlight {

struct TextRules {
  bool has_comments = false;  // '#' starts a comment that runs to the end of the line
  bool continuation = false;  // a backslash before a line end joins the lines
};

/// Walks a text once, from its start; the text outlives the scanner.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text, TextRules rules = {});

  /// Next word, on whatever line; empty at the end of the text.
  [[nodiscard]] std::string_view next();
  /// Next word of the current line; empty at its end.
  [[nodiscard]] std::string_view next_on_line();
  /// Rest of the current line without the white space around it; the scanner stands on the next line then.
  std::string_view rest_of_line();
  /// True when nothing but white space and comments is left.
  [[nodiscard]] bool at_end();

  /// Line (from 1) of the word read last.
  [[nodiscard]] std::size_t line() const { return token_line_; }
  /// Bytes of the text already walked.
  [[nodiscard]] std::size_t offset() const { return position_; }

 private:
  [[nodiscard]] bool skip_space(bool across_lines);
  void skip_line_end();
  [[nodiscard]] std::size_t continuation_length() const;

  std::string_view text_;
  TextRules rules_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  std::size_t token_line_ = 1;
};

/// The number that the whole word spells, in C notation with an optional plus sign; may be infinite or NaN.
/// Values too small for a double are 0, too large ones infinite. Independent of the locale.
[[nodiscard]] std::optional<double> parse_number(std::string_view word);

/// The decimal integer that the whole word spells.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view word);

/// ASCII letters compared without regard to case; `lower` is in lower case.
[[nodiscard]] bool equals_ignoring_case(std::string_view word, std::string_view lower);

/// A word in quotes for a message, as shown_text() has it, of 40 bytes at most; "nothing" for an empty one.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// A name from a file made fit for messages and JSON: shown_text() of 200 bytes at most.
[[nodiscard]] std::string clean_name(std::string_view name);

}  // namespace moldlight
