// The first thing that is said of a part, and the sweep that runs by itself for it.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "gui/panels/panels.hpp"
#include "gui/window_with_part.hpp"
#include "io/mesh_writer.hpp"
#include "support/boxes.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight::gui::test {
namespace {

class Verdicts : public ::testing::Test {
 protected:
  explicit Verdicts(int directions = 40) : window_(options(directions)) {}

  static OffscreenOptions options(int directions) {
    OffscreenOptions options = quick_options();
    options.user.window.motion = false;
    options.user.sweep.directions = directions;
    options.user.sweep.refine = 1;
    options.user.layout = k_look_unfolded;
    return options;
  }

  void open(const TriangleMesh& mesh) {
    const std::string path = folder_.file("part.stl");
    const std::vector<Region> regions(mesh.facets.size(), Region::both);
    write_coloured_mesh(path, {.mesh = mesh, .regions = regions});
    window_.app().open(path);
    window_.wait_until_loaded();
    window_.wait_until_measured();
  }
  [[nodiscard]] VerdictCard verdict() const { return verdict_card(window_.state()); }
  void click(const std::string& control) {
    window_.move_mouse(window_.control(control).centre());
    window_.frames(2);
    window_.set_button(0, true);
    window_.frame();
    window_.set_button(0, false);
    window_.frames(3);
  }

