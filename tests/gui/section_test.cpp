// Sections: chosen by key and panel, dragged by their arrow, measured at the cursor.
#include <glm/geometric.hpp>

#include "gui/panels/panels.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

class Sections : public WindowWithPart {
 protected:
  Sections() {
    window.app().open(
        part.folder().write("box.off",
                            "OFF\n8 6 0\n0 0 0\n30 0 0\n30 20 0\n0 20 0\n0 0 10\n30 0 10\n30 20 10\n0 20 10\n"
                            "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"));
    window.wait_until_loaded();
    window.wait_until_measured();
    window.settle();
  }
  [[nodiscard]] const LookSettings& look() const { return state().settings.look; }
  /// What is said at a place of the part.
  [[nodiscard]] std::vector<std::string> said_at(const glm::dvec3& point) {
    const auto pixel =
        project(state().camera, window.size(), glm::dvec3(state().model->frame.to_unit(point)));
    move_to(glm::vec2(pixel.value_or(glm::dvec2(-1.0))));
    return readout_lines(state());
  }
  using Lines = std::vector<std::string>;
};

TEST_F(Sections, GoRoundByAKey) {
  for (const Section section : {Section::across, Section::along, Section::off}) {
    key({.key = 'S'});
    EXPECT_EQ(look().section, section);
  }
  undo();
  EXPECT_EQ(look().section, Section::along);
}

TEST_F(Sections, SayThatTheyMeasureWalls) {
  const auto said = [&] {
    return std::ranges::any_of(window.app().texts(), [](const DrawnText& each) {
      return each.text.starts_with("Point at the cut");
    });
  };
  EXPECT_FALSE(said());
  click("Section=x");
  window.settle();
  EXPECT_TRUE(said());
}

TEST_F(Sections, AreDraggedByTheirArrowInOneStep) {
  click("Section=x");
  const glm::vec2 start = window.control("section arrow").centre();
  const CutPlane before = state().cut.value();
  EXPECT_NEAR(before.offset, 0.0, 1e-12);
  // As far as the plane goes in 5 units.
  const glm::ivec2 size = window.size();
  const glm::dvec3 way = 5.0 / state().model->frame.diagonal * before.normal;
  const glm::dvec2 by = *project(state().camera, size, way) - *project(state().camera, size, glm::dvec3(0.0));
  drag(start, start + glm::vec2(by));
  EXPECT_NEAR(look().section_at, 0.5 + 5.0 / 30.0, 2e-3);
  EXPECT_NEAR(glm::distance(window.control("section arrow").centre(), start + glm::vec2(by)), 0.0, 1.5);
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
  undo();
  EXPECT_EQ(look().section_at, 0.5);
  EXPECT_EQ(look().section, Section::x) << "the drag was one step";

  drag(start, start + glm::vec2(by), false);
  EXPECT_GT(look().section_at, 0.6);
  key({.key = k_escape});
  EXPECT_EQ(look().section_at, 0.5);
  window.move_mouse(start + glm::vec2(80, 0));
  window.frames(2);
  EXPECT_EQ(look().section_at, 0.5) << "it was let go";
  window.set_button(0, false);
  window.frames(2);
  drag(start, start + glm::vec2(1000, 600));
  EXPECT_EQ(look().section_at, 1.0);
}

TEST_F(Sections, TellTheThicknessAtTheCursor) {
  click("Section=x");
  EXPECT_EQ(said_at({15, 8, 4}), (Lines{"Section", "thickness 20 unit"}));
  EXPECT_FALSE(state().hover) << "a cut is no surface of the part";
  ASSERT_TRUE(state().span);
  EXPECT_NEAR(std::abs(state().span->start.y - state().span->end.y) * state().model->frame.diagonal, 20.0,
              1e-3);
  EXPECT_EQ(state().span->start.x, state().span->end.x);
  click("Section=y");
  EXPECT_EQ(said_at({8, 10, 4}), (Lines{"Section", "thickness 30 unit"}));
  click("Section=across");
  EXPECT_EQ(said_at({9, 6, 5}), (Lines{"Section", "thickness 20 unit"})) << "the shortest way";
}

TEST_F(Sections, TellTheGapBetweenWalls) {
  // A cup of 1 unit, as the tests' own parts are: its walls are cut, and what lies between them is a gap.
  const moldlight::test::Shape cup = moldlight::test::cup({});
  const std::string file = part.output("cup.obj");
  write_coloured_mesh(file, {cup.mesh, std::vector<Region>(cup.mesh.facets.size(), Region::core)});
  window.app().open(file);
  window.wait_until_loaded();
  window.settle();
  click("Section=across");
  key({.key = '7', .shift = true});
  window.settle();
  const glm::dvec3 middle = state().model->frame.center;
  const Lines lines = said_at(middle + glm::dvec3(3.0, 2.0, 0.0));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "Core") << "the cup's floor";
  ASSERT_TRUE(state().span);
  EXPECT_FALSE(state().span->material);
  EXPECT_EQ(lines[2].substr(0, 4), "gap ");
  // Beyond the gap's end there is material.
  const glm::dvec3 end = glm::dvec3(state().span->end) * state().model->frame.diagonal + middle;
  const glm::dvec3 out =
      glm::normalize(end - glm::dvec3(state().span->start) * state().model->frame.diagonal - middle);
  EXPECT_EQ(said_at(end + 0.3 * out)[0], "Section");
  EXPECT_TRUE(state().span->material);
}

}  // namespace
}  // namespace moldlight::gui::test
