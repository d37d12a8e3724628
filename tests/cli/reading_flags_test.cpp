// Flags for how a part is read: unit, body, repair, tables of faces.
#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"
#include "support/boxes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;
using test::ScratchFolder;

/// Two cubes as two solids; with `gap`, the corner that the second shares with nothing is moved for one
/// facet.
std::string two_cubes(double gap) {
  std::ostringstream text;
  text.precision(17);
  int number = 0;
  for (const double side : {1.0, 2.0}) {
    const std::string name = number == 0 ? "small" : "large";
    const double x = 5.0 * number++;
    std::vector<glm::dvec3> corners = test::box_corners({x, 0, 0}, {x + side, side, side});
    if (name == "large") corners[0].y -= gap;
    text << "solid " << name << "\n";
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      text << "facet normal 0 0 0\nouter loop\n";
      for (std::size_t k = i; k < i + 3; ++k) {
        text << "vertex " << corners[k].x << " " << corners[k].y << " " << corners[k].z << "\n";
      }
      text << "endloop\nendfacet\n";
    }
    text << "endsolid " << name << "\n";
  }
  return text.str();
}

nlohmann::ordered_json info(const std::string& file, std::vector<std::string> more) {
  more.insert(more.begin(), {"info", file, "--json", "-"});
  const auto run = run_moldlight(more);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return run.exit_code == 0 ? json_of(run.out) : nlohmann::ordered_json();
}

TEST(ReadingFlags, ChooseABodyByNumberOrName) {
  const ScratchFolder folder;
  const std::string file = folder.write("cubes.stl", two_cubes(0.0));
  const auto all = info(file, {});
  EXPECT_EQ(all["part"]["area"], 30.0);
  ASSERT_EQ(all["bodies"].size(), 2u);
  EXPECT_EQ(all["bodies"][1]["name"], "large");
  EXPECT_EQ(info(file, {"--body", "1"})["part"]["area"], 6.0);
  EXPECT_EQ(info(file, {"--body", "large"})["part"]["area"], 24.0);
  const std::string csv = folder.file("large.csv");
  const auto run = run_moldlight({"classify", file, "--direction", "0,0,1", "--body", "2", "--facets", csv,
                                  "--samples", "1000", "--resolution", "64"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(test::file_bytes(csv).find("\n12,"), std::string::npos)
      << "facets keep their numbers in the file";
  EXPECT_EQ(test::file_bytes(csv).find("\n11,"), std::string::npos);
  const auto unknown = run_moldlight({"info", file, "--body", "medium"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("large"), std::string::npos) << unknown.err;
}

TEST(ReadingFlags, NameTheUnit) {
  const ScratchFolder folder;
  const std::string file = folder.write("cubes.stl", two_cubes(0.0));
  EXPECT_TRUE(info(file, {})["part"]["unit"].is_null());
  EXPECT_EQ(info(file, {"--unit", "mm"})["part"]["unit"], "mm");
  const auto run =
      run_moldlight({"classify", file, "--direction", "0,0,1", "--unit", "mm", "--samples", "1000"});
  EXPECT_NE(run.out.find("area mm²"), std::string::npos) << run.out;
  EXPECT_EQ(run_moldlight({"info", file, "--unit", "furlong"}).exit_code, 2);
}

TEST(ReadingFlags, RepairOnRequestAndSayWhatWasDone) {
  const ScratchFolder folder;
  const std::string file = folder.write("cubes.stl", two_cubes(1e-7));
  const auto open = info(file, {});
  EXPECT_EQ(open["part"]["closed"], false);
  EXPECT_TRUE(open["part"]["repairs"].empty());
  const auto welded = info(file, {"--repair", "weld"});
  EXPECT_EQ(welded["part"]["closed"], true);
  EXPECT_FALSE(welded["part"]["repairs"].empty());
  EXPECT_EQ(info(file, {"--repair", "weld", "--weld-tolerance", "1e-9"})["part"]["closed"], false);
  for (const char* bad : {"some", ""}) EXPECT_EQ(run_moldlight({"info", file, "--repair", bad}).exit_code, 2);
  for (const char* flag : {"--weld-tolerance", "--linear-deflection", "--angular-deflection"}) {
    for (const char* bad : {"0", "-1", "nan"}) {
      EXPECT_EQ(run_moldlight({"info", file, flag, bad}).exit_code, 2) << flag << " " << bad;
    }
  }
}

TEST(ReadingFlags, StepPartsTellTheirFaces) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  const std::string file = (*shared / "parts" / "trimesh_featuretype.step").string();
  const ScratchFolder folder;
  const auto run = run_moldlight({"classify", file, "--direction", "0,0,1", "--faces",
                                  folder.file("faces.csv"), "--json", "-", "--angular-deflection", "15"});
  if (run.err.find("no STEP support") != std::string::npos) GTEST_SKIP() << "a build without STEP";
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(run.out);
  ASSERT_EQ(json["faces"].size(), 96u);
  double core = 0.0, area = 0.0;
  for (const auto& face : json["faces"]) {
    core += face["core"].get<double>();
    area += face["area"].get<double>();
  }
  EXPECT_NEAR(area, json["areas"]["total"].get<double>(), 1e-6 * area);
  EXPECT_NEAR(core, json["areas"]["core"].get<double>(), 1e-6 * area);
  const std::string csv = test::file_bytes(folder.file("faces.csv"));
  EXPECT_TRUE(csv.starts_with("face,area,core_share,cavity_share,both_share,undercut_share\n0,"))
      << csv.substr(0, 80);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 97);
}

}  // namespace
}  // namespace moldlight
