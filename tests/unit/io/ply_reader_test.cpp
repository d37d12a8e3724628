#include <algorithm>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;

std::string ascii_header(const std::string& vertices = "4", const std::string& faces = "2") {
  return "ply\nformat ascii 1.0\ncomment a test\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}
const std::string k_ply_square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// Two quads in a row with values before, between and after what is read.
std::string binary_ply(bool big_endian, const std::string& line_end = "\n") {
  std::string bytes =
      "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
      "_endian 1.0\nobj_info made by a test\nelement camera 2\nproperty list uchar double view\nproperty "
      "char roll\n"
      "element vertex 6\nproperty uchar red\nproperty double x\nproperty float32 y\nproperty short z\n"
      "property list ushort int16 tags\nelement face 2\nproperty float quality\n"
      "property list uint32 ushort vertex_index\nproperty int flag\nend_header\n";
  for (std::size_t at = bytes.find('\n'); line_end != "\n" && at != std::string::npos;
       at = bytes.find('\n', at + line_end.size())) {
    bytes.replace(at, 1, line_end);
  }
  const auto put = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big_endian) std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
  };
  for (int camera = 0; camera < 2; ++camera) {
    put(std::uint8_t{2}), put(1.5), put(2.5), put(std::int8_t{-1});
  }
  for (int i = 0; i < 6; ++i) {
    put(std::uint8_t{255}), put(i / 2 + 0.1), put(static_cast<float>(i % 2)), put(std::int16_t{-300});
    put(static_cast<std::uint16_t>(i));
    for (int tag = 0; tag < i; ++tag) put(std::int16_t{7});
  }
  for (int face = 0; face < 2; ++face) {
    put(0.5f), put(std::uint32_t{4});
    for (const int corner : {0, 2, 3, 1}) put(static_cast<std::uint16_t>(corner + 2 * face));
    put(std::int32_t{-1});
  }
  return bytes;
}

