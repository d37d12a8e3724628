#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;

const std::string k_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsEveryFormOfCorner) {
  for (const char* faces :
       {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/1 4/4/1",
        "f -4 -3 -2 -1", "f -4/1/-1 -3/2/-1 -2/3/-1 -1/4/-1", "f 1/ 2/ 3/ 4/", "f 1 2 \\\n3 4",
        "f 1 2 \\\r\n 3 4 # a square", "f\t1  2\t3 4\r\n", "fo 1 2 3 4"}) {
    const Part part = read_bytes("part.obj", k_square + faces);
    EXPECT_EQ(part.format, "OBJ");
    ASSERT_EQ(part.mesh.facets.size(), 2u) << faces;
    EXPECT_EQ(part.mesh.corner(0, 0), glm::dvec3(0, 0, 0)) << faces;
    EXPECT_EQ(part.mesh.corner(0, 2), glm::dvec3(1, 1, 0)) << faces;
    EXPECT_EQ(part.mesh.corner(1, 2), glm::dvec3(0, 1, 0)) << faces;
    EXPECT_EQ(part.facet_source, (std::vector<std::uint32_t>{0, 0}));
  }
}

TEST(Obj, ReadsEveryFormOfNumber) {
  const Part part = read_bytes("part.obj",
                               "\xef\xbb\xbf# by hand\nv .5 5. +1\nv -1e2 1E+2 1.5e-1\nv 0 0 0 1.0\nv 1 2 3 "
                               "0.5 0.5 0.5\nf 1 2 3\nf 2 3 4");
  EXPECT_EQ(part.mesh.corner(0, 0), glm::dvec3(0.5, 5, 1));
  EXPECT_EQ(part.mesh.corner(0, 1), glm::dvec3(-100, 100, 0.15));
  EXPECT_EQ(part.mesh.corner(1, 2), glm::dvec3(1, 2, 3));
  EXPECT_TRUE(part.facet_source.empty());
}

TEST(Obj, NumbersFacetsInTheOrderOfPolygons) {
  const Part part = read_bytes("part.obj", k_square + "v 0.5 0.5 1\nf 1 2 5\nf 4 3 2 1\nf 3 4 5\n");
  ASSERT_EQ(part.mesh.facets.size(), 4u);
  EXPECT_EQ(part.facet_source, (std::vector<std::uint32_t>{0, 1, 1, 2}));
}

