#include "batch/csv.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/shown_text.hpp"

namespace moldlight::batch {

constexpr int k_end = std::char_traits<char>::eof();

CsvReader::CsvReader(std::istream& stream, std::string name)
    : bytes_(*stream.rdbuf()), name_(std::move(name)) {
  // A mark of UTF-8, which some programs put first.
  for (const char expected : std::string_view("\xEF\xBB\xBF")) {
    if (bytes_.sgetc() != std::char_traits<char>::to_int_type(expected)) break;
    bytes_.sbumpc();
  }
}

int CsvReader::take() {
  const int c = bytes_.sbumpc();
  if (c == '\n') ++line_;
  return c;
}

void CsvReader::quoted_field(std::string& field) {
  for (;;) {
    const int c = take();
    if (c == k_end)
      throw FileError(name_, fmt::format("line {}", record_line_), "a quoted field does not end");
    if (c != '"') {
      field += static_cast<char>(c);
    } else if (bytes_.sgetc() == '"') {
      field += static_cast<char>(take());
    } else {
      return;
    }
  }
}

bool CsvReader::next(std::vector<std::string>& fields) {
  while (bytes_.sgetc() == '\n' || bytes_.sgetc() == '\r') static_cast<void>(take());
  if (bytes_.sgetc() == k_end) return false;
  record_line_ = line_;
  std::size_t count = 0;
  const auto begin_field = [&] {
    if (count == fields.size()) fields.emplace_back();
    fields[count++].clear();
  };
  begin_field();
  for (;;) {
    const int c = take();
    std::string& field = fields[count - 1];
    if (c == '"' && field.empty()) {
      quoted_field(field);
    } else if (c == separator_) {
      begin_field();
    } else if (c == '\n' || c == k_end ||
               (c == '\r' && (bytes_.sgetc() == '\n' || bytes_.sgetc() == k_end))) {
      if (c == '\r') static_cast<void>(take());
      break;
    } else {
      field += static_cast<char>(c);
    }
  }
  fields.resize(count);
  return true;
}

std::string csv_field(std::string_view text) {
  const bool plain = text.find_first_of(",;\"\r\n") == std::string_view::npos && !text.starts_with(' ') &&
                     !text.ends_with(' ') && !text.starts_with('\xEF');
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string spreadsheet_text(std::string_view text) {
  const std::string shown = shown_text(text);
  // White space and full-width forms are left aside by some programs.
  const std::u32string letters = letters_of(shown);
  const auto first = letters.find_first_not_of(U" \u00A0\u3000");
  const bool formula =
      first != std::u32string::npos &&
      std::u32string_view(U"=+-@\uFF1D\uFF0B\uFF0D\uFF20").find(letters[first]) != std::u32string_view::npos;
  return formula ? "'" + shown : shown;
}

std::string csv_record(const std::vector<std::string>& fields) {
  std::string record;
  for (const std::string& field : fields) {
    if (&field != &fields.front()) record += ',';
    record += csv_field(field);
  }
  return record + '\n';
}

}  // namespace moldlight::batch
