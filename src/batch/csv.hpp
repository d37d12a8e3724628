// Tables of comma-separated values (RFC 4180) of any length, record by record: quoted fields may hold commas,
// quotes and line ends.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace moldlight::batch {

class CsvReader {
 public:
  /// `name` is what errors call the file.
  CsvReader(std::istream& stream, std::string name);

  /// Takes the next record that is not an empty line; false at the end. Throws FileError for a quoted field
  /// that does not end, and for a stream that cannot be read.
  [[nodiscard]] bool next(std::vector<std::string>& fields);
  /// Fields are parted by this: a comma unless set otherwise.
  void set_separator(char separator) { separator_ = separator; }
  /// Line on which the record that was taken last begins, from 1.
  [[nodiscard]] std::size_t line() const { return record_line_; }

 private:
  [[nodiscard]] int take();
  void quoted_field(std::string& field);

  std::streambuf& bytes_;
  std::string name_;
  char separator_ = ',';
  std::size_t line_ = 1, record_line_ = 0;
};

/// The field as a record holds it, quoted where it has to be.
[[nodiscard]] std::string csv_field(std::string_view text);
/// Text that somebody else chose, for a table that people open in a spreadsheet: as shown_text() has it, and
/// after an apostrophe where the spreadsheet would take it for a formula.
[[nodiscard]] std::string spreadsheet_text(std::string_view text);
/// The record with its line end.
[[nodiscard]] std::string csv_record(const std::vector<std::string>& fields);

}  // namespace moldlight::batch
