// Every backend that exists here gives a context that works, beside the others and from thread to thread;
// what does not exist is explained.
#include <array>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

#include "backends.hpp"
#include "base/error.hpp"
#include "gl/headless_context.hpp"
#include "gl/objects.hpp"

namespace moldlight::gl {
namespace {

using Texel = std::array<unsigned char, 4>;

Texel cleared_texel(const Functions& gl, float red) {
  const Texture colour = make_texture_2d(gl, GL_RGBA8, 4, 3);
  const GLuint names[] = {colour.name()};
  const Framebuffer framebuffer = make_framebuffer(gl, {names, 0});
  const float value[] = {red, 0.0f, 1.0f, 1.0f};
  gl.ClearBufferfv(GL_COLOR, 0, value);
  Texel texel = {};
  gl.ReadPixels(3, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  check_errors(gl, "clearing");
  return texel;
}

std::string failure(HeadlessBackend backend, const HeadlessLibraries& libraries) {
  try {
    (void)create_headless_context(backend, libraries);
  } catch (const Error& error) {
    return error.what();
  }
  return "no failure";
}

TEST(HeadlessContext, EveryBackendClearsAndReadsBack) {
  const auto contexts = available_contexts();
  ASSERT_FALSE(contexts.empty());
  for (const auto& context : contexts) {
    std::cout << context->backend() << ": " << context->renderer() << '\n';
    context->make_current();
    EXPECT_FALSE(context->renderer().empty());
    GLint major = 0, minor = 0, profile = 0;
    context->functions().GetIntegerv(GL_MAJOR_VERSION, &major);
    context->functions().GetIntegerv(GL_MINOR_VERSION, &minor);
    context->functions().GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(major * 10 + minor, 33) << context->backend();
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT) << context->backend();
    EXPECT_EQ(cleared_texel(context->functions(), 0.0f), (Texel{0, 0, 255, 255})) << context->backend();
    EXPECT_EQ(cleared_texel(context->functions(), 1.0f), (Texel{255, 0, 255, 255})) << context->backend();
  }
}

TEST(HeadlessContext, AutomaticTakesTheFirstThatWorks) {
  const auto contexts = available_contexts();
  ASSERT_FALSE(contexts.empty());
  EXPECT_EQ(create_headless_context(HeadlessBackend::automatic)->backend(), contexts.front()->backend());
}

TEST(HeadlessContext, ContextsOfAllBackendsTakeTurnsOnOneThread) {
  const auto contexts = available_contexts();
  // A second round meets contexts that were current before: each must be itself again.
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      contexts[i]->make_current();
      const float red = i % 2 == 0 ? 1.0f : 0.0f;
      EXPECT_EQ(cleared_texel(contexts[i]->functions(), red)[0], i % 2 == 0 ? 255 : 0);
      EXPECT_EQ(reinterpret_cast<const char*>(contexts[i]->functions().GetString(GL_RENDERER)),
                contexts[i]->renderer());
    }
  }
}

TEST(HeadlessContext, ObjectsOutliveTheTurnsOfOthers) {
  const auto contexts = available_contexts();
  ASSERT_FALSE(contexts.empty());
  contexts.front()->make_current();
  const Functions& gl = contexts.front()->functions();
  const Texture colour = make_texture_2d(gl, GL_RGBA8, 1, 1);
  const GLuint names[] = {colour.name()};
  const Framebuffer framebuffer = make_framebuffer(gl, {names, 0});
  const float green[] = {0.0f, 1.0f, 0.0f, 1.0f};
  gl.ClearBufferfv(GL_COLOR, 0, green);
  for (const auto& other : contexts) {
    other->make_current();
    if (other != contexts.front()) cleared_texel(other->functions(), 1.0f);
  }
  contexts.front()->make_current();
  Texel texel = {};
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  EXPECT_EQ(texel, (Texel{0, 255, 0, 255}));
}

