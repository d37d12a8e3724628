// Batches on one machine: what is planned, done, passed over, recorded as failed, merged.
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "cli/small_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::json_of;
using test::run_moldlight;
using test::SmallParts;

TEST(Batch, ResultsAreThoseOfTheCommandItself) {
  const SmallParts parts(3);
  ASSERT_EQ(parts.plan().exit_code, 0);
  const auto run = parts.batch("run");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("this run: 3 done, 0 failed, 0 skipped"), std::string::npos) << run.out;
  const auto results = parts.results();
  ASSERT_EQ(results.size(), 3u);
  for (const auto& [name, result] : results) {
    const std::string part = parts.path("parts/" + result["path"].get<std::string>());
    auto alone = json_of(run_moldlight({"classify", part, "--direction", "z", "--json", "-"}).out);
    alone.erase("timings_ms");
    EXPECT_EQ(result["report"], alone) << part;
    EXPECT_EQ(result["outcome"], "done");
    EXPECT_EQ(result["tries"], 1);
  }
  const auto again = parts.batch("run");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("this run: 0 done, 0 failed, 3 skipped"), std::string::npos) << again.out;
}

TEST(Batch, SweepsActionsAndMoldsAreWorkToo) {
  const SmallParts parts(2);
  ASSERT_EQ(parts.plan("parts", "sweeps", {"sweep", "--directions", "20", "--top", "1"}).exit_code, 0);
  ASSERT_EQ(parts.plan("parts", "actions", {"actions", "--direction", "z", "--incline", "20"}).exit_code, 0);
  ASSERT_EQ(parts.plan("parts", "molds", {"mold", "--direction", "z", "--shrink", "0.5"}).exit_code, 0);
  ASSERT_EQ(parts.plan("parts", "pieces", {"pieces", "--max", "3"}).exit_code, 0);
  for (const char* name : {"sweeps", "actions", "molds", "pieces"}) {
    const auto run = parts.batch("run", {}, name);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(parts.status(name)["done"], 2) << name;
    const std::string table = parts.path("all.csv");
    EXPECT_EQ(parts.batch("merge", {"--csv", table}, name).exit_code, 0);
    EXPECT_NE(file_bytes(table).find("part-0001.off"), std::string::npos);
  }
  const std::string pieces = file_bytes(parts.path("all.csv"));
  EXPECT_NE(pieces.find("unreleased_area,pieces,piece_bound,"), std::string::npos) << pieces;
  EXPECT_NE(pieces.find("two-piece"), std::string::npos) << pieces;
  EXPECT_NE(pieces.find(",2,2,"), std::string::npos) << pieces;
  EXPECT_EQ(parts.batch("merge", {"--fail-on", "pieces > 2"}, "pieces").exit_code, 0);
  EXPECT_EQ(parts.batch("merge", {"--fail-on", "pieces > 1"}, "pieces").exit_code, 3);
  const auto settings = json_of(file_bytes(parts.path("actions/batch.json")))["settings"][0];
  EXPECT_EQ(settings["effective"]["incline_deg"], 20.0);
  const auto sweep = json_of(file_bytes(parts.path("sweeps/batch.json")))["settings"][0]["effective"];
  EXPECT_EQ(sweep["directions"], 20);
  EXPECT_FALSE(sweep.contains("jobs")) << "what changes no result is no part of a key";
  EXPECT_FALSE(sweep.contains("time_limit_s"));
}

