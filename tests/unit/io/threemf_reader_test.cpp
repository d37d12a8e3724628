#include <string>

#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "support/zip_bytes.hpp"
#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;
using test::threemf_bytes;

const std::string k_triangle =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices>)"
    R"(<triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>)";

std::string model(const std::string& resources, const std::string& items,
                  const std::string& attributes = R"(unit="inch")") {
  return R"(<?xml version="1.0"?><model )" + attributes +
         R"( xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02")"
         R"( xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" xmlns:x="urn:other"><resources>)" +
         resources + "</resources><build>" + items + "</build></model>";
}
std::string object(int id, const std::string& content, const std::string& attributes = "") {
  return "<object id=\"" + std::to_string(id) + "\" " + attributes + ">" + content + "</object>";
}
std::string uses(const std::string& content) { return "<components>" + content + "</components>"; }

TEST(Threemf, PlacesItemsAndComponents) {
  const std::string shift_x = R"(transform="1 0 0 0 1 0 0 0 1 10 0 0")";
  const std::string turn_z = R"(transform="0 1 0 -1 0 0 0 0 1 0 0 5")";
  const Part part = read_bytes(
      "part.3mf",
      threemf_bytes(
          model(object(1, k_triangle, R"(name="leaf")") +
                    object(2, uses("<component objectid=\"1\" " + shift_x + "/><component objectid=\"1\"/>"),
                           R"(name="pair")") +
                    object(3, k_triangle),
                "<item objectid=\"2\" " + turn_z + "/><item objectid=\"3\"/>")));
  EXPECT_EQ(part.format, "3MF");
  EXPECT_EQ(part.unit, "in");
  ASSERT_EQ(part.bodies.size(), 3u);
  EXPECT_EQ(part.bodies[0].name, "leaf");
  EXPECT_EQ(part.bodies[2].name, "");
  EXPECT_EQ(part.bodies[2].first_facet, 2u);
  // (1, 0, 0) is shifted to (11, 0, 0), then turned by 90 degrees about z and lifted.
  EXPECT_EQ(part.mesh.corner(0, 1), glm::dvec3(0, 11, 5));
  EXPECT_EQ(part.mesh.corner(1, 2), glm::dvec3(-1, 0, 5));
  EXPECT_EQ(part.mesh.corner(2, 1), glm::dvec3(1, 0, 0));
}

TEST(Threemf, KeepsOutsidesOutsideWhereATransformMirrors) {
  const Part part = read_bytes(
      "part.3mf", threemf_bytes(model(object(1, k_triangle),
                                      R"(<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>)")));
  EXPECT_EQ(facet_geometry(part.mesh).normals[0], glm::dvec3(0, 0, 1));
}

TEST(Threemf, FollowsTheProductionExtensionInsideTheArchive) {
  const std::string root =
      model(object(8, uses(R"(<component p:path="/3D/Objects/leaf.model" objectid="1"/>)")),
            R"(<item objectid="8"/>)", R"(unit="millimeter" requiredextensions="p")");
  const std::string rels =
      R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" )"
      R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" Target="/3D/3dmodel.model"/></Relationships>)";
  const std::string leaf = model(object(1, k_triangle), "", R"(unit="centimeter")");
  const Part part = read_bytes(
      "part.3mf",
      test::zip_bytes({{"_rels/.rels", rels}, {"3D/3dmodel.model", root}, {"3D/Objects/leaf.model", leaf}}));
  EXPECT_EQ(part.mesh.corner(0, 1), glm::dvec3(10, 0, 0));
  EXPECT_TRUE(part.warnings.empty());
  for (const char* path :
       {"/etc/passwd", "../../../../etc/passwd", "/3D/../../etc/passwd", "file:///etc/passwd"}) {
    std::string outside = root;
    outside.replace(outside.find("/3D/Objects/leaf.model"), 22, path);
    const std::string error =
        read_error("a.3mf", test::zip_bytes({{"_rels/.rels", rels}, {"3D/3dmodel.model", outside}}));
    EXPECT_TRUE(error.starts_with("a.3mf: the archive holds no '")) << error;
  }
}

