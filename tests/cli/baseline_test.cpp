// --baseline and --fail-on of classify and sweep.
#include <gtest/gtest.h>

#include "cli/small_part.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;
using test::with;

class BaselineFlags : public ::testing::Test {
 protected:
  test::SmallPart part;
  std::string report = part.output("before.json");
};

TEST_F(BaselineFlags, ClassifyTellsWhatChanged) {
  ASSERT_EQ(run_moldlight(part.classify({"--json", report})).exit_code, 0);
  const auto same =
      run_moldlight(part.classify({"--baseline", report, "--fail-on", "undercut > +0, near-vertical > +0"}));
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("No figure changed"), std::string::npos) << same.out;
  // Tilted, more is hidden.
  const auto tilted = run_moldlight(
      with(part.classify({"--baseline", report, "--fail-on", "undercut > +1%"}), "--direction", "0.2,0,1"));
  EXPECT_EQ(tilted.exit_code, 3) << tilted.err;
  EXPECT_EQ(tilted.error_lines(), 1U) << tilted.err;
  EXPECT_NE(tilted.out.find("undercut"), std::string::npos);
  const auto json = json_of(run_moldlight(part.classify({"--baseline", report, "--json", "-"})).out);
  EXPECT_EQ(json["schema"], "moldlight.classify/2");
  EXPECT_EQ(json["baseline"]["figures"]["undercut"]["was"], json["areas"]["undercut"]);
}

TEST_F(BaselineFlags, SweepComparesItsBestDirection) {
  ASSERT_EQ(run_moldlight(part.sweep({"--json", report})).exit_code, 0);
  EXPECT_EQ(run_moldlight(part.sweep({"--baseline", report, "--fail-on", "undercuts > +0, undercut > +0"}))
                .exit_code,
            0);
  EXPECT_EQ(run_moldlight(part.sweep({"--baseline", report, "--fail-on", "draw-depth > 1"})).exit_code, 3);
}

TEST_F(BaselineFlags, RefuseWhatMakesNoSense) {
  ASSERT_EQ(run_moldlight(part.classify({"--json", report})).exit_code, 0);
  const auto other = run_moldlight(part.sweep({"--baseline", report}));
  EXPECT_EQ(other.exit_code, 2) << "a report of another command";
  EXPECT_EQ(other.error_lines(), 1U) << other.err;
  EXPECT_EQ(run_moldlight(part.classify({"--fail-on", "undercut > +0"})).exit_code, 2) << "against what?";
  EXPECT_EQ(run_moldlight(part.classify({"--baseline", part.output("none.json")})).exit_code, 1);
  EXPECT_EQ(run_moldlight(part.classify({"--baseline", report, "--json", report})).exit_code, 2)
      << "would be overwritten";
  EXPECT_EQ(run_moldlight(part.classify({"--baseline", report, "--fail-on", "actions > 0"})).exit_code, 2);
  const auto mesh = run_moldlight(part.classify({"--baseline", part.file()}));
  EXPECT_EQ(mesh.exit_code, 1) << "no JSON";
  EXPECT_EQ(mesh.error_lines(), 1U) << mesh.err;
}

TEST(Gates, HoldOfWhatIsNowWithoutABaseline) {
  const SmallPart part;
  const auto run = [&](const std::string& command, const std::string& criteria) {
    std::vector<std::string> words = {command, part.file(), "--fail-on", criteria, "--quiet"};
    if (command != "sweep") words.insert(words.end(), {"--direction", "x"});
    return run_moldlight(words);
  };
  for (const std::string command : {"classify", "actions", "mold"}) {
    EXPECT_EQ(run(command, "undercuts > 0").exit_code, 3) << command;
    EXPECT_EQ(run(command, "undercuts > 9, undercut > 100%").exit_code, 0) << command;
  }
  EXPECT_EQ(run("actions", "actions > 0").exit_code, 3);
  EXPECT_EQ(run("actions", "lifters > 40, slides > 40, unreleased > 100%").exit_code, 0);
  EXPECT_EQ(run("mold", "steel-on-steel >= 0").exit_code, 3);
  EXPECT_EQ(run("sweep", "undercut >= 0").exit_code, 3);
  const auto of_change = run("classify", "undercut > +1%");
  EXPECT_EQ(of_change.exit_code, 2);
  EXPECT_NE(of_change.err.find("give --baseline"), std::string::npos) << of_change.err;
  EXPECT_EQ(run("mold", "slopes > 1").exit_code, 2) << "no figure of that name";
}

TEST(Gates, TakeAVerdictAndWriteJUnit) {
  const SmallPart part;
  const std::string file = part.output("gate.xml");
  const auto run = [&](const std::string& criteria) {
    return run_moldlight({"classify", part.file(), "-d", "x", "-q", "--fail-on", criteria, "--junit", file});
  };
  const auto undercut = run("verdict > side-actions, undercut > 100%");
  EXPECT_EQ(undercut.exit_code, 3) << undercut.err;
  EXPECT_NE(undercut.err.find("verdict > side-actions: verdict is undercuts"), std::string::npos)
      << undercut.err;
  const std::string xml = test::file_bytes(file);
  EXPECT_NE(xml.find("<testsuites name=\"moldlight\" tests=\"2\" failures=\"1\">"), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"undercut &gt; 100%\"/>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"verdict &gt; side-actions\"><failure message=\"criterion failed"),
            std::string::npos)
      << xml;
  EXPECT_EQ(run("verdict > undercuts").exit_code, 0);
  EXPECT_EQ(run("verdict > bad").exit_code, 2);
  EXPECT_EQ(run_moldlight({"classify", part.file(), "-d", "x", "--junit", file}).exit_code, 2) << "of what?";
  EXPECT_EQ(
      run_moldlight({"classify", part.file(), "-d", "x", "--fail-on", "undercut > 0", "--junit", part.file()})
          .exit_code,
      2)
      << "would be overwritten";
}

TEST(Gates, CompareSideActionsAndMoldsWithEarlierOnes) {
  const SmallPart part;
  for (const std::string command : {"actions", "mold"}) {
    const std::string before = part.output(command + ".json");
    ASSERT_EQ(run_moldlight({command, part.file(), "-d", "x", "-q", "--json", before}).exit_code, 0);
    const auto same = run_moldlight({command, part.file(), "-d", "x", "-q", "--baseline", before, "--fail-on",
                                     "undercut > +0, core > +0"});
    EXPECT_EQ(same.exit_code, command == "mold" ? 0 : 2) << command << same.err << "actions have no core";
    const auto turned =
        run_moldlight({command, part.file(), "-d", "z", "-q", "--baseline", before, "--json", "-"});
    ASSERT_EQ(turned.exit_code, 0) << turned.err;
    EXPECT_TRUE(json_of(turned.out)["baseline"]["figures"].contains("undercut"));
  }
}

}  // namespace
}  // namespace moldlight