TEST(Batch, OddNamesMissingFilesAndDuplicates) {
  const SmallParts parts(1);
  parts.add("a b.off", test::tetrahedron_text(7));
  parts.add("line\nend.off", test::tetrahedron_text(8));
  parts.add("-q\"uo'te,;.off", test::tetrahedron_text(9));
  parts.add("same.off", test::tetrahedron_text(7));
  parts.add("junk.stl", "junk");
  static_cast<void>(parts.folder().write(
      "list.csv",
      "path,unit\nparts/a b.off,\n\"parts/line\nend.off\",mm\n\"parts/-q\"\"uo'te,;.off\",\nparts/same.off,\n"
      "parts/junk.stl,\nparts/none.off,\nparts,\n"));
  const auto plan = parts.plan("list.csv");
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_NE(plan.err.find("2 parts cannot be read"), std::string::npos) << plan.err;
  EXPECT_NE(plan.err.find("1 part holds the same content and settings as another"), std::string::npos)
      << plan.err;
  const auto run = parts.batch("run");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("parts/junk.stl: failed: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("parts/none.off: failed: could not be read when it was planned"), std::string::npos)
      << run.err;
  const auto status = parts.status();
  EXPECT_EQ(status["parts"], 7);
  EXPECT_EQ(status["done"], 4);
  EXPECT_EQ(status["failed"], 3);
  EXPECT_EQ(status["shared"], 1);
  EXPECT_EQ(parts.results().size(), 6u);
  EXPECT_EQ(parts.batch("run", {"--fail-on-error"}).exit_code, 3);
  // Failures are passed over until they are asked for.
  EXPECT_NE(parts.batch("run").out.find("0 done, 0 failed, 6 skipped"), std::string::npos);
  const auto retried = parts.batch("run", {"--retry-failed"});
  EXPECT_NE(retried.out.find("0 done, 3 failed, 3 skipped"), std::string::npos) << retried.out;
  const std::string table = parts.path("all.csv");
  ASSERT_EQ(parts.batch("merge", {"--csv", table}).exit_code, 0);
  EXPECT_NE(file_bytes(table).find("parts/line\\u000Aend.off,'--unit=mm --direction=z"), std::string::npos)
      << file_bytes(table);
}

TEST(Batch, AFileThatChangedAfterPlanningIsSaid) {
  const SmallParts parts(3);
  ASSERT_EQ(parts.plan().exit_code, 0);
  parts.add("part-0001.off", test::tetrahedron_text(77));
  fs::remove(parts.path("parts/part-0002.off"));
  const auto run = parts.batch("run");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("part-0001.off: failed: has changed since it was planned"), std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("part-0002.off: failed: is gone since it was planned"), std::string::npos)
      << run.err;
  // Planned anew, what has not changed holds.
  const auto plan = run_moldlight({"batch", "plan", "--anew", parts.path("night")});
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  const auto again = parts.batch("run");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("1 done, 0 failed, 1 skipped"), std::string::npos) << again.out;
}

TEST(Batch, AFolderOfPartsThatIsNotThereIsTriedAgain) {
  const SmallParts parts(3);
  ASSERT_EQ(parts.plan().exit_code, 0);
  fs::rename(parts.path("parts"), parts.path("unmounted"));
  const auto run = parts.batch("run");
  EXPECT_EQ(run.exit_code, 75) << run.err;
  EXPECT_NE(run.err.find("3 parts could not be reached"), std::string::npos) << run.err;
  EXPECT_TRUE(parts.results().empty()) << "that says nothing of the parts";
  const auto elsewhere = parts.batch("run", {"--parts", parts.path("unmounted")});
  EXPECT_EQ(elsewhere.exit_code, 0) << elsewhere.err;
  EXPECT_EQ(parts.status()["done"], 3);
}

TEST(Batch, ShardsDoTheirPartsAndNoOthers) {
  const SmallParts parts(7);
  ASSERT_EQ(parts.plan().exit_code, 0);
  EXPECT_EQ(parts.batch("run", {"--shard", "1/3"}).exit_code, 0);
  EXPECT_EQ(parts.status()["done"], 2);
  const auto missing = parts.batch("status", {"--missing"});
  EXPECT_EQ(missing.exit_code, 75);
  EXPECT_EQ(
      missing.out,
      "row,path\n0,part-0000.off\n2,part-0002.off\n3,part-0003.off\n5,part-0005.off\n6,part-0006.off\n");
  EXPECT_EQ(parts.batch("status", {"--shard", "1/3"}).exit_code, 0);
  EXPECT_EQ(parts.batch("run", {"--shard", "0/3"}).exit_code, 0);
  EXPECT_EQ(parts.batch("run", {"--shard", "2/3"}).exit_code, 0);
  EXPECT_EQ(parts.status()["done"], 7);
}

