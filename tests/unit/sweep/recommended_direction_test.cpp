// The direction that a mold maker would take, of parts whose least undercut lies elsewhere. What is
// recommended turns with the part.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "mold/direction.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/solid_builder.hpp"
#include "sweep/sweep.hpp"

namespace moldlight {
namespace {

using test::Loop;
using test::SolidBuilder;

/// A window in an outer wall: across from the middle of the wall, and in height.
struct Window {
  int face;  // 0 … 3: -x, +x, -y, +y
  double from, to, low, high;
  double depth = 0.0;  // of a blind one; 0 goes through the wall
};

struct OpenBox {
  glm::dvec3 size{60, 40, 24};
  double wall = 3.0, floor = 3.0, draft_deg = 2.0;  // of the inner walls
  std::vector<Window> windows = {};
};

Loop reversed(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

/// A box that is open at the top.
class OpenBoxMaker {
 public:
  explicit OpenBoxMaker(const OpenBox& box)
      : box_(box), rim_(ring(box.wall, box.size.z)), ground_(ring(thickness(box.floor), box.floor)) {}

  TriangleMesh mesh() {
    solid_.face(test::box_face({0, 0, 0}, box_.size, 4));
    solid_.face(test::box_face({0, 0, 0}, box_.size, 5), {rim_});
    solid_.face(ground_);
    for (int face = 0; face < 4; ++face) add_wall(face);
    return solid_.mesh();
  }

 private:
  [[nodiscard]] Loop ring(double inset, double z) const {
    const double x = box_.size.x - inset, y = box_.size.y - inset;
    return {{inset, inset, z}, {x, inset, z}, {x, y, z}, {inset, y, z}};
  }

  /// Across the wall from its middle, in height, and inwards from the outer face.
  [[nodiscard]] glm::dvec3 at(int face, double across, double z, double inwards) const {
    const glm::dvec3 middle = 0.5 * box_.size;
    if (face < 2) return {face == 0 ? inwards : box_.size.x - inwards, middle.y + across, z};
    return {middle.x + across, face == 2 ? inwards : box_.size.y - inwards, z};
  }

  [[nodiscard]] double thickness(double z) const {
    return box_.wall + (box_.size.z - z) * std::tan(glm::radians(box_.draft_deg));
  }

  /// Counter-clockwise seen from outside.
  [[nodiscard]] Loop opening(const Window& window, bool inner) const {
    Loop loop;
    for (const auto& [across, z] : {std::pair(window.from, window.low), std::pair(window.to, window.low),
                                    std::pair(window.to, window.high), std::pair(window.from, window.high)}) {
      const double inwards = !inner ? 0.0 : window.depth > 0.0 ? window.depth : thickness(z);
      loop.push_back(at(window.face, across, z, inwards));
    }
    const bool turned = window.face == 0 || window.face == 3;
    return turned ? reversed(loop) : loop;
  }

  void add_wall(int face) {
    std::vector<Loop> outer, inner;
    for (const Window& window : box_.windows) {
      if (window.face != face) continue;
      const Loop mouth = opening(window, false), end = opening(window, true);
      outer.push_back(mouth);
      solid_.walls(reversed(end), reversed(mouth));
      if (window.depth > 0.0) {
        solid_.face(end);
      } else {
        inner.push_back(end);
      }
    }
    solid_.face(test::box_face({0, 0, 0}, box_.size, face), outer);
    // Counter-clockwise seen from the void.
    constexpr std::array<std::size_t, 4> k_first = {3, 1, 0, 2};  // corner of the rings, by face
    const std::size_t a = k_first[static_cast<std::size_t>(face)], b = (a + 1) % 4;
    solid_.face({ground_[b], ground_[a], rim_[a], rim_[b]}, inner);
  }

  const OpenBox& box_;
  Loop rim_, ground_;  // of the void
  SolidBuilder solid_;
};

TriangleMesh open_box(const OpenBox& box) { return OpenBoxMaker(box).mesh(); }

/// A speck in one wall, smaller than the lateral tolerance.
TriangleMesh clip() {
  return open_box(
      {.windows = {{.face = 1, .from = 4.0, .to = 4.2, .low = 15, .high = 15.2, .depth = 0.004}}});
}

/// A pocket in one wall, of which less is hidden from a direction that leans towards it.
TriangleMesh mount() {
  return open_box({.windows = {{.face = 1, .from = -6, .to = 6, .low = 8, .high = 18, .depth = 2.0}}});
}

/// Pockets in opposite walls.
TriangleMesh latch() {
  return open_box({.windows = {{.face = 1, .from = -6, .to = 6, .low = 8, .high = 18, .depth = 2.0},
                               {.face = 0, .from = -5, .to = 4, .low = 9, .high = 15, .depth = 2.0}}});
}

/// A window in each wall.
TriangleMesh vented_box() {
  OpenBox box;
  for (int face = 0; face < 4; ++face)
    box.windows.push_back({.face = face, .from = -7.0 - face, .to = 6.0, .low = 9, .high = 16});
  return open_box(box);
}

struct MiddlePocket {
  int face;
  glm::dvec3 half;  // of its opening
  double depth;
};

/// A block with a pocket in the middle of faces.
TriangleMesh pocketed_block(const glm::dvec3& size, const std::vector<MiddlePocket>& pockets) {
  SolidBuilder solid;
  std::vector<int> pierced;
  for (const MiddlePocket& pocket : pockets) pierced.push_back(pocket.face);
  solid.box({0, 0, 0}, size, pierced);
  for (const MiddlePocket& pocket : pockets) {
    const int axis = pocket.face / 2;
    glm::dvec3 low = 0.5 * size - pocket.half, high = 0.5 * size + pocket.half;
    const bool at_high = pocket.face % 2 == 1;
    low[axis] = at_high ? size[axis] - pocket.depth : 0.0;
    high[axis] = at_high ? size[axis] : pocket.depth;
    solid.box(low, high, {pocket.face}, true);
    solid.face(test::box_face({0, 0, 0}, size, pocket.face), {test::box_face(low, high, pocket.face)});
  }
  return solid.mesh();
}

/// Along z two slides, the one large; along x, where less is hidden, three small ones.
TriangleMesh frame() {
  return pocketed_block({80, 60, 50}, {{.face = 1, .half = {0, 22, 16}, .depth = 30},
                                       {.face = 3, .half = {5, 0, 4}, .depth = 6},
                                       {.face = 4, .half = {5, 4, 0}, .depth = 6},
                                       {.face = 5, .half = {5, 4, 0}, .depth = 14}});
}

SweepResult quickly_swept(const TriangleMesh& mesh, SweepSettings settings = {}) {
  settings.directions = 300;
  settings.refine = 4;
  return run_sweep(test::model_of(mesh), settings, Progress{}, {});
}

/// All of it, for what a failure says.
std::string noted(const SweepResult& result) {
  std::string text = result.recommended ? result.recommended->why : "nothing recommended";
  for (const SweepCandidate& each : result.candidates) {
    text += fmt::format("\n{}: {}, {}", direction_words(each.candidate.direction),
                        each.actions ? each.actions->text() : "?", fmt::join(each.rank_reasons, ", "));
  }
  return text;
}

struct Known {
  std::string name;
  TriangleMesh mesh;
  glm::dvec3 direction{0, 0, 1};  // the core is on its side
};

std::vector<Known> known_parts() {
  std::vector<Known> parts;
  parts.push_back({"clip", clip()});
  parts.push_back({"mount", mount()});
  parts.push_back({"latch", latch()});
  parts.push_back({"vented box", vented_box()});
  parts.push_back({"frame", frame()});
  return parts;
}

TriangleMesh mirrored(TriangleMesh mesh) {
  for (glm::dvec3& vertex : mesh.vertices) vertex.x = -vertex.x;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) test::reverse_facet(mesh, facet);
  return mesh;
}

TEST(RecommendedDirection, IsTheOneThatAMoldMakerTakes) {
  for (const Known& part : known_parts()) {
    const auto model = test::model_of(part.mesh);
    const SweepResult result = quickly_swept(part.mesh);
    ASSERT_TRUE(result.recommended) << part.name;
    EXPECT_EQ(nearest_axis(result.recommended->direction).name, "z") << part.name << noted(result);
    EXPECT_EQ(result.recommended->name, direction_words(result.recommended->direction)) << part.name;
    EXPECT_FALSE(result.recommended->provisional);
    EXPECT_TRUE(result.candidates.front().candidate.canonical) << part.name;
    const BestDirection best = best_direction(model, {}, Progress{});
    EXPECT_EQ(best.direction, result.recommended->direction) << part.name << ": by the short way, too";
    EXPECT_EQ(best.off_axis, "");
  }
}

TEST(RecommendedDirection, TurnsWithThePart) {
  std::uint32_t seed = 1;
  for (const Known& part : known_parts()) {
    const glm::dvec3 straight = best_direction(test::model_of(part.mesh), {}, Progress{}).direction;
    const glm::dquat rotation = test::random_rotation(seed++);
    const BestDirection turned =
        best_direction(test::model_of(test::rotated(part.mesh, rotation)), {}, Progress{});
    EXPECT_LT(glm::distance(turned.direction, rotation * straight), 1e-6) << part.name << ": " << turned.why;
    EXPECT_FALSE(turned.off_axis.empty());
    EXPECT_NEAR(turned.off_axis_deg, nearest_axis(turned.direction).angle_deg, 1e-12);
  }
}

TEST(RecommendedDirection, DoesNotDependOnOrderSideOrScale) {
  for (const Known& part : known_parts()) {
    const glm::dvec3 straight = best_direction(test::model_of(part.mesh), {}, Progress{}).direction;
    const auto best_of = [](TriangleMesh mesh) {
      return best_direction(test::model_of(std::move(mesh)), {}, Progress{}).direction;
    };
    EXPECT_EQ(best_of(test::permuted(part.mesh, 7)), straight) << part.name;
    EXPECT_EQ(best_of(mirrored(part.mesh)), straight * glm::dvec3(-1, 1, 1) + 0.0) << part.name;
    EXPECT_EQ(best_of(test::scaled(part.mesh, 0.5)), straight) << part.name;
  }
}

/// The two bars on what is listed, for a part at any angle.
TEST(RecommendedDirection, NothingIsListedBesideACanonicalOneThatCostsNoMore) {
  for (const Known& part : known_parts()) {
    const SweepResult result = quickly_swept(test::rotated(part.mesh, test::random_rotation(9)));
    for (const SweepCandidate& listed : result.candidates) {
      for (const SweepCandidate& other : result.candidates) {
        if (&other == &listed || !other.candidate.canonical || !other.actions) continue;
        if (line_angle_deg(other.candidate.direction, listed.candidate.direction) > 3.0) continue;
        ASSERT_TRUE(listed.actions) << part.name;
        EXPECT_TRUE(other.actions->weight > listed.actions->weight ||
                    other.actions->totals.unreleased_area > listed.actions->totals.unreleased_area)
            << part.name << noted(result);
      }
    }
  }
}

/// Less undercut by more than it is worth to leave the axis, or fewer side actions.
TEST(RecommendedDirection, WorthDecidesWhatIsListedBesideAnAxis) {
  for (const double worth_pct : {0.5, 100.0}) {
    SweepSettings settings;
    settings.worth_pct = worth_pct;
    const SweepResult result = quickly_swept(mount(), settings);
    const SweepCandidate& best = result.candidates.front();
    ASSERT_TRUE(best.beside) << "one of less undercut was found: " << noted(result);
    EXPECT_LT(best.beside->undercut, best.classification.areas[Region::undercut]);
    EXPECT_LE(best.beside->angle_deg, 10.0);
    for (const SweepCandidate& each : result.candidates) {
      const double angle_deg = line_angle_deg(each.candidate.direction, best.candidate.direction);
      if (each.rank == 1 || angle_deg > 10.0) continue;
      ASSERT_TRUE(each.actions) << noted(result);
      EXPECT_GE(each.actions->weight, best.actions->weight) << "the best is the best";
      EXPECT_GT(angle_deg, 3.0) << noted(result);
      EXPECT_GT(best.classification.areas[Region::undercut] - each.classification.areas[Region::undercut],
                0.01 * worth_pct * best.classification.total_area)
          << noted(result);
      ASSERT_TRUE(each.beside);
      EXPECT_EQ(each.beside->name, "z");
    }
  }
}

TEST(RecommendedDirection, TheCoreIsInsideOfABox) {
  const BestDirection best = best_direction(test::model_of(latch()), {}, Progress{});
  EXPECT_EQ(best.direction, glm::dvec3(0, 0, 1)) << "it opens upwards";
  EXPECT_NE(best.why.find("The core is on the side of z"), std::string::npos) << best.why;
  const glm::dquat over = glm::angleAxis(glm::radians(180.0), glm::dvec3(1, 0, 0));
  const BestDirection down = best_direction(test::model_of(test::rotated(latch(), over)), {}, Progress{});
  EXPECT_LT(glm::distance(down.direction, glm::dvec3(0, 0, -1)), 1e-12) << down.why;
}

/// Before others are searched for: final where it needs no side action, else so far.
TEST(RecommendedDirection, IsToldBeforeTheSearchOnce) {
  for (const bool is_free : {true, false}) {
    SweepSettings settings;
    settings.directions = 100;
    settings.refine = 1;
    std::vector<SweepResult> told;
    const SweepListener listener{.evaluated = {},
                                 .named = [&](SweepResult named) { told.push_back(std::move(named)); }};
    const SweepResult result =
        run_sweep(test::model_of(is_free ? clip() : vented_box()), settings, Progress{}, listener);
    ASSERT_EQ(told.size(), 1U);
    ASSERT_TRUE(told[0].recommended && result.recommended) << noted(result);
    EXPECT_EQ(told[0].recommended->direction, result.recommended->direction) << noted(result);
    EXPECT_EQ(told[0].recommended->provisional, !is_free);
    EXPECT_LE(told[0].candidates.size(), 3U);
    EXPECT_FALSE(told[0].complete);
    ASSERT_TRUE(result.candidates.front().cost);
    EXPECT_EQ(told[0].candidates.front().cost->weight, result.candidates.front().cost->weight);
  }
}

/// No effort, so that regions are too coarse for lines between them: none is not a planar one.
TEST(Recommended, ALineThatIsNotKnownIsNotPlanar) {
  SweepSettings settings;
  settings.directions = 30;
  settings.refine = 0;
  const SweepResult result =
      run_sweep(test::model_of(test::box_mesh({0, 0, 0}, {4, 3, 2}), 1e-9), settings, Progress{}, {});
  ASSERT_FALSE(result.candidates.empty());
  std::size_t ranked = 0;
  for (const SweepCandidate& each : result.candidates) {
    EXPECT_FALSE(each.line.has_value()) << direction_words(each.candidate.direction);
    ranked += each.actions ? 1 : 0;
  }
  EXPECT_GT(ranked, 0U);
}

}  // namespace
}  // namespace moldlight
