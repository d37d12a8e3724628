// What `moldlight sweep` proves, which criteria end it with an exit code, and the side actions of what it
// lists.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"
#include "cli/sweep_runs.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::keys;
using test::run_moldlight;
using test::SmallPart;
using test::sweep_of;
using test::without_time;
using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

TEST(SweepCommand, ProvesWhatWasAskedFor) {
  const SmallPart part;
  // The side hole is an undercut along z, and the best there is; the part has a hundred times as much area.
  const Json json = sweep_of(part.sweep({"--json", "-", "--prove", "0.5%", "--all-free", "--proof", "area"}));
  ASSERT_TRUE(json.contains("proof") && json.contains("all_free"));
  const Json& proof = json["proof"];
  EXPECT_EQ(keys(proof), (Names{"grade", "epsilon", "bound", "bound_error", "proved_share", "open", "cells",
                                "complete", "proved", "elapsed_s"}));
  EXPECT_EQ(proof["grade"], "area");
  const double total = json["part"]["area"].get<double>();
  EXPECT_NEAR(proof["epsilon"].get<double>(), 0.005 * total, 1e-9 * total);
  const double best = json["candidates"][0]["areas"]["undercut"].get<double>();
  EXPECT_NEAR(proof["bound"].get<double>(), std::max(0.0, best - 0.005 * total), 1e-9 * total);
  EXPECT_EQ(proof["complete"], true);
  EXPECT_NEAR(json["all_free"]["epsilon"].get<double>(), 0.005 * total, 1e-9 * total) << "if EPS is left out";
  EXPECT_EQ(json["settings"]["prove"], "0.5%");
  EXPECT_EQ(json["settings"]["all_free"], "0.5%");
  for (const Json& open : json["all_free"]["open"])
    EXPECT_EQ(keys(open), (Names{"direction", "radius_deg", "undercut"}));
  const auto run = run_moldlight(part.sweep({"--prove", "--fail-unless-proved"}));
  EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_NE(run.out.find("Proved: "), std::string::npos) << run.out;
}

TEST(SweepCommand, EndsWithFourWhenNothingIsProved) {
  const SmallPart part;
  // Hardly a direction has so much: nearly all of them are open.
  const auto failed = run_moldlight(part.sweep({"--all-free", "90%", "--fail-unless-proved"}));
  EXPECT_EQ(failed.exit_code, 4) << failed.err;
  EXPECT_NE(failed.err.find("not proved"), std::string::npos) << failed.err;
  EXPECT_NE(failed.out.find("undercut unit²"), std::string::npos) << "the result is there all the same";
  EXPECT_EQ(run_moldlight(part.sweep({"--fail-unless-proved"})).exit_code, 2);
  for (const std::string eps : {"-1", "101%", "much", "nan"})
    EXPECT_EQ(run_moldlight(part.sweep({"--prove", eps})).exit_code, 2) << eps;
}

TEST(SweepCommand, EndsWithThreeWhenTheCriterionFails) {
  const SmallPart part;
  const auto sweep = [&](const std::string& limit) {
    return run_moldlight(part.sweep({"--fail-if-undercut", limit}));
  };
  // The side hole is an undercut along z, and the best there is.
  EXPECT_EQ(sweep("100%").exit_code, 0);
  EXPECT_EQ(sweep("1e6").exit_code, 0);
  for (const std::string limit : {"0.001%", "0.001"}) {
    const auto failed = sweep(limit);
    EXPECT_EQ(failed.exit_code, 3) << failed.err;
    EXPECT_NE(failed.err.find("criterion"), std::string::npos) << failed.err;
    EXPECT_NE(failed.out.find("undercut unit²"), std::string::npos) << "the result is there all the same";
  }
  for (const std::string limit : {"-1", "1%%", "much", "", "nan"}) {
    EXPECT_EQ(sweep(limit).exit_code, 2) << limit;
  }
}

TEST(SweepCommand, TellsTheSideActionsOfWhatIsListed) {
  const SmallPart part;
  const auto run = run_moldlight(part.sweep({"--actions"}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  for (const char* word :
       {"side actions\n", "unreleased unit²", "Side actions of the best direction: 1 slide"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " in\n" << run.out;
  for (const char* word : {"± unit²", "undercuts\n"})
    EXPECT_EQ(run.out.find(word), std::string::npos) << word;
  const Json json = sweep_of(part.sweep({"--actions", "--json", "-", "--clearance", "5"}));
  EXPECT_EQ(json["settings"]["actions"], true);
  EXPECT_EQ(json["settings"]["clearance_mm"], 5.0);
  for (const Json& candidate : json["candidates"]) {
    std::string direction;
    for (const Json& component : candidate["direction"])
      direction += (direction.empty() ? "" : ",") + component.dump();
    const Json plan = json_of(
        run_moldlight({"actions", part.file(), "--direction", direction, "--clearance", "5", "--json", "-"})
            .out);
    double travel = 0.0;
    for (const Json& action : plan["actions"]) travel = std::max(travel, action["travel"].get<double>());
    EXPECT_EQ(candidate["travel"].get<double>(), travel) << direction;
    EXPECT_EQ(candidate["unreleased_area"], plan["unreleased"]["area"]) << direction;
    EXPECT_EQ(candidate["actions"] == "none", plan["actions"].empty()) << direction;
    EXPECT_EQ(candidate["side_actions"] == 0.0, plan["actions"].empty()) << direction;
  }
  const Json without = sweep_of(part.sweep({"--json", "-"}));
  EXPECT_TRUE(without["candidates"][0]["actions"].is_null());
  EXPECT_TRUE(without["candidates"][0]["side_actions"].is_null());
  EXPECT_FALSE(without["settings"].contains("clearance_mm"));
}

TEST(SweepCommand, RanksBySideActionsWhateverTheJobs) {
  const SmallPart part;
  const Json first = sweep_of(part.sweep({"--objective", "side-actions", "--json", "-", "--jobs", "1"}));
  const Json second = sweep_of(part.sweep({"--objective", "side-actions", "--json", "-", "--jobs", "3"}));
  EXPECT_EQ(without_time(first).dump(), without_time(second).dump());
  const Json& candidates = first["candidates"];
  ASSERT_GE(candidates.size(), 2U);
  for (std::size_t k = 1; k < candidates.size(); ++k) {
    // Of what is released whole, the one that asks for less comes first.
    if (candidates[k]["unreleased_area"] != 0.0 || candidates[k - 1]["unreleased_area"] != 0.0) continue;
    EXPECT_LE(candidates[k - 1]["side_actions"].get<double>(), candidates[k]["side_actions"].get<double>());
  }
}

TEST(SweepCommand, SettingsOfSideActionsWantThem) {
  const SmallPart part;
  const auto run = run_moldlight(part.sweep({"--incline", "20"}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("--incline: "), std::string::npos) << run.err;
  EXPECT_EQ(run_moldlight(part.sweep({"--incline", "20", "--objective", "travel"})).exit_code, 0);
}

}  // namespace
}  // namespace moldlight