  moldlight::test::ScratchFolder folder_;
  OffscreenWindow window_;
};

TEST_F(Verdicts, LeadToTheBestDirection) {
  // A block with a pocket in its side: along z one undercut, along the pocket none.
  const auto shape = moldlight::test::plate_with_side_pocket({});
  open(shape.mesh);
  EXPECT_FALSE(verdict().good());
  EXPECT_TRUE(verdict().sentence.starts_with("1 slide releases the undercut (")) << verdict().sentence;
  window_.wait_until_swept();  // by itself
  EXPECT_FALSE(window_.app().controls().contains("direction 1")) << "its table waits until it is asked for";
  click("card 1");
  window_.wait_until_measured();
  EXPECT_TRUE(verdict().good());
  EXPECT_EQ(verdict().sentence, "Two-plate mold: no undercut.");
  click("All directions");
  EXPECT_TRUE(window_.app().controls().contains("direction 1"));
}

TEST_F(Verdicts, HaveAreasWithTheirUnit) {
  open(moldlight::test::hollow_sphere({}).mesh);
  window_.settle();
  const std::string area = " " + powered_unit(window_.state().model->part, 2);
  const auto row = window_.control("line unreleased");
  EXPECT_TRUE(std::ranges::any_of(window_.app().texts(), [&](const DrawnText& each) {
    return each.text.ends_with(area) && each.box.min.y > row.min.y && each.box.max.y < row.max.y;
  }));
}

TEST_F(Verdicts, ShowTheUndercuts) {
  // The pocket lies in the side at x = 31.7: seen from the other side a click turns to it.
  open(moldlight::test::plate_with_side_pocket({}).mesh);
  window_.press_key({.key = '3', .ctrl = true, .shift = true});
  window_.frame();
  window_.hold_modifiers(false, false, false);
  window_.frames(3);
  ASSERT_LT(window_.state().camera.toward_viewer().x, -0.9);
  click("verdict");
  EXPECT_GT(window_.state().camera.toward_viewer().x, 0.1);
  EXPECT_NEAR(glm::dot(window_.state().camera.right(), glm::dvec3(0, 0, 1)), 0.0, 1e-9) << "upright";
}

TEST_F(Verdicts, RepairTheMesh) {
  // A block whose lid lacks a triangle: too little is known of it as it is.
  TriangleMesh mesh = moldlight::test::box_mesh({0, 0, 0}, {20, 20, 10});
  mesh.facets.pop_back();
  open(mesh);
  ASSERT_TRUE(window_.state().verdict);
  ASSERT_EQ(window_.state().verdict->state, VerdictState::unknown) << verdict().sentence;
  window_.settle();
  ASSERT_TRUE(window_.app().controls().contains("verdict repair"));
  // The hole is larger than what is filled unasked: that is said, and the next repair is offered.
  click("verdict repair");
  window_.wait_until_loaded();
  window_.wait_until_measured();
  EXPECT_EQ(window_.state().reading.repair.level, RepairLevel::full);
  EXPECT_FALSE(window_.state().model->part.repairs.empty()) << "what was done is on record";
}

TEST_F(Verdicts, AreDecidedOnceTheMeshIsRepaired) {
  TriangleMesh mesh = moldlight::test::box_mesh({0, 0, 0}, {20, 20, 10});
  std::swap(mesh.facets.front()[0], mesh.facets.front()[1]);  // one facet faces inward
  open(mesh);
  ASSERT_EQ(window_.state().verdict->state, VerdictState::unknown) << verdict().sentence;
  window_.settle();
  click("verdict repair");
  window_.wait_until_loaded();
  window_.wait_until_measured();
  window_.settle();
  EXPECT_EQ(verdict().sentence, "Two-plate mold: no undercut.");
  EXPECT_FALSE(window_.app().controls().contains("verdict repair"));
  window_.press_key({.key = '1'});
  window_.settle();
  EXPECT_TRUE(window_.app().controls().contains("Repair=full")) << "the panel has the choice, too";
}

TEST_F(Verdicts, OfferTheRepairAlsoWhereTheyAreDecided) {
  TriangleMesh mesh = moldlight::test::plate_with_side_pocket({}).mesh;
  // A small facet far from the pocket is missing: its undercut is certain, the mesh is open.
  std::size_t least = 0;
  const auto area = [&](std::size_t k) {
    const auto& [a, b, c] = mesh.facets[k];
    return glm::length(glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
  };
  for (std::size_t k = 1; k < mesh.facets.size(); ++k)
    if (area(k) < area(least)) least = k;
  mesh.facets.erase(mesh.facets.begin() + static_cast<std::ptrdiff_t>(least));
  open(mesh);
  window_.settle();
  ASSERT_GT(window_.state().model->health.open_edges, 0U);
  click("verdict repair");
  window_.wait_until_loaded();
  window_.wait_until_measured();
  window_.settle();
  EXPECT_EQ(window_.state().model->health.open_edges, 0U) << "the hole is small";
  EXPECT_FALSE(window_.app().controls().contains("verdict repair"));
}

/// Pixels of a colour that only regions have, between the panels.
std::size_t coloured_between_panels(const OffscreenWindow& window) {
  const std::vector<std::uint8_t> pixels = window.pixels();
  const glm::ivec2 size = window.size();
  std::size_t count = 0;
  for (int y = 60; y < size.y - 60; ++y) {
    for (int x = 290; x < size.x - 290; ++x) {
      const std::uint8_t* const at =
          pixels.data() +
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
      if (std::max({at[0], at[1], at[2]}) - std::min({at[0], at[1], at[2]}) > 90) ++count;
    }
  }
  return count;
}

TEST_F(Verdicts, LightWhatALineSpeaksOf) {
  using Of = Subject::Of;
  open(moldlight::test::plate_with_side_pocket({}).mesh);
  window_.settle();
  const std::size_t all = coloured_between_panels(window_);
  const auto point_at = [&](const char* control) {
    window_.move_mouse(window_.control(control).centre());
    window_.settle();
  };
  point_at("verdict");
  EXPECT_EQ(window_.state().lit, (Subject{.of = Of::undercuts}));
  const std::size_t undercuts = coloured_between_panels(window_);
  EXPECT_GT(undercuts, 50U) << "also where the part hides it";
  EXPECT_LT(undercuts, all / 4) << "all else is gray";
  point_at("core");
  EXPECT_EQ(window_.state().lit, (Subject{.of = Of::region, .region = Region::core}));
  const std::size_t core = coloured_between_panels(window_);
  EXPECT_GT(core, 1000U);
  EXPECT_LT(core, all);
  point_at("total");
  window_.move_mouse({640, 50});
  window_.settle();
  EXPECT_FALSE(window_.state().lit) << "as long as the mouse is on the line";
  EXPECT_NEAR(static_cast<double>(coloured_between_panels(window_)), static_cast<double>(all),
              0.02 * static_cast<double>(all));
  // A click on a region goes to where most of it is seen.
  window_.press_key({.key = '3', .ctrl = true, .shift = true});
  window_.frame();
  window_.hold_modifiers(false, false, false);
  window_.frames(3);
  click("undercut");
  EXPECT_GT(window_.state().camera.toward_viewer().x, 0.1);
}

TEST_F(Verdicts, LeadToWhatNothingReleases) {
  open(moldlight::test::hollow_sphere({}).mesh);
  window_.settle();
  window_.move_mouse(window_.control("line unreleased").centre());
  window_.settle();
  EXPECT_EQ(window_.state().lit, (Subject{.of = Subject::Of::unreleased}));
  EXPECT_GT(coloured_between_panels(window_), 200U) << "the void shines through";
  click("line unreleased");
  EXPECT_EQ(window_.state().step, Step::undercuts);
  EXPECT_EQ(window_.state().action_choices.chosen, 0U);
}

TEST_F(Verdicts, LeadToTheFaultsOfTheMesh) {
  TriangleMesh mesh = moldlight::test::plate_with_side_pocket({}).mesh;
  mesh.facets.erase(mesh.facets.begin());
  open(mesh);
  window_.settle();
  window_.move_mouse(window_.control("line open").centre());
  window_.settle();
  EXPECT_EQ(window_.state().lit, (Subject{.of = Subject::Of::open_edges}));
  const Camera before = window_.state().camera;
  click("line open");
  window_.settle();
  EXPECT_FALSE(window_.state().camera == before) << "it is looked at";
  EXPECT_FALSE(window_.app().controls().contains("line turned")) << "no such fault";
}

class LongVerdicts : public Verdicts {
 protected:
  LongVerdicts() : Verdicts(100'000) {}
};

TEST_F(Verdicts, LeadToAMarkThatIsIgnored) {
  // A groove of 0.02 mm around half a block: shallower than any release.
  moldlight::test::SolidBuilder solid;
  solid.extrude({{0, 0}, {20, 0}, {20, 5}, {19.98, 5}, {19.98, 10}, {20, 10}, {20, 15}, {0, 15}}, {}, 60.0);
  open(solid.mesh());
  ASSERT_TRUE(window_.state().verdict);
  EXPECT_EQ(window_.state().verdict->undercuts, 0U);
  ASSERT_GT(window_.state().verdict->specks, 0U) << verdict().sentence;
  EXPECT_TRUE(window_.state().verdict->good());
  EXPECT_FALSE(verdict().good()) << "the groove is red";
  const Camera before = window_.state().camera;
  click("verdict");
  window_.settle();
  EXPECT_LT(window_.state().camera.height, 0.7 * before.height) << "closer to it";
  const auto& texts = window_.app().texts();
  EXPECT_TRUE(std::ranges::any_of(
      texts, [](const DrawnText& each) { return each.text.starts_with("The largest tiny undercut: "); }));
}

TEST_F(LongVerdicts, AChangeOfTheSettingsBeginsTheSweepThatNobodyAskedForAnew) {
  open(moldlight::test::plate_with_side_pocket({}).mesh);
  window_.frames(3);
  ASSERT_TRUE(window_.state().sweep.running.has_value());
  click("Palette=safe");  // the palette
  EXPECT_TRUE(window_.state().sweep.running.has_value()) << "what only looks different ends nothing";
  click("+Y");
  EXPECT_TRUE(window_.state().sweep.running.has_value()) << "the direction is what is searched for";
  PartNotes notes;
  notes.settings = window_.state().settings;
  notes.settings.method.tau_deg = 2.0;
  window_.app().set_notes(notes);
  window_.frame();
  EXPECT_FALSE(window_.state().sweep.running.has_value());
  EXPECT_EQ(window_.state().sweep.result, nullptr);
  window_.wait_until_measured();
  window_.frames(2);
  EXPECT_TRUE(window_.app().sweeping()) << "with the new ones";
}

TEST_F(Verdicts, ASweepThatIsRefusedIsNotWaitedFor) {
  PartNotes notes;
  notes.settings.method.tolerance = 1e20;  // no length of this part
  window_.app().set_notes(notes);
  open(moldlight::test::plate_with_side_pocket({}).mesh);
  window_.wait_until_swept();
  EXPECT_FALSE(window_.app().sweeping());
  EXPECT_NE(window_.state().sweep.error.find("--tolerance"), std::string::npos)
      << window_.state().sweep.error;
  EXPECT_TRUE(window_.state().sweep.cards.empty());
}

}  // namespace
}  // namespace moldlight::gui::test
