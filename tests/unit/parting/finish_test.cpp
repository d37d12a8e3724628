// Finishes, the draft that they ask for, and which faces have too little of it.
#include "parting/draft/finish.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "mesh/faces.hpp"
#include "parting/draft/draft_check.hpp"
#include "support/classify_mesh.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::at_height;
using test::Loop2;
using test::SolidBuilder;

double draft_of(std::string_view text, TextureRule rule = TextureRule::metric) {
  const auto finish = parse_finish(text, rule);
  return finish ? finish->required_deg : -1.0;
}

TEST(Finish, AsksForDraftByTheNamedTable) {
  EXPECT_EQ(draft_of("polished"), 0.5);
  EXPECT_EQ(draft_of(" shut-off "), 3.0);
  EXPECT_EQ(draft_of("none"), 0.0);
  EXPECT_EQ(draft_of("draft 2.25"), 2.25);
  EXPECT_NEAR(draft_of("texture 0.05"), 2.0, 1e-12);
  EXPECT_NEAR(draft_of("texture 0.05 mm", TextureRule::inch), 1.5 * 0.05 / 0.0254, 1e-12);
  EXPECT_NEAR(draft_of("texture 0.001 in", TextureRule::inch), 1.5, 1e-12);
  EXPECT_NEAR(draft_of("texture 0.001 in"), 1.016, 1e-12);
  EXPECT_EQ(draft_of("texture 0.001"), 0.5) << "no less than polished";
}

TEST(Finish, RefusesWhatIsNone) {
  for (const char* text : {"", "matt", "texture", "texture -1", "texture 1 m", "texture 5 mm", "draft",
                           "draft 0", "draft 46", "draft 2 deg", "polished 2", "texture nan"})
    EXPECT_EQ(draft_of(text), -1.0) << text;
}

/// A block whose walls narrow upward by 1 degree, on a level foot.
TriangleMesh block() {
  const double in = 8.0 * std::tan(glm::radians(1.0));
  const Loop2 foot = {{0, 0}, {20, 0}, {20, 12}, {0, 12}},
              top = {{in, in}, {20 - in, in}, {20 - in, 12 - in}, {in, 12 - in}};
  SolidBuilder solid;
  solid.face(at_height({foot.rbegin(), foot.rend()}, 0.0));
  solid.face(at_height(top, 8.0));
  solid.walls(at_height(foot, 0.0), at_height(top, 8.0));
  return solid.mesh();
}

DraftCheck checked(const PartModel& model, const DraftDemand& demand) {
  const Query query{glm::dvec3(0, 0, 1), {}};
  const Classification result = classify_exact(model, query, Progress{});
  return check_draft(model, assign_sides(model, query, {}, Progress{}), result.reverse_draft, demand);
}

TEST(Finish, FailsTheFacesThatHaveTooLittle) {
  const auto model = test::model_of(block());
  const Faces faces = part_faces(model->part, model->geometry, model->adjacency);
  ASSERT_EQ(faces.count(), 6U);
  // Two walls are textured, the rest is polished.
  std::string text = "face,finish\n*, polished\n";
  std::vector<std::uint32_t> textured;
  double area = 0.0;
  for (std::uint32_t face = 0; face < faces.count() && textured.size() < 2; ++face) {
    if (std::abs(model->geometry.normals[faces.facets(face)[0]].z) > 0.5) continue;
    textured.push_back(face);
    text += std::to_string(face) + ",texture 0.05 mm\n";
    for (const FacetIndex facet : faces.facets(face)) area += model->geometry.areas[facet];
  }
  const auto finishes = finishes_in(text, "finish.csv", *model, TextureRule::metric);
  ASSERT_EQ(finishes.size(), 6U);
  const DraftCheck check = checked(*model, {0.0, finishes});
  ASSERT_EQ(check.finishes.size(), 2U);
  const FinishDraft &texture = check.finishes[0], &polished = check.finishes[1];
  EXPECT_EQ(texture.finish.name, "texture 0.05 mm");
  EXPECT_EQ(texture.faces, 2U);
  EXPECT_EQ(texture.faces_below, 2U);
  EXPECT_NEAR(texture.area, area, 1e-9 * area);
  EXPECT_NEAR(texture.below, area, 1e-9 * area);
  EXPECT_NEAR(texture.least_deg.value_or(0.0), 1.0, 1e-6);
  EXPECT_EQ(polished.faces, 4U);
  EXPECT_EQ(polished.faces_below, 0U);
  EXPECT_EQ(polished.below, 0.0);
  ASSERT_EQ(check.walls.size(), 2U);
  for (const WallDraft& wall : check.walls) {
    EXPECT_EQ(wall.finish, "texture 0.05 mm");
    EXPECT_NEAR(wall.required_deg, 2.0, 1e-12);
    EXPECT_NEAR(wall.thickness, 8.0 * (std::tan(glm::radians(2.0)) - std::tan(glm::radians(1.0))), 1e-6);
    EXPECT_TRUE(wall.face == textured[0] || wall.face == textured[1]);
  }
  // Faces without a finish ask for what all do.
  const DraftCheck others =
      checked(*model, {1.5, finishes_in("0,none\n", "finish.csv", *model, TextureRule::metric)});
  for (const WallDraft& wall : others.walls) EXPECT_EQ(wall.required_deg, 1.5);
}

