// The Part panel: the bodies of the file as a tree, of which one is molded, and the unit.
#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "base/stopwatch.hpp"
#include "classify/part_model.hpp"
#include "gui/panels/step_panels.hpp"
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
  /// On so many bodies at least; 0: on all.
  void wait_for_verdicts(std::ptrdiff_t least = 0) {
    const moldlight::Stopwatch stopwatch;
    const auto& found = state().bodies.verdicts;
    const auto all = static_cast<std::ptrdiff_t>(found.size());
    const auto known = [](const std::optional<Verdict>& verdict) { return verdict.has_value(); };
    while (std::ranges::count_if(found, known) < (least > 0 ? least : all)) {
      window.frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      ASSERT_LT(stopwatch.elapsed_ms(), 60'000.0);
    }
    window.settle();
  }
};

TEST_F(Bodies, AreATreeWithTheirNamesAndVerdicts) {
  wait();
  EXPECT_EQ(area(), 6.0 + 24.0 + 54.0) << "all as one part";
  wait_for_verdicts();
  for (const char* text : {"All 3 bodies as one part", "one", "two", "three"})
    EXPECT_TRUE(std::ranges::any_of(window.app().texts(), [&](const DrawnText& drawn) {
      return drawn.text == text;
    })) << text;
  ASSERT_EQ(state().bodies.verdicts.size(), 3U);
  for (const auto& verdict : state().bodies.verdicts)
    EXPECT_EQ(verdict->sentence, "Two-plate mold: no undercut.");
}

TEST_F(Bodies, AreMoldedOneOrAllWithoutReadingTheFileAgain) {
  wait();
  const Part* const whole = &state().bodies.whole->model->part;
  click("body 1");
  EXPECT_EQ(state().reading.body, "all") << "it is looked at";
  click("Mold this one");
  wait();
  EXPECT_EQ(area(), 6.0);
  EXPECT_EQ(state().model->part.bodies[0].name, "one");
  EXPECT_EQ(state().body, 0U);
  const Camera camera = state().camera;
  key({.key = 'F'});
  EXPECT_EQ(state().camera, camera) << "it fills the picture";
  click("body 3");
  wait();
  EXPECT_EQ(area(), 54.0) << "another one is a click away";
  EXPECT_EQ(&state().bodies.whole->model->part, whole);
  click("all bodies");
  wait();
  EXPECT_EQ(area(), 84.0);
  EXPECT_EQ(&state().model->part, whole) << "as it was";
}

TEST_F(Bodies, AreTheSameAsThoseThatAreReadAlone) {
  wait();
  click("body 2");
  click("Mold this one");
  wait();
  ReadOptions alone;
  alone.body = "2";
  const auto read = load_part(state().path, alone, Progress());
  EXPECT_EQ(state().model->part.mesh.facets, read->part.mesh.facets);
  EXPECT_EQ(state().model->part.mesh.vertices, read->part.mesh.vertices);
  EXPECT_EQ(state().model->part.file_facets, read->part.file_facets);
  EXPECT_EQ(state().reading, alone);
}

