// Ctrl-C in the midst of the work.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "cli/small_part.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, EndsWith130AndLeavesNothingHalfWritten) {
  const test::SmallPart part;
  const std::string kept = part.folder().write("kept.csv", "old");
  const std::vector<std::string> arguments = {MOLDLIGHT_BINARY, "classify",
                                              part.file(),      "--direction",
                                              "0,0,1",          "--readout",
                                              "samples",        "--samples",
                                              "10000000",       "--verbose",
                                              "--facets",       kept,
                                              "--json",         part.output("a.json"),
                                              "--split-dir",    part.output("pieces"),
                                              "--borders",      part.output("a.obj")};
  test::Process process(arguments, {});
  ASSERT_TRUE(process.wait_for_error_text("drawing the maps"));
  process.send_signal(GetParam());
  const auto result = process.finish();
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.ends_with("moldlight: interrupted\n")) << result.err;
  EXPECT_EQ(test::file_bytes(kept), "old");
  EXPECT_FALSE(fs::exists(part.output("a.json")));
  EXPECT_FALSE(fs::exists(part.output("pieces")));
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(part.folder().path())) ++entries;
  EXPECT_EQ(entries, 3u) << "part, its material file, and the old table";
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM),
                         [](const auto& signal) { return signal.param == SIGINT ? "Int" : "Term"; });

TEST(SecondInterrupt, EndsTheProgramAtOnce) {
  const test::SmallPart part;
  // Opening a pipe that nobody reads takes for ever.
  const std::string pipe = part.output("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::vector<std::string> arguments = part.sweep({"--csv", pipe, "--time-limit", "0.01"});
  arguments.insert(arguments.begin(), MOLDLIGHT_BINARY);
  test::Process process(arguments, {});
  ASSERT_TRUE(process.wait_for_error_text("time limit"));
  for (int i = 0; i < 20; ++i) {
    process.send_signal(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const auto result = process.finish();
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.exit_code, 128 + SIGINT);
  EXPECT_EQ(result.err.find("interrupted"), std::string::npos) << "no word of it: " << result.err;
}

TEST(IgnoredInterrupt, IsNotHeardWhereTheCallerIgnoresIt) {
  const test::SmallPart part;
  std::vector<std::string> arguments = part.classify({"--verbose"});
  arguments.insert(arguments.begin(), {"/bin/sh", "-c", "trap '' INT; exec \"$@\"", "sh", MOLDLIGHT_BINARY});
  test::Process process(arguments, {});
  ASSERT_TRUE(process.wait_for_error_text("reading"));
  process.send_signal(SIGINT);
  EXPECT_EQ(process.finish().exit_code, 0);
}

}  // namespace
}  // namespace moldlight
