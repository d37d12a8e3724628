// The page that --live writes, in a real browser: directions that the program did not compute are right by
// its own measure, and what is known exactly is shown exactly.
#include <optional>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/page_trial.hpp"
#include "cli/small_part.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::json_of;
using test::run_moldlight;
using test::SmallPart;
using Json = nlohmann::ordered_json;

constexpr const char* k_regions_json[] = {"core", "cavity", "both", "undercut"};

std::vector<std::string> live_words(const std::string& part, const std::string& page) {
  return {"classify", part, "--direction", "z", "--backend", "osmesa", "--html", page, "--live"};
}

/// A page of the small part, made once for all that is looked at in it, and the browser that shows it.
class LivePage : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::has_browser()) GTEST_SKIP() << "chromium is not installed: the page is not looked at";
  }
  [[nodiscard]] std::string page() const { return part_.output("live.html"); }
  /// Loads the page anew.
  void load() {
    if (!browser_) browser_.emplace();
    browser_->load(page());
  }
  /// What a script puts into `found` once the page has begun; `live` is its director.
  [[nodiscard]] Json found(const std::string& script) {
    Json found = browser_->value(
        "begun.then(async (view) => { const live = view.director, text = (id) => "
        "document.getElementById(id).textContent, found = {};" +
        script + "return found; })");
    EXPECT_TRUE(browser_->messages().empty()) << browser_->messages().front();
    return found;
  }
  [[nodiscard]] Json exact_areas(const std::string& direction) const {
    const std::vector<std::string> words = {"classify", part_.file(), "--direction=" + direction, "--json",
                                            part_.output("a.json")};
    EXPECT_EQ(run_moldlight(words).exit_code, 0);
    return json_of(file_bytes(part_.output("a.json")))["areas"];
  }

  void areas_of_any_direction_are_within_the_stated_error();
  void exact_areas_stand_for_the_asked_direction_and_its_opposite();
  void a_click_shows_the_undercut_and_what_blocks_it();
  void ball_arrow_field_and_keys_turn_the_direction();

  SmallPart part_;
  std::optional<test::Browser> browser_;
};

void LivePage::areas_of_any_direction_are_within_the_stated_error() {
  const std::vector<std::string> directions = {"1,0,0", "0,1,0", "0.3,-0.5,0.81", "-0.7,0.2,0.1", "0.02,0,1"};
  std::string script =
      "found.resting = []; found.moving = []; found.texts = [];"
      "const keep = (list) => { view.draw(); list.push(live.areas); found.texts.push(text('standing')); };";
  for (const std::string& direction : directions)
    script += "live.shownAt = 0; live.go(unit([" + direction +
              "]), false); keep(found.moving); live.go(unit([" + direction +
              "]), true); keep(found.resting);";
  const Json found = this->found(script);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const Json exact = exact_areas(directions[k]);
    const double total = exact["total"];
    for (const std::size_t resting : {0u, 1u}) {
      std::smatch stated;
      const auto text = found["texts"][2 * k + resting].get<std::string>();
      ASSERT_TRUE(
          std::regex_search(text, stated, std::regex("Areas by shadow maps, ± ([0-9.]+) % of the surface")))
          << text;
      const double error = std::stod(stated[1]);
      EXPECT_LT(error, resting == 1 ? 0.5 : 10.0);  // maps are small while it moves
      for (std::size_t region = 0; region < 4; ++region)
        EXPECT_NEAR(100.0 * found[resting == 1 ? "resting" : "moving"][k][region].get<double>() / total,
                    100.0 * exact[k_regions_json[region]].get<double>() / total, error)
            << directions[k] << ' ' << k_regions_json[region];
    }
  }
}

void LivePage::exact_areas_stand_for_the_asked_direction_and_its_opposite() {
  const Json found = this->found(
      "live.go([0, 0, 1], true); view.draw(); found.asked = live.areas; found.maps = view.byMaps;"
      "live.go([0, 0, -1], true); view.draw(); found.opposite = live.areas; found.exact = live.exact;"
      "byId('tau').value = 3; live.change(true); view.draw(); found.otherTau = live.exact;"
      "found.text = text('standing'); byId('tau').value = live.live.tau; live.change(true); "
      "view.draw();");
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

void LivePage::a_click_shows_the_undercut_and_what_blocks_it() {
  const Json found = this->found(
      "live.go([0, 0, 1], true); view.draw();"
      "const box = view.canvas.getBoundingClientRect(); found.regions = {};"
      "for (let x = 0.05; x < 1; x += 0.03) for (let y = 0.05; y < 1; y += 0.03) {"
      "  const hit = live.pick(x * box.width, y * box.height);"
      "  if (!hit) continue;"
      "  found.regions[hit.region] = (found.regions[hit.region] ?? 0) + 1;"
      "  if (hit.region === 'undercut') { found.depth = hit.depth; found.area = hit.area;"
      "    found.marks = view.marks.length; found.text = text('picked'); }"
      "}");
  ASSERT_TRUE(found["regions"].contains("undercut")) << found;
  EXPECT_GT(found["depth"], 0.0);
  EXPECT_GT(found["area"], 0.0);
  EXPECT_EQ(found["marks"], 3);
  EXPECT_NE(found["text"].get<std::string>().find("blocks it"), std::string::npos) << found["text"];
}

void LivePage::ball_arrow_field_and_keys_turn_the_direction() {
  const Json found = this->found(
      "const at = () => view.direction.map((value) => Number(value.toFixed(3)));"
      "document.querySelector('[data-direction=\"1,0,0\"]').click(); found.button = at();"
      "const field = document.getElementById('direction'); field.value = '0 3 4';"
      "field.dispatchEvent(new Event('change')); found.field = at();"
      "field.value = 'up'; field.dispatchEvent(new Event('change')); found.refused = at();"
      "live.ball.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft'})); found.key = at();"
      "live.go([0, 0, 1], true); view.draw();"
      "live.grab(...view.onScreen(scaled(view.tips[0], 0.9)))(20, 0); found.arrow = at();");
  EXPECT_EQ(found["button"], Json({1.0, 0.0, 0.0}));
  EXPECT_EQ(found["field"], Json({0.0, 0.6, 0.8}));
  EXPECT_EQ(found["refused"], found["field"]);
  EXPECT_NE(found["key"], found["field"]);
  EXPECT_NE(found["arrow"], Json({0.0, 0.0, 1.0}));
}

TEST_F(LivePage, FollowsTheDirection) {
  const auto run = run_moldlight(live_words(part_.file(), page()));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  load();
  static_cast<void>(test::try_page(*browser_));
  load();
  areas_of_any_direction_are_within_the_stated_error();
  exact_areas_stand_for_the_asked_direction_and_its_opposite();
  a_click_shows_the_undercut_and_what_blocks_it();
  ball_arrow_field_and_keys_turn_the_direction();

  test::Browser without({"--disable-3d-apis"});
  without.load(page());
  EXPECT_EQ(without.value("begun"), "Error: no WebGL 2");
  EXPECT_EQ(without.value("document.querySelector('.direct').hidden"), true);
}

TEST_F(LivePage, ASweepsDirectionsAreExactCards) {
  const auto run =
      run_moldlight({"sweep", part_.file(), "--backend", "osmesa", "--directions", "60", "--refine", "2",
                     "--top", "4", "--scoring-samples", "2000", "--html", page(), "--live"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  load();
  const Json found = this->found(
      "found.cards = []; for (const card of document.querySelectorAll('.card')) {"
      "card.click(); view.draw(); found.cards.push(live.exact); }"
      "found.ball = Boolean(live.live.sphere); found.named = live.places.length;");
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
