// What the program says of its own command line.
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

using test::run_moldlight;
using test::SmallPart;

TEST(Help, PutsFlagsIntoGroupsExpertsLast) {
  const std::string help = run_moldlight({"classify", "--help"}).out;
  std::size_t before = 0;
  for (const char* heading :
       {"\nPart:\n", "\nDirection:\n", "\nTolerances and rules:\n", "\nResult:\n", "\nPictures:\n",
        "\nPass or fail:\n", "\nExpert: shadow maps:\n", "\nProgram:\n", "\nExamples:\n"}) {
    const std::size_t at = help.find(heading);
    ASSERT_NE(at, std::string::npos) << heading << help;
    EXPECT_GT(at, before) << heading;
    before = at;
  }
  EXPECT_GT(help.find("--kernel TEXELS"), help.find("\nExpert: shadow maps:\n"));
  EXPECT_EQ(run_moldlight({"help", "classify"}).out, help);
}

TEST(Help, HasEveryFlagInOneGroup) {
  const std::string list = run_moldlight({"manual", "--form", "flags"}).out;
  for (const std::string command :
       {"info", "classify", "actions", "mold", "sweep", "pieces", "compare", "view"}) {
    const std::string help = run_moldlight({command, "--help"}).out;
    const std::size_t begin = list.find("\n## " + command + "\n");
    ASSERT_NE(begin, std::string::npos) << command;
    const std::string flags = list.substr(begin, list.find("\n## ", begin + 1) - begin);
    static const std::regex k_flag(R"(- `(--[a-z0-9-]+))");
    for (std::sregex_iterator it(flags.begin(), flags.end(), k_flag), end; it != end; ++it) {
      const std::regex line(R"(\n  (-.,)?)" + (*it)[1].str() + R"([ \n])");
      EXPECT_EQ(std::distance(std::sregex_iterator(help.begin(), help.end(), line), {}), 1)
          << command << " " << (*it)[1];
    }
  }
}

TEST(Help, ShortNamesAndWordsForDirectionsAndUnitsAreTaken) {
  const SmallPart part;
  const std::string usual =
      run_moldlight({"classify", part.file(), "--direction", "0,0,1", "--unit", "mm"}).out;
  EXPECT_EQ(run_moldlight({"classify", part.file(), "-d", "0 0 1", "-u", "MM"}).out, usual);
  EXPECT_EQ(run_moldlight({"classify", part.file(), "-d", "0, 0, 1", "-u", "Millimetre"}).out, usual);
  EXPECT_EQ(run_moldlight({"classify", part.file(), "-d", " z", "-u", "mm"}).out, usual);
  EXPECT_EQ(run_moldlight({"sweep", part.file(), "--candidates", "none", "-d", "z"}).exit_code, 0);
  EXPECT_EQ(run_moldlight({"version"}).out, run_moldlight({"--version"}).out);
}

TEST(Help, BatchShowsTheExamplesOfItsCommands) {
  const std::string help = run_moldlight({"batch", "--help"}).out;
  for (const char* line : {"moldlight batch plan ", "moldlight batch run ", "moldlight batch merge "})
    EXPECT_NE(help.find(line, help.find("\nExamples:\n")), std::string::npos) << line;
}

TEST(Help, GuessesWhatAMistypedWordMeant) {
  const SmallPart part;
  EXPECT_NE(run_moldlight({"clasify", part.file()}).err.find("did you mean classify?"), std::string::npos);
  EXPECT_NE(run_moldlight({"mold", part.file(), "--direcion", "z"}).err.find("did you mean --direction?"),
            std::string::npos);
  EXPECT_NE(run_moldlight({"sweep", part.file(), "--rank", "Modl"}).err.find("did you mean mold?"),
            std::string::npos);
  EXPECT_NE(
      run_moldlight({"sweep", part.file(), "--objective", "undercuts:1,travle"}).err.find("mean travel?"),
      std::string::npos);
  EXPECT_NE(run_moldlight(part.classify({"--fail-on", "udercut > 0"})).err.find("did you mean undercut?"),
            std::string::npos);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"batch", "rnu"}, {"help", "batch", "rnu"}, {"batch", "rnu", "--help"}})
    EXPECT_NE(run_moldlight(words).err.find("did you mean run?"), std::string::npos) << words.back();
  EXPECT_NE(run_moldlight({"batch", "plan", "parts", "--out", part.output("night"), "--", "clasify"})
                .err.find("did you mean classify?"),
            std::string::npos);
  EXPECT_NE(run_moldlight({"batch", "plan", "parts", "--out", part.output("night"), "--", "classify",
                           "--direcion", "z"})
                .err.find("did you mean --direction?"),
            std::string::npos);
  EXPECT_EQ(run_moldlight({"mold", part.file(), "--upside-down"}).err.find("did you mean"),
            std::string::npos);
}

TEST(Help, RefusesAPictureThatIsNamedOtherwise) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--image", part.output("part.jpg")}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("name it .png"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(part.output("part.jpg")));
}

/// Words of a command line; quotes hold words together.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  static const std::regex k_word(R"re("([^"]*)"|(\S+))re");
  for (std::sregex_iterator it(line.begin(), line.end(), k_word), end; it != end; ++it)
    words.push_back((*it)[1].matched ? (*it)[1].str() : (*it)[2].str());
  return words;
}

TEST(Help, ItsExamplesAreCommandLinesThatItTakes) {
  const test::ScratchFolder folder;
  std::istringstream help(run_moldlight({"sweep", "--help"}).out + run_moldlight({"mold", "--help"}).out +
                          run_moldlight({"classify", "--help"}).out +
                          run_moldlight({"actions", "--help"}).out +
                          run_moldlight({"compare", "--help"}).out + run_moldlight({"info", "--help"}).out);
  std::size_t tried = 0;
  for (std::string line; std::getline(help, line);) {
    if (!line.starts_with("    moldlight ")) continue;
    std::vector<std::string> words = words_of(line);
    words.erase(words.begin());
    const auto run = run_moldlight(words);
    EXPECT_EQ(run.exit_code, 1) << line << ": " << run.err;
    EXPECT_NE(run.err.find("clip"), std::string::npos) << "the part alone is missing: " << run.err;
    ++tried;
  }
  EXPECT_GE(tried, 7U);
}

}  // namespace
}  // namespace moldlight
