// One verdict: every command that shows one says the same of a part and a direction, in JSON and in text.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::json_of;
using test::run_moldlight;

nlohmann::ordered_json report(const std::string& part, std::vector<std::string> words) {
  words.insert(words.begin() + 1, part);
  words.insert(words.end(), {"--unit", "mm", "--json", "-", "-q"});
  const auto run = run_moldlight(words);
  EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 3) << part << ": " << run.err;
  return json_of(run.out);
}

/// Of the counts, which none may show in another way.
void expect_same_counts(const nlohmann::ordered_json& a, const nlohmann::ordered_json& b,
                        const std::string& what) {
  EXPECT_EQ(a["undercuts"], b["undercuts"]) << what;
  EXPECT_EQ(a["specks"]["number"], b["specks"]["number"]) << what;
  EXPECT_NEAR(a["undercut_area"].get<double>(), b["undercut_area"].get<double>(),
              1e-9 * (1.0 + b["undercut_area"].get<double>()))
      << what;
}

void expect_one_verdict(const std::string& part, const std::string& direction) {
  const std::string what = part + " along " + direction;
  const auto regions = report(part, {"classify", "--direction", direction})["verdict"];
  const auto actions = report(part, {"actions", "--direction", direction})["verdict"];
  const auto mold = report(part, {"mold", "--direction", direction})["verdict"];
  const auto with_actions = report(part, {"mold", "--direction", direction, "--actions"})["verdict"];
  expect_same_counts(regions, actions, what);
  EXPECT_EQ(regions["sentence"], mold["sentence"]) << what;
  for (const char* key : {"state", "sentence", "undercuts", "unreleased_area", "actions"})
    EXPECT_EQ(actions[key], with_actions[key]) << what << ", " << key;
  const std::string state = actions["state"];
  EXPECT_EQ(regions["state"] == "two-plate", state == "two-plate") << what;
  EXPECT_EQ(regions["state"] == "unknown", state == "unknown") << what;
  EXPECT_NE(state, "undercuts") << what << ": actions were asked for";

  const auto listed = report(part, {"sweep", "--candidates", "none", "--direction", direction, "--top", "1",
                                    "--actions", "--refine", "0"});
  ASSERT_FALSE(listed["candidates"].empty()) << what;
  expect_same_counts(listed["candidates"][0]["verdict"], actions, what);
  EXPECT_EQ(listed["verdict"]["sentence"], actions["sentence"]) << what;
}

TEST(OneVerdict, IsTheSameInEveryCommand) {
  const test::SmallPart part;
  expect_one_verdict(part.file(), "z");
  expect_one_verdict(part.file(), "x");
}

TEST(OneVerdict, IsTheSameOfShippedParts) {
  for (const auto& entry : fs::directory_iterator(test::asset_folder()))
    if (entry.path().extension() == ".stl" && fs::file_size(entry.path()) < 2'000'000)
      expect_one_verdict(entry.path().string(), "z");
}

TEST(OneVerdict, LeadsTheTextOfTheTerminal) {
  const test::SmallPart part;
  for (const std::string command : {"classify", "actions", "mold"}) {
    const auto json = report(part.file(), {command, "--direction", "z"});
    const auto text = run_moldlight({command, part.file(), "--direction", "z", "--unit", "mm", "-q"});
    const std::string sentence = json["verdict"]["sentence"];
    EXPECT_TRUE(text.out.starts_with(sentence + "\n")) << text.out.substr(0, 200);
  }
}

}  // namespace
}  // namespace moldlight