TEST(Ply, ReadsTextWithPolygons) {
  const Part part = read_bytes("part.ply", ascii_header() + k_ply_square + "4 0 1 2 3\n3 0 2 1\n");
  EXPECT_EQ(part.format, "PLY");
  ASSERT_EQ(part.mesh.facets.size(), 3u);
  EXPECT_EQ(part.facet_source, (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(part.mesh.corner(2, 1), glm::dvec3(1, 1, 0));
  EXPECT_TRUE(part.warnings.empty());
}

TEST(Ply, ReadsBothBinaryOrdersAndPassesOverTheRest) {
  for (const bool big_endian : {false, true}) {
    for (const char* line_end : {"\n", "\r\n"}) {
      const Part part = read_bytes("part.ply", binary_ply(big_endian, line_end));
      ASSERT_EQ(part.mesh.facets.size(), 4u);
      EXPECT_EQ(part.mesh.corner(0, 0), glm::dvec3(0.1, 0, -300));
      EXPECT_EQ(part.mesh.corner(2, 1), glm::dvec3(2.1, 0, -300));
      EXPECT_EQ(part.mesh.corner(3, 2), glm::dvec3(1.1, 1, -300));
      EXPECT_EQ(part.facet_source, (std::vector<std::uint32_t>{0, 0, 1, 1}));
      EXPECT_TRUE(part.warnings.empty());
    }
  }
}

TEST(Ply, NamesThePlaceWhereverItIsCut) {
  const std::string whole = binary_ply(false);
  const std::size_t header = whole.find("end_header\n") + 11;
  for (std::size_t size = 4; size < whole.size(); ++size) {
    const std::string error = read_error("a.ply", whole.substr(0, size));
    EXPECT_NE(error, "no error") << size;
    EXPECT_EQ(error.starts_with("a.ply: line "), size + 1 < header) << error;
  }
  EXPECT_EQ(read_error("a.ply", whole.substr(0, whole.size() - 1)),
            "a.ply: face 1 (byte " + std::to_string(whole.size() - 4) +
                "): the file ends inside it; export the part again");
}

TEST(Ply, NamesThePlaceOfEveryFault) {
  const std::string again = "; export the part again";
  EXPECT_EQ(read_error("a.ply", "ply\nformat ascii 1.0\nelement vertex x\n"),
            "a.ply: line 3: expected a count of elements, found 'x'" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nformat ascii 1.0\nelement vertex -1\n"),
            "a.ply: line 3: expected a count of elements, found '-1'" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nformat text 1.0\n"),
            "a.ply: line 2: expected a PLY format such as 'ascii', found 'text'" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nproperty float x\n"),
            "a.ply: line 2: a property stands before any element" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nelement vertex 1\nproperty real x\n"),
            "a.ply: line 3: expected a PLY type such as 'float', found 'real'" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nvertex 1\n"),
            "a.ply: line 2: 'vertex' is not a line of a PLY header" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nend_header\n"),
            "a.ply: line 2: the PLY header names no format" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nformat ascii 1.0\n"),
            "a.ply: line 3: the PLY header ends without 'end_header'" + again);
  const std::string no_y =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement face 1\nend_header\n1\n";
  EXPECT_EQ(read_error("a.ply", no_y), "a.ply: the PLY element 'face' has no properties" + again);
  EXPECT_EQ(read_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
            "a.ply: the vertices have no coordinate y" + again);
  EXPECT_EQ(read_error("a.ply", ascii_header() + k_ply_square + "3 0 1 2\n3 0 1 4\n"),
            "a.ply: face 1 (line 16): it uses vertex 4, but there are 4, numbered from 0" + again);
  EXPECT_EQ(read_error("a.ply", ascii_header() + k_ply_square + "3 0 1 2\n3 0 1 -1\n"),
            "a.ply: face 1 (line 16): it uses vertex -1, but there are 4, numbered from 0" + again);
  EXPECT_EQ(read_error("a.ply", ascii_header() + k_ply_square + "3 0 1.5 2\n3 0 1 2\n"),
            "a.ply: face 0 (line 15): it uses vertex 1.5, but there are 4, numbered from 0" + again);
  EXPECT_EQ(read_error("a.ply", ascii_header() + k_ply_square + "2 0 1\n3 0 1 2\n"),
            "a.ply: face 0 (line 15): it has 2 corners, it needs three" + again);
  EXPECT_EQ(read_error("a.ply", ascii_header() + "0 0 0\n1 x 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"),
            "a.ply: vertex 1 (line 12): expected a number, found 'x'" + again);
  EXPECT_EQ(read_error("a.ply", ascii_header() + "0 0 0\n1 nan 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"),
            "a.ply: vertex 1 (line 12): its coordinates are (1, nan, 0)" + again);
  EXPECT_EQ(read_error("a.ply", ascii_header("4", "0") + k_ply_square),
            "a.ply: holds no facets; export the part as a mesh of polygons");
}

TEST(Ply, TrustsNoCount) {
  for (const char* count : {"9000000000000000000", "4294967296", "1000"}) {
    EXPECT_TRUE(read_error("a.ply", ascii_header(count) + k_ply_square).starts_with("a.ply: byte ")) << count;
    EXPECT_TRUE(read_error("a.ply", ascii_header("4", count) + k_ply_square).starts_with("a.ply: byte "))
        << count;
  }
  EXPECT_TRUE(read_error("a.ply", ascii_header() + k_ply_square + "4000000000 0 1 2 3\n3 0 2 1\n")
                  .starts_with("a.ply: face 0 (line 15): the file ends inside a list of 4000000000 values"));
  EXPECT_TRUE(read_error("a.ply", ascii_header() + k_ply_square + "-1 0 1 2 3\n3 0 2 1\n")
                  .starts_with("a.ply: face 0 (line 15): a list has the length -1"));
}

TEST(Ply, WarnsOfDataBehindTheLastElement) {
  EXPECT_EQ(
      read_bytes("part.ply", ascii_header() + k_ply_square + "3 0 1 2\n3 0 2 3\n3 1 2 3\n").warnings.size(),
      1u);
  EXPECT_EQ(read_bytes("part.ply", binary_ply(true) + "x").warnings.size(), 1u);
}

}  // namespace
}  // namespace moldlight
