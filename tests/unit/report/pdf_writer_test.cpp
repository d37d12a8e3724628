// A report as pages: all of it is there, within the margins, whatever its names are.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "base/shown_text.hpp"
#include "one_text_report.hpp"
#include "report/writers.hpp"
#include "support/pdf.hpp"

namespace moldlight::report {
namespace {

constexpr double k_margin_pt = 42.0;

/// Everything that stands between the margins, without spaces.
std::string text_of(const std::vector<test::PdfPage>& pages) {
  std::string text;
  for (const test::PdfPage& page : pages)
    for (const test::PdfWord& word : page.words) text += word.text;
  return text;
}

void expect_within_margins(const std::vector<test::PdfPage>& pages) {
  for (const test::PdfPage& page : pages) {
    ASSERT_FALSE(page.words.empty());
    for (const test::PdfWord& word : page.words) {
      EXPECT_GE(word.low.x, k_margin_pt) << word.text;
      EXPECT_LE(word.high.x, page.size.x - k_margin_pt) << word.text;
      EXPECT_GE(word.low.y, k_margin_pt - 6.0) << word.text;  // accents stand above the letters' line
      EXPECT_LE(word.high.y, page.size.y - k_margin_pt + 1.0) << word.text;
    }
  }
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

class PdfWriter : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::has_pdf_reader()) GTEST_SKIP() << "poppler-utils is not installed";
  }
};

TEST_F(PdfWriter, HasTheSizeOfThePaper) {
  const auto a4 = test::pdf_pages(pdf_document(report_of("word"), Paper::a4));
  EXPECT_NEAR(a4.front().size.x, 595.276, 0.01);
  EXPECT_NEAR(a4.front().size.y, 841.89, 0.01);
  const auto letter = test::pdf_pages(pdf_document(report_of("word"), Paper::letter));
  EXPECT_EQ(letter.front().size, glm::dvec2(612.0, 792.0));
}

TEST_F(PdfWriter, HasEveryText) {
  // Kind, part, subject, sentence and lead; the text of the picture, name and aside of the legend; of the
  // section its title, 5 of the figure, heading, cell and rest of the table, the caption, 4 texts and the
  // fact's 2; the name in the footer.
  const std::string text = text_of(test::pdf_pages(pdf_document(report_of("word"), Paper::a4)));
  EXPECT_EQ(count_of(text, "word"), 5u + 3u + 1u + 5u + 3u + 1u + 4u + 2u + 3u);
  EXPECT_NE(text.find("Page1of1"), std::string::npos);
  EXPECT_NE(text.find("0.5°askedfor"), std::string::npos);
}

TEST_F(PdfWriter, FontsAreEmbedded) {
  const std::string fonts = test::pdf_fonts(pdf_document(report_of("word ± ²"), Paper::a4));
  std::istringstream lines(fonts);
  std::string line;
  std::size_t found = 0;
  for (int k = 0; std::getline(lines, line); ++k) {
    if (k < 2) continue;
    ++found;
    EXPECT_NE(line.find(" yes yes yes "), std::string::npos) << "embedded, a subset, in Unicode: " << line;
  }
  EXPECT_GE(found, 1u);
}

TEST_F(PdfWriter, AnyNameStaysWithinTheMargins) {
  std::string spoken;
  for (int k = 0; k < 200; ++k) spoken += "spoken ";
  for (const std::string& name :
       {std::string(400, 'W'), spoken, std::string("a\nb\x1B[31m\xFF<script>(\\)endobj"),
        std::string("אבג\u202Eגבא"), utf8_of(std::u32string(90, U'\u0301')), std::string("\xEF\xBF\xBE")}) {
    for (const Paper paper : {Paper::a4, Paper::letter}) {
      const std::string pdf = pdf_document(report_of(name), paper);
      expect_within_margins(test::pdf_pages(pdf));
      EXPECT_NE(test::pdf_info(pdf).find("JavaScript:      no"), std::string::npos);
    }
  }
}

TEST_F(PdfWriter, ManyRowsHaveTheirHeadingsOnEveryPage) {
  Report report = report_of("word");
  Table table{{{"heading", true}, {"second"}}, {}};
  for (int k = 0; k < 150; ++k) table.rows.push_back({{{"row"}, {std::to_string(1000 + k)}}});
  report.sections.push_back({"long", {table}});
  const auto pages = test::pdf_pages(pdf_document(report, Paper::a4));
  ASSERT_GE(pages.size(), 4u);
  expect_within_margins(pages);
  std::set<std::string> rows;
  for (const test::PdfPage& page : pages) {
    const auto has = [&page](const char* text) {
      return std::ranges::any_of(page.words, [&](const test::PdfWord& word) { return word.text == text; });
    };
    EXPECT_EQ(has("row"), has("heading"));
    EXPECT_TRUE(has("Page"));
    for (const test::PdfWord& word : page.words)
      if (word.text.size() == 4 && word.text[0] == '1') rows.insert(word.text);
  }
  EXPECT_EQ(rows.size(), 150u);
}

TEST_F(PdfWriter, PicturesAreWithinTheMargins) {
  Report report = report_of("word");
  report.still.light = empty_image(40, 900);
  for (std::uint8_t& byte : report.still.light.rgba) byte = 200;
  Pictures many;
  for (int k = 0; k < 5; ++k) many.pictures.push_back(report.still);
  report.sections.push_back({"pictures", {many}});
  for (const Image& page : test::pdf_pictures(pdf_document(report, Paper::letter))) {
    for (int y = 0; y < page.height; ++y) {
      for (int x = 0; x < page.width; ++x) {
        const bool margin = x < 42 || y < 42 || x >= page.width - 42 || y >= page.height - 42;
        if (margin) {
          ASSERT_EQ(page.at(x, y)[0], 255) << x << ", " << y;
        }
      }
    }
  }
}

TEST_F(PdfWriter, WithoutPicturesItIsWritten) {
  Report report;
  report.part = "part";
  EXPECT_NE(text_of(test::pdf_pages(pdf_document(report, Paper::a4))).find("part"), std::string::npos);
}

}  // namespace
}  // namespace moldlight::report
