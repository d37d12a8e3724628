#include "fuzz/seed_files.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "support/zip_bytes.hpp"

namespace moldlight::fuzz {

namespace {

template <typename T>
void put(std::string& bytes, T value, bool big_endian = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (big_endian) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

/// Corners and triangles of a tetrahedron.
constexpr double k_points[4][3] = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
constexpr int k_triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

std::string binary_stl(const std::string& header) {
  std::string bytes = header;
  bytes.resize(80, '\0');
  put(bytes, std::uint32_t{4});
  for (const auto& triangle : k_triangles) {
    for (int i = 0; i < 3; ++i) put(bytes, 0.0f);
    for (const int corner : triangle) {
      for (const double value : k_points[corner]) put(bytes, static_cast<float>(value));
    }
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string ascii_solid(const std::string& name, const std::string& line_end) {
  std::string text = "solid " + name + line_end;
  for (const auto& triangle : k_triangles) {
    text += "facet normal 0 0 0" + line_end + "outer loop" + line_end;
    for (const int corner : triangle) {
      text += "vertex";
      for (const double value : k_points[corner]) text += " " + std::to_string(value);
      text += line_end;
    }
    text += "endloop" + line_end + "endfacet" + line_end;
  }
  return text + "endsolid " + name + line_end;
}

std::string upper_case(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

std::string ascii_ply() {
  return "ply\nformat ascii 1.0\ncomment seed\nelement vertex 4\nproperty double x\nproperty float "
         "y\nproperty int z\n"
         "property uchar red\nelement face 2\nproperty list uchar uint vertex_indices\nproperty float "
         "quality\nend_header\n"
         "0 0 0 255\n10 0 0 0\n10 10 0 1\n0 10 0 2\n4 0 1 2 3 0.5\n3 0 2 1 1e-3\n";
}

std::string binary_ply(bool big_endian) {
  std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                      "property list uchar short tags\nelement face 4\nproperty list uchar int vertex_index\n"
                      "property uchar red\nend_header\n";
  for (const auto& point : k_points) {
    for (const double value : point) put(bytes, static_cast<float>(value), big_endian);
    put(bytes, std::uint8_t{1});
    put(bytes, std::int16_t{-7}, big_endian);
  }
  for (const auto& triangle : k_triangles) {
    put(bytes, std::uint8_t{3});
    for (const int corner : triangle) put(bytes, std::int32_t{corner}, big_endian);
    put(bytes, std::uint8_t{200});
  }
  return bytes;
}

std::string obj_text() {
  return "# seed\nmtllib none.mtl\no first\nv 0 0 0\nv 10. 0 0\nv 10 1e1 0 1.0\nv 0 10 .0 0.5 0.5 0.5\nv 3 3 "
         "0\nvt 0 0\n"
         "vn 0 0 1\nusemtl steel\ns off\nf 1/1/1 2/1/1 3/1/1 4//1\ng second\nf -5 -4 -1\nf 1 2 \\\n 5 3\nf 4 "
         "5 1 2 3\n";
}

std::string model_text(const std::string& inner, const std::string& build) {
  return R"(<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" )"
         R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )"
         R"(xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" requiredextensions="p"><resources>)" +
         inner + "</resources><build>" + build + "</build></model>";
}

std::string mesh_object(const std::string& attributes) {
  std::string text = "<object " + attributes + "><mesh><vertices>";
  for (const auto& [x, y, z] : k_points) {
    text += "<vertex x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" z=\"" +
            std::to_string(z) + "\"/>";
  }
  text += "</vertices><triangles>";
  for (const auto& [a, b, c] : k_triangles) {
    text += "<triangle v1=\"" + std::to_string(a) + "\" v2=\"" + std::to_string(b) + "\" v3=\"" +
            std::to_string(c) + "\"/>";
  }
  return text + "</triangles></mesh></object>";
}

}  // namespace

std::vector<SeedFile> threemf_model_seeds() {
  const std::string leaf = mesh_object(R"(id="1" name="leaf" type="model")");
  const std::string twice =
      R"(<object id="2"><components><component objectid="1"/>)"
      R"(<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/></components></object>)";
  const std::string support = mesh_object(R"(id="7" type="support")");
  return {
      {"one_item.3mf", model_text(leaf, R"(<item objectid="1" transform="1 0 0 0 1 0 0 0 1 5 6 7"/>)"), true},
      {"components.3mf",
       model_text(leaf + twice, R"(<item objectid="2"/><item objectid="1" p:path="/3D/part.model"/>)"), true},
      {"support.3mf", model_text(leaf + support, R"(<item objectid="7"/><item objectid="1"/>)"), true},
      {"no_items.3mf", model_text(leaf, ""), true},
  };
}

std::vector<SeedFile> seed_files() {
  std::vector<SeedFile> seeds = {
      {"plain.stl", binary_stl("seed")},
      {"solid_header.stl", binary_stl("solid seed")},
      {"ascii.stl", ascii_solid("seed", "\n")},
      {"crlf_two_solids.stl", ascii_solid("a", "\r\n") + ascii_solid("b c", "\r\n")},
      {"one_line.stl", ascii_solid("seed", " ")},
      {"upper.stl", upper_case(ascii_solid("seed", "\n"))},
      {"seed.obj", obj_text()},
      {"ascii.ply", ascii_ply()},
      {"little.ply", binary_ply(false)},
      {"big.ply", binary_ply(true)},
      {"plain.off", "OFF\n4 2 0\n0 0 0\n10 0 0\n10 10 0\n0 10 0\n4 0 1 2 3\n3 0 2 1\n"},
      {"colours.off",
       "COFF # seed\n4 2 0\n0 0 0 1 0 0 1\n10 0 0 0 1 0 1\n10 10 0 0 0 1 1\n0 10 0 1 1 1 1\n4 0 1 2 3 255 0 "
       "0\n3 0 2 1\n"},
  };
  for (const SeedFile& model : threemf_model_seeds())
    seeds.push_back({model.name, test::threemf_bytes(model.bytes)});
  return seeds;
}

}  // namespace moldlight::fuzz