TEST(Batch, ABatchOfAnotherVersionIsToldAndLosesNothing) {
  const SmallParts parts(2);
  ASSERT_EQ(parts.plan().exit_code, 0);
  ASSERT_EQ(parts.batch("run").exit_code, 0);
  const auto results = parts.results();
  std::string manifest = file_bytes(parts.path("night/batch.json"));
  const std::size_t version = manifest.find("\"version\": \"0.");
  ASSERT_NE(version, std::string::npos);
  manifest.replace(version, 14, "\"version\": \"7.");
  static_cast<void>(parts.folder().write("night/batch.json", manifest));
  const auto run = parts.batch("run");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
  EXPECT_NE(run.err.find("batch plan --anew"), std::string::npos) << run.err;
  ASSERT_EQ(run_moldlight({"batch", "plan", "--anew", parts.path("night")}).exit_code, 0);
  EXPECT_EQ(parts.results(), results);
  EXPECT_EQ(parts.batch("run").exit_code, 0);
  EXPECT_EQ(parts.status()["done"], 2);
}

TEST(Batch, LimitsEndAPartAndItsFailureSaysSo) {
  const SmallParts parts(0);
  const test::SmallPart cup;
  parts.add("cup.obj", file_bytes(cup.file()));
  ASSERT_EQ(parts
                .plan("parts/cup.obj", "slow",
                      {"classify", "--direction", "z", "--readout", "samples", "--samples", "100000000"})
                .exit_code,
            0);
  const auto slow = parts.batch("run", {"--part-time", "0.3"}, "slow");
  EXPECT_EQ(slow.exit_code, 0) << slow.err;
  EXPECT_NE(slow.err.find("cup.obj: failed: took longer than 0.3 s"), std::string::npos) << slow.err;
  const auto results = parts.results("slow");
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(results.begin()->second["kind"], "time");
  EXPECT_EQ(results.begin()->second["tries"], 1) << "it would come to the limit again";
  const auto large = parts.batch("run", {"--part-memory", "1", "--retry-failed"}, "slow");
  EXPECT_EQ(large.exit_code, 0) << large.err;
  EXPECT_NE(large.err.find("cup.obj: failed: took more than 1 MB of memory"), std::string::npos) << large.err;
  EXPECT_EQ(parts.results("slow").begin()->second["kind"], "memory");
}

/// Paths of the results' folder with this ending, sorted.
std::vector<std::string> lying_beside(const SmallParts& parts, const std::string& ending) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(parts.path("night/results")))
    if (entry.path().extension() == ending) found.push_back(entry.path().string());
  std::ranges::sort(found);
  return found;
}

