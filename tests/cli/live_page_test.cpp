// The page that --live writes, in a real browser: directions that the program did not compute are right by
// its own measure, and what is known exactly is shown exactly.
#include <fstream>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"
#include "support/browser.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::json_of;
using test::run_moldlight;
using test::SmallPart;
using Json = nlohmann::ordered_json;

constexpr const char* k_regions_json[] = {"core", "cavity", "both", "undercut"};

std::vector<std::string> live_words(const std::string& part, const std::string& page,
                                    const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = {"classify", part,     "--direction", "z",     "--backend",
                                    "osmesa",   "--html", page,          "--live"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// What a script finds in the page once it has begun: `live` is its director, `found` what it puts. The
/// page's policy, which would not let it run, is looked at by other tests.
Json found_in(const std::string& page, const std::string& script) {
  std::string text = file_bytes(page);
  text = std::regex_replace(text, std::regex("<meta http-equiv[^>]*>"), "");
  text +=
      "<script>begun.then(async (view) => { const live = view && view.director, found = {errors: "
      "notes.errors};" +
      script +
      "document.body.append(Object.assign(document.createElement('pre'), {id: 'found', textContent: "
      "JSON.stringify(found)})); });</script>";
  const std::string copy = page + ".tried.html";
  std::ofstream(copy) << text;
  const test::LoadedPage loaded = test::load_page(copy, "");
  std::smatch match;
  const std::string dom =
      loaded.dom.substr(std::min(loaded.dom.size(), loaded.dom.rfind("<pre id=\"found\">")));
  EXPECT_TRUE(std::regex_search(dom, match, std::regex(R"re(<pre id="found">([^<]+)<)re")))
      << (loaded.messages.empty() ? "" : loaded.messages.front());
  return match.empty() ? Json() : json_of(match[1]);
}

class LivePage : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::has_browser()) GTEST_SKIP() << "chromium is not installed: the page is not looked at";
  }
  void write(const std::vector<std::string>& more = {}) {
    const auto run = run_moldlight(live_words(part_.file(), page(), more));
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  [[nodiscard]] std::string page() const { return part_.output("live.html"); }
  [[nodiscard]] Json exact_areas(const std::string& direction,
                                 const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"classify", part_.file(), "--direction=" + direction, "--json",
                                      part_.output("a.json")};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_moldlight(words).exit_code, 0);
    return json_of(file_bytes(part_.output("a.json")))["areas"];
  }

  SmallPart part_;
};

TEST_F(LivePage, AreasOfAnyDirectionAreWithinTheStatedError) {
  write();
  const std::vector<std::string> directions = {"1,0,0", "0,1,0", "0.3,-0.5,0.81", "-0.7,0.2,0.1", "0.02,0,1"};
  std::string script = "found.areas = []; found.texts = [];";
  for (const std::string& direction : directions)
    script += "live.go(unit([" + direction +
              "]), true); view.draw(); found.areas.push(live.areas); "
              "found.texts.push(document.getElementById('standing').textContent);";
  const Json found = found_in(page(), script);
  ASSERT_EQ(found["errors"], Json::array());
  for (std::size_t k = 0; k < directions.size(); ++k) {
    std::smatch stated;
    const auto text = found["texts"][k].get<std::string>();
    ASSERT_TRUE(
        std::regex_search(text, stated, std::regex("Areas by shadow maps, ± ([0-9.]+) % of the surface")))
        << text;
    const Json exact = exact_areas(directions[k]);
    const double total = exact["total"], error = std::stod(stated[1]);
    EXPECT_LT(error, 2.0);
    for (std::size_t region = 0; region < 4; ++region)
      EXPECT_NEAR(100.0 * found["areas"][k][region].get<double>() / total,
                  100.0 * exact[k_regions_json[region]].get<double>() / total, error)
          << directions[k] << ' ' << k_regions_json[region];
  }
}

TEST_F(LivePage, ExactAreasStandForTheAskedDirectionAndItsOpposite) {
  write();
  const Json found = found_in(
      page(),
      "live.go([0, 0, 1], true); view.draw(); found.asked = live.areas; found.maps = view.byMaps;"
      "live.go([0, 0, -1], true); view.draw(); found.opposite = live.areas; found.exact = live.exact;"
      "live.find('#tau').value = 3; live.change(true); view.draw(); found.otherTau = live.exact;"
      "found.text = document.getElementById('standing').textContent;");
  const Json exact = exact_areas("0,0,1");
  EXPECT_EQ(found["maps"], false);
  EXPECT_EQ(found["exact"], true);
  for (std::size_t region = 0; region < 4; ++region)
    EXPECT_EQ(found["asked"][region].get<double>(), exact[k_regions_json[region]].get<double>());
  EXPECT_EQ(found["opposite"][0], found["asked"][1]);
  EXPECT_EQ(found["opposite"][1], found["asked"][0]);
  EXPECT_EQ(found["otherTau"], false);
  EXPECT_NE(found["text"].get<std::string>().find("not measured"), std::string::npos) << found["text"];
}

