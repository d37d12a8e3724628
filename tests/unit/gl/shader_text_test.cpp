// Expansion of shader files and reading of driver logs, without a driver.
#include "gl/shader_text.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace moldlight::gl {
namespace {

constexpr ShaderFile k_text_files[] = {
    {"a.glsl", "#include \"b.glsl\"\nfloat a;\n"},
    {"b.glsl", "float b;"},
    {"cycle.vert", "#version 330 core\n#include \"cycle.glsl\"\nlast\n"},
    {"cycle.glsl", "#include \"cycle.vert\"\nfirst\n"},
    {"both.vert", "// Head.\n#version 330 core\n#include \"a.glsl\"\n#include \"b.glsl\"\nvoid main() {}\n"},
    {"lost.vert", "#version 330 core\n#include \"no_such.glsl\"\n"},
    {"bare.vert", "void main() {}\n"},
};

std::string failure(std::string_view path) {
  try {
    (void)expand_shader(path, {}, k_text_files);
  } catch (const Error& error) {
    return error.what();
  }
  return "no failure";
}

TEST(ShaderText, EachFileIsIncludedOnceWithItsLines) {
  const ShaderText shader = expand_shader("both.vert", {{"SIDE", "1"}}, k_text_files);
  EXPECT_EQ(shader.files, (std::vector<std::string>{"both.vert", "a.glsl", "b.glsl"}));
  EXPECT_EQ(shader.text, "// Head.\n#version 330 core\n#define SIDE 1\nfloat b;\nfloat a;\nvoid main() {}\n");
  std::string origins;
  for (const ShaderText::Origin& origin : shader.origins) {
    origins += shader.files[origin.file] + ":" + std::to_string(origin.line) + " ";
  }
  EXPECT_EQ(origins, "both.vert:1 both.vert:2 both.vert:2 b.glsl:1 a.glsl:2 both.vert:5 ");
}

TEST(ShaderText, ABrowsersHasItsOwnFirstLines) {
  const ShaderFile files[] = {{"a.frag", "#version 330 core\n#include \"b.glsl\"\nvoid main() {}\n"},
                              {"b.glsl", "uniform float u_b;\n"}};
  const std::string text = es_text(expand_shader("a.frag", {{"LIVE", ""}}, files));
  EXPECT_TRUE(text.starts_with("#version 300 es\nprecision highp float;\n")) << text;
  EXPECT_TRUE(text.ends_with("#define LIVE \nuniform float u_b;\nvoid main() {}\n")) << text;
}

TEST(ShaderText, CyclesEnd) {
  const ShaderText shader = expand_shader("cycle.vert", {}, k_text_files);
  EXPECT_NE(shader.text.find("first"), std::string::npos);
  EXPECT_NE(shader.text.find("last"), std::string::npos);
}

TEST(ShaderText, MissingFilesAndVersionsAreNamed) {
  EXPECT_EQ(failure("lost.vert"), "shaders/no_such.glsl: no such file, included from shaders/lost.vert");
  EXPECT_EQ(failure("absent.vert"), "shaders/absent.vert: no such file");
  EXPECT_EQ(failure("bare.vert"), "shaders/bare.vert: no #version line");
}

TEST(ShaderText, LogsOfSeveralDriversAreRead) {
  const ShaderText shader = {"", {"a.vert", "common/b.glsl"}, {{0, 1}, {1, 1}, {1, 2}, {0, 3}}};
  EXPECT_EQ(
      readable_log(shader, "0:1(5): warning: odd\n0:3(3): error: `x' undeclared\n0:4(3): error: more\n"),
      "shaders/common/b.glsl:2: error: `x' undeclared (and 1 more)");
  EXPECT_EQ(readable_log(shader, "0(4) : error C1008: undefined variable \"x\"\n"),
            "shaders/a.vert:3: error C1008: undefined variable \"x\"");
  EXPECT_EQ(readable_log(shader, "ERROR: 0:4: 'x' : undeclared identifier\n"),
            "shaders/a.vert:3: 'x' : undeclared identifier");
  EXPECT_EQ(readable_log(shader, "0:9(5): error: of no line\n"), "shaders/a.vert: 0:9(5): error: of no line");
  EXPECT_EQ(readable_log(shader, ""), "shaders/a.vert: the driver gives no reason");
}

}  // namespace
}  // namespace moldlight::gl
