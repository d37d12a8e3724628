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

/// What follows a hand: `press(element, x, y)` presses a place of the page and lets go.
constexpr const char* k_press = R"js(
  const press = (element, clientX, clientY) => {
    element.setPointerCapture = () => {};  // no pointer of the browser's own is there
    for (const type of ["pointerdown", "pointerup"])
      element.dispatchEvent(new PointerEvent(type, {pointerId: 1, clientX, clientY, bubbles: true}));
  };)js";

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
  const Json found = this->found(std::string(k_press) + R"js(
    live.go([0, 0, 1], true);
    view.draw();
    const box = view.canvas.getBoundingClientRect(), {mesh, size} = live.rays;
    // Facet by facet: how far along a way the next surface that faces the point is.
    const nearest = (point, way) => Math.min(...Array.from({length: mesh.facets}, (_, f) => {
      const [a, b, c] = mesh.cornersOf(f), normal = at(mesh.normals, f), along = dot(normal, way);
      const reach = dot(normal, minus(a, point)) / along, place = plus(point, scaled(way, reach));
      const inside = [[a, b], [b, c], [c, a]].every(([start, stop]) =>
        dot(normal, cross(minus(stop, start), minus(place, start))) >= 0);
      return inside && along < 0 && reach > -1e-7 * size ? reach : Infinity;
    }));
    const corners = Array.from({length: mesh.facets}, (_, f) => mesh.cornersOf(f)).flat();
    const heights = corners.map((corner) => corner[2]);
    found.height = Math.max(...heights) - Math.min(...heights);
    Object.assign(found, {regions: {}, off: 0, blocked: 0});
    for (let x = 0.05; x < 1; x += 0.03) for (let y = 0.05; y < 1; y += 0.03) {
      const hit = live.pick(x * box.width, y * box.height);
      if (!hit) continue;
      found.regions[hit.region] = (found.regions[hit.region] ?? 0) + 1;
      if (hit.region !== "Undercut") continue;
      const {eye, way} = view.sightAt(x * box.width, y * box.height), from = inPart(live.live, eye);
      const point = plus(from, scaled(way, live.rays.hit(from, way, true).way));
      for (const [side, blocker] of [[1, hit.blockers.plus], [-1, hit.blockers.minus]]) {
        if (!blocker || hit.blockers.beside) continue;
        ++found.blocked;
        found.off = Math.max(found.off, Math.abs(blocker.way - nearest(point, [0, 0, side])) / size);
      }
      Object.assign(found, {depth: hit.depth, area: hit.area, marks: view.marks.length, at: [x, y]});
    }
    live.mark("", []);
    const [x, y] = found.at;
    press(view.canvas, box.left + x * box.width, box.top + y * box.height);
    found.text = text("picked");)js");
  ASSERT_TRUE(found["regions"].contains("Undercut")) << found;
  EXPECT_GE(found["regions"].size(), 2u) << found;
  EXPECT_GT(found["depth"], 0.0);
  EXPECT_LE(found["depth"], found["height"]);
  EXPECT_LE(found["area"].get<double>(), 1.2 * exact_areas("0,0,1")["undercut"].get<double>());
  EXPECT_GT(found["area"], 0.0);
  EXPECT_GT(found["blocked"], 0) << found;
  EXPECT_LT(found["off"], 1e-9) << "what blocks it is the nearest surface along the direction";
  EXPECT_EQ(found["marks"], 3);
  const std::string text = found["text"];
  EXPECT_TRUE(text.starts_with("Undercut of ")) << text;
  EXPECT_NE(text.find(" deep along the direction."), std::string::npos) << text;
  EXPECT_NE(text.find("blocks it"), std::string::npos) << text;
}

void LivePage::ball_arrow_field_and_keys_turn_the_direction() {
  const Json found = this->found(
      "const at = () => view.direction.map((value) => Number(value.toFixed(3)));"
      "document.querySelector('button[data-direction=\"1,0,0\"]').click(); found.button = at();"
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
  const Json found = this->found(std::string(k_press) + R"js(
    found.cards = [];
    for (const card of document.querySelectorAll(".card")) {
      card.click();
      view.draw();
      found.cards.push(live.exact);
    }
    found.named = live.places.length;
    const ball = live.ball.getBoundingClientRect(), stage = view.canvas.getBoundingClientRect(), {gl} = view;
    // Where a direction is on the ball, in radii from its middle.
    const placeOf = (direction) => [dot(direction, view.seen.right), dot(direction, view.seen.above)];
    const go = ([x, y]) =>
      press(live.ball, ball.left + ball.width * (0.5 + 0.5 * x), ball.top + ball.height * (0.5 - 0.5 * y));
    // Away from all names.
    const free = unit(plus(view.seen.toward, scaled(view.seen.right, -0.37), scaled(view.seen.above, -0.21)));
    go(placeOf(free));
    found.off = Math.hypot(...minus(view.direction, free));
    live.change(true);
    view.draw();
    found.byMaps = !live.exact;
    // Beside the second one's number, which is met.
    const listed = live.places[4].direction;
    const near = dot(listed, view.seen.toward) < 0 ? scaled(listed, -1) : listed;
    go(placeOf(unit(plus(near, scaled(view.seen.right, 0.02)))));
    live.change(true);
    view.draw();
    found.met = [1 - dot(view.direction, near), live.exact];
    // The colours of the map, among them none of the bare ball's grays.
    const ratio = view.canvas.width / stage.width, pixel = new Uint8Array(4);
    found.colours = [[-0.4, -0.4], [0.3, -0.5], [-0.5, 0.1]].map(([x, y]) => {
      const left = ball.left - stage.left + ball.width * (0.5 + 0.5 * x);
      const bottom = stage.bottom - ball.bottom + ball.height * (0.5 + 0.5 * y);
      gl.readPixels(ratio * left, ratio * bottom, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return Math.max(...pixel.slice(0, 3)) - Math.min(...pixel.slice(0, 3));
    });)js");
  ASSERT_GE(found["cards"].size(), 2u);
  for (const Json& exact : found["cards"]) EXPECT_EQ(exact, true);
  EXPECT_EQ(found["named"], 3 + found["cards"].size());
  EXPECT_LT(found["off"], 0.03) << "a click goes where it is";
  EXPECT_EQ(found["byMaps"], true);
  EXPECT_LT(found["met"][0], 1e-12) << found;
  EXPECT_EQ(found["met"][1], true);
  for (const Json& spread : found["colours"]) EXPECT_GT(spread, 20) << found;
}

TEST(LiveFlag, NeedsAPage) {
  const SmallPart part;
  const auto run = run_moldlight({"classify", part.file(), "--direction", "z", "--live"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--html"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace moldlight
