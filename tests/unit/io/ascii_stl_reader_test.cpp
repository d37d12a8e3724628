#include <string>

#include <gtest/gtest.h>

#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;

std::string facet_text(const std::string& third = "0 1 0") {
  return "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex " + third +
         "\nendloop\nendfacet\n";
}

std::string solid_text(const std::string& facets, const std::string& name = "part") {
  return "solid " + name + "\n" + facets + "endsolid " + name + "\n";
}

TEST(AsciiStl, ReadsEverySpelling) {
  const std::string spellings[] = {
      solid_text(facet_text()),
      "SOLID PART\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 "
      "0\nENDLOOP\nENDFACET\nENDSOLID PART\n",
      "Solid\r\n\tFacet Normal 0 0 1\r\n\t\tOuter Loop\r\nVertex 0 0 0\r\nVertex 1 0 0\r\nVertex 0 1 "
      "0\r\nEndLoop\r\nEndFacet\r\nEndSolid",
      "solid\rfacet normal 0 0 1\router loop\rvertex 0 0 0\rvertex 1 0 0\rvertex 0 1 "
      "0\rendloop\rendfacet\rendsolid\r",
      "solid a b facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet "
      "endsolid a b",
      "\xef\xbb\xbfsolid\nfacet normal nan -nan(ind) 1.#QNAN outer loop\n\n\nvertex 0 0 0\vvertex 1 0 "
      "0\fvertex 0 1 0\nendloop endfacet\nendsolid",
      "  \n solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nend loop\nend "
      "facet\nend solid x\n",
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex +0.0E+00 -0e0 .0\nvertex 1.E+0 0. 0\nvertex 0 10e-1 "
      "0\nendloop\nendfacet\nendsolid",
  };
  for (const std::string& text : spellings) {
    const Part part = read_bytes("part.stl", text);
    EXPECT_EQ(part.format, "STL ASCII") << text;
    ASSERT_EQ(part.mesh.facets.size(), 1u) << text;
    EXPECT_EQ(part.mesh.corner(0, 0), glm::dvec3(0, 0, 0)) << text;
    EXPECT_EQ(part.mesh.corner(0, 1), glm::dvec3(1, 0, 0)) << text;
    EXPECT_EQ(part.mesh.corner(0, 2), glm::dvec3(0, 1, 0)) << text;
    EXPECT_TRUE(part.warnings.empty()) << part.warnings.front();
  }
}

TEST(AsciiStl, TakesNumbersExactly) {
  const Part part = read_bytes("part.stl", solid_text(facet_text("0.1 -1.25e-3 1e-400")));
  EXPECT_EQ(part.mesh.corner(0, 2), glm::dvec3(0.1, -0.00125, 0.0));
}

TEST(AsciiStl, MakesABodyOfEverySolidWithFacets) {
  const Part part = read_bytes("part.stl", solid_text(facet_text() + facet_text("0 2 0"), "lid") +
                                               solid_text("", "nothing") +
                                               solid_text(facet_text("0 3 0"), "\xe6\x9c\x88\xe7\x90\x83"));
  ASSERT_EQ(part.bodies.size(), 2u);
  EXPECT_EQ(part.bodies[0].name, "lid");
  EXPECT_EQ(part.bodies[0].first_facet, 0u);
  EXPECT_EQ(part.bodies[0].facet_count, 2u);
  EXPECT_EQ(part.bodies[1].name, "\xe6\x9c\x88\xe7\x90\x83");
  EXPECT_EQ(part.bodies[1].first_facet, 2u);
  EXPECT_EQ(part.bodies[1].facet_count, 1u);
  EXPECT_EQ(part.mesh.corner(2, 2), glm::dvec3(0, 3, 0));
}

TEST(AsciiStl, LosesNoFacetWhereAllStandsOnOneLine) {
  std::string text = solid_text(facet_text()) + solid_text(facet_text("0 2 0"));
  for (char& c : text) c = c == '\n' ? ' ' : c;
  EXPECT_EQ(read_bytes("part.stl", text).mesh.facets.size(), 2u);
}

TEST(AsciiStl, KeepsWordsOfTheGrammarInNames) {
  const Part part =
      read_bytes("part.stl", "solid facet normal plate\n" + facet_text() + "endsolid facet normal plate\n");
  EXPECT_EQ(part.bodies[0].name, "facet normal plate");
}

TEST(AsciiStl, MakesNamesPrintable) {
  EXPECT_EQ(read_bytes("part.stl", solid_text(facet_text(), "a\x1b[31m\xff z")).bodies[0].name,
            R"(a\u001B[31m\xFF z)");
}