TEST_F(LivePage, AClickShowsTheUndercutAndWhatBlocksIt) {
  write();
  const Json found = found_in(page(),
                              "const box = view.canvas.getBoundingClientRect(); found.regions = {};"
                              "for (let x = 0.05; x < 1; x += 0.03) for (let y = 0.05; y < 1; y += 0.03) {"
                              "  const hit = live.pick(x * box.width, y * box.height);"
                              "  if (!hit) continue;"
                              "  found.regions[hit.region] = (found.regions[hit.region] ?? 0) + 1;"
                              "  if (hit.region === 'undercut') { found.depth = hit.depth; found.area = "
                              "hit.area; found.marks = view.marks.length;"
                              "    found.text = document.getElementById('picked').textContent; }"
                              "}");
  ASSERT_EQ(found["errors"], Json::array());
  ASSERT_TRUE(found["regions"].contains("undercut")) << found;
  EXPECT_GT(found["depth"], 0.0);
  EXPECT_GT(found["area"], 0.0);
  EXPECT_EQ(found["marks"], 3);
  EXPECT_NE(found["text"].get<std::string>().find("blocks it"), std::string::npos) << found["text"];
}

TEST_F(LivePage, BallArrowFieldAndKeysTurnTheDirection) {
  write();
  const Json found = found_in(
      page(),
      "const at = () => view.direction.map((value) => Number(value.toFixed(3)));"
      "document.querySelector('[data-direction=\"1,0,0\"]').click(); found.button = at();"
      "const field = document.getElementById('direction'); field.value = '0 3 4';"
      "field.dispatchEvent(new Event('change')); found.field = at();"
      "field.value = 'up'; field.dispatchEvent(new Event('change')); found.refused = at();"
      "live.ball.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft'})); found.key = at();"
      "live.go([0, 0, 1], true); view.draw(); const {clip, box} = view.seen, tip = scaled(view.tips[0], "
      "0.9), p = moved(clip, tip),"
      "w = clip[3] * tip[0] + clip[7] * tip[1] + clip[11] * tip[2] + clip[15];"
      "const hold = live.grab(box.width * (0.5 + 0.5 * p[0] / w), box.height * (0.5 - 0.5 * p[1] / w));"
      "hold(20, 0); found.arrow = at();");
  ASSERT_EQ(found["errors"], Json::array());
  EXPECT_EQ(found["button"], Json({1.0, 0.0, 0.0}));
  EXPECT_EQ(found["field"], Json({0.0, 0.6, 0.8}));
  EXPECT_EQ(found["refused"], found["field"]);
  EXPECT_NE(found["key"], found["field"]);
  EXPECT_NE(found["arrow"], Json({0.0, 0.0, 1.0}));
}

TEST_F(LivePage, KeepsThePolicyAndItsOtherControls) {
  write();
  const test::LoadedPage loaded = test::load_page(page(), "selftest");
  EXPECT_TRUE(loaded.messages.empty()) << loaded.messages.front();
  EXPECT_EQ(loaded.requests, 0u);
  std::smatch match;
  ASSERT_TRUE(std::regex_search(loaded.dom, match, std::regex(R"re(<pre id="selftest">([^<]+)<)re")));
  const Json found = json_of(match[1]);
  EXPECT_EQ(found["errors"], Json::array());
  EXPECT_EQ(found["blocked"], 0);
  EXPECT_EQ(found["glError"], 0);
  for (const char* act : {"turned", "opened", "cleared", "cut", "hidden"})
    EXPECT_GT(found[act], 0.01 * found["pixels"].get<double>()) << act;
}

TEST_F(LivePage, IsThePictureWithoutWebGl) {
  write();
  const test::LoadedPage loaded = test::load_page(page(), "selftest", {"--disable-3d-apis"});
  EXPECT_NE(loaded.dom.find("no WebGL 2"), std::string::npos);
  EXPECT_TRUE(std::regex_search(loaded.dom, std::regex("<div class=\"direct\" hidden")));
}

TEST_F(LivePage, ASweepsDirectionsAreExactCards) {
  const auto run =
      run_moldlight({"sweep", part_.file(), "--backend", "osmesa", "--directions", "60", "--refine", "2",
                     "--top", "4", "--scoring-samples", "2000", "--html", page(), "--live"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json found = found_in(page(),
                              "found.cards = []; for (const card of document.querySelectorAll('.card')) {"
                              "card.click(); view.draw(); found.cards.push(live.exact); }"
                              "found.ball = Boolean(live.live.sphere); found.named = live.places.length;");
  ASSERT_EQ(found["errors"], Json::array());
  ASSERT_GE(found["cards"].size(), 2u);
  for (const Json& exact : found["cards"]) EXPECT_EQ(exact, true);
  EXPECT_EQ(found["ball"], true);
  EXPECT_EQ(found["named"], 3 + found["cards"].size());
}

TEST(LiveFlag, NeedsAPage) {
  const SmallPart part;
  const auto run = run_moldlight({"classify", part.file(), "--direction", "z", "--live"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--html"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace moldlight
