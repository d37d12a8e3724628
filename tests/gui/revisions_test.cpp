// Two revisions beside each other in the window: what is listed and lit, the tied cameras, how it ends.
#include "unit/compare/revisions.hpp"

#include <chrono>
#include <regex>
#include <thread>

#include <glm/geometric.hpp>

#include "compare/change_words.hpp"
#include "gui/barrier.hpp"
#include "gui/jobs/revision_state.hpp"
#include "gui/window_with_part.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight::gui::test {
namespace {

using Of = RevisionChange::Of;

constexpr double k_hole = 3.0;
constexpr glm::vec2 k_second(640.0F, 0.0F);  // where the second picture shows what the first one shows

void write_revision(const std::string& path, const TriangleMesh& mesh) {
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  write_coloured_mesh(path, {mesh, regions});
}

class Revisions : public WindowWithPart {
 protected:
  Revisions() {
    a = part.output("before.stl");
    b = part.output("after.stl");
    write_revision(a, plate_mesh({}));
    write_revision(b, plate_mesh({.hole_radius = k_hole}));
    window.app().open(a);
    window.wait_until_loaded();
    settle();
  }
  void settle() {
    window.wait_until_measured();
    window.move_mouse({640, 60});
    window.settle();
  }
  void compare(const std::string& path) {
    window.app().compare_with(path);
    settle();
    ASSERT_TRUE(state().revisions.result) << "nothing was compared";
    EXPECT_FALSE(state().revisions.stale);
  }
  [[nodiscard]] const moldlight::Revisions& result() const { return *state().revisions.result; }
  [[nodiscard]] glm::vec2 pixel_of(const glm::dvec3& point) const {
    return glm::vec2(
        project(state().camera, window.size(), glm::dvec3(state().model->frame.to_unit(point))).value());
  }
  [[nodiscard]] std::array<int, 3> colour_at(const glm::vec2& at) const {
    const auto pixels = window.pixels();
    const glm::ivec2 pixel(at);
    const std::size_t first = 4 * static_cast<std::size_t>(pixel.y * window.size().x + pixel.x);
    return {pixels[first], pixels[first + 1], pixels[first + 2]};
  }
  [[nodiscard]] bool says(const std::string& text) const {
    return std::ranges::any_of(window.app().texts(), [&](const DrawnText& each) {
      return each.text.find(text) != std::string::npos;
    });
  }
  /// In the middle of what is gone: the disc of the top that the hole takes.
  [[nodiscard]] static glm::dvec3 disc() { return {PlateWithBoss{}.hole, k_plate_high.z}; }
  /// Of the hole's wall, what faces the camera and is not hidden by its rim.
  [[nodiscard]] glm::dvec3 wall() const {
    const glm::dvec3 toward = state().camera.toward_viewer();
    const glm::dvec2 away = -glm::normalize(glm::dvec2(toward));
    return {PlateWithBoss{}.hole + 0.99 * k_hole * away, k_plate_high.z - 0.5};
  }
  static bool is_gone(const std::array<int, 3>& c) { return c[0] > c[1] + 50 && c[2] > c[1] + 50; }
  static bool is_new(const std::array<int, 3>& c) { return c[0] > c[1] + 25 && c[1] > c[2] + 25; }
  void expect_lit() {
    EXPECT_TRUE(is_gone(colour_at(pixel_of(disc())))) << "gone on the left";
    EXPECT_TRUE(is_new(colour_at(pixel_of(wall()) + k_second))) << "new on the right";
    const glm::dvec3 corner(-18, -10, k_plate_high.z);
    for (const glm::vec2& half : {glm::vec2(0.0F), k_second}) {
      const auto plain = colour_at(pixel_of(corner) + half);
      EXPECT_FALSE(is_gone(plain) || is_new(plain)) << "what is the same is not lit";
    }
  }

