// Mold halves where a hand says which half forms a face, and along a parting line.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/faces.hpp"
#include "mesh/facet_geometry.hpp"
#include "parting/make_halves.hpp"
#include "parting/mold_report.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/curved_solids.hpp"
#include "support/shapes.hpp"
#include "unit/parting/certified_halves.hpp"

namespace moldlight {
namespace {

using test::expect_certified;
using test::model_of;

/// The face whose facets have this normal and are this far along it.
std::uint32_t face_at(const PartModel& model, const glm::dvec3& normal, double along) {
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  for (std::uint32_t face = 0; face < faces.count(); ++face) {
    const FacetIndex facet = faces.facets(face).front();
    if (glm::distance(model.geometry.normals[facet], glm::normalize(normal)) < 1e-6 &&
        std::abs(glm::dot(model.part.mesh.corner(facet, 0), glm::normalize(normal)) - along) < 1e-6)
      return face;
  }
  ADD_FAILURE() << "no such face";
  return 0;
}

/// Area of a half's surface in the plane where this coordinate, of the part's, has this value.
double area_in_plane(const MoldHalves& halves, const TriangleMesh& mesh, int axis, double value) {
  double area = 0.0;
  const FacetGeometry geometry = facet_geometry(mesh);
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    bool in = true;
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 at = halves.centre + halves.frame.to_part(mesh.corner(facet, k));
      in = in && std::abs(at[axis] - value) < 1e-9;
    }
    if (in) area += geometry.areas[facet];
  }
  return area;
}

const TriangleMesh& box() {
  static const TriangleMesh k_box = test::box_mesh({1, 2, 3}, {5, 5, 5});
  return k_box;
}
MoldHalves box_halves(const MoldSettings& settings, const MeetingPlace& place = {.height = 3.5}) {
  return make_halves(*model_of(box()), {0, 0, 1}, place, settings, Progress{});
}

TEST(HalvesByHand, AFaceOfABoxGoesWholeToAHalf) {
  const auto model = model_of(box());
  const std::uint32_t face = face_at(*model, {1, 0, 0}, 5.0);
  for (const bool core : {true, false}) {
    MoldSettings settings;
    settings.margin = 6.0;
    settings.cosmetic = cosmetic_with("", face, core);
    const MoldHalves halves = box_halves(settings);
    expect_certified(halves, settings.cosmetic, &box());
    const double of_core = area_in_plane(halves, halves.core.mesh, 0, 5.0),
                 of_cavity = area_in_plane(halves, halves.cavity.mesh, 0, 5.0);
    EXPECT_NEAR(of_core, core ? 6.0 : 0.0, 1e-6);
    EXPECT_NEAR(of_cavity, core ? 0.0 : 6.0, 1e-6);
    // All other walls could be met at that height, too, so that the surface stays one plane.
    EXPECT_NEAR(area_in_plane(halves, halves.core.mesh, 0, 1.0), core ? 6.0 : 0.0, 1e-6);
    EXPECT_NEAR(area_in_plane(halves, halves.cavity.mesh, 0, 1.0), core ? 0.0 : 6.0, 1e-6);
    EXPECT_FALSE(halves.missed_leaning.at.has_value());
    EXPECT_FALSE(halves.missed_upright.at.has_value());
    EXPECT_NEAR(halves.surface.shelf_height, core ? 3.0 : 5.0, 1e-9);
    EXPECT_NEAR(halves.surface.shelf_share(), 1.0, 1e-9);
    EXPECT_NEAR(halves.contact_area, 0.0, 1e-9);
    EXPECT_NEAR(halves.core.volume + halves.cavity.volume, halves.block_volume - 24.0, 1e-9);
  }
}

TEST(HalvesByHand, OfFacesThatMeetTheOneOffTheShelfGivesWay) {
  const auto model = model_of(box());
  MoldSettings settings;
  settings.margin = 6.0;
  settings.cosmetic = cosmetic_with("", face_at(*model, {1, 0, 0}, 5.0), true);
  settings.cosmetic = cosmetic_with(settings.cosmetic, face_at(*model, {0, -1, 0}, -2.0), false);
  const MoldHalves halves = box_halves(settings);
  expect_certified(halves, "box", &box());
  ASSERT_TRUE(halves.missed_upright.at.has_value());
  EXPECT_LE(glm::distance(glm::dvec2(*halves.missed_upright.at), {5.0, 2.0}), 0.6);
  const double corner = 0.5 * 2.0 * 2.0 / std::sqrt(3.0);  // as high as the box, with the steepest slope
  EXPECT_NEAR(halves.missed_upright.area, corner, 0.05 * corner);
  EXPECT_LE(area_in_plane(halves, halves.core.mesh, 1, 2.0), 0.05 * corner);
  EXPECT_NEAR(
      area_in_plane(halves, halves.cavity.mesh, 0, 5.0) + area_in_plane(halves, halves.core.mesh, 1, 2.0),
      halves.missed_upright.area, 1e-6);
  EXPECT_FALSE(halves.missed_leaning.at.has_value());
}

