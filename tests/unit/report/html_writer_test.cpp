// A report as a page: all of it is there, and nothing in it becomes markup.
#include "report/html_writer.hpp"

#include <regex>

#include <gtest/gtest.h>

namespace moldlight::report {
namespace {

Image small_picture() {
  Image image = empty_image(4, 3);
  image.at(1, 1)[3] = 255;
  return image;
}

/// With the same text everywhere.
Report report_of(const std::string& text) {
  Report report;
  report.kind = report.part = report.subject = report.sentence = report.lead = text;
  const Picture picture{small_picture(), small_picture(), text, text};
  report.still = picture;
  ModelView view;
  view.groups = {{.name = text, .aside = text}};
  view.opens = text;
  report.view = std::move(view);
  Section section{text, {}};
  section.blocks.emplace_back(FigureGrid{{{text, {text, text, 1.5}, text, text, text}}});
  section.blocks.emplace_back(ShareBar{{{{{1, 2, 3}, true}, 0.5, text}}});
  section.blocks.emplace_back(
      Table{{{text, true}}, {{{{text}}, Mark{{9, 9, 9}}, small_picture(), text}}, text});
  section.blocks.emplace_back(Pictures{{picture}});
  section.blocks.emplace_back(DraftBars{
      .bars = {{-1.0, 1.0, 2.0, 3.0}}, .required_deg = 0.5, .core = {}, .cavity = {}, .unit = text});
  for (const TextLook look : {TextLook::normal, TextLook::quiet, TextLook::notice, TextLook::command})
    section.blocks.emplace_back(Text{text, look});
  section.blocks.emplace_back(Facts{{{text, text}}});
  report.sections.push_back(std::move(section));
  return report;
}

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
