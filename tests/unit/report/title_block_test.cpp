// The title block of a report, on a page and on paper.
#include <gtest/gtest.h>

#include "report/writers.hpp"
#include "support/pdf.hpp"
#include "unit/report/one_text_report.hpp"

namespace moldlight::report {
namespace {

Report titled_report() {
  Report report = report_of("word");
  report.title = TitleBlock{small_picture(),
                            {Facts{{{"Revision", "C7"}, {"Material", "ABS <grey>"}}}, Text{"Confirm it."}}};
  return report;
}

TEST(TitleBlock, StandsBelowTheVerdictOfAPage) {
  const std::string page = html_page(titled_report());
  const std::size_t verdict = page.find("class=\"verdict"), title = page.find("<div class=\"title\">"),
                    view = page.find("id=\"view\"");
  ASSERT_NE(title, std::string::npos);
  EXPECT_LT(verdict, title);
  EXPECT_LT(title, view);
  for (const char* text : {"<dt>Revision</dt><dd>C7</dd>", "ABS &lt;grey&gt;", "Confirm it."})
    EXPECT_NE(page.find(text, title), std::string::npos) << text;
  EXPECT_NE(page.find("<img src=\"data:image/png", title), std::string::npos);
  EXPECT_EQ(html_page(report_of("word")).find("<div class=\"title\">"), std::string::npos);
}

TEST(TitleBlock, StandsOnTheFirstPageOfPaper) {
  if (!test::has_pdf_reader()) GTEST_SKIP() << "poppler-utils is not installed";
  for (const Paper paper : {Paper::a4, Paper::letter}) {
    const auto pages = test::pdf_pages(pdf_document(titled_report(), paper));
    std::string text;
    for (const test::PdfWord& word : pages.front().words) text += word.text + " ";
    for (const char* part : {"Revision", "C7", "ABS", "Confirm it."})
      EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
}

}  // namespace
}  // namespace moldlight::report
