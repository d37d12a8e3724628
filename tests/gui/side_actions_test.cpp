// Side actions in the window, on the shipped lid: the list, the body that moves, directions and pins by hand.
#include "gui/view/side_actions.hpp"

#include <filesystem>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "gui/panels/panels.hpp"
#include "gui/view/mold_view.hpp"
#include "gui/window_with_part.hpp"
#include "io/mesh_writer.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"
#include "support/solid_builder.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight::gui::test {
namespace {

namespace fs = std::filesystem;

constexpr int k_delete = 261;

class SideActions : public ::testing::Test {
 protected:
  SideActions() : window(options()) {}

  static OffscreenOptions options() {
    OffscreenOptions options = quick_options();
    options.size = {1280, 720};
    options.user.window.quick_sweep = false;
    options.reading.unit = "mm";
    return options;
  }
  void open_lid() {
    const std::string path = folder.file("lid.stl");
    fs::copy_file(moldlight::test::asset_folder() / "parts" / "enclosure_lid.stl", path);
    open(path);
  }
  /// A box with a hook in it, for a lifter, and beside it a block with a groove, for a slide.
  void open_hook_and_groove() {
    TriangleMesh mesh = box_with_hook(3.0);
    moldlight::test::SolidBuilder solid;
    solid.extrude({{60, 0}, {80, 0}, {80, 5}, {76, 5}, {76, 10}, {80, 10}, {80, 15}, {60, 15}}, {}, 30.0);
    const TriangleMesh groove = solid.mesh();
    const auto first = static_cast<VertexIndex>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), groove.vertices.begin(), groove.vertices.end());
    for (const auto& corners : groove.facets)
      mesh.facets.push_back({first + corners[0], first + corners[1], first + corners[2]});
    const std::vector<Region> regions(mesh.facets.size(), Region::both);
    const std::string path = folder.file("hook_and_groove.stl");
    write_coloured_mesh(path, {.mesh = mesh, .regions = regions});
    open(path);
  }
  void open(const std::string& path) {
    window.app().open(path);
    window.wait_until_loaded();
    window.wait_until_measured();
    key({.key = '3'});
    window.settle();
  }

  /// A groove across which a slide may turn by nearly half a turn.
  void open_groove() {
    moldlight::test::SolidBuilder solid;
    solid.extrude({{0, 0}, {20, 0}, {20, 5}, {10, 5}, {10, 10}, {20, 10}, {20, 15}, {0, 15}}, {}, 60.0);
    const TriangleMesh mesh = solid.mesh();
    const std::vector<Region> regions(mesh.facets.size(), Region::both);
    const std::string path = folder.file("groove.stl");
    write_coloured_mesh(path, {.mesh = mesh, .regions = regions});
    open(path);
  }

  [[nodiscard]] bool is_told(std::string_view text) const {
    return std::ranges::any_of(window.app().texts(),
                               [&](const DrawnText& each) { return each.text.starts_with(text); });
  }
  [[nodiscard]] const AppState& state() const { return window.state(); }
  [[nodiscard]] const ActionPlan& plan() const { return *state().actions.plan; }
  [[nodiscard]] const ActionSettings& settings() const { return state().settings.actions; }
  [[nodiscard]] std::string sentence() const { return verdict_card(state()).sentence; }

  void move_to(const glm::vec2& place) {
    window.move_mouse(place);
    window.frames(2);
  }
  void click(const std::string& control) {
    move_to(window.control(control).centre());
    window.set_button(0, true);
    window.frame();
    window.set_button(0, false);
    window.frames(3);
  }
  void key(const KeyPress& press) {
    window.press_key(press);
    window.frame();
    window.hold_modifiers(false, false, false);
    window.frames(3);
  }
  void drag(const glm::vec2& from, const glm::vec2& to) {
    move_to(from);
    window.set_button(0, true);
    window.frames(2);
    for (int step = 1; step <= 8; ++step) {
      window.move_mouse(from + (to - from) * (0.125F * static_cast<float>(step)));
      window.frame();
    }
    window.set_button(0, false);
    window.frames(3);
  }
  /// The picture some frames after a row was clicked, the mouse in a corner.
  std::vector<std::uint8_t> picture_after(const char* row, int frames) {
    click(row);
    move_to({4, 700});
    window.frames(frames);
    return window.pixels();
  }

  moldlight::test::ScratchFolder folder;
  OffscreenWindow window;
};