TEST(HeadlessContext, MovesToAnotherThreadAndBack) {
  for (const auto& context : available_contexts()) {
    context->make_current();
    const Texture colour = make_texture_2d(context->functions(), GL_RGBA8, 1, 1);
    const GLuint names[] = {colour.name()};
    const Framebuffer framebuffer = make_framebuffer(context->functions(), {names, 0});
    context->release_current();
    std::thread([&context] {
      context->make_current();
      const float yellow[] = {1.0f, 1.0f, 0.0f, 1.0f};
      context->functions().ClearBufferfv(GL_COLOR, 0, yellow);
      context->release_current();
    }).join();
    context->make_current();
    Texel texel = {};
    context->functions().ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
    EXPECT_EQ(texel, (Texel{255, 255, 0, 255})) << context->backend();
  }
}

TEST(HeadlessContext, IsCurrentOnOneThreadAtMost) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto context = create_headless_context(HeadlessBackend::automatic);
  EXPECT_DEATH(std::thread([&context] { context->make_current(); }).join(), "internal error");
}

TEST(HeadlessContext, OneContextPerThreadWorksAtOnce) {
  for (const HeadlessBackend backend : {HeadlessBackend::egl, HeadlessBackend::osmesa}) {
    std::array<Texel, 4> texels = {};
    std::vector<std::thread> threads;
    try {
      (void)create_headless_context(backend);
    } catch (const Error& error) {
      std::cout << "left out: " << error.what() << '\n';
      continue;
    }
    for (std::size_t i = 0; i < texels.size(); ++i) {
      threads.emplace_back([&texels, i, backend] {
        const auto context = create_headless_context(backend);
        for (int repeat = 0; repeat < 5; ++repeat) {
          texels[i] = cleared_texel(context->functions(), i % 2 == 0 ? 1.0f : 0.0f);
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < texels.size(); ++i) EXPECT_EQ(texels[i][0], i % 2 == 0 ? 255 : 0);
  }
}

TEST(HeadlessContext, FailureListsEveryAttempt) {
  const HeadlessLibraries none = {{"libno_such_egl.so.1"},
                                  {"libno_such_osmesa.so.8", "libno_such_osmesa.so.6"}};
  const std::string automatic = failure(HeadlessBackend::automatic, none);
  for (const char* part : {"EGL device: ", "EGL surfaceless: ", "OSMesa: ", "libno_such_egl.so.1",
                           "libno_such_osmesa.so.8", "libno_such_osmesa.so.6", "; install "}) {
    EXPECT_NE(automatic.find(part), std::string::npos) << part << " in: " << automatic;
  }
  EXPECT_EQ(automatic.find('\n'), std::string::npos);

  const std::string egl = failure(HeadlessBackend::egl, none);
  EXPECT_NE(egl.find("EGL surfaceless: "), std::string::npos) << egl;
  EXPECT_EQ(egl.find("OSMesa"), std::string::npos) << egl;

  const std::string osmesa = failure(HeadlessBackend::osmesa, none);
  EXPECT_EQ(osmesa.find("EGL"), std::string::npos) << osmesa;
  EXPECT_NE(osmesa.find("install libosmesa6"), std::string::npos) << osmesa;
}

TEST(HeadlessContext, ALibraryThatIsNoGlLibraryIsExplained) {
  const std::string text = failure(HeadlessBackend::automatic, {{"libm.so.6"}, {"libm.so.6"}});
  EXPECT_NE(text.find("libm.so.6 has no eglGetProcAddress"), std::string::npos) << text;
  EXPECT_NE(text.find("libm.so.6 has no OSMesaCreateContextAttribs"), std::string::npos) << text;
}

TEST(HeadlessContext, AutomaticDoesWithoutEgl) {
  try {
    (void)create_osmesa_context(HeadlessLibraries().osmesa);
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  HeadlessLibraries libraries;
  libraries.egl = {"libno_such_egl.so.1"};
  EXPECT_EQ(create_headless_context(HeadlessBackend::automatic, libraries)->backend(), "OSMesa");
}

TEST(FunctionsTest, MissingEntryIsNamed) {
  const auto lacks_viewport = [](const char* name) -> void* {
    static int anything = 0;
    return std::string_view(name) == "glViewport" ? nullptr : &anything;
  };
  try {
    (void)Functions::load(lacks_viewport);
    FAIL() << "an entry is missing";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("glViewport"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace moldlight::gl