  std::string a, b;
};

TEST_F(Revisions, TellWhatChangedAndNothingElse) {
  compare(b);
  ASSERT_EQ(result().changes.size(), 1U);
  EXPECT_EQ(result().changes[0].of, Of::place);
  EXPECT_EQ(result().changes[0].kind, ChangeKind::changed);
  const ChangedPlace& place = result().comparison.surface.places[0];
  const moldlight::test::Loop2 rim = regular_polygon(PlateWithBoss{}.sides, k_hole, 0.0);
  const double disc = polygon_area(rim);
  EXPECT_NEAR(place.gone.area, 2.0 * disc, place.gone.error + 1e-3);
  EXPECT_NEAR(place.added.area, polygon_perimeter(rim) * k_plate_high.z, place.added.error + 1e-3);
  EXPECT_NEAR(place.volume.volume, -disc * k_plate_high.z, 1e-2 * disc * k_plate_high.z);
  EXPECT_TRUE(window.app().controls().contains("change 1"));
  EXPECT_FALSE(window.app().controls().contains("change 2"));
  EXPECT_TRUE(says("surface changed"));
  EXPECT_TRUE(says("before.stl"));
  EXPECT_TRUE(says("after.stl"));
  const std::string regions = ChangeWording(result().comparison).regions();
  EXPECT_FALSE(std::regex_search(regions, std::regex("[0-9]{3}\\.[0-9]{2}"))) << "four digits: " << regions;
}

TEST_F(Revisions, OfAMovedBossTellTheBossAlone) {
  PlateWithBoss moved;
  moved.boss.x += 2.0;
  write_revision(b, plate_mesh(moved));
  compare(b);
  ASSERT_FALSE(result().changes.empty());
  for (const RevisionChange& change : result().changes) {
    EXPECT_EQ(change.of, Of::place);
    EXPECT_GE(change.bounds.min.x, moved.boss.x - 2.0 - moved.radius - 1e-3);
    EXPECT_LE(change.bounds.max.x, moved.boss.x + moved.radius + 1e-3);
    EXPECT_GE(change.bounds.min.z, k_plate_high.z - 1e-3);
  }
}

TEST_F(Revisions, AreLitOnBothHalvesUnderOneCamera) {
  compare(b);
  expect_lit();
  for (const float half : {0.0F, 640.0F}) {
    drag({200.0F + half, 200.0F}, {260.0F + half, 190.0F});
    window.move_mouse({640, 60});
    window.settle();
    expect_lit();
  }
  move_to(glm::vec2(900, 300));
  window.turn_wheel(-1.0F);
  window.frame();
  window.move_mouse({640, 60});
  window.settle();
  expect_lit();
}

TEST_F(Revisions, AreToldAtTheCursorOnBoth) {
  compare(b);
  const PlateWithBoss plate;
  const glm::dvec3 head(plate.boss, k_plate_high.z + plate.height);
  std::array<glm::dvec3, 2> places;
  for (const bool second : {false, true}) {
    window.move_mouse(pixel_of(head) + (second ? k_second : glm::vec2(0.0F)));
    window.settle();
    const auto& hover = state().revisions.hover;
    ASSERT_TRUE(hover);
    EXPECT_EQ(hover->second, second);
    EXPECT_FALSE(hover->change);
    places[second ? 1 : 0] = hover->place;
  }
  EXPECT_LT(glm::distance(places[0], places[1]), 2e-3) << "cameras are tied";
  EXPECT_EQ(state().hover.has_value(), false) << "what is noted of the part is of the part";

  window.move_mouse(pixel_of(disc()));
  window.settle();
  ASSERT_TRUE(state().revisions.hover);
  EXPECT_EQ(state().revisions.hover->change, 0U);
  EXPECT_TRUE(says("surface changed  ·  number 1"));
  EXPECT_TRUE(says("gone 56.3"));
  window.move_mouse(pixel_of(wall()) + k_second);
  window.settle();
  ASSERT_TRUE(state().revisions.hover);
  EXPECT_TRUE(state().revisions.hover->second);
  EXPECT_EQ(state().revisions.hover->change, 0U);
  press();
  EXPECT_EQ(state().revision_choices.chosen, 0U) << "a click chooses it";
}

TEST_F(Revisions, AChangeIsFlownToAndRelit) {
  compare(b);
  const Camera before = state().camera;
  click("change 1");
  window.move_mouse({640, 60});
  window.settle();
  EXPECT_EQ(state().revision_choices.chosen, 0U);
  EXPECT_LT(state().camera.height, before.height);
  const auto chosen = colour_at(pixel_of(disc()));
  EXPECT_GT(chosen[1], 150) << "bright, no more the colour of what is gone";
  key({.key = k_escape});
  EXPECT_FALSE(state().revision_choices.chosen);
  EXPECT_TRUE(state().revisions.on());
}

TEST_F(Revisions, FollowTheDirectionAndTheSettings) {
  compare(b);
  const auto first = state().revisions.result;
  key({.key = 'X'});
  settle();
  ASSERT_NE(state().revisions.result, first);
  EXPECT_EQ(result().comparison.a.result.direction, glm::dvec3(0, 0, -1));
  EXPECT_EQ(result().comparison.b.result.direction, glm::dvec3(0, 0, -1));
  click("revision options");
  click("Align");
  settle();
  EXPECT_TRUE(state().settings.revision.align);
  ASSERT_TRUE(result().comparison.alignment);
  undo();
  settle();
  EXPECT_FALSE(state().settings.revision.align) << "one step of undo";
  EXPECT_FALSE(result().comparison.alignment);
}

TEST_F(Revisions, LeftPutBackWhatWasThere) {
  drag({300, 300}, {360, 320});
  enter(Step::parting_line);
  settle();
  const auto camera = state().camera;
  const auto picture = window.pixels();
  const bool mold = window.app().controls().contains("loops");
  compare(b);
  EXPECT_FALSE(window.app().controls().contains("loops"));
  EXPECT_NE(window.pixels(), picture);
  key({.key = 'D', .ctrl = true});
  settle();
  EXPECT_FALSE(state().revisions.on());
  EXPECT_EQ(window.app().controls().contains("loops"), mold);
  EXPECT_EQ(state().camera, camera);
  EXPECT_EQ(window.pixels(), picture);
}

TEST_F(Revisions, AFileThatCannotBeReadIsToldInOneLine) {
  const std::string bad = part.folder().write("bad.stl", "solid nothing\nfacet normal 0 0 1\n outer lo");
  window.app().compare_with(bad);
  settle();
  EXPECT_FALSE(state().revisions.on());
  ASSERT_EQ(state().toasts.size(), 1U);
  EXPECT_TRUE(state().toasts[0].failure);
  EXPECT_NE(state().toasts[0].text.find("bad.stl"), std::string::npos) << state().toasts[0].text;
  EXPECT_EQ(state().toasts[0].text.find('\n'), std::string::npos);
  // Where there was a comparison, it stays.
  key({.key = k_escape});
  compare(b);
  const auto good = state().revisions.result;
  std::filesystem::copy_file(bad, b, std::filesystem::copy_options::overwrite_existing);
  const auto start = std::chrono::steady_clock::now();
  while (state().revisions.error.empty()) {
    window.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  }
  EXPECT_EQ(state().revisions.result, good);
}

TEST_F(Revisions, AChangedFileIsComparedAgain) {
  compare(b);
  write_revision(b, plate_mesh({}));
  const auto start = std::chrono::steady_clock::now();
  while (!result().changes.empty()) {
    window.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  }
  settle();
  EXPECT_TRUE(says("Nothing changed"));
}

TEST_F(Revisions, OfADroppedPartAreAskedFor) {
  window.drop(b);
  window.frame();
  window.settle();
  EXPECT_EQ(state().dialogs.dropped, b);
  click("Compare");
  settle();
  EXPECT_FALSE(state().dialogs.dropped);
  ASSERT_TRUE(state().revisions.result);
  click("exchange revisions");
  window.wait_until_loaded();
  settle();
  EXPECT_EQ(state().path, b);
  EXPECT_EQ(state().revisions.path, a);
  ASSERT_TRUE(state().revisions.result);
  ASSERT_EQ(result().changes.size(), 1U);
  EXPECT_GT(result().comparison.surface.places[0].volume.volume, 0.0) << "the hole is filled now";
}

TEST_F(Revisions, DoNotBreakASmallWindow) {
  for (const glm::ivec2& size : {glm::ivec2(400, 300), glm::ivec2(320, 240)}) {
    window.resize(size);
    compare(b);
    click("leave revisions");
    settle();
    EXPECT_FALSE(state().revisions.on());
  }
}

TEST(RevisionsGivenUp, LeaveThePart) {
  Barrier barrier;
  OffscreenOptions options;
  options.user.window.motion = options.user.window.quick_sweep = false;
  options.wake = [&barrier] { barrier.pass(); };
  const moldlight::test::SmallPart part, other;
  OffscreenWindow window(options);
  window.app().open(part.file());
  window.wait_until_loaded();
  window.wait_until_measured();
  barrier.set_open(false);
  window.app().compare_with(other.file());
  window.frames(4);
  ASSERT_TRUE(window.state().revisions.awaited);
  window.move_mouse(window.control("cancel revisions").centre());
  window.frames(2);
  window.set_button(0, true);
  window.frame();
  window.set_button(0, false);
  window.frames(2);
  EXPECT_FALSE(window.state().revisions.on());
  barrier.set_open(true);
  window.wait_until_measured();
  window.settle();
  EXPECT_FALSE(window.state().revisions.prepared) << "what was given up does not come";
}

}  // namespace
}  // namespace moldlight::gui::test