TEST(Threemf, LeavesOutSupportsAndSaysSo) {
  const Part part = read_bytes(
      "part.3mf", threemf_bytes(model(object(1, k_triangle) + object(2, k_triangle, R"(type="support")"),
                                      R"(<item objectid="1"/><item objectid="2"/>)")));
  EXPECT_EQ(part.mesh.facets.size(), 1u);
  ASSERT_EQ(part.warnings.size(), 1u);
  EXPECT_EQ(part.warnings[0], "1 support structures were left out");
}

TEST(Threemf, TakesAllObjectsWhereNothingIsBuilt) {
  const Part part = read_bytes(
      "part.3mf",
      threemf_bytes(model(object(1, k_triangle) + object(2, uses(R"(<component objectid="1"/>)")), "")));
  EXPECT_EQ(part.mesh.facets.size(), 1u);
  EXPECT_EQ(part.warnings.size(), 1u);
}

TEST(Threemf, WarnsOfExtensionsThatItDoesNotRead) {
  const Part part = read_bytes(
      "part.3mf",
      threemf_bytes(model(object(1, k_triangle), R"(<item objectid="1"/>)", R"(requiredextensions="x p")")));
  EXPECT_EQ(part.unit, "mm");
  ASSERT_EQ(part.warnings.size(), 1u);
  EXPECT_EQ(part.warnings[0], "the 3MF extension 'urn:other' is not read; some of the part may be missing");
}

TEST(Threemf, StopsReferencesWithoutEnd) {
  const std::string ring =
      model(object(1, uses(R"(<component objectid="2"/>)")) + object(2, uses(R"(<component objectid="1"/>)")),
            R"(<item objectid="1"/>)");
  EXPECT_TRUE(read_error("a.3mf", threemf_bytes(ring)).find("nested more than 64 deep, or in a ring") !=
              std::string::npos);
  // Ten uses at each of twelve levels: a million million triangles, or as many empty objects.
  for (const auto& [leaf, error] :
       {std::pair{k_triangle, "a.3mf: places more than 20000 bodies; save those that matter"},
        std::pair{std::string(), "a.3mf: uses more than 1000000 objects, as no real part does"}}) {
    std::string objects = object(1, leaf);
    for (int level = 2; level <= 13; ++level) {
      std::string ten;
      for (int i = 0; i < 10; ++i) ten += "<component objectid=\"" + std::to_string(level - 1) + "\"/>";
      objects += object(level, uses(ten));
    }
    EXPECT_EQ(read_error("a.3mf", threemf_bytes(model(objects, R"(<item objectid="13"/>)"))), error);
  }
  std::string chain = object(1, k_triangle);
  for (int level = 2; level <= 60; ++level)
    chain += object(level, uses("<component objectid=\"" + std::to_string(level - 1) + "\"/>"));
  EXPECT_EQ(
      read_bytes("part.3mf", threemf_bytes(model(chain, R"(<item objectid="60"/>)"))).mesh.facets.size(), 1u);
}