TEST(Obj, CutsConcavePolygonsWithoutOverlap) {
  // An arrow head and an L, each with a corner order for which the fan from the first corner leaves the
  // polygon.
  const Part arrow = read_bytes("part.obj", "v 2 0 0\nv 0 2 0\nv -2 0 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_DOUBLE_EQ(facet_geometry(arrow.mesh).total_area, 2.0);
  const Part ell = read_bytes(
      "part.obj", "v 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nv 0 0 0\nf 1 2 3 4 5 6\nf 6 5 4 3 2 1\n");
  ASSERT_EQ(ell.mesh.facets.size(), 8u);
  const FacetGeometry geometry = facet_geometry(ell.mesh);
  EXPECT_DOUBLE_EQ(geometry.total_area, 10.0);
  for (FacetIndex k = 0; k < 8; ++k) EXPECT_EQ(geometry.normals[k].z, k < 4 ? 1.0 : -1.0);
  EXPECT_TRUE(ell.warnings.empty());
}

TEST(Obj, WarnsOfPolygonsThatCrossThemselves) {
  for (const char* last : {"v 0 1 0\n", "v 0 3 0\n"}) {
    const Part part =
        read_bytes("part.obj", std::string("v 0 0 0\nv 3 3 0\nv 3 0 0\n") + last + "f 1 2 3\nf 1 2 3 4\n");
    EXPECT_EQ(part.mesh.facets.size(), 3u);
    ASSERT_EQ(part.warnings.size(), 1u) << last;
    EXPECT_TRUE(part.warnings[0].starts_with("1 polygons, the first of them polygon 1, cross themselves"));
  }
}

TEST(Obj, KeepsPolygonsWithoutArea) {
  const Part part = read_bytes("part.obj", k_square + "f 1 2 3 4\nf 1 1 1 1\nf 1 2 1 2\n");
  EXPECT_EQ(part.mesh.facets.size(), 6u);
  EXPECT_TRUE(part.warnings.empty());
}

TEST(Obj, TakesObjectsAsBodiesBeforeGroups) {
  const std::string faces = "g 0\ng a\nf 1 2 3\nf 1 3 4\ng b c\nf 2 3 4\ng b c\nf 1 2 4\n";
  const Part groups = read_bytes("part.obj", k_square + faces);
  ASSERT_EQ(groups.bodies.size(), 2u);
  EXPECT_EQ(groups.bodies[0].name, "a");
  EXPECT_EQ(groups.bodies[0].facet_count, 2u);
  EXPECT_EQ(groups.bodies[1].name, "b c");
  EXPECT_EQ(groups.bodies[1].first_facet, 2u);
  EXPECT_EQ(groups.bodies[1].facet_count, 2u);
  const Part objects = read_bytes("part.obj", k_square + "f 1 2 3\no lid#2\n" + faces);
  ASSERT_EQ(objects.bodies.size(), 2u);
  EXPECT_EQ(objects.bodies[0].name, "");
  EXPECT_EQ(objects.bodies[0].facet_count, 1u);
  EXPECT_EQ(objects.bodies[1].name, "lid#2");
  EXPECT_EQ(objects.bodies[1].facet_count, 4u);
}

TEST(Obj, OpensNoOtherFile) {
  EXPECT_EQ(read_bytes("part.obj",
                       "mtllib missing.mtl ../../etc/passwd\n" + k_square + "usemtl steel\ns off\nf 1 2 3\n")
                .mesh.facets.size(),
            1u);
}

TEST(Obj, LetsFacesComeBeforeTheirVertices) {
  EXPECT_EQ(read_bytes("part.obj", "f 1 2 3 4\n" + k_square).mesh.facets.size(), 2u);
  EXPECT_EQ(read_error("a.obj", "f 1 2 3\nf 1 2 5\nf 1 2 6\n" + k_square),
            "a.obj: line 2: a face uses vertex 5, but there are 4; export the part again");
}

TEST(Obj, NamesThePlaceOfEveryFault) {
  const std::string again = "; export the part again";
  EXPECT_EQ(read_error("a.obj", k_square + "f 1 2 3\nf 1 3 9\nf 1 2 4\n"),
            "a.obj: line 6: a face uses vertex 9, but there are 4" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "f 0 1 2\n"),
            "a.obj: line 5: a face uses vertex 0, but there are 4 so far, numbered from 1" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "f -5 -1 -2\n"),
            "a.obj: line 5: a face uses vertex -5, but there are 4 so far, numbered from 1" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "f 1 2 4294967296\n"),
            "a.obj: line 5: a face uses vertex 4294967296, but there are 4 so far, numbered from 1" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "f 1 2 \\\n 99999999999999999999\n"),
            "a.obj: line 6: expected a corner such as 7 or 7/1/3, found '99999999999999999999'" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "f 1 2\n"),
            "a.obj: line 5: a face has 2 corners, it needs three" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "f\n"),
            "a.obj: line 5: a face has 0 corners, it needs three" + again);
  for (const char* corner : {"1.5", "x", "/1", "1/2/3/4", "1/x", "1//y", "1-", "--1"}) {
    EXPECT_EQ(
        read_error("a.obj", k_square + "f 1 2 " + corner),
        std::string("a.obj: line 5: expected a corner such as 7 or 7/1/3, found '") + corner + "'" + again);
  }
  EXPECT_EQ(read_error("a.obj", "v 0 0\n"), "a.obj: line 1: a vertex has 2 coordinates, not three" + again);
  EXPECT_EQ(read_error("a.obj", "v 0 0 1,5\n"), "a.obj: line 1: expected a coordinate, found '1,5'" + again);
  EXPECT_EQ(read_error("a.obj", "v inf nan +inf\n"), "a.obj: line 1: vertex 1 is (inf, nan, inf)" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "v 1e31 0 0\n"),
            "a.obj: line 5: vertex 5 is (1e+31, 0, 0)" + again);
  EXPECT_EQ(read_error("a.obj", k_square + "w 1 2 3\n"),
            "a.obj: line 5: 'w' is not a line of an OBJ file" + again);
  EXPECT_EQ(read_error("a.obj", k_square), "a.obj: holds no facets; export the part as a mesh of polygons");
}

TEST(Obj, StopsAtTheFacetLimit) {
  EXPECT_EQ(read_error("a.obj", k_square + "f 1 2 3 4\n", {.max_facets = 1}),
            "a.obj: holds more facets than the limit of 1; raise the limit (--max-facets) if they are meant");
}

TEST(Obj, CutsAHugeConcavePolygonInBoundedTime) {
  std::string text, face = "f";
  constexpr int k_teeth = 100'000;
  for (int i = 0; i < k_teeth; ++i) {
    text += "v " + std::to_string(i) + " " + (i % 2 == 0 ? "0" : "1") + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  text += "v 50000 1000000 0\n" + face + " " + std::to_string(k_teeth + 1) + "\n";
  const Part part = read_bytes("part.obj", text);
  EXPECT_EQ(part.mesh.facets.size(), static_cast<std::size_t>(k_teeth - 1));
}

}  // namespace
}  // namespace moldlight