TEST(HalvesByHand, AHolesWallsMoveItsShutOff) {
  const TriangleMesh plate = test::plate_with_holes(1, 1, 2.0);
  const auto model = model_of(plate);
  const MoldHalves before = make_halves(*model, {0, 0, 1}, {.height = 1.0}, {}, Progress{});
  for (const bool core : {true, false}) {
    MoldSettings settings;
    const Faces faces = part_faces(model->part, model->geometry, model->adjacency);
    for (std::uint32_t face = 0; face < faces.count(); ++face) {
      const glm::dvec3 &normal = model->geometry.normals[faces.facets(face).front()],
                       &at = model->part.mesh.corner(faces.facets(face).front(), 0);
      const Bounds box = bounds(plate);
      const bool outside =
          std::min({at.x - box.min.x, at.y - box.min.y, box.max.x - at.x, box.max.y - at.y}) < 1e-9;
      if (normal.z == 0.0 && !outside) settings.cosmetic = cosmetic_with(settings.cosmetic, face, core);
    }
    ASSERT_EQ(std::ranges::count(settings.cosmetic, ','), 3) << settings.cosmetic;
    const MoldHalves halves = make_halves(*model, {0, 0, 1}, {.height = 1.0}, settings, Progress{});
    expect_certified(halves, "plate", &plate);
    // The hole is 4 wide, the walls 2 high, divided in the middle before.
    const double grown = (core ? 1.0 : -1.0) * 16.0 * 1.0;
    EXPECT_NEAR(halves.core.volume - before.core.volume, grown, 1e-9);
    EXPECT_NEAR(halves.cavity.volume - before.cavity.volume, -grown, 1e-9);
    EXPECT_NEAR(halves.surface.shut_off_area, 16.0, 1e-9);
    EXPECT_FALSE(halves.missed_upright.at.has_value());
  }
}

TEST(HalvesByHand, ACupsRimFollowsItsWall) {
  const test::Shape cup = test::cup({});
  const auto model = model_of(cup.mesh);
  const Faces faces = part_faces(model->part, model->geometry, model->adjacency);
  // Outer walls, as far as they are upright: the halves meet at their top or at their bottom, never between.
  for (const bool core : {true, false}) {
    MoldSettings settings;
    double area = 0.0;
    for (std::uint32_t face = 0; face < faces.count(); ++face) {
      const FacetIndex facet = faces.facets(face).front();
      const glm::dvec3& normal = model->geometry.normals[facet];
      if (std::abs(glm::dot(normal, cup.direction)) > 1e-9) continue;
      if (glm::dot(normal, model->part.mesh.corner(facet, 0) - model->frame.center) <= 0.0) continue;
      settings.cosmetic = cosmetic_with(settings.cosmetic, face, core);
      for (const FacetIndex each : faces.facets(face)) area += model->geometry.areas[each];
    }
    ASSERT_GT(area, 0.0);
    const double middle = glm::dot(model->frame.center, cup.direction);
    const MoldHalves plain = make_halves(*model, cup.direction, {.height = middle}, {}, Progress{}),
                     halves = make_halves(*model, cup.direction, {.height = middle}, settings, Progress{});
    expect_certified(halves, "cup", &cup.mesh);
    EXPECT_FALSE(halves.missed_upright.at.has_value()) << halves.missed_upright.area << " of " << area;
    EXPECT_FALSE(halves.missed_leaning.at.has_value()) << halves.missed_leaning.area << " of " << area;
    EXPECT_EQ(halves.core.volume > plain.core.volume, core);
  }
}