TEST(Finish, IsThatOfAColourOfTheFile) {
  const auto plain = test::model_of(block());
  Part part = plain->part;
  part.facet_source = part_faces(part, plain->geometry, plain->adjacency).of_facet;
  part.has_cad_faces = true;
  part.face_colours = {0xFF0000, k_no_colour, 0x00AAFF, 0xFF0000, k_no_colour, k_no_colour};
  const auto model = prepare_part(std::move(part), Progress{});
  const auto found = finishes_in("#FF0000,polished\n#00aaff,texture 0.1 mm\n3,shut-off\n", "finish.csv",
                                 *model, TextureRule::metric);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].face, 0U);
  EXPECT_EQ(found[0].finish.name, "polished");
  EXPECT_EQ(found[1].face, 2U);
  EXPECT_EQ(found[1].finish.required_deg, 4.0);
  EXPECT_EQ(found[2].finish.name, "shut-off") << "a later line holds";
  try {
    static_cast<void>(finishes_in("#123456,polished\n", "finish.csv", *model, TextureRule::metric));
    FAIL() << "no face has it";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("#00aaff, #ff0000"), std::string::npos) << error.what();
  }
}

/// An overhang by half a degree: what the lateral tolerance lets pass is reverse draft, the rest an undercut.
TEST(Draft, OfAWallThatLeansBackIsAllOfIt) {
  const double height = 20.0, back = height * std::tan(glm::radians(0.5));
  const Loop2 foot = {{0, 0}, {20, 0}, {20, 12}, {0, 12}},
              top = {{0, 0}, {20 + back, 0}, {20 + back, 12}, {0, 12}};
  SolidBuilder solid;
  solid.box({-5, -5, -3}, {40, 17, 0}, {5});
  solid.face(test::box_face({-5, -5, -3}, {40, 17, 0}, 5), {at_height(foot, 0.0)});
  solid.face(at_height(top, height));
  solid.walls(at_height(foot, 0.0), at_height(top, height));
  const auto model = test::model_of(solid.mesh());
  const DraftCheck check = checked(*model, {1.0});
  const double wall = 12.0 * height / std::cos(glm::radians(0.5));
  EXPECT_LT(check.reverse.area, 0.9 * wall);
  EXPECT_NEAR(check.reverse.area + check.reverse_undercut, wall, 1e-3 * wall);
}

TEST(Finish, NamesTheLineThatIsWrong) {
  const auto model = test::model_of(block());
  const auto message = [&](std::string_view text) {
    try {
      static_cast<void>(finishes_in(text, "finish.csv", *model, TextureRule::metric));
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("face,finish\n0,polished\n6,polished\n").find("line 3"), std::string::npos);
  EXPECT_NE(message("0,shiny\n").find("shiny"), std::string::npos);
  EXPECT_NE(message("0\n"), "");
  EXPECT_NE(message(""), "");
  EXPECT_NE(message("face,finish\n"), "");
  EXPECT_EQ(message("# walls\n\n0;polished\n0,shut-off\n"), "");
}

}  // namespace
}  // namespace moldlight
