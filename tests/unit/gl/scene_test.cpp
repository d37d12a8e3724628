// One small scene with everything the renderer relies on, drawn by every backend: shading, 32-bit float
// depth, integer and float colours and a buffer texture. Software renderers must agree to the bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "backends.hpp"
#include "gl/program.hpp"

namespace moldlight::gl {
namespace {

constexpr int k_size = 96;
constexpr int k_triangles = 40;

constexpr ShaderFile k_scene_files[] = {
    {"common/palette.glsl",
     "uniform samplerBuffer u_palette;\n"
     "vec3 palette(int i) { return texelFetch(u_palette, i % 3).rgb; }\n"},
    {"fan.vert", R"(#version 330 core
uniform mat4 u_clip_from_world;
uniform float u_turn[2];
out vec3 v_position;
flat out uint v_id;
void main() {
  int triangle = gl_VertexID / 3;
  float angle = float(triangle) * u_turn[0] + float(gl_VertexID % 3) * u_turn[1];
  v_position = vec3(cos(angle), sin(angle), 0.02 * float(triangle) - 0.4 * sin(3.0 * angle));
  v_id = uint(triangle + 1);
  gl_Position = u_clip_from_world * vec4(v_position, 1.0);
})"},
    {"fan.frag", R"(#version 330 core
#include "common/palette.glsl"
in vec3 v_position;
flat in uint v_id;
layout(location = 0) out vec4 o_colour;
layout(location = 1) out uint o_id;
layout(location = 2) out vec4 o_position;
void main() {
  vec3 normal = normalize(cross(dFdx(v_position), dFdy(v_position)));
  o_colour = vec4(palette(int(v_id)) * (0.3 + 0.7 * abs(normal.z)) + GLOW, 1.0);
  o_id = v_id;
  o_position = vec4(v_position, 1.0);
})"}};

struct Picture {
  std::vector<std::uint32_t> colour, ids;
  std::vector<float> depth;
  std::vector<std::array<float, 4>> positions;
};

template <typename T>
std::vector<T> read(const Functions& gl, GLenum attachment, GLenum format, GLenum type) {
  std::vector<T> texels(k_size * k_size);
  if (attachment != GL_NONE) gl.ReadBuffer(attachment);
  gl.ReadPixels(0, 0, k_size, k_size, format, type, texels.data());
  return texels;
}

Picture draw(const Functions& gl) {
  const Texture colour = make_texture_2d(gl, GL_RGBA8, k_size, k_size);
  const Texture ids = make_texture_2d(gl, GL_R32UI, k_size, k_size);
  const Texture depth = make_texture_2d(gl, GL_DEPTH_COMPONENT32F, k_size, k_size);
  const Texture positions = make_texture_2d(gl, GL_RGBA32F, k_size, k_size);
  const GLuint colours[] = {colour.name(), ids.name(), positions.name()};
  const Framebuffer framebuffer = make_framebuffer(gl, {colours, depth.name()});
  const std::array<float, 12> palette = {0.9f, 0.3f, 0.1f, 1.0f, 0.2f, 0.6f,
                                         0.4f, 1.0f, 0.1f, 0.4f, 0.8f, 1.0f};
  const Buffer palette_buffer = make_buffer(gl, GL_TEXTURE_BUFFER, std::span<const float>(palette));
  const Texture palette_texture = make_buffer_texture(gl, GL_RGBA32F, palette_buffer);
  const VertexArray vertices = make_vertex_array(gl);

  const Program program(gl, {.vertex = "fan.vert", .fragment = "fan.frag", .defines = {{"GLOW", "0.05"}}},
                        k_scene_files);
  program.use();
  program.set("u_clip_from_world", glm::rotate(glm::mat4(0.8f), 0.7f, glm::vec3(0.5f, 1.0f, 0.2f)));
  program.set("u_turn[0]", 0.37f);
  program.set("u_turn[1]", 1.9f);
  program.set_texture("u_palette", 2, GL_TEXTURE_BUFFER, palette_texture);

  gl.Viewport(0, 0, k_size, k_size);
  gl.Enable(GL_DEPTH_TEST);
  const float black[] = {0.0f, 0.0f, 0.0f, 1.0f};
  const GLuint no_id[] = {0, 0, 0, 0};
  const float far = 1.0f;
  gl.ClearBufferfv(GL_COLOR, 0, black);
  gl.ClearBufferuiv(GL_COLOR, 1, no_id);
  gl.ClearBufferfv(GL_COLOR, 2, black);
  gl.ClearBufferfv(GL_DEPTH, 0, &far);
  gl.BindVertexArray(vertices.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3 * k_triangles);

  Picture picture;
  picture.colour = read<std::uint32_t>(gl, GL_COLOR_ATTACHMENT0, GL_RGBA, GL_UNSIGNED_BYTE);
  picture.ids = read<std::uint32_t>(gl, GL_COLOR_ATTACHMENT1, GL_RED_INTEGER, GL_UNSIGNED_INT);
  picture.depth = read<float>(gl, GL_NONE, GL_DEPTH_COMPONENT, GL_FLOAT);
  picture.positions = read<std::array<float, 4>>(gl, GL_COLOR_ATTACHMENT2, GL_RGBA, GL_FLOAT);
  check_errors(gl, "drawing the scene");
  return picture;
}

std::size_t different(const auto& one, const auto& other) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    count += std::memcmp(&one[i], &other[i], sizeof(one[i])) != 0 ? 1 : 0;
  return count;
}

TEST(Scene, IsDrawnAsAsked) {
  const auto context = create_headless_context(HeadlessBackend::automatic);
  const Picture picture = draw(context->functions());
  std::size_t covered = 0;
  std::vector<bool> seen(k_triangles + 1);
  for (std::size_t i = 0; i < picture.ids.size(); ++i) {
    ASSERT_LE(picture.ids[i], static_cast<std::uint32_t>(k_triangles));
    seen[picture.ids[i]] = true;
    const bool drawn = picture.ids[i] != 0;
    covered += drawn ? 1 : 0;
    EXPECT_EQ(picture.depth[i] < 1.0f, drawn);
    EXPECT_EQ(picture.colour[i] != 0xff000000u, drawn);
    // The corners lie on a circle of radius one.
    const auto& [x, y, z, w] = picture.positions[i];
    EXPECT_LE(std::hypot(x, y), 1.0f + 1e-5f);
    EXPECT_EQ(x != 0.0f && y != 0.0f, drawn);
  }
  EXPECT_GT(covered, picture.ids.size() / 5);
  EXPECT_GT(std::count(seen.begin(), seen.end(), true), 10);
}

TEST(Scene, SoftwareBackendsAgreeToTheBit) {
  std::vector<std::pair<std::string, Picture>> pictures;
  for (const auto& context : available_contexts()) {
    if (context->renderer().find("llvmpipe") == std::string::npos) {
      std::cout << "left out: " << context->backend() << " draws with " << context->renderer() << '\n';
      continue;
    }
    context->make_current();
    pictures.emplace_back(context->backend(), draw(context->functions()));
  }
  if (pictures.size() < 2) GTEST_SKIP() << "fewer than two software backends here";
  for (std::size_t i = 1; i < pictures.size(); ++i) {
    const auto& [name, picture] = pictures[i];
    EXPECT_EQ(different(picture.colour, pictures[0].second.colour), 0u) << name;
    EXPECT_EQ(different(picture.ids, pictures[0].second.ids), 0u) << name;
    EXPECT_EQ(different(picture.depth, pictures[0].second.depth), 0u) << name;
    EXPECT_EQ(different(picture.positions, pictures[0].second.positions), 0u) << name;
  }
}

}  // namespace
}  // namespace moldlight::gl
