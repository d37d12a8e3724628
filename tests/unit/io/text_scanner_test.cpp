#include "io/text_scanner.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace moldlight {
namespace {

TEST(TextScanner, CountsLinesOfEveryKindOfLineEnd) {
  TextScanner words("a\nb\r\nc\rd\r\n\r\ne\n\r\rf");
  const std::size_t lines[] = {1, 2, 3, 4, 6, 9};
  for (const std::size_t line : lines) {
    EXPECT_FALSE(words.next().empty());
    EXPECT_EQ(words.line(), line);
  }
  EXPECT_TRUE(words.at_end());
  EXPECT_TRUE(words.next().empty());
}

TEST(TextScanner, EndsWordsAtCommentsAndLines) {
  TextScanner words("v 1#2 3\n# 4\n 5", {.has_comments = true});
  EXPECT_EQ(words.next(), "v");
  EXPECT_EQ(words.next_on_line(), "1");
  EXPECT_EQ(words.next_on_line(), "");
  EXPECT_EQ(words.next(), "5");
  EXPECT_EQ(words.line(), 3u);
}

TEST(TextScanner, JoinsContinuedLines) {
  TextScanner words("f 1\\\n2 \\\r\n 3 a\\b\\\n\nx\\", {.continuation = true});
  for (const char* word : {"f", "1", "2", "3", "a\\b"}) EXPECT_EQ(words.next_on_line(), word);
  EXPECT_EQ(words.next_on_line(), "");
  EXPECT_EQ(words.next(), "x\\");
  EXPECT_EQ(words.line(), 5u);
}

TEST(TextScanner, GivesTheRestOfALine) {
  TextScanner words("o  a part \t\nnext");
  EXPECT_EQ(words.next(), "o");
  EXPECT_EQ(words.rest_of_line(), "a part");
  EXPECT_EQ(words.next(), "next");
  EXPECT_EQ(words.line(), 2u);
  EXPECT_EQ(words.rest_of_line(), "");
}

TEST(ParseNumber, ReadsWholeWordsOnly) {
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("5."), 5.0);
  EXPECT_EQ(parse_number("-1E-003"), -0.001);
  EXPECT_EQ(parse_number("1e-5000"), 0.0);
  EXPECT_EQ(parse_number("-1e5000"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(*parse_number("NaN")));
  for (const char* bad : {"", "+", "-", "+-1", "--1", "1,5", "1.5x", "0x10", "e5", ".", "1 2"}) {
    EXPECT_FALSE(parse_number(bad)) << bad;
  }
}

TEST(CleanName, LeavesValidUtf8AndReplacesTheRest) {
  EXPECT_EQ(clean_name("M\xc3\xbcller \xe6\x9c\x88 \xf0\x9f\x99\x82"),
            "M\xc3\xbcller \xe6\x9c\x88 \xf0\x9f\x99\x82");
  EXPECT_EQ(clean_name("a\xc3"), "a\\xC3");
  EXPECT_EQ(clean_name("\xc0\xaf\xed\xa0"), "\\xC0\\xAF\\xED\\xA0");
  EXPECT_EQ(clean_name("a\tb\x7f"), "a\\u0009b\\u007F");
  EXPECT_EQ(clean_name(std::string(300, 'x')), std::string(200, 'x') + "...");
}

}  // namespace
}  // namespace moldlight