TEST_F(SideActions, AreToldInTheVerdictAndListed) {
  open_hook_and_groove();
  EXPECT_TRUE(sentence().starts_with("1 slide and 1 lifter release both undercuts (")) << sentence();
  ASSERT_EQ(plan().undercuts.size(), 2U);
  ASSERT_TRUE(state().figures.undercuts.has_value());
  EXPECT_EQ(state().figures.undercuts->count, plan().undercuts.size())
      << "as they are counted before there is a list";
  for (std::size_t k = 1; k <= plan().undercuts.size(); ++k)
    EXPECT_TRUE(window.app().controls().contains("undercut " + std::to_string(k))) << k;
  EXPECT_TRUE(is_told("lifter"));
  EXPECT_TRUE(is_told("stroke 21.3 mm"));
  EXPECT_TRUE(is_told("free −"));
}

TEST_F(SideActions, MoveWhileTheyAreLookedAt) {
  open_hook_and_groove();
  const glm::dquat before = state().camera.orientation;
  const auto first = picture_after("undercut 1", 40);
  EXPECT_NE(state().camera.orientation, before) << "flies there";
  EXPECT_EQ(state().action_choices.chosen, 0U);
  window.frames(24);
  const auto later = window.pixels();
  EXPECT_NE(first, later) << "it moves";
  click("undercut 1");
  EXPECT_FALSE(state().action_choices.chosen) << "a second click ends it";
  EXPECT_EQ(picture_after("undercut 1", 40), first) << "the same after the same time";
  key({.key = k_escape});
  EXPECT_FALSE(state().action_choices.chosen);
}

TEST_F(SideActions, MoveInTheirOrderWhileTheMoldOpens) {
  open_hook_and_groove();
  key({.key = '6'});
  const glm::vec2 slider = window.control("Opened").centre();
  const auto open_to = [&](float share) {
    const ScreenBox box = window.control("Opened");
    drag(slider, {glm::mix(box.min.x, box.max.x, share), slider.y});
    return body_places(state(), state().settings.look.open_mold, 0.0, true);
  };
  const auto opened = [&] { return opened_mold(&plan(), state().settings.look.open_mold); };
  const auto early = open_to(0.08F);
  ASSERT_FALSE(early.empty());
  EXPECT_GT(opened().slides, 0.0);
  EXPECT_EQ(opened().halves, 0.0);
  window.frames(60);  // no double click
  open_to(0.99F);
  EXPECT_GT(opened().lifters, 0.9);
  EXPECT_EQ(opened().halves, 1.0);
}

TEST_F(SideActions, AreSeenWholeInTheShotThatOpensTheMold) {
  open_hook_and_groove();
  move_to({640, 300});
  window.turn_wheel(6.0F);  // the camera is no longer fitted
  window.settle();
  key({.key = 'O'});
  window.frames(90);
  key({.key = ' '});
  window.settle();
  const double stopped = state().settings.look.open_mold;
  EXPECT_GT(stopped, 0.0);
  EXPECT_LT(stopped, 1.0);
  EXPECT_GT(opened_mold(&plan(), stopped).slides, 0.0);
  EXPECT_EQ(opened_mold(&plan(), stopped).lifters, 0.0);
  click("settings");
  click("Motion");
  key({.key = k_escape});
  key({.key = 'O'});
  window.settle();
  EXPECT_EQ(state().settings.look.open_mold, 1.0) << "it goes on";
  EXPECT_EQ(opened_mold(&plan(), 1.0).lifters, 1.0);
  const glm::vec3 way(k_mold_travel * state().settings.direction.unit());
  const auto expect_seen = [&](const glm::vec3& point) {
    const glm::dvec2 pixel =
        project(state().camera, options().size, glm::dvec3(point)).value_or(glm::dvec2(-1.0));
    EXPECT_TRUE(pixel.x > 0.0 && pixel.y > 0.0 && pixel.x < 1280.0 && pixel.y < 720.0)
        << pixel.x << ", " << pixel.y;
  };
  for (const glm::vec3& corner : points_of_bodies(state(), 1.0, true)) expect_seen(corner);
  for (const glm::vec3& corner : block_corners(state())) {
    const float side = glm::dot(corner, way) < 0.0F ? -1.0F : 1.0F;
    expect_seen(corner + side * way);
  }
  key({.key = 'O'});
  window.settle();
  EXPECT_EQ(state().settings.look.open_mold, 0.0);
}

TEST_F(SideActions, KeepToAPinUntilItIsUndone) {
  open_lid();
  const std::string free = sentence();
  click("pin 3");
  click("none");
  ASSERT_EQ(settings().pins.size(), 1U);
  window.wait_until_measured();
  ASSERT_TRUE(plan().undercuts[2].pin);
  EXPECT_EQ(action_of(plan(), 2), nullptr);
  EXPECT_EQ(sentence().find("1 slide"), std::string::npos) << sentence();

  key({.key = 'B'});
  key({.key = 'Z', .ctrl = true});
  window.wait_until_measured();
  EXPECT_TRUE(settings().pins.empty());
  EXPECT_EQ(sentence(), free);
  key({.key = '2'});
  click("bookmark");
  click("go");
  key({.key = k_escape});
  key({.key = '3'});
  window.wait_until_measured();
  ASSERT_EQ(settings().pins.size(), 1U) << "the bookmark restores it";
  EXPECT_TRUE(plan().undercuts[2].pin);

  click("pin 3");
  click("automatic");
  EXPECT_TRUE(settings().pins.empty());
}

