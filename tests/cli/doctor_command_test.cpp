// moldlight doctor, and what becomes of a driver that draws wrongly: Mesa's softpipe leaves the maps empty.
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"

namespace moldlight {
namespace {

using test::run_moldlight;
using test::SmallPart;

test::ProcessSettings with_a_wrong_driver() {
  test::ProcessSettings settings;
  settings.environment = {"GALLIUM_DRIVER=softpipe", "LIBGL_ALWAYS_SOFTWARE=true"};
  return settings;
}

/// True where softpipe is not in use after all, or draws rightly.
bool driver_is_right() {
  return run_moldlight({"doctor"}, with_a_wrong_driver()).out.find("✗ softpipe") == std::string::npos;
}

TEST(Doctor, TellsOfEveryBackend) {
  const auto run = run_moldlight({"doctor"}, {});
  EXPECT_TRUE(run.out.starts_with("moldlight")) << run.out;
  for (const char* name : {"processor", "memory", "EGL", "OSMesa", "STEP", "font"})
    EXPECT_NE(run.out.find(std::string("\n") + name), std::string::npos) << name << "\n" << run.out;
  EXPECT_EQ(run.exit_code, run.out.find("draws a known part as computed") == std::string::npos ? 1 : 0)
      << run.out;
}

TEST(Doctor, ADriverThatDrawsWronglyIsNamed) {
  if (driver_is_right()) GTEST_SKIP() << "no driver here draws wrongly";
  const auto run = run_moldlight({"doctor"}, with_a_wrong_driver());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("softpipe draws shadow maps wrongly"), std::string::npos) << run.out;
  EXPECT_EQ(run.error_lines(), 1U) << run.err;
}

TEST(Doctor, ADriverThatDrawsWronglyIsNotUsed) {
  if (driver_is_right()) GTEST_SKIP() << "no driver here draws wrongly";
  const SmallPart part;
  const std::string image = part.output("a.png");
  for (const auto& arguments : {part.classify({"--readout", "samples"}), part.classify({"--image", image}),
                                part.sweep({"--engine", "gl"}),
                                std::vector<std::string>{"view", part.file(), "--screenshot", image}}) {
    const auto run = run_moldlight(arguments, with_a_wrong_driver());
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find("softpipe"), std::string::npos) << run.err;
    EXPECT_EQ(run.error_lines(), 1U) << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(image));
  // Exact regions need no driver.
  const auto run = run_moldlight(part.classify({"--json", "-"}), with_a_wrong_driver());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.find("softpipe"), std::string::npos);
}

}  // namespace
}  // namespace moldlight