TEST(HalvesByHand, ADraftedFaceStaysAndIsTold) {
  // A box that narrows upwards by half a degree: its walls are the core's alone.
  TriangleMesh drafted = box();
  const double in = 2.0 * std::tan(glm::radians(0.5));
  for (glm::dvec3& v : drafted.vertices) {
    if (v.z < 4.0) continue;
    v.x += v.x < 3.0 ? in : -in;
    v.y += v.y < 3.5 ? in : -in;
  }
  const auto model = model_of(drafted);
  const double tilt = std::tan(glm::radians(0.5));
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 0.0, tilt));
  MoldSettings settings;
  const std::uint32_t face = face_at(*model, normal, glm::dot(normal, glm::dvec3(5, 2, 3)));
  settings.cosmetic = cosmetic_with("", face, false);
  const MoldHalves plain = make_halves(*model, {0, 0, 1}, {.height = 3.5}, {}, Progress{}),
                   halves = make_halves(*model, {0, 0, 1}, {.height = 3.5}, settings, Progress{});
  expect_certified(halves, "drafted box", &drafted);
  const double area = 0.5 * (3.0 + 3.0 - 2.0 * in) * 2.0 / std::cos(glm::radians(0.5));
  EXPECT_NEAR(halves.missed_leaning.area, area, 1e-9);
  ASSERT_TRUE(halves.missed_leaning.at.has_value());
  EXPECT_LE(glm::distance(*halves.missed_leaning.at, {5.0, 3.5, 4.0}), 1.2);
  EXPECT_EQ(halves.core.mesh.vertices, plain.core.mesh.vertices);
  settings.cosmetic = cosmetic_with("", face, true);
  const MoldHalves right = make_halves(*model, {0, 0, 1}, {.height = 3.5}, settings, Progress{});
  EXPECT_FALSE(right.missed_leaning.at.has_value());
  // The report has it as one sentence.
  settings.cosmetic = cosmetic_with("", face, false);
  const Query query{glm::dvec3(0, 0, 1), {}};
  const Assignment assignment = assign_sides(*model, query, settings, Progress{});
  const PartingLine line = parting_line(assignment);
  const WrittenMold written = written_mold(halves);
  const MoldReport report{*model, query, settings, assignment, line, halves, written};
  const std::vector<std::string> remarks = halves_remarks(report);
  EXPECT_TRUE(std::ranges::any_of(
      remarks, [](const std::string& remark) { return remark.find("reverse draft") != std::string::npos; }));
  EXPECT_NEAR(mold_json(report)["halves"]["missed"]["leaning"]["area"].get<double>(), area, 1e-9);
}

TEST(HalvesByHand, HalvesMeetAlongTheLine) {
  PartingLine line;
  line.loops.emplace_back();
  line.loops.back().points = {{1, 2, 4.2}, {5, 2, 4.2}, {5, 5, 4.2}, {1, 5, 4.2}};
  const MoldHalves halves = box_halves({}, {.height = 3.5, .line = &line});
  expect_certified(halves, "box", &box());
  for (const auto& [axis, value, width] :
       {std::tuple{0, 5.0, 3.0}, {0, 1.0, 3.0}, {1, 2.0, 4.0}, {1, 5.0, 4.0}}) {
    EXPECT_NEAR(area_in_plane(halves, halves.core.mesh, axis, value), 0.8 * width, 1e-6);
    EXPECT_NEAR(area_in_plane(halves, halves.cavity.mesh, axis, value), 1.2 * width, 1e-6);
  }
  // A hand outweighs it.
  MoldSettings settings;
  settings.margin = 6.0;
  settings.cosmetic = cosmetic_with("", face_at(*model_of(box()), {1, 0, 0}, 5.0), true);
  const MoldHalves moved = box_halves(settings, {.height = 3.5, .line = &line});
  EXPECT_NEAR(area_in_plane(moved, moved.core.mesh, 0, 5.0), 6.0, 1e-6);
  EXPECT_NEAR(area_in_plane(moved, moved.core.mesh, 0, 1.0), 6.0, 1e-6);
}

/// Steeper than asked the surface is nowhere; where the part's outline is, upright walls make up for it.
TEST(PartingSurface, KeepsTheSlopeWhateverTheOutline) {
  constexpr int k_corners = 48;
  constexpr double k_radius = 10.0, k_thickness = 0.5, k_tangent = 2.5;
  const TriangleMesh sheet =
      test::sheet_mesh(k_corners, k_radius, k_thickness, [&](double x, double) { return k_tangent * x; });
  MoldSettings settings;
  settings.margin = 20.0;
  const MoldHalves halves = make_halves(*model_of(sheet), {0, 0, 1}, {}, settings, Progress{});
  expect_certified(halves, "steep sheet", &sheet);
  EXPECT_LE(halves.surface.steepest_deg, 60.0);
  EXPECT_EQ(halves.surface.too_steep_area, 0.0);
  EXPECT_GT(halves.contact_area, 1.0);
  // Around a convex outline the way is along its sides: the steepest between two corners.
  double steepest = 0.0;
  const double side = 2.0 * k_radius * std::sin(std::numbers::pi / k_corners);
  for (int from = 0; from < k_corners; ++from) {
    for (int steps = 1; steps <= k_corners / 2; ++steps) {
      const auto x = [&](int k) { return k_radius * std::cos(2.0 * std::numbers::pi * k / k_corners); };
      steepest = std::max(steepest, (k_tangent * (x(from + steps) - x(from)) - k_thickness) / (side * steps));
    }
  }
  EXPECT_NEAR(halves.forced_deg, glm::degrees(std::atan(steepest)), 0.01);
  ASSERT_TRUE(halves.forced_at.has_value());
  settings.slope_deg = std::ceil(halves.forced_deg);
  const MoldHalves steep = make_halves(*model_of(sheet), {0, 0, 1}, {}, settings, Progress{});
  EXPECT_EQ(steep.forced_deg, 0.0);
  EXPECT_FALSE(steep.forced_at.has_value());
  EXPECT_LE(steep.contact_area, 0.2 * halves.contact_area);
}

}  // namespace
}  // namespace moldlight
