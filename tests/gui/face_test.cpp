// Faces: a click chooses the whole face; its figures are those of a table of faces.
#include <glm/geometric.hpp>

#include "classify/classify_report.hpp"
#include "gui/window_with_part.hpp"

namespace moldlight::gui::test {
namespace {

/// A box of six quadrangles, which are its faces.
constexpr const char* k_box_file =
    "OFF\n8 6 0\n0 0 0\n30 0 0\n30 20 0\n0 20 0\n0 0 10\n30 0 10\n30 20 10\n0 20 10\n"
    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

class ChosenFaces : public WindowWithPart {
 protected:
  void open_box() {
    window.app().open(part.folder().write("box.off", k_box_file));
    window.wait_until_loaded();
    window.wait_until_measured();
  }
  [[nodiscard]] glm::vec2 place_of(const glm::dvec3& point) const {
    const auto pixel =
        project(state().camera, window.size(), glm::dvec3(state().model->frame.to_unit(point)));
    return glm::vec2(pixel.value_or(glm::dvec2(-1.0)));
  }
  [[nodiscard]] std::vector<std::uint8_t> settled_pixels() {
    window.move_mouse({-1e6F, -1e6F});
    window.settle();
    std::vector<std::uint8_t> pixels = window.pixels();
    // Below the bar, which shows whether there is something to undo.
    pixels.erase(pixels.begin(), pixels.begin() + std::ptrdiff_t{4} * 40 * window.size().x);
    return pixels;
  }
};

TEST_F(ChosenFaces, AClickChoosesTheWholeFace) {
  open_box();
  const std::vector<std::uint8_t> bare = settled_pixels();
  move_to(place_of({12, 9, 10}));
  press();
  ASSERT_TRUE(state().face);
  EXPECT_EQ(state().face->number, 1U);
  EXPECT_EQ(state().faces->facets(1).size(), 2U);
  EXPECT_EQ(outline_of(*state().model, *state().faces, 1).size(), 4U) << "no diagonal";
  ASSERT_TRUE(state().face->figures);
  EXPECT_DOUBLE_EQ(state().face->figures->areas.total(), 600.0);
  const auto table = face_areas(*state().model, *state().figures.shown);
  ASSERT_EQ(table.size(), 6U);
  for (const Region region : k_regions)
    EXPECT_EQ(state().face->figures->areas[region], table[1].areas[region]);
  EXPECT_EQ(state().face->figures->least_draft_deg, 90.0);
  EXPECT_EQ(state().face->figures->most_draft_deg, 90.0);
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1)) << "a click leaves the direction";
  EXPECT_FALSE(state().can_undo);
  const std::vector<std::uint8_t> chosen = settled_pixels();
  EXPECT_NE(chosen, bare);

  // Another face, then what is measured anew, then none.
  move_to(place_of({30, 9, 4}));
  press();
  ASSERT_TRUE(state().face);
  EXPECT_EQ(state().face->number, 3U);
  click("+X");
  window.wait_until_measured();
  EXPECT_EQ(state().face->figures->areas[Region::core], 200.0);
  key({.key = k_escape});
  EXPECT_FALSE(state().face);
  click("+Z");
  window.wait_until_measured();
  EXPECT_EQ(settled_pixels(), bare);
}

TEST_F(ChosenFaces, ADragChoosesNothingAndTheBackgroundClears) {
  open_box();
  const glm::vec2 place = place_of({12, 9, 10});
  drag(place, place + glm::vec2(40, 10));
  EXPECT_FALSE(state().face);
  move_to(place_of({12, 9, 10}));
  press();
  EXPECT_TRUE(state().face);
  move_to({300, 560});
  ASSERT_FALSE(state().hover);
  press();
  EXPECT_FALSE(state().face);
}

TEST_F(ChosenFaces, OfAPartThatNamesNoneAreFoundByHowItBends) {
  move_to({640, 360});
  ASSERT_TRUE(state().hover);
  ASSERT_TRUE(state().model->part.facet_source.empty());
  const std::vector<std::uint8_t> hovered = window.pixels();
  press();
  ASSERT_TRUE(state().face);
  EXPECT_EQ(state().face->number, state().faces->of_facet[state().hover->point.facet]);
  window.settle();
  EXPECT_NE(window.pixels(), hovered);
}

TEST_F(ChosenFaces, ThePartingLineIsDrawn) {
  const std::vector<std::uint8_t> bare = settled_pixels();
  click("Parting line");
  EXPECT_TRUE(state().settings.look.parting_line);
  EXPECT_NE(settled_pixels(), bare);
  undo();
  EXPECT_EQ(settled_pixels(), bare);
}

}  // namespace
}  // namespace moldlight::gui::test