TEST(Batch, PicturesAndReportsAreMadeAlsoOfWhatIsDone) {
  const SmallParts parts(2);
  ASSERT_EQ(parts.plan().exit_code, 0);
  ASSERT_EQ(parts.batch("run").exit_code, 0);
  const auto run = parts.batch("run", {"--thumbnails"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(lying_beside(parts, ".png").size(), 2u) << run.err;
  EXPECT_TRUE(lying_beside(parts, ".html").empty());
  const std::string page = parts.path("all.html");
  EXPECT_EQ(parts.batch("merge", {"--html", page}).exit_code, 0);
  EXPECT_NE(file_bytes(page).find("\"results\": \"night/results/\""), std::string::npos);
  const auto again = parts.batch("run", {"--reports"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  const std::vector<std::string> reports = lying_beside(parts, ".html");
  ASSERT_EQ(reports.size(), 2u) << again.err;
  EXPECT_EQ(parts.batch("merge", {"--html", page}).exit_code, 0);
  for (const std::string& report : reports) {
    EXPECT_NE(file_bytes(report).find("part-000"), std::string::npos) << "the report of a part";
    const std::string below = fs::relative(report, parts.path("night/results")).string();
    EXPECT_NE(file_bytes(page).find("\"" + below + "\""), std::string::npos) << "the page links to it";
  }
  // What is there is not made again.
  const auto before = fs::last_write_time(reports[0]);
  EXPECT_EQ(parts.batch("run", {"--reports", "--thumbnails"}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(reports[0]), before);
}

TEST(Batch, LiveReportsAreOfCommandsThatHaveThem) {
  const SmallParts parts(1);
  ASSERT_EQ(parts.plan().exit_code, 0);
  const auto run = parts.batch("run", {"--live"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::vector<std::string> reports = lying_beside(parts, ".html");
  ASSERT_EQ(reports.size(), 1u) << run.err;
  EXPECT_NE(file_bytes(reports[0]).find("id=\"live\""), std::string::npos);
  ASSERT_EQ(parts.plan("parts", "actions", {"actions", "--direction", "z"}).exit_code, 0);
  const auto refused = parts.batch("run", {"--live"}, "actions");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--live: reports of actions are not live"), std::string::npos) << refused.err;
}

struct Refusal {
  std::vector<std::string> arguments;
  int exit_code;
  std::vector<std::string> words;
};

TEST(Batch, WhatMakesNoSenseIsToldInOneLine) {
  const SmallParts parts(1);
  ASSERT_EQ(parts.plan().exit_code, 0);
  static_cast<void>(parts.folder().write("colour.csv", "path,colour\nparts/part-0000.off,red\n"));
  const std::string night = parts.path("night"), source = parts.path("parts"), fresh = parts.path("fresh");
  const auto planned = [&](const std::string& what, std::vector<std::string> work) {
    std::vector<std::string> arguments = {"batch", "plan", what, "--out", fresh, "--"};
    arguments.insert(arguments.end(), work.begin(), work.end());
    return arguments;
  };
  const std::vector<Refusal> refusals = {
      {{"batch"}, 2, {"which command?"}},
      {{"batch", "plan"}, 2, {"SOURCE --out DIR -- WORK"}},
      {{"batch", "plan", source, "--out", night, "--", "classify", "--direction", "z"}, 2, {"--anew", night}},
      {{"batch", "plan", source, "--out", source, "--", "classify", "--direction", "z"},
       2,
       {"not an empty folder"}},
      {planned(source, {"melt"}), 2, {"melt", "classify, sweep, actions, mold or pieces"}},
      {planned(source, {"view"}), 2, {"view", "classify, sweep, actions, mold or pieces"}},
      {planned(source, {"classify"}), 2, {"--direction"}},
      {planned(source, {"classify", "--direction", "0,0,0"}), 2, {"--direction"}},
      {planned(source, {"classify", "--direction", "z", "--colour", "red"}), 2, {"--colour"}},
      {planned(source, {"classify", "--direction", "z", "--json", "a.json"}), 2, {"--json", "merge"}},
      {planned(source, {"sweep", "--image-dir", "out"}), 2, {"--image-dir", "merge"}},
      {planned(source, {"classify", "other.stl", "--direction", "z"}), 2, {"other.stl"}},
      {planned(parts.path("none"), {"classify", "--direction", "z"}), 1, {"none"}},
      {planned(parts.path("colour.csv"), {"classify", "--direction", "z"}), 2, {"line 2", "--colour"}},
      {{"batch", "run"}, 2, {"DIR"}},
      {{"batch", "run", source}, 1, {"is not a batch"}},
      {{"batch", "run", fresh}, 1, {"is not a folder"}},
      {{"batch", "run", night, "--shard", "2/2"}, 2, {"--shard"}},
      {{"batch", "run", night, "--shard", "0/0"}, 2, {"--shard"}},
      {{"batch", "run", night, "--shard", "-1/2"}, 2, {"--shard"}},
      {{"batch", "run", night, "-j", "-1"}, 2, {"--jobs"}},
      {{"batch", "run", night, "--processes", "-1"}, 2, {"--jobs"}},
      {{"batch", "status", source}, 1, {"is not a batch"}},
      {{"batch", "merge", night}, 2, {"--csv"}},
      {{"batch", "merge", night, "--csv", night + "/batch.json"}, 2, {"--csv"}},
      {{"batch", "merge", night, "--csv", "/nowhere/a.csv"}, 1, {"/nowhere/a.csv"}},
      {{"batch", "merge", night, "--sqlite", source + "/part-0000.off"}, 1, {"not a merged batch"}},
  };
  for (const auto& [arguments, exit_code, words] : refusals) {
    const auto run = run_moldlight(arguments);
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    EXPECT_EQ(run.exit_code, exit_code) << line << "\n" << run.err;
    EXPECT_EQ(run.error_lines(), 1u) << line << "\n" << run.err;
    EXPECT_EQ(run.out, "") << line;
    for (const std::string& word : words)
      EXPECT_NE(run.err.find(word), std::string::npos) << line << ": no '" << word << "' in " << run.err;
    EXPECT_FALSE(fs::exists(fresh)) << line;
  }
}

}  // namespace
}  // namespace moldlight
