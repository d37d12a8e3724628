// A report as a page: all of it is there, and nothing in it becomes markup.
#include <regex>

#include <gtest/gtest.h>

#include "one_text_report.hpp"
#include "report/writers.hpp"

namespace moldlight::report {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// Its tags, without what their attributes hold.
std::vector<std::string> tags(const std::string& page) {
  static const std::regex k_tag(R"re(<(/?[a-zA-Z!][^\s>]*)((?:\s+[^\s=>"]+(?:="[^"]*")?)*)\s*/?>)re");
  std::vector<std::string> found;
  const std::string body =
      page.substr(page.find("<body>"), page.find("\n\"use strict\"") - page.find("<body>"));
  for (std::sregex_iterator it(body.begin(), body.end(), k_tag), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

TEST(HtmlWriter, NoTextBecomesMarkup) {
  const std::string plain = html_page(report_of("word"));
  for (const char* evil : {"</script><script>alert(1)</script>", "\"><img src=x onerror=alert(1)>",
                           "' onmouseover='alert(1)", "<!--", "]]>", "</style></title></pre>", "&lt;b&gt;"}) {
    std::string page = html_page(report_of(evil));
    EXPECT_EQ(tags(page), tags(plain)) << evil;
    // The data, where quotes are JSON's own, holds no markup: page/html_test.cpp.
    page.resize(page.find("<script type=\"application/json\""));
    for (const char* word : {"<script>alert", "<img src=x", "' onmouseover='alert"})
      EXPECT_EQ(count(page, word), 0u) << evil;
  }
}

TEST(HtmlWriter, FiguresAreForProgramsToo) {
  const std::string page = html_page(report_of("/areas/core"));
  EXPECT_NE(page.find("<data data-key=\"/areas/core\" value=\"1.5\">/areas/core</data>"), std::string::npos);
}

TEST(HtmlWriter, LoadsNothing) {
  const std::string page = html_page(report_of("word"));
  EXPECT_EQ(count(page, "src=\""), count(page, "src=\"data:image/png;base64,"));
  EXPECT_EQ(count(page, "href="), 0u);
  EXPECT_EQ(count(page, "url("), 0u);
  EXPECT_EQ(count(page, " style=\""), 0u) << "the policy forbids it";
  EXPECT_EQ(count(page, "://"), 0u);
}

TEST(HtmlWriter, WithoutAViewThePictureStands) {
  Report report = report_of("word");
  report.view.reset();
  const std::string page = html_page(report);
  EXPECT_EQ(count(page, "<canvas"), 0u);
  EXPECT_EQ(count(page, "id=\"model\""), 0u);
  EXPECT_NE(page.find("<img"), std::string::npos);
}

}  // namespace
}  // namespace moldlight::report
