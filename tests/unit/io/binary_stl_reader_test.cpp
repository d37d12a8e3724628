#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;

/// Facet k has the corners (k, 0, 0), (k + 1, 0, 0), (k, 0.1f, 0).
std::string stl_bytes(std::uint32_t facets, std::uint32_t declared,
                      const std::string& header = "made by a test") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes.append(reinterpret_cast<const char*>(&declared), 4);
  for (std::uint32_t k = 0; k < facets; ++k) {
    const auto x = static_cast<float>(k);
    const float numbers[12] = {0, 0, 1, x, 0, 0, x + 1, 0, 0, x, 0.1f, 0};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(BinaryStl, KeepsFacetsInOrderAndFloatsExactly) {
  const Part part = read_bytes("part.stl", stl_bytes(40, 40));
  EXPECT_EQ(part.format, "STL binary");
  ASSERT_EQ(part.mesh.facets.size(), 40u);
  for (FacetIndex k = 0; k < 40; ++k) {
    EXPECT_EQ(part.mesh.corner(k, 0), glm::dvec3(k, 0, 0));
    EXPECT_EQ(part.mesh.corner(k, 2), glm::dvec3(k, static_cast<double>(0.1f), 0));
  }
  EXPECT_EQ(part.mesh.vertices.size(), 81u);
  ASSERT_EQ(part.bodies.size(), 1u);
  EXPECT_EQ(part.bodies[0].facet_count, 40u);
  EXPECT_TRUE(part.facet_source.empty());
}

TEST(BinaryStl, IsToldByItsSizeNotByItsHeaderOrName) {
  for (const char* header : {"solid part", "SOLID", "ply\n", "OFF\n", "PK\x03\x04", "# v f", "\xfe\xff"}) {
    EXPECT_EQ(read_bytes("part.stl", stl_bytes(3, 3, header)).format, "STL binary") << header;
  }
  EXPECT_EQ(read_bytes("part.obj", stl_bytes(3, 3)).format, "STL binary");
  EXPECT_EQ(read_bytes("part", stl_bytes(3, 3)).format, "STL binary");
}

TEST(BinaryStl, RefusesCountsThatLie) {
  EXPECT_EQ(read_error("a.stl", stl_bytes(3, 0xffffffff)),
            "a.stl: byte 80: the header declares 4294967295 facets, but the file's size is that of 3; export "
            "the part again");
  EXPECT_EQ(read_error("a.stl", stl_bytes(3, 1)),
            "a.stl: byte 80: the header declares 1 facets, but the file's size is that of 3; export the part "
            "again");
  EXPECT_EQ(read_error("a.stl", stl_bytes(3, 5).substr(0, 84 + 2 * 50 + 17)),
            "a.stl: facet 2: the file ends inside this facet, 5 are declared; export the part again");
  EXPECT_EQ(read_error("a.stl", stl_bytes(3, 3) + "extra"),
            "a.stl: byte 234: 5 bytes follow the 3 facets that the header declares; export the part again");
  EXPECT_EQ(read_error("a.stl", stl_bytes(0, 0)), "a.stl: byte 80: holds no facets; export the part again");
  EXPECT_EQ(read_error("a.stl", std::string("\0\1\2", 3)),
            "a.stl: byte 3: ends inside the 84 bytes of the binary STL header; export the part again");
}

TEST(BinaryStl, RefusesCoordinatesThatAreNoNumbers) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e30f, -2e30f}) {
    std::string bytes = stl_bytes(9, 9);
    std::memcpy(bytes.data() + 84 + 7 * 50 + 12 + 4 * 8, &bad, 4);
    EXPECT_TRUE(read_error("a.stl", bytes).starts_with("a.stl: facet 7: a coordinate is ")) << bad;
  }
}

TEST(BinaryStl, LooksAtNoNormal) {
  std::string bytes = stl_bytes(2, 2);
  const float nan = std::nanf("");
  std::memcpy(bytes.data() + 84, &nan, 4);
  EXPECT_EQ(read_bytes("part.stl", bytes).mesh.facets.size(), 2u);
}

TEST(BinaryStl, StopsAtTheFacetLimit) {
  EXPECT_EQ(read_error("a.stl", stl_bytes(3, 3), {.max_facets = 2}),
            "a.stl: holds more facets than the limit of 2; raise the limit (--max-facets) if they are meant");
}

}  // namespace
}  // namespace moldlight
