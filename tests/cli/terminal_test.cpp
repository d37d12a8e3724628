// What changes when stdout is a terminal, and when it cannot be written.
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"

namespace moldlight {
namespace {

using test::Process;
using test::ProcessSettings;
using test::SmallPart;
using test::with;

std::string shell_command(const std::vector<std::string>& arguments) {
  std::string command = "'" MOLDLIGHT_BINARY "'";
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  return command;
}

/// Runs on a terminal made for it; out holds both streams.
test::ProcessResult run_on_terminal(const std::vector<std::string>& arguments,
                                    const ProcessSettings& settings) {
  return Process({"/usr/bin/script", "-qec", shell_command(arguments), "/dev/null"}, settings).finish();
}

TEST(Terminal, ShowsColoursUnlessAskedNotTo) {
  if (!std::filesystem::exists("/usr/bin/script")) GTEST_SKIP() << "nothing here makes a terminal";
  const SmallPart part;
  const std::string red = "\033[31mUndercut";
  ProcessSettings settings;
  settings.removed_environment = {"NO_COLOR"};
  settings.environment = {"TERM=xterm"};
  const auto colourful = run_on_terminal(part.classify(), settings);
  ASSERT_EQ(colourful.exit_code, 0) << colourful.out;
  EXPECT_NE(colourful.out.find(red), std::string::npos) << colourful.out;
  settings.environment = {"TERM=dumb"};
  EXPECT_EQ(run_on_terminal(part.classify(), settings).out.find(red), std::string::npos);
  settings.environment = {"TERM=xterm", "NO_COLOR=1"};
  EXPECT_EQ(run_on_terminal(part.classify(), settings).out.find(red), std::string::npos);
}

TEST(Terminal, ProgressIsDrawnAndTakenAwayAgain) {
  if (!std::filesystem::exists("/usr/bin/script")) GTEST_SKIP() << "nothing here makes a terminal";
  const SmallPart part;
  auto arguments = with(part.classify({"--readout", "samples"}), "--samples", "3000000");
  ProcessSettings settings;
  settings.environment = {"TERM=xterm", "NO_COLOR=1"};
  const std::string shown = run_on_terminal(arguments, settings).out;
  EXPECT_NE(shown.find("\r\033[K"), std::string::npos) << shown;
  EXPECT_LT(shown.rfind("\033[K"), shown.find("region ")) << "progress stays on the screen";
  arguments.push_back("--quiet");
  EXPECT_EQ(run_on_terminal(arguments, settings).out.find('\033'), std::string::npos);
}

TEST(Terminal, AnOutputThatCannotBeWrittenIsAFailure) {
  const SmallPart part;
  for (const std::string place : {">/dev/full", ">&-"}) {
    const std::string json = part.output("a.json");
    const auto run =
        Process({"/bin/sh", "-c", shell_command(part.classify({"--json", json})) + place}, ProcessSettings{})
            .finish();
    EXPECT_EQ(run.exit_code, 1) << place;
    EXPECT_NE(run.err.find("stdout: cannot be written"), std::string::npos) << place << run.err;
    EXPECT_NO_THROW(static_cast<void>(test::json_of(test::file_bytes(json)))) << place;
  }
}

}  // namespace
}  // namespace moldlight