TEST(Threemf, StopsBombs) {
  const std::string padding(200'000'000, ' ');
  EXPECT_EQ(
      read_error("a.3mf", threemf_bytes(model(object(1, k_triangle) + padding, R"(<item objectid="1"/>)"))),
      "a.3mf: '3D/part.model': expands to more than 100 times the file's size, as no real part does");
  EXPECT_TRUE(read_error("a.3mf", threemf_bytes(model(
                                      "<object id=\"1\" name=\"" + std::string(3'000'000, 'x') + "\"/>", "")))
                  .find("holds a tag of more than 1048576 bytes") != std::string::npos);
  const std::string laughs = R"(<!DOCTYPE model [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]>)" +
                             model(object(1, k_triangle), "&b;").substr(21);
  EXPECT_EQ(read_error("a.3mf", threemf_bytes(laughs)),
            "a.3mf: '3D/part.model' line 1: declares a document type, which is forbidden here; export the "
            "part again");
  std::string deep;
  for (int i = 0; i < 300'000; ++i) deep += "<d>";
  EXPECT_TRUE(read_error("a.3mf", threemf_bytes(model(deep, ""))).find("is damaged XML") !=
              std::string::npos);
}

TEST(Threemf, StopsAtTheFacetLimit) {
  const std::string two = model(object(1, k_triangle), R"(<item objectid="1"/><item objectid="1"/>)");
  EXPECT_EQ(read_error("a.3mf", threemf_bytes(two), {.max_facets = 1}),
            "a.3mf: holds more facets than the limit of 1; raise the limit (--max-facets) if they are meant");
}

TEST(Threemf, NamesThePlaceOfEveryFault) {
  const std::string again = "; export the part again";
  const auto error_of = [](const std::string& text) {
    const std::string error = read_error("a.3mf", threemf_bytes(text));
    const std::string place = "a.3mf: '3D/part.model' line 1: ";
    return error.starts_with(place) ? error.substr(place.size()) : error;
  };
  const std::string item = R"(<item objectid="1"/>)";
  const auto mesh = [&](const std::string& from, const std::string& to) {
    std::string changed = k_triangle;
    changed.replace(changed.find(from), from.size(), to);
    return model(object(1, changed), item);
  };
  EXPECT_EQ(error_of(mesh("v3=\"2\"", "v3=\"3\"")),
            "triangle 0 of object 1 uses vertex 3, but there are 3, numbered from 0" + again);
  EXPECT_EQ(error_of(mesh("v3=\"2\"", "v3=\"-1\"")), "expected a number from 0 as 'v3', found '-1'" + again);
  EXPECT_EQ(error_of(mesh("v3=\"2\"", "")), "the attribute 'v3' is missing" + again);
  EXPECT_EQ(error_of(mesh("x=\"1\"", "x=\"one\"")), "expected a coordinate, found 'one'" + again);
  EXPECT_EQ(error_of(mesh("x=\"1\"", "x=\"NaN\"")), "vertex 1 of object 1 is (nan, 0, 0)" + again);
  EXPECT_EQ(error_of(mesh("<triangle ", "<triangle <")),
            "is damaged XML (not well-formed (invalid token))" + again);
  EXPECT_EQ(error_of(model(object(1, k_triangle), R"(<item objectid="2"/>)")),
            "there is no object 2 in '3D/part.model'" + again);
  EXPECT_EQ(
      error_of(model(object(1, k_triangle), R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0"/>)")),
      "expected twelve numbers of a transform, found nothing" + again);
  EXPECT_EQ(error_of(model(object(1, k_triangle) + object(1, k_triangle), item)),
            "a second object has the identifier 1" + again);
  EXPECT_EQ(error_of(model(object(1, k_triangle), item, R"(unit="furlong")")),
            "the unit 'furlong' is unknown" + again);
  EXPECT_EQ(error_of(model(object(1, ""), item)), "a.3mf: holds no facets" + again);
  EXPECT_EQ(error_of("<html/>"), "expected a 3MF model, found the element 'html'" + again);
  EXPECT_EQ(error_of(""), "is damaged XML (no element found)" + again);
}

TEST(Threemf, SaysWhatIsWrongWithTheArchive) {
  const std::string whole = threemf_bytes(model(object(1, k_triangle), R"(<item objectid="1"/>)"));
  EXPECT_TRUE(read_error("a.3mf", whole.substr(0, whole.size() / 2))
                  .starts_with("a.3mf: is a damaged or truncated zip archive ("));
  EXPECT_EQ(read_error("a.3mf", test::zip_bytes({{"notes.txt", "nothing"}})),
            "a.3mf: is a zip archive, but not a 3MF package; export the part again");
  std::string broken = whole;
  broken[broken.find("3D/part.model") + 40] ^= 0x55;
  EXPECT_NE(read_error("a.3mf", broken), "no error");
}

}  // namespace
}  // namespace moldlight
