// What goes into a page is harmless there, whatever it was.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/image.hpp"
#include "io/file_contents.hpp"
#include "page/page.hpp"
#include "support/hostile_names.hpp"

namespace moldlight::page {
namespace {

using Json = nlohmann::ordered_json;

TEST(Html, TextIsText) {
  EXPECT_EQ(html_text("<b a=\"x\">&'"), "&lt;b a=&quot;x&quot;&gt;&amp;&#39;");
  EXPECT_EQ(html_text("größe\t½\n"), "größe\t½\n");
  EXPECT_EQ(html_text(std::string("\xFF\x1B\0", 3)), "\uFFFD\\u001B\\u0000");
  for (const std::string& name : test::hostile_names())
    EXPECT_TRUE(test::is_harmless(html_text(name), U"\n\t")) << html_text(name);
}

TEST(Html, NothingInDataEndsItsScript) {
  const Json json = {"</script><!--<script>", "größe", "\xFF"};
  const std::string text = script_json(json);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 127; }));
  EXPECT_EQ(Json::parse(text)[0], json[0]);
  EXPECT_EQ(Json::parse(text)[1], json[1]);
}

TEST(Html, Base64OfTheTextsOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE"), "//4=");
}

TEST(Html, APathIsPartOfAnAddress) { EXPECT_EQ(url_of("a b/\"ü?.png"), "a%20b/%22%C3%BC%3F.png"); }

TEST(Page, AllowsItsOwnStyleAndScriptAlone) {
  const PageFrame frame{"<title>", "batch.css", {"batch.js"}};
  const std::string head = page_begin(frame), end = page_end(frame);
  EXPECT_NE(head.find("<title>&lt;title&gt;</title>"), std::string::npos);
  const auto between = [](const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t begin = text.find(from) + from.size();
    return text.substr(begin, text.find(to, begin) - begin);
  };
  const auto hash = [](const std::string& text) {
    const Digest digest = digest_of(text);
    return base64({reinterpret_cast<const char*>(digest.data()), digest.size()});
  };
  const std::string policy = between(head, "content=\"", "\"");
  EXPECT_EQ(policy, "default-src 'none'; img-src data:; style-src 'sha256-" +
                        hash(between(head, "<style>", "</style>")) + "'; script-src 'sha256-" +
                        hash(between(end, "<script>", "</script>")) +
                        "'; base-uri 'none'; form-action 'none'");
}

TEST(Page, FilesOfPagesHoldNothingThatWouldEndThem) {
  for (const PageFile& file : page_files()) {
    EXPECT_EQ(file.text.find("</script"), std::string_view::npos) << file.name;
    EXPECT_EQ(file.text.find("</style"), std::string_view::npos) << file.name;
    EXPECT_EQ(file.text.find("://"), std::string_view::npos) << file.name << " names something elsewhere";
  }
}

}  // namespace
}  // namespace moldlight::page
