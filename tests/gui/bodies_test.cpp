// The Part panel: the draft that is required, the unit, and the body that is molded.
#include <fmt/format.h>

#include "gui/store/part_notes.hpp"
#include "gui/window_with_part.hpp"
#include "support/boxes.hpp"
#include "support/zip_bytes.hpp"

namespace moldlight::gui::test {
namespace {

/// ASCII STL solids "one", "two" …: cubes of side 1, 2 …, apart.
std::string cubes(int count) {
  std::string text;
  for (int n = 1; n <= count; ++n) {
    const std::string name = n == 1 ? "one" : n == 2 ? "two" : "three";
    const double x = 10.0 * n;
    const auto corners = moldlight::test::box_corners({x, 0, 0}, {x + n, n, n});
    text += "solid " + name + "\n";
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (std::size_t k = i; k < i + 3; ++k)
        text += fmt::format("vertex {} {} {}\n", corners[k].x, corners[k].y, corners[k].z);
      text += "endloop\nendfacet\n";
    }
    text += "endsolid " + name + "\n";
  }
  return text;
}

class Bodies : public WindowWithPart {
 protected:
  Bodies() {
    window.app().open(part.folder().write("cubes.stl", cubes(3)));
    window.wait_until_loaded();
    enter(Step::part);
    window.settle();
  }
  void wait() {
    window.wait_until_loaded();
    window.wait_until_measured();
    window.settle();
  }
  [[nodiscard]] double area() const { return state().figures.shown->total_area; }
};

TEST_F(Bodies, AreGoneThroughOneByOne) {
  wait();
  EXPECT_EQ(area(), 6.0 + 24.0 + 54.0) << "all as one part";
  click("next body");
  wait();
  EXPECT_EQ(area(), 6.0);
  const Camera camera = state().camera;
  key({.key = 'F'});
  EXPECT_EQ(state().camera, camera) << "it fills the picture";
  click("next body");
  wait();
  EXPECT_EQ(area(), 24.0);
  click("previous body");
  click("previous body");
  wait();
  EXPECT_EQ(area(), 84.0) << "two clicks without waiting";
  click("previous body");
  wait();
  EXPECT_EQ(area(), 54.0) << "before all comes the last";
}

TEST_F(Bodies, AreChosenFromAList) {
  click("body");
  window.settle();
  click("body 2");
  wait();
  EXPECT_EQ(area(), 24.0);
  EXPECT_EQ(state().model->part.bodies[0].name, "two");
}

TEST_F(Bodies, OfOneFileAreNotLookedForInAnother) {
  click("next body");
  wait();
  window.app().open(part.file());
  wait();
  EXPECT_EQ(state().path, part.file());
  EXPECT_EQ(state().model->part.chosen_body, 0U);
  EXPECT_FALSE(window.app().controls().contains("next body")) << "one body is no choice";
}

TEST_F(Bodies, KeepDirectionAndDraft) {
  slide("Near-vertical below", 0.5F);
  const double tau = method().tau_deg;
  enter(Step::direction);
  click("+X");
  enter(Step::part);
  click("next body");
  wait();
  EXPECT_EQ(method().tau_deg, tau);
  EXPECT_EQ(direction(), glm::dvec3(1, 0, 0));
}

TEST_F(WindowWithPart, AUnitIsNamedAndThenConvertsNothing) {
  enter(Step::part);
  window.wait_until_measured();
  const double before = state().figures.shown->total_area;
  EXPECT_EQ(state().model->part.unit, "");
  for (const std::string unit : {"in", "mm"}) {
    click("Unit=" + unit);
    window.wait_until_loaded();
    window.wait_until_measured();
    EXPECT_EQ(state().model->part.unit, unit);
    EXPECT_EQ(state().figures.shown->total_area, before) << "the file names no unit: nothing to convert from";
  }
  PartNotes notes;
  notes.unit = "cm";
  window.app().set_notes(notes);
  window.app().open(part.folder().write("cubes.stl", cubes(1)));
  window.wait_until_loaded();
  EXPECT_EQ(state().model->part.unit, "cm") << "as it was noted for the part";
}

/// A tetrahedron whose file says that it is in inches.
const std::string k_in_inches = moldlight::test::threemf_bytes(
    R"(<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">)"
    R"(<resources><object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>)"
    R"(<vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles>)"
    R"(<triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/>)"
    R"(<triangle v1="2" v2="0" v3="3"/></triangles></mesh></object></resources>)"
    R"(<build><item objectid="1"/></build></model>)");

TEST_F(WindowWithPart, LengthsKeepTheirSizeInAnotherUnit) {
  PartNotes notes;
  notes.settings.method.tolerance = 0.01;
  window.app().set_notes(notes);
  window.app().open(part.folder().write("tetrahedron.3mf", k_in_inches));
  window.wait_until_loaded();
  window.wait_until_measured();
  ASSERT_EQ(state().model->part.unit, "in");
  const double diagonal = state().model->frame.diagonal;
  enter(Step::part);
  click("Unit=mm");
  window.wait_until_loaded();
  window.wait_until_measured();
  EXPECT_EQ(state().model->part.unit, "mm");
  EXPECT_NEAR(state().model->frame.diagonal, 25.4 * diagonal, 1e-9);
  EXPECT_NEAR(method().tolerance, 0.254, 1e-12);
}

}  // namespace
}  // namespace moldlight::gui::test
