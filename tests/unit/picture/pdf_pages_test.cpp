// Pages of a PDF: as large as asked for, of the same bytes, with text that reads as it was written.
#include <gtest/gtest.h>

#include "picture/canvas.hpp"
#include "support/pdf.hpp"

namespace moldlight {
namespace {

std::string document(const std::vector<std::string>& texts) {
  PdfPages pages({300.0, 200.0}, "A title");
  for (std::size_t k = 0; k < texts.size(); ++k) {
    if (k > 0) pages.next_page();
    pages.outline(texts[k], 10.0);
    pages.page().text({20.0, 50.0}, texts[k], {.size_px = 10.0});
    pages.page().fill_box({{20, 60}, {30, 10}}, {{200, 10, 20}});
  }
  return pages.finish();
}

TEST(PdfPages, AreTheSameBytesEveryTime) {
  const std::string once = document({"one", "two"});
  EXPECT_TRUE(once.starts_with("%PDF-"));
  EXPECT_EQ(document({"one", "two"}), once);
  EXPECT_EQ(once.find("CreationDate"), std::string::npos) << "no clock shows in it";
}

TEST(PdfPages, KeepTextAsText) {
  if (!test::has_pdf_reader()) GTEST_SKIP() << "poppler-utils is not installed";
  const std::vector<test::PdfPage> pages = test::pdf_pages(document({"Größe 12.5 ± 0.1 mm² −3° Ωλ", "end"}));
  ASSERT_EQ(pages.size(), 2u);
  EXPECT_EQ(pages[0].size, glm::dvec2(300.0, 200.0));
  std::string text;
  for (const test::PdfWord& word : pages[0].words) {
    text += word.text + " ";
    EXPECT_GE(word.low.x, 19.0);
  }
  EXPECT_EQ(text, "Größe 12.5 ± 0.1 mm² −3° Ωλ ");
  ASSERT_EQ(pages[1].words.size(), 1u);
}

TEST(PdfPages, EveryLetterMayStandInThem) {
  // Bytes that are no UTF-8, controls, letters that are never assigned, right to left, beyond 16 bits.
  std::string all;
  for (const char* text : {"\xFF\xC0", "\x01\x1B", "\xEF\xBF\xBE", "\xEF\xB7\x90", "אבג", "\xF0\x9F\x98\x80",
                           "\xF4\x8F\xBF\xBF", "(\\)<</>>endobj"})
    all += text;
  const std::string bytes = document({all + "end"});
  if (!test::has_pdf_reader()) GTEST_SKIP() << "poppler-utils is not installed";
  const std::vector<test::PdfPage> pages = test::pdf_pages(bytes);
  ASSERT_EQ(pages.size(), 1u);
  std::string text;
  for (const test::PdfWord& word : pages[0].words) text += word.text;
  EXPECT_NE(text.find("(\\)<</>>endobjend"), std::string::npos) << text;
}

}  // namespace
}  // namespace moldlight
