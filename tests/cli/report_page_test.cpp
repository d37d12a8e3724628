// The page that --html writes, as a program reads it and as a browser shows it.
#include <algorithm>
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/page_trial.hpp"
#include "cli/report_kinds.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::json_of;
using test::run_moldlight;
using test::SmallPart;
using Json = nlohmann::ordered_json;

class ReportPages : public testing::TestWithParam<test::ReportKind> {
 protected:
  /// Writes the page and the JSON.
  void write() {
    const auto run = run_moldlight(test::report_run(GetParam(), part_, {"--html", page(), "--json", json()}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  [[nodiscard]] std::string page() const { return part_.output("report.html"); }
  [[nodiscard]] std::string json() const { return part_.output("report.json"); }

  SmallPart part_;
};

TEST_P(ReportPages, ItsFiguresAreTheJsonsAndItTurnsOpensAndCutsInABrowser) {
  write();
  const Json json = json_of(file_bytes(this->json()));
  const std::string page = file_bytes(this->page());
  const std::regex figure(R"re(<data data-key="([^"]+)" value="([^"]+)">)re");
  std::size_t figures = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), figure), end; it != end; ++it, ++figures) {
    const Json::json_pointer place((*it)[1].str());
    ASSERT_TRUE(json.contains(place)) << place;
    EXPECT_EQ(json[place].get<double>(), std::stod((*it)[2])) << place;
  }
  EXPECT_GE(figures, GetParam().least_figures);
  EXPECT_LT(fs::file_size(this->page()), 1'500'000u);

  if (!test::has_browser()) GTEST_SKIP() << "chromium is not installed: the page is not looked at";
  test::Browser browser;
  browser.load(this->page());
  const Json found = test::try_page(browser);
  const double pixels = found["pixels"], drawn = found["drawn"];
  EXPECT_GT(drawn, 0.03 * pixels) << found;
  EXPECT_LT(drawn, 0.95 * pixels) << found;
  EXPECT_GT(found["colours"], 50);
  EXPECT_LT(found["restored"], 0.02 * drawn) << "as it was, once all is undone: " << found;
}

TEST(ReportPage, HasTheNumbersOfTheTableWhereTheirUndercutsAre) {
  const SmallPart part;
  const std::string page = part.output("page.html");
  const auto run =
      run_moldlight({"actions", part.file(), "--direction", "z", "--backend", "osmesa", "--html", page});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string text = file_bytes(page);
  const std::regex number(R"re(<span class="number">(\d+)</span>)re");
  std::size_t numbers = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
    EXPECT_EQ(std::stoul((*it)[1]), ++numbers);
  EXPECT_EQ(numbers, 1u) << "the hole";
  if (!test::has_browser()) GTEST_SKIP() << "chromium is not installed: the page is not looked at";
  test::Browser browser;
  browser.load(page);
  // Turned about, the surface with the number faces the viewer from some sides and not from others.
  const Json found = browser.value(
      "begun.then((view) => Array.from({length: 36}, (_, k) => { view.yaw = k * Math.PI / 6; "
      "view.pitch = [-1.2, 0, 1.2][k % 3]; view.draw(); "
      "return document.querySelector('.tags .number').hidden; }))");
  const auto hidden = std::ranges::count(found, Json(true));
  EXPECT_GE(hidden, 9) << found;
  EXPECT_LE(hidden, 27) << found;
}

TEST(ReportPage, HasAPictureOfEachLoop) {
  const SmallPart part;
  const std::string page = part.output("page.html"), json = part.output("mold.json");
  const auto run = run_moldlight({"mold", part.file(), "--direction", "z", "--fill-undercut", "--backend",
                                  "osmesa", "--html", page, "--json", json});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string text = file_bytes(page);
  const std::regex picture(R"re(alt="Loop (\d+)")re");
  const auto pictures = static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), picture), std::sregex_iterator()));
  EXPECT_GE(pictures, 1u);
  EXPECT_LE(pictures, json_of(file_bytes(json))["loops"].size());
  EXPECT_NE(text.find("alt=\"The part with the loops of its parting line\""), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, ReportPages, testing::ValuesIn(test::report_kinds()),
                         [](const auto& each) { return each.param.name; });

std::vector<std::string> classify_page(const std::string& part, const std::string& page) {
  return {"classify", part, "--direction", "z", "--backend", "osmesa", "--html", page};
}