TEST(AsciiStl, WarnsOfMissingClosingWord) {
  const Part cut = read_bytes("part.stl", "solid a\n" + facet_text());
  ASSERT_EQ(cut.warnings.size(), 1u);
  EXPECT_EQ(cut.warnings[0],
            "1 solids end without 'endsolid'; the file may be cut short (the first at line 9)");
  const Part two = read_bytes("part.stl", "solid a\n" + facet_text() + solid_text(facet_text(), "b"));
  EXPECT_EQ(two.warnings.size(), 1u);
  EXPECT_EQ(two.bodies.size(), 2u);
  const Part none = read_bytes("part.stl", facet_text());
  ASSERT_EQ(none.warnings.size(), 2u);
  EXPECT_EQ(none.warnings[0], "1 solids begin without the word 'solid' (the first at line 1)");
}

TEST(AsciiStl, KeepsDegenerateFacets) {
  const Part part = read_bytes("part.stl", solid_text(facet_text("1 0 0") + facet_text()));
  ASSERT_EQ(part.mesh.facets.size(), 2u);
  EXPECT_EQ(part.mesh.corner(0, 1), part.mesh.corner(0, 2));
  EXPECT_EQ(part.mesh.corner(1, 2), glm::dvec3(0, 1, 0));
}

TEST(AsciiStl, NamesThePlaceOfEveryFault) {
  const std::string again = "; export the part again";
  const std::string solid = "solid a\n" + facet_text();
  EXPECT_EQ(read_error("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 x 0\n"),
            "a.stl: line 5: expected a number, found 'x' (facet 0)" + again);
  EXPECT_EQ(read_error("a.stl", solid + "facet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\n"),
            "a.stl: line 12: expected a number, found 'vertex' (facet 1)" + again);
  EXPECT_EQ(read_error("a.stl", solid_text(facet_text() + facet_text("0 nan 0"))),
            "a.stl: line 13: a coordinate of facet 1 is 'nan'" + again);
  EXPECT_EQ(read_error("a.stl", solid_text(facet_text("-Inf 0 0"))),
            "a.stl: line 6: a coordinate of facet 0 is '-Inf'" + again);
  EXPECT_EQ(read_error("a.stl", solid_text(facet_text("1e400 0 0"))),
            "a.stl: line 6: a coordinate of facet 0 is '1e400'" + again);
  EXPECT_EQ(read_error("a.stl", solid_text(facet_text("0,5 0 0"))),
            "a.stl: line 6: expected a number, found '0,5' (facet 0)" + again);
  EXPECT_EQ(read_error("a.stl", solid_text(facet_text("0 1 0\nvertex 1 1 1"))),
            "a.stl: line 7: facet 0 has more than three vertices; export the part as triangles");
  EXPECT_EQ(
      read_error("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"),
      "a.stl: line 6: expected 'vertex', found 'endloop' (facet 0)" + again);
  EXPECT_EQ(read_error("a.stl", "solid a\nfacet normal 0 1\nouter loop\n"),
            "a.stl: line 3: expected three numbers of a normal, found 'outer' (facet 0)" + again);
  EXPECT_EQ(read_error("a.stl", solid + "endfacet\n"),
            "a.stl: line 9: expected 'facet' or 'endsolid', found 'endfacet' (facet 1)" + again);
  EXPECT_EQ(read_error("a.stl", solid + "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nver"),
            "a.stl: line 12: expected 'vertex', found 'ver' (facet 1)" + again);
  EXPECT_EQ(read_error("a.stl", solid + "facet normal 0 0 1\nouter loop"),
            "a.stl: line 10: the file ends where 'vertex' should follow (facet 1)" + again);
  EXPECT_EQ(read_error("a.stl", solid_text(facet_text()) + "junk\n"),
            "a.stl: line 10: expected 'solid', found 'junk' (facet 1)" + again);
  EXPECT_EQ(read_error("a.stl", "solid a\nendsolid a\n"), "a.stl: line 2: holds no facets" + again);
  EXPECT_EQ(read_error("a.stl", "solid"),
            "a.stl: line 1: the file ends where 'facet' or 'endsolid' should follow (facet 0)" + again);
}

TEST(AsciiStl, StopsAtTheFacetLimit) {
  const std::string text = solid_text(facet_text() + facet_text() + facet_text());
  EXPECT_EQ(read_error("a.stl", text, {.max_facets = 2}),
            "a.stl: holds more facets than the limit of 2; raise the limit (--max-facets) if they are meant");
  EXPECT_EQ(read_error("a.stl", text, {.max_facets = 3}), "no error");
}

}  // namespace
}  // namespace moldlight
