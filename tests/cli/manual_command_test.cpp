// The manual page and the shells' completion against what the commands' own help lists.
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/process.hpp"

namespace moldlight {
namespace {

using test::run_moldlight;

/// Flags stand two columns in, after their letter where they have one.
std::set<std::string> flags_of(const std::string& command) {
  std::set<std::string> flags;
  std::vector<std::string> words;
  std::istringstream names(command);
  for (std::string word; names >> word;) words.push_back(word);
  words.emplace_back("--help");
  std::istringstream help(run_moldlight(words).out);
  for (std::string line; std::getline(help, line);) {
    if (!line.starts_with("  -")) continue;
    const std::size_t begin = line.find("--");
    flags.insert(line.substr(begin, line.find(' ', begin) - begin));
  }
  return flags;
}

/// The subcommands that the help of a command lists, of the program itself for "".
std::set<std::string> commands_of(const std::string& command) {
  std::vector<std::string> words = {"--help"};
  if (!command.empty()) words.insert(words.begin(), command);
  std::istringstream help(run_moldlight(words).out);
  std::set<std::string> commands;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (listed && line.starts_with("  ") && line[2] != ' ') {
      std::istringstream text(line);
      std::string name;
      text >> name;
      commands.insert(name);
    }
    listed = line == "Subcommands:" || (listed && line.starts_with(' '));
  }
  return commands;
}

/// As a manual page has it.
std::string escaped(const std::string& flag) {
  std::string text;
  for (const char c : flag) text += c == '-' ? std::string("\\-") : std::string(1, c);
  return text;
}

std::string completions(const std::string& words) {
  const std::string script = "source <('" MOLDLIGHT_BINARY "' manual --form bash); COMP_WORDS=(moldlight " +
                             words +
                             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _moldlight; echo \"${COMPREPLY[@]}\"";
  return test::Process({"/bin/bash", "-c", script}, {}).finish().out;
}

TEST(Manual, ThePageHoldsEveryFlagOfEveryCommand) {
  const auto page = run_moldlight({"manual"});
  ASSERT_EQ(page.exit_code, 0);
  std::set<std::string> commands = commands_of("");
  EXPECT_TRUE(commands.contains("mold"));
  EXPECT_EQ(commands.erase("batch"), 1u);
  for (const std::string& part : commands_of("batch")) commands.insert("batch " + part);
  for (const std::string& command : commands) {
    const std::size_t begin = page.out.find("\n.SH MOLDLIGHT " + command + "\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string section = page.out.substr(begin, page.out.find("\n.SH ", begin + 1) - begin);
    const std::set<std::string> flags = flags_of(command);
    EXPECT_FALSE(flags.empty()) << command;
    for (const std::string& flag : flags) {
      EXPECT_NE(section.find("\\fB\\&" + escaped(flag) + "\\fR"), std::string::npos)
          << command << ' ' << flag;
    }
  }
}

TEST(Manual, ExamplesHaveOnlyFlagsThatThereAre) {
  std::set<std::string> commands = commands_of("");
  commands.erase("batch");  // has the examples of its subcommands
  for (const std::string& part : commands_of("batch")) commands.insert("batch " + part);
  std::size_t seen = 0;
  for (const std::string& command : commands) {
    std::istringstream names(command + " --help");
    std::vector<std::string> words;
    for (std::string word; names >> word;) words.push_back(word);
    const std::string help = run_moldlight(words).out;
    const std::string flags = help.substr(0, help.find("\nExamples:"));
    std::istringstream lines(help.substr(flags.size()));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream typed(line.starts_with("    moldlight ") ? line : "");
      for (std::string word; typed >> word && word != "--"; ++seen) {
        const std::string listed = word + (word.starts_with("--") ? " " : ",");
        EXPECT_TRUE(!word.starts_with('-') || flags.find(listed) != std::string::npos)
            << command << ' ' << word;
      }
    }
  }
  EXPECT_GT(seen, 20U);
}

TEST(Manual, ThePageHoldsEveryExitCode) {
  const std::string page = run_moldlight({"manual"}).out;
  const std::size_t begin = page.find("\n.SH EXIT STATUS\n");
  ASSERT_NE(begin, std::string::npos);
  for (const ExitCode& each : k_exit_codes)
    EXPECT_NE(page.find(".TP\n" + std::to_string(each.code) + "\n", begin), std::string::npos) << each.code;
}

TEST(Manual, ListsFlagsAndKeysInMarkdown) {
  const std::string flags = run_moldlight({"manual", "--form", "flags"}).out;
  for (const std::string command : {"sweep", "batch run"}) {
    const std::size_t begin = flags.find("\n## " + command + "\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string section = flags.substr(begin, flags.find("\n## ", begin + 1) - begin);
    for (const std::string& flag : flags_of(command))
      EXPECT_NE(section.find("\n- `" + flag), std::string::npos) << command << ' ' << flag;
  }
  EXPECT_NE(flags.find("\n- `--direction X,Y,Z|AXIS|best`, `-d`: "), std::string::npos);
  EXPECT_NE(run_moldlight({"manual"}).out.find("X,Y,Z|AXIS|best\\fR, \\fB\\&\\-d\\fR\n"), std::string::npos);
  const std::string keys = run_moldlight({"manual", "--form", "keys"}).out;
  EXPECT_NE(keys.find("\n| direction | what it does |\n|---|---|\n"), std::string::npos);
  EXPECT_NE(keys.find("\n| Ctrl+E | export |\n"), std::string::npos);
}

TEST(Manual, BashCompletesCommandsFlagsAndWords) {
  EXPECT_EQ(completions("cl"), "classify\n");
  EXPECT_EQ(completions("classify --readout ''"), "exact samples facet-id\n");
  EXPECT_EQ(completions("classify --kernel-shape s"), "symmetric\n");
  EXPECT_EQ(completions("batch st"), "status\n");
  EXPECT_NE(completions("batch run --").find("--part-memory"), std::string::npos);
  std::string all = completions("sweep --");
  for (const std::string& flag : flags_of("sweep")) EXPECT_NE(all.find(flag), std::string::npos) << flag;
}

TEST(Manual, ZshReadsItsCompletion) {
  const auto completion = run_moldlight({"manual", "--form", "zsh"});
  EXPECT_TRUE(completion.out.starts_with("#compdef moldlight\n"));
  EXPECT_NE(completion.out.find(":(exact samples facet-id)"), std::string::npos);
  if (!std::filesystem::exists("/usr/bin/zsh")) GTEST_SKIP() << "no zsh here";
  const auto read =
      test::Process(
          {"/bin/sh", "-c", "'" MOLDLIGHT_BINARY "' manual --form zsh | /usr/bin/zsh -n /dev/stdin"}, {})
          .finish();
  EXPECT_EQ(read.exit_code, 0) << read.err;
}

}  // namespace
}  // namespace moldlight