/// Share of the pixels that have a colour, as regions have and text has not.
double coloured_share(const Image& image) {
  std::size_t coloured = 0;
  for (std::size_t k = 0; k < image.rgba.size(); k += 4) {
    const auto [least, greatest] = std::minmax({image.rgba[k], image.rgba[k + 1], image.rgba[k + 2]});
    coloured += greatest - least > 60 ? 1 : 0;
  }
  return 4.0 * static_cast<double>(coloured) / static_cast<double>(image.rgba.size());
}

TEST(ReportPage, WhatAPageMustNotDoWouldBeSeen) {
  if (!test::has_browser()) GTEST_SKIP() << "chromium is not installed";
  const test::ScratchFolder folder;
  test::Browser browser;
  browser.load(folder.write("page.html", "<img src=\"http://127.0.0.1:8099/picture.png\">"));
  EXPECT_GE(browser.requests(), 1u);
  browser.load(folder.write("page.html",
                            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'\">"
                            "<script>1</script>"));
  EXPECT_FALSE(browser.messages().empty());
  browser.load(folder.write("page.html", "<p>no picture</p>"));
  EXPECT_EQ(coloured_share(browser.picture()), 0.0);
}

TEST(ReportPage, AHostileNameInjectsNothing) {
  const SmallPart part;
  const fs::path folder = fs::path(part.file()).parent_path();
  for (const char* name : {"<img src=x onerror=alert(1)>.obj", "a\"onload=\"alert(1).obj", "<!--.obj",
                           "<script>alert(1)<'script>.obj", "\xFF\xFE\n.obj"}) {
    const fs::path file = folder / name;
    fs::copy_file(part.file(), file);
    const std::string page = part.output("page.html");
    const auto run = run_moldlight(classify_page(file.string(), page));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string text = file_bytes(page);
    for (const char* evil : {"<img src=x", "<script>alert", "\"onload=\"", "<!--"})
      EXPECT_EQ(text.find(evil), std::string::npos) << name;
    if (!test::has_browser() || name[1] != 's') continue;
    test::Browser browser;
    browser.load(page);
    static_cast<void>(test::try_page(browser));
  }
}

TEST(ReportPage, FitsNarrowWindowsAndIsAPictureWithoutScriptsOrWebGl) {
  if (!test::has_browser()) GTEST_SKIP() << "chromium is not installed: the page is not looked at";
  const SmallPart part;
  const std::string page = part.output("page.html");
  ASSERT_EQ(run_moldlight(classify_page(part.file(), page)).exit_code, 0);
  {
    test::Browser browser;
    browser.resize(400, 900);
    browser.load(page);
    const Json found = test::try_page(browser);
    EXPECT_LE(found["width"], 400) << found;
    EXPECT_GT(found["drawn"], 0.03 * found["pixels"].get<double>()) << found;

    // No script runs in a frame with this word.
    browser.resize(940, 940);
    browser.load(part.folder().write(
        "frame.html", "<iframe sandbox src=\"page.html\" width=\"900\" height=\"900\"></iframe>"));
    // A process of its own draws that frame, some time after the page has loaded.
    double coloured = 0.0;
    for (int tries = 0; coloured <= 0.03 && tries < 100; ++tries)
      coloured = coloured_share(browser.picture());
    EXPECT_GT(coloured, 0.03);
  }
  test::Browser browser({"--disable-3d-apis"});
  browser.load(page);
  EXPECT_EQ(browser.value("begun"), "Error: no WebGL 2") << "it says so where it is asked";
  EXPECT_EQ(browser.value("document.querySelector('.view').classList.contains('live')"), false);
  EXPECT_EQ(browser.value("document.querySelector('canvas').hidden"), true);
}

TEST(ReportPage, IsTheSameEveryTime) {
  const SmallPart part;
  const std::string page = part.output("page.html");
  ASSERT_EQ(run_moldlight(classify_page(part.file(), page)).exit_code, 0);
  const std::string first = file_bytes(page);
  ASSERT_EQ(run_moldlight(classify_page(part.file(), page)).exit_code, 0);
  EXPECT_EQ(file_bytes(page), first);
}

TEST(ReportPage, CannotTakeThePlaceOfWhatIsRead) {
  const SmallPart part;
  const auto run = run_moldlight(classify_page(part.file(), part.file()));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--html"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace moldlight
