// The pages that --pdf writes: the figures of the page that --html writes, the same every time.
#include <map>
#include <regex>

#include <gtest/gtest.h>

#include "cli/report_kinds.hpp"
#include "support/pdf.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::run_moldlight;
using test::SmallPart;

class ReportPdfs : public testing::TestWithParam<test::ReportKind> {
 protected:
  void SetUp() override {
    if (!test::has_pdf_reader()) GTEST_SKIP() << "poppler-utils is not installed";
  }
  void write(std::vector<std::string> more) const {
    more.insert(more.end(), {"--pdf", pdf()});
    const auto run = run_moldlight(test::report_run(GetParam(), part_, more));
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  [[nodiscard]] std::string pdf() const { return part_.output("report.pdf"); }

  SmallPart part_;
};

/// How often each word is there.
using Words = std::map<std::string, int>;

void add_words(const std::string& text, Words& words) {
  static const std::regex k_word(R"(\S+)");
  for (std::sregex_iterator it(text.begin(), text.end(), k_word), end; it != end; ++it) ++words[it->str()];
}

/// The words of all figures of the page that have a place in the JSON report.
Words figure_words(const std::string& html) {
  static const std::regex k_figure(R"re(<data data-key="[^"]+" value="[^"]+">([^<]*)</data>)re");
  Words words;
  for (std::sregex_iterator it(html.begin(), html.end(), k_figure), end; it != end; ++it)
    add_words(std::regex_replace((*it)[1].str(), std::regex("&lt;"), "<"), words);
  return words;
}

TEST_P(ReportPdfs, HaveTheFiguresOfThePage) {
  const std::string html = part_.output("report.html");
  write({"--html", html});
  Words words;
  for (const test::PdfPage& page : test::pdf_pages(file_bytes(pdf())))
    for (const test::PdfWord& word : page.words) add_words(word.text, words);
  const Words figures = figure_words(file_bytes(html));
  EXPECT_GE(figures.size(), 5u);
  for (const auto& [word, times] : figures) EXPECT_GE(words[word], times) << word;
  for (const char* word : {"moldlight", "--pdf", "Page", "osmesa"}) EXPECT_GE(words[word], 1) << word;
}

TEST_P(ReportPdfs, AreWithinTheMarginsOfBothPapers) {
  for (const char* paper : {"a4", "letter"}) {
    write({"--paper", paper});
    const std::vector<test::PdfPage> pages = test::pdf_pages(file_bytes(pdf()));
    ASSERT_GE(pages.size(), 2u);
    for (const test::PdfPage& page : pages) {
      EXPECT_NEAR(page.size.x, paper[0] == 'a' ? 595.28 : 612.0, 0.01);
      ASSERT_FALSE(page.words.empty());
      for (const test::PdfWord& word : page.words) {
        EXPECT_GE(word.low.x, 42.0) << word.text;
        EXPECT_LE(word.high.x, page.size.x - 42.0) << word.text;
        EXPECT_GE(word.low.y, 36.0) << word.text;
        EXPECT_LE(word.high.y, page.size.y - 41.0) << word.text;
      }
    }
  }
}

TEST_P(ReportPdfs, AreTheSameBytesEveryTime) {
  write({});
  const std::string first = file_bytes(pdf());
  EXPECT_LT(first.size(), 4'000'000u);
  write({});
  EXPECT_EQ(file_bytes(pdf()), first);
}

INSTANTIATE_TEST_SUITE_P(All, ReportPdfs, testing::ValuesIn(test::report_kinds()),
                         [](const auto& each) { return each.param.name; });

TEST(ReportPdf, TakesTheTwoPapersAlone) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--pdf", part.output("a.pdf"), "--paper", "a\n3"}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
  EXPECT_NE(run.err.find("--paper"), std::string::npos);
  EXPECT_EQ(run_moldlight(part.classify({"--paper", "a4"})).exit_code, 2) << "of nothing";
}

TEST(ReportPdf, CannotTakeThePlaceOfWhatIsReadOrWritten) {
  const SmallPart part;
  const std::string file = part.output("one.file");
  for (const auto& words :
       {part.classify({"--pdf", part.file()}), part.classify({"--pdf", file, "--html", file})}) {
    const auto run = run_moldlight(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("--pdf"), std::string::npos) << run.err;
  }
}

TEST(ReportPdf, ThatCannotBeWrittenIsOneLine) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--pdf", part.output("no/such/folder/a.pdf")}));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
}

}  // namespace
}  // namespace moldlight
