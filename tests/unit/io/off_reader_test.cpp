#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;

const std::string k_off_square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Off, ReadsEverySpelling) {
  const std::vector<std::string> spellings = {
      "OFF\n4 2 0\n" + k_off_square + "4 0 1 2 3\n3 0 2 1\n",
      "OFF 4 2 0\n" + k_off_square + "4 0 1 2 3\n3 0 2 1",
      "# by hand\r\nOFF # text\r\n\r\n4 2\r\n0 0 0 # first\r\n1 0 0\r\n\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 "
      "3\r\n3 0 2 1\r\n",
      "COFF\n4 2 5\n0 0 0 255 0 0 255\n1 0 0 0 1 0 1\n1 1 0 0 0 0 0\n0 1 0 1 1 1 1\n4 0 1 2 3 0.5 0.5 "
      "0.5\n3 0 2 1 255 255 255 0\n",
      std::string("NOFF\n4 2 5\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n3 0 2 1\n"),
  };
  for (const std::string& text : spellings) {
    const Part part = read_bytes("part.off", text);
    EXPECT_EQ(part.format, "OFF");
    ASSERT_EQ(part.mesh.facets.size(), 3u) << text;
    EXPECT_EQ(part.facet_source, (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(part.mesh.corner(1, 2), glm::dvec3(0, 1, 0)) << text;
    EXPECT_EQ(part.mesh.corner(2, 1), glm::dvec3(1, 1, 0)) << text;
    EXPECT_TRUE(part.warnings.empty());
  }
  EXPECT_EQ(read_bytes("part", "OFF\n4 1 0\n" + k_off_square + "3 0 1 2\n").format, "OFF");
  EXPECT_EQ(read_bytes("part.off", "OFF\n4 1 0\n" + k_off_square + "3 0 1 2\n3 0 1 2\n").warnings.size(), 1u);
}

TEST(Off, NamesThePlaceOfEveryFault) {
  const std::string again = "; export the part again";
  EXPECT_EQ(read_error("a.off", "4OFF\n4 1 0\n"),
            "a.off: line 1: expected 'OFF', found '4OFF'; export the part in three dimensions");
  EXPECT_EQ(read_error("a.off", "OFF BINARY\n"), "a.off: line 1: is binary OFF; export the part as text");
  EXPECT_EQ(read_error("a.off", "OFF\n4 -1 0\n"),
            "a.off: line 2: expected a count of vertices or faces, found '-1'" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4\n0 0 0\n"),
            "a.off: line 2: expected a count of vertices or faces, found nothing" + again);
  EXPECT_EQ(
      read_error("a.off", "OFF\n99999999999 1 0\n"),
      "a.off: line 2: declares 99999999999 vertices and 1 faces, more than a file of 20 bytes holds" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4 1 0\n0 0 0\n1 0\n1 1 0\n0 1 0\n3 0 1 2\n"),
            "a.off: line 4: expected three coordinates of vertex 1, found nothing" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4 1 0\n0 0 0\n1 0 inf\n1 1 0\n0 1 0\n3 0 1 2\n"),
            "a.off: line 4: vertex 1 is (1, 0, inf)" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4 2 0\n" + k_off_square + "3 0 1 2\n"),
            "a.off: line 8: expected the corner count of face 1, found nothing" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4 1 0\n" + k_off_square + "2 0 1\n"),
            "a.off: line 7: face 0 has 2 corners, it needs three" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4 1 0\n" + k_off_square + "3 0 1\n"),
            "a.off: line 7: expected 3 vertex numbers of face 0, found nothing" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4 1 0\n" + k_off_square + "3 0 1 4\n"),
            "a.off: line 7: face 0 uses vertex 4, but there are 4, numbered from 0" + again);
  EXPECT_EQ(read_error("a.off", "OFF\n4 0 0\n" + k_off_square),
            "a.off: holds no facets; export the part as a mesh of polygons");
}

}  // namespace
}  // namespace moldlight