TEST_F(Bodies, AreHiddenAndIsolatedInThePicture) {
  wait();
  const std::vector<std::uint8_t> all = window.pixels();
  const auto differing = [&] {
    std::size_t count = 0;
    const std::vector<std::uint8_t> now = window.pixels();
    for (int y = 60; y < 600; ++y)
      for (int x = 300; x < 980; ++x) {
        const std::size_t at = 4 * (static_cast<std::size_t>(y) * 1280 + static_cast<std::size_t>(x));
        if (std::abs(int{now[at]} - int{all[at]}) > 24) ++count;
      }
    return count;
  };
  click("hide 3");
  move_to({640, 60});
  window.settle();
  EXPECT_EQ(state().hidden_bodies, (std::set<std::size_t>{2}));
  EXPECT_GT(differing(), 2'000U) << "the largest is gone";
  click("hide 3");
  move_to({640, 60});
  window.settle();
  EXPECT_LT(differing(), 50U);
  click("body 2");
  click("Isolate");
  window.settle();
  EXPECT_EQ(state().hidden_bodies, (std::set<std::size_t>{0, 2}));
  // It fills the picture, and is what a click there means.
  click("body 1");
  EXPECT_EQ(state().body, 0U);
  key({.key = k_escape});
  click("body 2");
  window.settle();
  move_to({640, 390});
  press();
  EXPECT_EQ(state().body, 1U);
  click("Show all");
  EXPECT_TRUE(state().hidden_bodies.empty());
  EXPECT_EQ(area(), 84.0) << "only the picture was without them";
}

TEST_F(Bodies, HaveTheirVerdictsInATable) {
  wait();
  wait_for_verdicts();
  click("All verdicts");
  window.settle();
  const auto above = [&](const char* first, const char* second) {
    return window.control(first).min.y < window.control(second).min.y;
  };
  click("sort by facets");
  click("sort by body");
  EXPECT_TRUE(above("body row 1", "body row 3")) << "one, three";
  EXPECT_TRUE(above("body row 3", "body row 2")) << "three, two";
  click("sort by body");
  EXPECT_TRUE(above("body row 2", "body row 1")) << "the other way round";
  click("body row 2");
  EXPECT_EQ(state().body, 1U) << "it is looked at";
  click("close bodies");
  EXPECT_FALSE(window.app().controls().contains("body row 1"));
}

TEST_F(Bodies, AreSortedAndFilteredByTheirVerdicts) {
  wait();
  BodiesState bodies = state().bodies;
  const auto verdict = [](VerdictState is, double undercut, const char* sentence) {
    Verdict made;
    made.state = is;
    made.undercut_area = undercut;
    made.sentence = sentence;
    return made;
  };
  bodies.verdicts = {verdict(VerdictState::side_actions, 2.0, "1 slide releases it."), std::nullopt,
                     verdict(VerdictState::not_releasable, 1.0, "Not releasable.")};
  using By = BodyOrder::By;
  using Rows = std::vector<std::size_t>;
  EXPECT_EQ(sorted_bodies(bodies, {}), (Rows{0, 2, 1})) << "what is not known comes last";
  EXPECT_EQ(sorted_bodies(bodies, {.descending = false}), (Rows{2, 0, 1}));
  EXPECT_EQ(sorted_bodies(bodies, {.by = By::verdict}), (Rows{2, 0, 1})) << "the worst first";
  EXPECT_EQ(sorted_bodies(bodies, {.by = By::name, .descending = false}), (Rows{0, 2, 1}));
  EXPECT_EQ(sorted_bodies(bodies, {.words = "RELEAS"}), (Rows{0, 2}));
  EXPECT_EQ(sorted_bodies(bodies, {.words = "slide one"}), (Rows{0}));
  EXPECT_TRUE(sorted_bodies(bodies, {.words = "four"}).empty());
}

TEST_F(Bodies, OfOneFileAreNotLookedForInAnother) {
  wait();
  click("body 1");
  click("Mold this one");
  wait();
  window.app().open(part.file());
  wait();
  EXPECT_EQ(state().path, part.file());
  EXPECT_EQ(state().model->part.chosen_body, 0U);
  EXPECT_FALSE(window.app().controls().contains("all bodies")) << "one body is no choice";
}

TEST_F(Bodies, KeepDirectionAndDraft) {
  wait();
  slide("Near-vertical below", 0.5F);
  const double tau = method().tau_deg;
  enter(Step::direction);
  click("+X");
  enter(Step::part);
  click("body 1");
  click("Mold this one");
  wait();
  EXPECT_EQ(method().tau_deg, tau);
  EXPECT_EQ(direction(), glm::dvec3(1, 0, 0));
}

TEST_F(Bodies, AreAtHandAtOnceIfThereAreAThousand) {
  window.app().open(part.folder().write("thousand.obj", moldlight::test::obj_of_boxes(1000)));
  wait();
  ASSERT_EQ(state().bodies.verdicts.size(), 1000U);
  click("body 2");
  const moldlight::Stopwatch stopwatch;
  click("Mold this one");
  while (state().reading.body != "2" || !state().figures.shown || state().figures.stale) {
    window.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ASSERT_LT(stopwatch.elapsed_ms(), 3'000.0);
  }
  std::printf("one of 1,000 bodies: %.0f ms\n", stopwatch.elapsed_ms());
  EXPECT_EQ(area(), 24.0);
  wait_for_verdicts(20);
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
