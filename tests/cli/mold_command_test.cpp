// moldlight mold, as a user runs it.
#include <cmath>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;

class Mold : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> mold(std::vector<std::string> more) const {
    more.insert(more.begin(), {"mold", part.file(), "--direction", "z", "--unit", "mm"});
    return more;
  }
  test::SmallPart part;
};

TEST_F(Mold, TellsThePartingLineInATable) {
  const auto run = run_moldlight(mold({}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("\nParting line: planar at z = "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("length mm"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\nDetails\nEuler characteristics "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("  add up, core "), std::string::npos) << run.out;
  // What is nothing stands in no row.
  EXPECT_EQ(run.out.find("\nReverse draft"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("\nSlides"), std::string::npos) << run.out;
}

TEST_F(Mold, TellsThePartingLineInJson) {
  const auto run = run_moldlight(mold({"--json", "-", "--soft-draft", "3"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(run.out);
  EXPECT_EQ(json["schema"], "moldlight.mold/2");
  EXPECT_EQ(json["settings"]["soft_deg"], 3.0);
  EXPECT_EQ(json["settings"]["tau_deg"], 1.0);
  for (const char* key :
       {"part", "direction", "settings", "assignment", "euler", "loops", "parting_line", "verdict"})
    EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"core", "cavity", "action", "free"})
    EXPECT_TRUE(json["assignment"].contains(key)) << key;
  for (const char* key : {"part", "core", "cavity", "loops", "genus"})
    EXPECT_TRUE(json["euler"].contains(key)) << key;
  ASSERT_GE(json["loops"].size(), 1U);
  for (const char* key :
       {"kind", "length", "climb", "flatness", "steep_length", "sharpest_deg", "on_crease", "points"})
    EXPECT_TRUE(json["loops"][0].contains(key)) << key;
  EXPECT_EQ(json["loops"][0]["kind"], "outer");
  EXPECT_TRUE(json["euler"]["sums"].get<bool>());
  EXPECT_EQ(run_moldlight(mold({"--json", "-", "--soft-draft", "3"})).out, run.out) << "the same every time";
}

TEST_F(Mold, WritesTheLineInEveryFormat) {
  std::vector<std::string> arguments = mold({});
  for (const char* extension : {"dxf", "svg", "obj", "csv", "step"})
    arguments.insert(arguments.end(), {"--lines", part.output(std::string("line.") + extension)});
  const auto run = run_moldlight(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* extension : {"dxf", "svg", "obj", "csv", "step"})
    EXPECT_GT(test::file_bytes(part.output(std::string("line.") + extension)).size(), 200U) << extension;
}

TEST_F(Mold, WritesHalvesThatAreClosed) {
  const std::string folder = part.output("mold");
  const auto run = run_moldlight(mold(
      {"--out", folder, "--fill-undercut", "--3mf", "--step-bodies", "--json", part.output("mold.json")}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(test::file_bytes(part.output("mold.json")));
  EXPECT_LE(std::abs(json["volume_gap"].get<double>()), 1e-9);
  ASSERT_EQ(json["inserts"].size(), 1U);
  for (const auto& body : {json["halves"]["core"], json["halves"]["cavity"], json["inserts"][0]}) {
    EXPECT_TRUE(body["closed"].get<bool>());
    const auto info = run_moldlight({"info", body["file"].get<std::string>(), "--json", "-"});
    ASSERT_EQ(info.exit_code, 0) << info.err;
    const auto solid = json_of(info.out)["part"];
    EXPECT_TRUE(solid["closed"].get<bool>());
    EXPECT_NEAR(solid["volume"].get<double>(), body["volume"].get<double>(),
                1e-4 * body["volume"].get<double>());
  }
  EXPECT_LE(json["halves"]["core"]["undercut"].get<double>(), 1e-8);
  EXPECT_LE(json["halves"]["cavity"]["undercut"].get<double>(), 1e-8);
  for (const char* key : {"parting", "shut_offs", "steepest_deg"})
    EXPECT_TRUE(json["surfaces"].contains(key)) << key;
  const auto all = run_moldlight({"info", folder + "/mold.3mf", "--json", "-"});
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(json_of(all.out)["bodies"].size(), 3U);
  EXPECT_NE(test::file_bytes(folder + "/mold.step").find("MANIFOLD_SOLID_BREP('insert_1',"),
            std::string::npos);
  EXPECT_NE(test::file_bytes(folder + "/mold.step").find("SHELL_BASED_SURFACE_MODEL('parting_surface',"),
            std::string::npos);
}

TEST_F(Mold, TellsWhichInsertsGoWithSideActions) {
  const auto run = run_moldlight(mold({"--actions", "--json", "-"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto inserts = json_of(run.out)["inserts"];
  ASSERT_EQ(inserts.size(), 1U);
  ASSERT_EQ(inserts[0]["actions"].size(), 1U) << inserts.dump();
  EXPECT_EQ(inserts[0]["actions"][0]["kind"], "slide");
  EXPECT_EQ(inserts[0]["unreleased"], 0);
  const auto table = run_moldlight(mold({"--actions", "--registration"}));
  EXPECT_NE(table.out.find("slide_1 is the slide along"), std::string::npos) << table.out;
}

TEST_F(Mold, WritesSlidesAsSolids) {
  const std::string folder = part.output("pieces");
  const auto run = run_moldlight(mold({"--actions", "--out", folder, "--json", "-"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto pieces = json_of(run.out)["pieces"];
  ASSERT_EQ(pieces.size(), 3U) << pieces.dump();
  EXPECT_EQ(pieces[2]["kind"], "slide");
  EXPECT_EQ(pieces[2]["file"], folder + "/slide_1.stl");
  const auto slide = run_moldlight({"info", folder + "/slide_1.stl", "--json", "-"});
  ASSERT_EQ(slide.exit_code, 0) << slide.err;
  EXPECT_EQ(json_of(slide.out)["part"]["closed"], true);
}

TEST_F(Mold, IsDrawn) {
  const std::string picture = part.output("mold.png");
  const auto run = run_moldlight(mold({"--image", picture, "--size", "320x160", "--backend", "osmesa"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(test::file_bytes(picture).substr(1, 3), "PNG");
  EXPECT_EQ(run_moldlight(mold({"--size", "320x160"})).exit_code, 2) << "there is no picture";
}

/// What a sweep ranks by is what the mold of its direction says.
TEST_F(Mold, IsWhatASweepCompares) {
  const auto swept = run_moldlight(part.sweep({"--objective", "parting-length", "--json", "-"}));
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  const auto candidates = json_of(swept.out)["candidates"];
  double before = 0.0;
  for (const auto& candidate : candidates) {
    const double length = candidate["parting_length"].get<double>();
    EXPECT_GE(length, before * (1.0 - 1e-9));
    before = length;
  }
  const auto& best = candidates[0];
  const auto d = best["direction"];
  const auto run = run_moldlight({"mold", part.file(), "--direction",
                                  d[0].dump() + "," + d[1].dump() + "," + d[2].dump(), "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  double length = 0.0, climb = 0.0;
  const auto loops = json_of(run.out)["loops"];
  for (const auto& loop : loops) {
    if (loop["kind"] == "action") continue;
    length += loop["length"].get<double>();
    climb += loop["climb"].get<double>();
  }
  EXPECT_NEAR(best["parting_length"].get<double>(), length, 1e-9 * length);
  EXPECT_NEAR(best["parting_climb"].get<double>(), climb, 1e-9 * length);
}

TEST_F(Mold, WritesNoHalvesWhereUndercutsAreInTheWay) {
  const std::string folder = part.output("mold");
  const auto run = run_moldlight(mold({"--out", folder}));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("--fill-undercut"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("Parting line: planar"), std::string::npos) << "the report comes all the same";
  EXPECT_EQ(run_moldlight({"info", folder + "/core.stl"}).exit_code, 1) << "nothing was written";
}

TEST_F(Mold, RefusesWhatMakesNoSense) {
  const auto code = [&](const std::string& flag, const std::string& value) {
    return run_moldlight(mold({flag, value})).exit_code;
  };
  EXPECT_EQ(code("--lines", part.output("line.png")), 2);
  EXPECT_EQ(code("--parting-height", "high"), 2);
  EXPECT_EQ(code("--cosmetic", "lid:3"), 2);
  EXPECT_EQ(code("--cosmetic", "core:100000"), 2);
  EXPECT_EQ(code("--margin", "-1"), 2);
  EXPECT_EQ(code("--margin", "1e30"), 2) << "where points of a plane have too few digits";
  EXPECT_EQ(code("--shrink", "50"), 2);
  EXPECT_EQ(code("--parting-height", "1.5"), 0);
  const auto high = run_moldlight(mold({"--parting-height", "500"}));
  EXPECT_EQ(high.exit_code, 2);
  EXPECT_NE(high.err.find("--parting-height: 500 is outside of the part, which reaches from "),
            std::string::npos)
      << high.err;
  EXPECT_NE(run_moldlight(mold({"--lines", part.output("line.png")})).err.find("--lines: "),
            std::string::npos);
  EXPECT_EQ(run_moldlight({"mold", part.file()}).exit_code, 2) << "a direction is needed";
  const auto same = run_moldlight(mold({"--lines", part.file()}));
  EXPECT_EQ(same.exit_code, 2) << "the part is not overwritten";
}

}  // namespace
}  // namespace moldlight
