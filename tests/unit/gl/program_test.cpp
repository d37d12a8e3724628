// Programs: what goes wrong is named with file and line, and no uniform is set into the void.
#include "gl/program.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "gl/headless_context.hpp"
#include "gl/pass.hpp"

namespace moldlight::gl {
namespace {

constexpr ShaderFile k_files[] = {
    {"common/good.glsl", "uniform float u_shift;\nfloat shifted(float x) { return x + u_shift; }\n"},
    {"common/bad.glsl", "float one() { return 1.0; }\nfloat two() { return no_such_name; }\n"},
    {"good.vert",
     "#version 330 core\n#include \"common/good.glsl\"\nuniform vec3 u_offsets[3];\nuniform int "
     "u_which;\nout float v_which;\n"
     "void main() { v_which = 1.0; gl_Position = vec4(u_offsets[u_which], shifted(1.0)); }\n"},
    {"bad.vert", "#version 330 core\n// A comment.\nvoid main() {\n  gl_Position = missing;\n}\n"},
    {"bad_after_include.vert",
     "#version 330 core\n#include \"common/good.glsl\"\nvoid main() { gl_Position = missing; }\n"},
    {"bad_include.vert",
     "#version 330 core\n#include \"common/bad.glsl\"\nvoid main() { gl_Position = vec4(two()); }\n"},
    {"good.frag", "#version 330 core\nout vec4 o_colour;\nvoid main() { o_colour = vec4(1.0); }\n"},
    {"wants_input.frag",
     "#version 330 core\nin vec2 v_which;\nout vec4 o_colour;\n"
     "void main() { o_colour = vec4(v_which, 0.0, 1.0); }\n"},
};

class ProgramTest : public ::testing::Test {
 protected:
  const Functions& gl() const { return context_->functions(); }
  std::string failure(const ProgramSources& sources) const {
    try {
      const Program program(gl(), sources, k_files);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "no failure";
  }

 private:
  std::unique_ptr<Context> context_ = create_headless_context(HeadlessBackend::automatic);
};

TEST_F(ProgramTest, CompileErrorNamesFileAndLine) {
  EXPECT_EQ(failure({.vertex = "bad.vert"}).find("shaders/bad.vert:4: "), 0u)
      << failure({.vertex = "bad.vert"});
  const std::string with_defines =
      failure({.vertex = "bad.vert", .defines = {{"ONE", "1"}, {"TWO", "2"}, {"THREE", "3"}}});
  EXPECT_EQ(with_defines.find("shaders/bad.vert:4: "), 0u) << with_defines;
  EXPECT_NE(with_defines.find("missing"), std::string::npos) << with_defines;
}

TEST_F(ProgramTest, CompileErrorAroundIncludesNamesTheRightFile) {
  const std::string inside = failure({.vertex = "bad_include.vert"});
  EXPECT_EQ(inside.find("shaders/common/bad.glsl:2: "), 0u) << inside;
  const std::string after = failure({.vertex = "bad_after_include.vert"});
  EXPECT_EQ(after.find("shaders/bad_after_include.vert:3: "), 0u) << after;
}

TEST_F(ProgramTest, LinkErrorNamesTheFiles) {
  const std::string text = failure({.vertex = "good.vert", .fragment = "wants_input.frag"});
  EXPECT_EQ(text.find("shaders/good.vert + wants_input.frag: "), 0u) << text;
  EXPECT_NE(text.find("v_which"), std::string::npos) << text;
}

TEST_F(ProgramTest, KnowsItsUniforms) {
  const Program program(gl(), {.vertex = "good.vert", .fragment = "good.frag"}, k_files);
  for (const char* name : {"u_shift", "u_which", "u_offsets", "u_offsets[0]", "u_offsets[2]"}) {
    EXPECT_TRUE(program.has(name)) << name;
  }
  EXPECT_FALSE(program.has("u_offsets[3]"));
  EXPECT_FALSE(program.has("u_absent"));
  EXPECT_FALSE(program.has("gl_Position"));
  program.use();
  program.set("u_offsets[2]", glm::vec3(1.0f));
  program.set("u_which", 2);
  EXPECT_NO_THROW(check_errors(gl(), "setting uniforms"));
}

TEST_F(ProgramTest, UnknownUniformEndsTheProgram) {
  const Program program(gl(), {.vertex = "good.vert", .fragment = "good.frag"}, k_files);
  program.use();
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(program.set("u_absent", 1.0f), "u_absent.*good.vert");
}

TEST_F(ProgramTest, AValueOfTheWrongTypeIsReported) {
  const Program program(gl(), {.vertex = "good.vert", .fragment = "good.frag"}, k_files);
  program.use();
  program.set("u_shift", 1);
  EXPECT_THROW(check_errors(gl(), "setting uniforms"), Error);
  EXPECT_NO_THROW(check_errors(gl(), "after the report"));
}

TEST_F(ProgramTest, EmbeddedFilesCompile) {
  const Program program(gl(), {.vertex = "common/fullscreen.vert"});
  EXPECT_FALSE(program.has("u_absent"));
}

TEST_F(ProgramTest, NoneThatIsInUseIsDeleted) {
  GLint used = 0;
  {
    Programs programs(gl());
    programs.use("common/at_infinity.vert", {});
    gl().GetIntegerv(GL_CURRENT_PROGRAM, &used);
    EXPECT_NE(used, 0);
  }
  gl().GetIntegerv(GL_CURRENT_PROGRAM, &used);
  EXPECT_EQ(used, 0);
}

TEST_F(ProgramTest, AreSharedByAllToolsOfAContext) {
  const Tools first(gl());
  const Program& own = first.programs.use("common/at_infinity.vert", {});
  {
    const Tools second(gl());
    EXPECT_EQ(&second.programs.use("common/at_infinity.vert", {}), &own);
    EXPECT_EQ(second.programs.count(), 1U);
  }
  EXPECT_EQ(&first.programs.use("common/at_infinity.vert", {}), &own) << "they stay with the last tools";
  EXPECT_EQ(gl().programs.lock().get(), &first.programs);
}

TEST_F(ProgramTest, TexturesBeyondTheDriverAreRefused) {
  EXPECT_THROW((void)make_texture_2d(gl(), GL_RGBA8, 1 << 20, 16), Error);
  EXPECT_THROW((void)make_texture_2d(gl(), GL_RGBA8, 16, 0), Error);
}

TEST_F(ProgramTest, IncompleteFramebufferIsRefused) {
  const Texture small = make_texture_2d(gl(), GL_DEPTH_COMPONENT32F, 8, 8);
  const GLuint colours[] = {small.name()};
  EXPECT_THROW((void)make_framebuffer(gl(), {colours, 0}), Error);
}

}  // namespace
}  // namespace moldlight::gl
