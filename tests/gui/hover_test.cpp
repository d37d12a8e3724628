// The surface under the cursor: facet, draft, region, and for an undercut what blocks it.
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "gui/panels/panels.hpp"
#include "gui/window_with_part.hpp"
#include "mold/round_wall.hpp"

namespace moldlight::gui::test {
namespace {

class Hovering : public WindowWithPart {
 protected:
  [[nodiscard]] glm::dvec3 centroid(FacetIndex facet) const {
    const TriangleMesh& mesh = state().model->part.mesh;
    return (mesh.corner(facet, 0) + mesh.corner(facet, 1) + mesh.corner(facet, 2)) / 3.0;
  }

  /// The place of a facet's middle on the screen, where it is in sight and free of panels.
  [[nodiscard]] std::optional<glm::vec2> place_of(FacetIndex facet) const {
    const PartModel& model = *state().model;
    const Camera& camera = state().camera;
    const glm::dvec3& normal = model.geometry.normals[facet];
    if (model.geometry.areas[facet] < 1e-3 * model.geometry.total_area / 10.0) return std::nullopt;
    if (glm::dot(normal, camera.toward_viewer()) < 0.2) return std::nullopt;
    const glm::dvec3 point(model.frame.to_unit(centroid(facet)));
    const glm::vec3 start(point + 1e-4 * normal);
    if (model.rays().first_hit(start, glm::vec3(camera.toward_viewer()), false)) return std::nullopt;
    const auto pixel = project(camera, window.size(), point);
    if (!pixel || pixel->x < 320.0 || pixel->x > 960.0) return std::nullopt;
    return glm::vec2(*pixel);
  }

  /// Moves the mouse to a facet of this region that is in sight.
  void find(Region region) {
    window.wait_until_measured();
    const auto& fractions = state().figures.shown->facet_fractions;
    for (FacetIndex facet = 0; facet < fractions.size(); ++facet) {
      if (fractions[facet][static_cast<std::size_t>(region)] < 0.999F) continue;
      const auto place = place_of(facet);
      if (!place) continue;
      move_to(*place);
      found = facet;
      return;
    }
    FAIL() << "no facet of the region is in sight";
  }

