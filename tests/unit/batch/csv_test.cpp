// Tables with everything in their fields that a file's name may hold.
#include "batch/csv.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/hostile_names.hpp"

namespace moldlight::batch {
namespace {

using Record = std::vector<std::string>;

std::vector<Record> records_of(const std::string& text, char separator = ',') {
  std::istringstream stream(text);
  CsvReader reader(stream, "list.csv");
  reader.set_separator(separator);
  std::vector<Record> records;
  for (Record record; reader.next(record);) records.push_back(record);
  return records;
}

TEST(Csv, WhatIsWrittenReadsBackTheSame) {
  const std::vector<Record> written = {{"path", "unit"},
                                       {"with space", ""},
                                       {"line\nend", "a,b"},
                                       {"\"quoted\"", "'"},
                                       {" around ", "\r"},
                                       {"\xFF\xFE no UTF-8", "ü"},
                                       {"", ";"}};
  std::string text;
  for (const Record& record : written) text += csv_record(record);
  EXPECT_EQ(records_of(text), written);
}

TEST(Csv, ASpreadsheetFindsNoFormula) {
  EXPECT_EQ(spreadsheet_text("=cmd|calc!A1.stl"), "'=cmd|calc!A1.stl");
  EXPECT_EQ(spreadsheet_text(" +1"), "' +1");
  EXPECT_EQ(spreadsheet_text("\t=1"), "\\u0009=1");
  EXPECT_EQ(spreadsheet_text("a-b=c@d.stl"), "a-b=c@d.stl");
  EXPECT_EQ(spreadsheet_text(""), "");
  for (const std::string& name : test::hostile_names()) {
    const std::string cell = spreadsheet_text(name);
    EXPECT_TRUE(test::is_harmless(cell)) << cell;
    EXPECT_NE(cell.find_first_of("=+-@"), 0u) << cell;
  }
}

TEST(Csv, ForeignFormsAreRead) {
  EXPECT_EQ(records_of("\xEF\xBB\xBFpath,unit\r\na.stl,mm\r\n\r\nb.stl,in"),
            (std::vector<Record>{{"path", "unit"}, {"a.stl", "mm"}, {"b.stl", "in"}}));
  EXPECT_EQ(records_of("path;tau\na.stl;1,5\n", ';'),
            (std::vector<Record>{{"path", "tau"}, {"a.stl", "1,5"}}));
  EXPECT_TRUE(records_of("").empty());
  EXPECT_TRUE(records_of("\n\r\n").empty());
}

TEST(Csv, AQuotedFieldWithoutEndIsNamedWithItsLine) {
  try {
    static_cast<void>(records_of("path\n\na\n\"b\nc\n"));
    FAIL() << "nothing was thrown";
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), std::string("list.csv: line 4: a quoted field does not end"));
  }
}

TEST(Csv, LinesAreThoseOfTheFile) {
  std::istringstream stream("a\n\"b\nc\"\nd\n");
  CsvReader reader(stream, "list.csv");
  Record record;
  std::vector<std::size_t> lines;
  while (reader.next(record)) lines.push_back(reader.line());
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 2, 4}));
}

}  // namespace
}  // namespace moldlight::batch
