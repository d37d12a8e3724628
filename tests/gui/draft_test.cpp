// The draft in the window: the chart that follows the required draft, walls to choose from, what is said at
// the cursor.
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gui/panels/step_panels.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

/// A block whose wall at x = 30 recedes by 0.1 over its height of 10; the others are straight.
constexpr const char* k_block =
    "OFF\n8 6 0\n0 0 0\n30 0 0\n30 20 0\n0 20 0\n0 0 10\n29.9 0 10\n29.9 20 10\n0 20 10\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

class Draft : public WindowWithPart {
 protected:
  Draft() {
    window.app().open(part.folder().write("block.off", k_block));
    window.wait_until_loaded();
    settle();
    key({.key = 'D'});
    settle();
  }
  void settle() {
    window.wait_until_measured();
    window.settle();
  }
  [[nodiscard]] const DraftCheck& check() const { return *state().mold.line->draft; }
  [[nodiscard]] bool says(const std::string& text) const {
    return std::ranges::any_of(window.app().texts(), [&](const DrawnText& each) {
      return each.text.find(text) != std::string::npos;
    });
  }
};

TEST_F(Draft, FollowsTheRequiredDraftAsTheCommandDoes) {
  ASSERT_TRUE(state().mold.line && state().mold.line->draft);
  EXPECT_EQ(check().required_deg, state().settings.required_draft.deg);
  const DraftCheck same = check_draft(*state().model, state().mold.line->assignment,
                                      state().figures.shown->reverse_draft, {check().required_deg});
  EXPECT_EQ(check().below, same.below);
  ASSERT_EQ(check().walls.size(), 4U);
  const double lean = glm::degrees(std::atan(0.01));
  EXPECT_NEAR(check().walls[3].least_deg, lean, 1e-6);
  EXPECT_TRUE(says("Below 1°: "));

  // The limit is dragged to where that wall has enough, and no other.
  const ScreenBox box = window.app().controls().at("draft chart");
  const DraftChart chart{box};
  const float level = box.centre().y;
  drag({chart.place_of(check().required_deg), level}, {chart.place_of(0.5), level});
  settle();
  EXPECT_NEAR(state().settings.required_draft.deg, 0.5, 1e-9);
  ASSERT_TRUE(state().mold.line && state().mold.line->draft);
  EXPECT_EQ(check().walls.size(), 3U);
  EXPECT_EQ(state().settings.method.tau_deg, 1.0) << "the regions' tolerance is another";
  key({.key = 'Z', .ctrl = true});
  settle();
  EXPECT_EQ(state().settings.required_draft.deg, 1.0) << "one step of undo";
  EXPECT_EQ(check().walls.size(), 4U);
}

TEST_F(Draft, AWallIsLookedAtAndItsFootShown) {
  const WallDraft& wall = check().walls.front();
  const double before = state().camera.height;
  click("wall 1");
  settle();
  ASSERT_TRUE(state().face);
  EXPECT_EQ(state().face->number, wall.face);
  EXPECT_NE(state().camera.height, before);
  EXPECT_TRUE(says("foot"));
  // Its middle is seen; there the cursor shows what to do.
  const auto& [from, to] = *wall.foot_line;
  const double up = wall.side == MoldSide::core ? 0.5 : -0.5;
  const glm::dvec3 middle = 0.5 * (from + to) + glm::dvec3(0, 0, up * wall.height);
  const auto pixel = project(state().camera, window.size(), glm::dvec3(state().model->frame.to_unit(middle)));
  ASSERT_TRUE(pixel);
  window.move_mouse(glm::vec2(*pixel));
  window.settle();
  ASSERT_TRUE(state().hover);
  EXPECT_EQ(state().faces->of_facet[state().hover->point.facet], wall.face);
  EXPECT_TRUE(says("turn by 1.00° about its foot"));
  EXPECT_EQ(wall_of_face(state(), wall.face, wall.side), &wall);
}

TEST_F(Draft, IsAskedForByItsColours) {
  EXPECT_TRUE(window.app().controls().contains("panel Draft"));
  key({.key = 'D'});
  settle();
  EXPECT_FALSE(says("Below 1°: "));
  EXPECT_FALSE(window.app().controls().contains("wall 1"));
}

TEST_F(Draft, FinishesAreGivenByClicksAndCheckedAsTheCommandDoes) {
  const auto finishes = [&]() -> const std::vector<FaceFinish>& {
    return state().settings.required_draft.finishes;
  };
  const auto click_face = [&](const glm::dvec3& middle) {
    const auto pixel =
        project(state().camera, window.size(), glm::dvec3(state().model->frame.to_unit(middle)));
    ASSERT_TRUE(pixel);
    move_to(glm::vec2(*pixel));
    press();
    settle();
  };
  const glm::dvec3 camera = state().camera.toward_viewer();
  const glm::dvec3 wall_y(15, camera.y > 0.0 ? 20 : 0, 5), wall_x(camera.x > 0.0 ? 29.95 : 0, 10, 5);
  click("finish polished");
  EXPECT_TRUE(says("Click faces: polished"));
  click_face(wall_y);
  ASSERT_EQ(finishes().size(), 1U);
  EXPECT_EQ(finishes()[0].finish, (Finish{"polished", 0.5}));
  const std::uint32_t first = finishes()[0].face;
  const glm::dvec3 before = direction();
  click("finish texture");
  click_face(wall_x);
  ASSERT_EQ(finishes().size(), 2U);
  EXPECT_EQ(direction(), before);
  EXPECT_FALSE(state().face) << "the click gave a finish";
  const std::uint32_t second = finishes()[0].face == first ? finishes()[1].face : finishes()[0].face;
  EXPECT_EQ(*finish_of(finishes(), second), (Finish{"texture 0.025 mm", 1.0}));
  ASSERT_EQ(check().finishes.size(), 2U);
  EXPECT_TRUE(says("texture 0.025 mm"));

  // The rule of the other unit asks for more.
  click("Texture rule=inch");
  settle();
  EXPECT_NEAR(finish_of(finishes(), second)->required_deg, 1.5 * 0.025 / 0.0254, 1e-12);

  // What is saved, the command reads, and finds the same.
  click("save finishes");
  window.frames(3);
  click("Save");
  window.frames(3);
  const std::string saved = part.output("block-finishes.csv");
  const auto read = read_finishes(saved, *state().model, TextureRule::inch, {});
  EXPECT_EQ(read, finishes());
  const DraftCheck same =
      check_draft(*state().model, state().mold.line->assignment, state().figures.shown->reverse_draft,
                  {state().settings.required_draft.deg, read});
  EXPECT_EQ(draft_json(*state().model, check()), draft_json(*state().model, same));

  // A second click takes it away, undo gives it back; the cross takes it from all; a file brings all again.
  click_face(wall_x);
  EXPECT_EQ(finishes().size(), 1U);
  undo();
  settle();
  EXPECT_EQ(finishes(), read);
  click("take finish 1");
  settle();
  ASSERT_EQ(finishes().size(), 1U);
  EXPECT_EQ(finishes()[0].face, first) << "the texture asks for more and stands first";
  click("load finishes");
  window.frames(3);
  click("Load");
  settle();
  EXPECT_EQ(finishes(), read);
  key({.key = k_escape});
  key({.key = k_escape});
  EXPECT_TRUE(state().draft_choices.kind.empty());
  click("finish row 1");
  settle();
  ASSERT_TRUE(state().face);
  EXPECT_EQ(state().face->number, second) << "its worst wall";
}

}  // namespace
}  // namespace moldlight::gui::test
