// What `moldlight pieces` prints, writes and refuses.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;
using test::SmallPart;

TEST(PiecesCommand, SaysInWordsHowManyPiecesAndWhich) {
  const SmallPart part;
  const auto run = run_moldlight({"pieces", part.file(), "--unit", "mm"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("The mold opens along ") || run.out.starts_with("Two pieces ")) << run.out;
  EXPECT_NE(run.out.find("Directions, in the order of removal"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("Seams between the pieces"), std::string::npos) << run.out;
}

TEST(PiecesCommand, JsonHasAllKeysAndAgreesWithItself) {
  const SmallPart part;
  const auto json = json_of(run_moldlight({"pieces", part.file(), "--json", "-"}).out);
  EXPECT_EQ(json["schema"], "moldlight.pieces/1");
  for (const std::string key : {"directions", "count", "lower_bound", "proved", "left", "seams", "pieces",
                                "void", "verdict", "optimal", "elapsed_s", "settings", "part"})
    EXPECT_TRUE(json.contains(key)) << key;
  ASSERT_EQ(json["count"], json["directions"].size());
  EXPECT_LE(json["lower_bound"], json["count"]);
  EXPECT_EQ(json["proved"].get<bool>(), json["lower_bound"] == json["count"]);
  double area = json["left"]["area"];
  for (std::size_t k = 0; k < json["directions"].size(); ++k) {
    EXPECT_EQ(json["directions"][k]["order"], k + 1);
    area += json["directions"][k]["area"].get<double>();
    const auto patches =
        std::ranges::count_if(json["pieces"], [&](const auto& piece) { return piece["order"] == k + 1; });
    EXPECT_EQ(json["directions"][k]["components"], static_cast<std::size_t>(patches));
  }
  const double whole = json["part"]["area"];
  EXPECT_NEAR(area, whole, 1e-3 * whole);
}

TEST(PiecesCommand, IsTheSameWithAnyNumberOfThreads) {
  const SmallPart part;
  const auto without_time = [](nlohmann::json json) {
    json.erase("elapsed_s");
    return json.dump();
  };
  const auto once = json_of(run_moldlight({"pieces", part.file(), "--json", "-"}).out);
  test::ProcessSettings one_thread;
  one_thread.environment = {"MOLDLIGHT_THREADS=1"};
  const auto again = json_of(run_moldlight({"pieces", part.file(), "--json", "-"}, one_thread).out);
  EXPECT_EQ(without_time(once), without_time(again));
}

TEST(PiecesCommand, WritesThePartInColoursAndTheSeamsAsLines) {
  const SmallPart part;
  for (const std::string extension : {"ply", "obj", "stl", "glb", "vtp"}) {
    const auto run = run_moldlight({"pieces", part.file(), "--mesh", part.output("pieces." + extension)});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_GT(test::file_bytes(part.output("pieces." + extension)).size(), 1000U);
  }
  EXPECT_NE(test::file_bytes(part.output("pieces.obj")).find("piece_1"), std::string::npos);
  std::vector<std::string> words = {"pieces", part.file()};
  for (const std::string extension : {"dxf", "svg", "obj", "csv", "step"})
    words.insert(words.end(), {"--lines", part.output("seams." + extension)});
  const auto run = run_moldlight(words);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(test::file_bytes(part.output("seams.dxf")).find("SEAM"), std::string::npos);
  EXPECT_NE(test::file_bytes(part.output("seams.step")).find("seams of mold pieces"), std::string::npos);
  EXPECT_NE(test::file_bytes(part.output("seams.csv")).find("1,seam,"), std::string::npos);
  EXPECT_NE(test::file_bytes(part.output("seams.step")).find("POLYLINE('seam'"), std::string::npos);
}

TEST(PiecesCommand, WritesSolidsAndAPictureOfThem) {
  const SmallPart part;
  const std::string folder = part.output("mold");
  std::filesystem::create_directories(folder);
  for (const std::string name : {"piece_9.stl", "piece_3_7.stl", "left_1.stl", "piece_mine.stl"})
    std::ofstream(folder + "/" + name) << "old";
  const auto run =
      run_moldlight({"pieces", part.file(), "--out", folder, "--3mf", "--step-bodies", "--shrink", "1",
                     "--image", part.output("pieces.png"), "--size", "320x200", "--html",
                     part.output("pieces.html"), "--json", part.output("pieces.json")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(test::file_bytes(part.output("pieces.json")));
  ASSERT_GE(json["solids"]["bodies"].size(), 2U);
  double volume = json["part"]["volume"].get<double>() / std::pow(0.99, 3.0);
  std::set<std::string> files;
  for (const auto& body : json["solids"]["bodies"]) {
    EXPECT_TRUE(body["closed"]);
    EXPECT_EQ(body["file"], folder + "/" + body["name"].get<std::string>() + ".stl");
    EXPECT_GT(test::file_bytes(body["file"]).size(), 84U);
    files.insert(std::filesystem::path(body["file"].get<std::string>()).filename());
    volume += body["volume"].get<double>();
  }
  const double block = json["solids"]["block_volume"];
  EXPECT_NEAR(volume, block, 1e-6 * block);
  // What a former run left is gone, what it did not write stays.
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(files.contains(name) || name == "mold.3mf" || name == "mold.step" || name == "piece_mine.stl")
        << name;
  }
  EXPECT_TRUE(std::filesystem::exists(folder + "/piece_mine.stl"));
  EXPECT_NE(run.out.find("Pieces as solids"), std::string::npos) << run.out;
  EXPECT_TRUE(test::file_bytes(part.output("pieces.png")).starts_with("\x89PNG"));
  EXPECT_NE(test::file_bytes(part.output("pieces.html")).find("Open the mold"), std::string::npos);
}

TEST(PiecesCommand, TakesDirectionsOfTheUser) {
  const SmallPart part;
  const auto fixed =
      json_of(run_moldlight({"pieces", part.file(), "--fixed", "-y", "--fixed", "0,0,3", "--json", "-"}).out);
  ASSERT_GE(fixed["directions"].size(), 2U);
  EXPECT_EQ(fixed["directions"][0]["direction"], (std::array<double, 3>{0.0, -1.0, 0.0}));
  EXPECT_EQ(fixed["directions"][1]["direction"], (std::array<double, 3>{0.0, 0.0, 1.0}));
  std::ofstream(part.output("more.csv")) << "0.1,0.2,1\n1,1,0\n";
  const auto more = run_moldlight({"pieces", part.file(), "--directions", part.output("more.csv")});
  EXPECT_EQ(more.exit_code, 0) << more.err;
}

TEST(PiecesCommand, MeasuresAFlexibleMold) {
  const SmallPart part;
  const auto run = run_moldlight({"pieces", part.file(), "--fixed", "x", "--fixed", "-x", "--max", "2",
                                  "--elongation", "400", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(run.out);
  EXPECT_EQ(json["settings"]["elongation_pct"], 400.0);
  EXPECT_EQ(json["flexible"]["undercuts"].empty(), json["verdict"]["state"] != "stretched");
  for (const auto& undercut : json["flexible"]["undercuts"])
    EXPECT_TRUE(undercut["order"] == 1 || undercut["order"] == 2);
  EXPECT_TRUE(json_of(run_moldlight({"pieces", part.file(), "--json", "-"}).out)["flexible"].is_null());
}

TEST(PiecesCommand, RefusesWhatMakesNoSenseInOneLine) {
  const SmallPart part;
  const std::vector<std::pair<std::vector<std::string>, int>> refused = {
      {{"pieces"}, 2},
      {{"pieces", part.file(), "--eps", "2"}, 2},
      {{"pieces", part.file(), "--max", "0"}, 2},
      {{"pieces", part.file(), "--fixed", "0,0,0"}, 2},
      {{"pieces", part.file(), "--elongation", "-1"}, 2},
      {{"pieces", part.file(), "--cosmetic", "0:1"}, 2},
      {{"pieces", part.file(), "--cosmetic", "9:0"}, 2},
      {{"pieces", part.file(), "--cosmetic", "99999"}, 2},
      {{"pieces", part.file(), "--max", "1", "--fixed", "x", "--fixed", "y"}, 2},
      {{"pieces", part.file(), "--directions", part.output("none.csv")}, 1},
      {{"pieces", part.file(), "--lines", part.output("seams.png")}, 2},
      {{"pieces", part.output("none.stl")}, 1}};
  for (const auto& [words, code] : refused) {
    const auto run = run_moldlight(words);
    EXPECT_EQ(run.exit_code, code) << words.back() << "\n" << run.err;
    EXPECT_EQ(run.error_lines(), 1U) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace moldlight
