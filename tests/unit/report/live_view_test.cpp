// What a live page unpacks is the part to the bit, and its shaders are the program's own.
#include "report/live_view.hpp"

#include <bit>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "gl/shader_text.hpp"
#include "packed_reader.hpp"
#include "support/shapes.hpp"

namespace moldlight::report {
namespace {

LiveView live_of(const TriangleMesh& mesh) {
  LiveView live;
  live.mesh = mesh;
  live.known = {{"+z", {0, 0, 1}, {}}};
  live.errors = {{512, 0.01, 0.005}, {2048, 0.001, 0.001}};
  return live;
}

/// The coordinates are planes of bytes.
template <typename Bits>
std::vector<double> coordinates(PackedReader& reader, std::size_t count) {
  std::vector<Bits> bits(count, 0);
  for (std::size_t byte = 0; byte < sizeof(Bits); ++byte)
    for (Bits& number : bits) number |= static_cast<Bits>(static_cast<Bits>(reader.byte()) << (8 * byte));
  std::vector<double> values;
  for (const Bits number : bits) {
    if constexpr (sizeof(Bits) == 4) {
      values.push_back(static_cast<double>(std::bit_cast<float>(number)));
    } else {
      values.push_back(std::bit_cast<double>(number));
    }
  }
  return values;
}

void expect_same(const TriangleMesh& mesh, std::size_t bytes) {
  const Json packed = report::packed(live_of(mesh));
  PackedReader reader(packed);
  ASSERT_EQ(packed["bytes"], bytes);
  const std::size_t count = 3 * packed["corners"].get<std::size_t>();
  const std::vector<double> values =
      bytes == 4 ? coordinates<std::uint32_t>(reader, count) : coordinates<std::uint64_t>(reader, count);
  std::uint32_t next = 0;
  for (const auto& facet : mesh.facets) {
    for (const VertexIndex corner : facet) {
      const std::uint32_t back = reader.number();
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(values.at(3 * (next - back) + static_cast<std::size_t>(axis))),
                  std::bit_cast<std::uint64_t>(mesh.vertices[corner][axis]));
      if (back == 0) ++next;
    }
  }
  EXPECT_TRUE(reader.at_end());
}

TEST(LiveView, KeepsCoordinatesToTheBit) {
  TriangleMesh mesh = test::refined(test::cup_with_side_hole(test::ShapeSettings{}), 500).mesh;
  for (glm::dvec3& vertex : mesh.vertices) vertex = glm::dvec3(glm::vec3(vertex));
  expect_same(mesh, 4);
  mesh.vertices.front().x = std::nextafter(mesh.vertices.front().x, 1e9);
  expect_same(mesh, 8);
}

TEST(LiveView, ItsShadersAreThePrograms) {
  const Json shaders = page_shaders(true);
  for (const auto& [name, stages] : shaders.items()) {
    for (const Json& stage : stages) {
      const auto text = stage.get<std::string>();
      EXPECT_TRUE(text.starts_with("#version 300 es\n")) << name;
      EXPECT_EQ(text.find("#version 330"), std::string::npos) << name;
      EXPECT_EQ(text.find("#include"), std::string::npos) << name;
    }
  }
  const std::string looked_up =
      gl::expand_shader("measure/samples.frag", {{"WITH_DOUBT", ""}}, gl::shader_files()).text;
  EXPECT_TRUE(shaders["samples"][1].get<std::string>().ends_with(looked_up.substr(looked_up.find('\n') + 1)));
  EXPECT_FALSE(page_shaders(false).contains("samples"));
}

TEST(LiveView, ControlsStartAtTheSettings) {
  LiveView live = live_of(test::cup(test::ShapeSettings{}).mesh);
  live.method.tau_deg = 2.5;
  live.method.resolution = 512;
  const std::string html = live_controls_html(live);
  EXPECT_NE(html.find("id=\"tau\" type=\"range\" min=\"0\" max=\"10\" step=\"0.1\" value=\"2.5\""),
            std::string::npos);
  EXPECT_NE(html.find("<option selected>512</option>"), std::string::npos);
  EXPECT_EQ(html.find("class=\"card\""), std::string::npos) << "nothing is listed";
  live.known.front().verdict = "<b>";
  EXPECT_NE(live_controls_html(live).find("&lt;b&gt;"), std::string::npos);
}

}  // namespace
}  // namespace moldlight::report