TEST_F(SideActions, ShowWhatTheirSettingsDo) {
  open_hook_and_groove();
  const auto stroke = [&] { return *action_of(plan(), 1)->stroke; };
  const double before = stroke();
  click("action options");
  click("lifter_angle_deg");
  window.frames(3);
  window.type("16");
  window.frames(2);
  key({.key = 257});
  window.wait_until_measured();
  EXPECT_EQ(settings().lifter_angle_deg, 16.0);
  EXPECT_NEAR(stroke(), before * std::tan(glm::radians(8.0)) / std::tan(glm::radians(16.0)), 1e-6);
  key({.key = 'Z', .ctrl = true});
  EXPECT_EQ(settings().lifter_angle_deg, 8.0);
}

TEST_F(SideActions, ShowTheWindowThatWouldDoWithoutThem) {
  open_groove();
  EXPECT_FALSE(window.app().controls().contains("undercut window")) << "none is looked at";
  click("undercut 1");
  window.settle();
  const DesignChange* const change = chosen_change(state());
  ASSERT_TRUE(change != nullptr && change->depth && change->window);
  EXPECT_NEAR(*change->depth, 10.0, 0.07);
  EXPECT_NEAR(change->window->area, 600.0, 0.6);
  EXPECT_TRUE(is_told("or a window of 600 mm²"));
  // Where the corners of the way through are seen.
  const double top = change->window->core_side ? 15.0 : 0.0;
  ScreenBox seen{glm::vec2(1e9F), glm::vec2(-1e9F)};
  for (const glm::dvec3 corner :
       {glm::dvec3(10, 0, top), glm::dvec3(20, 0, top), glm::dvec3(10, 60, top), glm::dvec3(20, 60, top)}) {
    const auto at = project(state().camera, {1280, 720}, glm::dvec3(state().model->frame.to_unit(corner)));
    ASSERT_TRUE(at);
    seen.min = glm::min(seen.min, glm::vec2(*at));
    seen.max = glm::max(seen.max, glm::vec2(*at));
  }
  const ScreenBox drawn = window.control("undercut window");
  EXPECT_LT(glm::distance(drawn.min, seen.min), 2.0F);
  EXPECT_LT(glm::distance(drawn.max, seen.max), 2.0F);
  move_to(window.control("undercut 1").centre());
  window.frames(60);
  const auto texts = window.app().texts();
  EXPECT_TRUE(std::ranges::any_of(texts, [](const DrawnText& each) {
    return each.text.find("What to change of the part: cut back by 10 mm, or open ") != std::string::npos;
  })) << "the row's tip";
  click("undercut 1");
  EXPECT_FALSE(window.app().controls().contains("undercut window"));
}

TEST_F(SideActions, TakeADirectionThatIsDraggedAndFree) {
  open_groove();
  ASSERT_EQ(plan().actions.size(), 1U);
  click("undercut 1");
  window.settle();
  ASSERT_TRUE(side_arrow(state())->free);
  EXPECT_GT(side_arrow(state())->free->to_deg, 80.0);
  // From above it turns as the hand does.
  key({.key = '7', .shift = true});
  window.frames(30);
  const glm::vec2 tip = window.control("side arrow").centre();
  drag(tip, tip + glm::vec2(-40.0F, -60.0F));
  ASSERT_EQ(settings().side_directions.size(), 1U);
  const glm::dvec3 wish = settings().side_directions.front();
  EXPECT_NEAR(wish.z, 0.0, 1e-9) << "across the parting direction";
  EXPECT_GT(std::abs(glm::degrees(std::atan2(wish.y, wish.x))), 10.0);
  window.wait_until_measured();
  EXPECT_GT(glm::dot(plan().actions.front().direction, wish), 1.0 - 1e-9);
  EXPECT_EQ(state().action_choices.chosen, 0U) << "it is still looked at";
  key({.key = 'Z', .ctrl = true});
  EXPECT_TRUE(settings().side_directions.empty()) << "a drag is one step";
  key({.key = 'Y', .ctrl = true});
  EXPECT_EQ(settings().side_directions.size(), 1U);
  key({.key = k_delete});
  EXPECT_TRUE(settings().side_directions.empty());
  key({.key = 'Z', .ctrl = true});
  window.wait_until_measured();
  click("by hand 1");
  EXPECT_TRUE(settings().side_directions.empty());
}

}  // namespace
}  // namespace moldlight::gui::test