  FacetIndex found = k_no_facet;
};

TEST_F(Hovering, TellsTheFacet) {
  find(Region::core);
  ASSERT_TRUE(state().hover);
  EXPECT_EQ(state().hover->point.facet, found);
  EXPECT_EQ(state().hover->point.region, Region::core);
  EXPECT_FALSE(state().hover->blocker);
  EXPECT_NEAR(state().hover->draft_deg, draft_angle_deg(state().model->geometry.normals[found], direction()),
              1e-12);
}

TEST_F(Hovering, TellsWhatBlocksAnUndercut) {
  // The sides of the hole through the cup's wall.
  find(Region::undercut);
  ASSERT_TRUE(state().hover);
  EXPECT_EQ(state().hover->point.facet, found);
  EXPECT_EQ(state().hover->point.region, Region::undercut);
  ASSERT_TRUE(state().hover->blocker);

  // The blocker lies on the line along the direction, at the distance that is reported, and faces the point.
  const Blocker& blocker = *state().hover->blocker;
  const PartModel& model = *state().model;
  const glm::dvec3 along = direction() * (blocker.above ? 1.0 : -1.0);
  const glm::dvec3 point =
      glm::dvec3(state().hover->point.position) * model.frame.diagonal + model.frame.center;
  const glm::dvec3& normal = model.geometry.normals[blocker.facet];
  EXPECT_LT(glm::dot(normal, along), 0.0);
  const glm::dvec3 hit = point + blocker.distance * along;
  EXPECT_NEAR(glm::dot(hit - centroid(blocker.facet), normal), 0.0, 1e-3);
  const TriangleMesh& mesh = model.part.mesh;
  for (int corner = 0; corner < 3; ++corner) {
    const glm::dvec3& a = mesh.corner(blocker.facet, corner);
    const glm::dvec3& b = mesh.corner(blocker.facet, (corner + 1) % 3);
    EXPECT_GT(glm::dot(glm::cross(b - a, hit - a), normal), -1e-2 * glm::length(b - a)) << corner;
  }
}

TEST_F(Hovering, IsExplainedBesideTheCursor) {
  find(Region::undercut);
  const std::vector<std::string> lines = readout_lines(state());
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "Undercut");
  const double draft_deg = draft_angle_deg(state().model->geometry.normals[found], direction());
  EXPECT_NE(lines[1].find("draft " + draft_text(draft_deg)), std::string::npos) << lines[1];
  const Blocker& blocker = *state().hover->blocker;
  EXPECT_NE(lines[2].find(
                fmt::format("blocked {:.4g} unit {}", blocker.distance, blocker.above ? "above" : "below")),
            std::string::npos)
      << lines[2];
  EXPECT_NEAR(glm::distance(blocker.from, blocker.at) * state().model->frame.diagonal, blocker.distance,
              1e-4);
}

TEST_F(Hovering, TheReadoutIsNeitherUnderTheCursorNorUnderAPanelNorOutside) {
  key({.key = '7', .shift = true});
  move_to({640, 360});
  for (int step = 0; step < 3; ++step) {  // the part grows over the whole window
    window.turn_wheel(6.0F);
    window.frames(2);
  }
  const ScreenBox left = window.control("panel Direction"), right = window.control("panel Verdict"),
                  below = window.control("panel Shadow maps");
  int seen = 0;
  for (float x = left.max.x + 4.0F; x < right.min.x; x += 110.0F) {
    for (float y = 50.0F; y < below.min.y; y += 110.0F) {
      move_to({x, y});
      if (!state().hover) continue;
      ++seen;
      const ScreenBox box = window.control("readout");
      EXPECT_TRUE(x < box.min.x || x > box.max.x || y < box.min.y || y > box.max.y) << x << " " << y;
      EXPECT_TRUE(box.min.x >= left.max.x && box.max.x <= right.min.x && box.min.y >= 40.0F &&
                  box.max.y <= below.min.y)
          << x << " " << y;
    }
  }
  EXPECT_GT(seen, 15);
}

TEST_F(Hovering, NothingBesideThePart) {
  move_to({640, 700});
  EXPECT_FALSE(state().hover);
  turn_maps_drawer();
  move_to(window.control("Kernel").centre());
  EXPECT_FALSE(state().hover) << "a panel lies over the part";
}

TEST_F(Hovering, ADoubleClickTakesTheNormal) {
  key({.key = '1', .shift = true});
  window.settle();
  find(Region::both);
  press();
  press();
  const glm::dvec3& normal = state().model->geometry.normals[found];
  EXPECT_NEAR(glm::dot(direction(), normal), 1.0, 1e-9);
  undo();
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
}

TEST_F(Hovering, AnAltDoubleClickTakesTheAxis) {
  // A round hole that runs along y.
  const moldlight::test::Shape shape = moldlight::test::block_with_crossing_hole({});
  const std::string block = part.output("block.obj");
  write_coloured_mesh(block, {shape.mesh, std::vector<Region>(shape.mesh.facets.size(), Region::core)});
  window.app().open(block);
  window.wait_until_loaded();
  find(Region::undercut);
  window.hold_modifiers(false, false, true);
  press();
  press();
  window.hold_modifiers(false, false, false);
  EXPECT_NEAR(std::abs(direction().y), 1.0, 1e-9);
  undo();
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
}

TEST_F(Hovering, AnAltDoubleClickOnAFlatWallSaysThatThereIsNoAxis) {
  find(Region::undercut);
  window.hold_modifiers(false, false, true);
  press();
  press();
  window.hold_modifiers(false, false, false);
  EXPECT_EQ(direction(), glm::dvec3(0, 0, 1));
  ASSERT_EQ(state().toasts.size(), 1U);
  EXPECT_NE(state().toasts[0].text.find("no round wall"), std::string::npos);
}

/// No nudge of the mouse is needed to see what a rest of the mouse calls up.
TEST_F(WindowWithPart, ATooltipComesByItself) {
  enter(Step::part);
  window.settle();
  window.move_mouse(window.control("Near-vertical below").centre());
  window.frames_asked_for();
  const std::vector<std::uint8_t> before = window.pixels();
  window.pass_time(0.6);
  window.frames_asked_for();
  const std::vector<std::uint8_t> rested = window.pixels();
  EXPECT_NE(rested, before);
  window.frames(5);
  EXPECT_EQ(window.pixels(), rested) << "it was not drawn to its end";
}

}  // namespace
}  // namespace moldlight::gui::test
