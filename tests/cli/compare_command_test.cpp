// moldlight compare, as a user runs it.
#include <sstream>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/mesh_edits.hpp"
#include "support/read_png.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;

/// A bar with a groove in its side, which is an undercut along z; the groove's depth is what a revision
/// changes.
class Compare : public ::testing::Test {
 protected:
  [[nodiscard]] std::string bar(const std::string& name, double groove, double scale = 1.0) const {
    test::SolidBuilder solid;
    if (groove > 0.0) {
      solid.extrude(
          {{0, 0}, {20, 0}, {20, 4}, {20 - groove, 4}, {20 - groove, 8}, {20, 8}, {20, 12}, {0, 12}}, {},
          30.0);
    } else {
      solid.extrude({{0, 0}, {20, 0}, {20, 12}, {0, 12}}, {}, 30.0);
    }
    return write(name, test::scaled(solid.mesh(), scale));
  }
  [[nodiscard]] std::string write(const std::string& name, const TriangleMesh& mesh) const {
    const std::vector<Region> regions(mesh.facets.size(), Region::core);
    write_coloured_mesh(folder.file(name), {mesh, regions});
    return folder.file(name);
  }
  [[nodiscard]] static test::ProcessResult compare(const std::string& a, const std::string& b,
                                                   std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"compare", a, b, "--unit", "mm"});
    if (std::ranges::find(more, "--direction") == more.end()) more.insert(more.end(), {"--direction", "z"});
    return run_moldlight(more);
  }
  test::ScratchFolder folder;
};

TEST_F(Compare, TellsNothingOfTheSamePart) {
  const auto run = compare(bar("a.obj", 3.0), bar("b.obj", 3.0));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("Nothing changed"), std::string::npos) << run.out;
}

TEST_F(Compare, TellsATableOfEightyColumns) {
  const auto run = compare(bar("a.obj", 2.0), bar("b.obj", 3.0));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("1 place changed"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("undercut"), std::string::npos);
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    const auto letters = std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
    if (line.find("changed") == std::string::npos) {
      EXPECT_LE(letters, 80) << line;
    }
  }
}

TEST_F(Compare, TellsJson) {
  const auto run = compare(bar("a.obj", 2.0), bar("b.obj", 3.0), {"--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(run.out);
  EXPECT_EQ(json["schema"], "moldlight.compare/1");
  for (const char* key : {"a", "b", "direction", "alignment", "surface", "places", "regions", "undercuts",
                          "actions", "verdict"})
    EXPECT_TRUE(json.contains(key)) << key;
  // The groove's bottom moves in by 1: its old one is gone, a new one is there, and both flanks grow by 1,
  // and so do the notches in the ends.
  const double flanks = 2.0 * 1.0 * 30.0, bottom = 4.0 * 30.0, ends = 2.0 * 1.0 * 4.0;
  EXPECT_NEAR(json["surface"]["new"]["area"].get<double>(), bottom + flanks, 0.05);
  EXPECT_NEAR(json["surface"]["gone"]["area"].get<double>(), bottom + ends, 0.05);
  EXPECT_NEAR(json["places"][0]["volume"].get<double>(), -1.0 * bottom, 0.05);
  EXPECT_EQ(compare(bar("a.obj", 2.0), bar("b.obj", 3.0), {"--json", "-"}).out, run.out)
      << "the same every time";
}

TEST_F(Compare, TellsAScaleAndVolumesThatAddUp) {
  const auto run = compare(bar("a.obj", 2.0), bar("b.obj", 2.0, 1.01), {"--json", "-", "--actions", "off"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(run.out);
  EXPECT_NEAR(json["scale"]["factor"].get<double>(), 1.01, 1e-6);
  EXPECT_TRUE(json["verdict"].get<std::string>().starts_with("B is A × 1.0100.")) << json["verdict"];
  double sum = json["surface"]["volume_elsewhere"];
  for (const auto& place : json["places"]) sum += place["volume"].get<double>();
  const double before = json["a"]["volume"], after = json["b"]["volume"];
  EXPECT_NEAR(sum, after - before, 1e-9 * after);
}

/// No share of nothing, no row of nothing, four digits everywhere.
TEST_F(Compare, TellsFiguresInOneWay) {
  const auto run = compare(bar("a.obj", 2.0), bar("b.obj", 3.0), {"--actions", "off"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* none : {"-0.00 %", "+0.00 %", " 0.0 ", "< "})
    EXPECT_EQ(run.out.find(none), std::string::npos) << run.out;
  const auto json = json_of(compare(bar("a.obj", 2.0), bar("b.obj", 3.0), {"--json", "-"}).out);
  EXPECT_NE(run.out.find(json["verdict"].get<std::string>().substr(0, 16)), std::string::npos);
}

TEST_F(Compare, TellsUndercutsAndActions) {
  const auto run = compare(bar("a.obj", 2.0), bar("b.obj", 3.0), {"--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(run.out);
  ASSERT_EQ(json["undercuts"].size(), 1U);
  const auto& undercut = json["undercuts"][0];
  EXPECT_EQ(undercut["change"], "grown");
  EXPECT_NEAR(undercut["b"]["depth"].get<double>() - undercut["a"]["depth"].get<double>(), 1.0, 0.05);
  ASSERT_EQ(json["actions"].size(), 1U);
  EXPECT_EQ(json["actions"][0]["change"], "changed") << "it travels by one more";
  EXPECT_NEAR(
      json["actions"][0]["b"]["travel"].get<double>() - json["actions"][0]["a"]["travel"].get<double>(), 1.0,
      0.05);

  const auto added = json_of(compare(bar("a.obj", 0.0), bar("b.obj", 3.0), {"--json", "-"}).out);
  ASSERT_EQ(added["undercuts"].size(), 1U);
  EXPECT_EQ(added["undercuts"][0]["change"], "new");
  EXPECT_TRUE(added["undercuts"][0]["a"].is_null());
  EXPECT_EQ(added["actions"][0]["change"], "new");
  const auto without =
      json_of(compare(bar("a.obj", 0.0), bar("b.obj", 3.0), {"--json", "-", "--actions", "off"}).out);
  EXPECT_TRUE(without["actions"].is_null());
}

TEST_F(Compare, EndsWithThreeWhereACriterionFails) {
  const std::string a = bar("a.obj", 2.0), b = bar("b.obj", 3.0);
  const auto failed = compare(a, b, {"--fail-on", "undercut > +1%, actions > 5"});
  EXPECT_EQ(failed.exit_code, 3);
  EXPECT_EQ(failed.error_lines(), 1U) << failed.err;
  EXPECT_NE(failed.err.find("undercut > +1%"), std::string::npos) << failed.err;
  EXPECT_EQ(compare(a, b, {"--fail-on", "actions > +0, gone > 2%"}).exit_code, 3);
  EXPECT_EQ(compare(a, b, {"--fail-on", "actions > +0"}).exit_code, 0);
  EXPECT_EQ(compare(a, a, {"--fail-on", "undercut > +0, new > 0, places > 0"}).exit_code, 0);
  for (const char* wrong : {"undercut", "weight > 1", "undercut > +x"}) {
    const auto run = compare(a, b, {"--fail-on", wrong});
    EXPECT_EQ(run.exit_code, 2) << wrong;
    EXPECT_EQ(run.error_lines(), 1U) << run.err;
  }
  EXPECT_EQ(compare(a, b, {"--actions", "off", "--fail-on", "actions > 0"}).exit_code, 2) << "not looked for";
}

/// The groove becomes deeper by 1: the slide that forms it needs steel.
TEST_F(Compare, TellsWhetherTheMoldSurvives) {
  const std::string a = bar("a.obj", 2.0), b = bar("b.obj", 3.0);
  const auto json = json_of(compare(a, b, {"--json", "-"}).out);
  const double steel = 1.0 * 4.0 * 30.0;
  EXPECT_NEAR(json["mold"]["steel_to_add"]["volume"].get<double>(), steel, 1e-9 * steel);
  EXPECT_EQ(json["mold"]["steel_to_cut"]["volume"], 0.0);
  EXPECT_TRUE(json["mold"]["sentence"].get<std::string>().starts_with(
      "No steel is cut. Steel is added at 1 place: 120 mm³ at (17.5, 15, 6) mm, slide 1."))
      << json["mold"]["sentence"];
  const auto& place = json["places"][0];
  EXPECT_TRUE(place["steel_to_cut"].is_null());
  EXPECT_EQ(place["steel_to_add"]["of"][0]["name"], "slide 1");
  EXPECT_NEAR(place["steel_to_add"]["depth"].get<double>(), 4.0, 1e-9);
  const auto back = json_of(compare(b, a, {"--json", "-"}).out);
  EXPECT_NEAR(back["mold"]["steel_to_cut"]["volume"].get<double>(), steel, 1e-9 * steel);
  EXPECT_EQ(back["mold"]["steel_to_add"]["volume"], 0.0);
  const auto text = compare(a, b).out;
  EXPECT_NE(text.find("Does the mold survive?"), std::string::npos) << text;
  EXPECT_TRUE(json_of(compare(a, a, {"--json", "-"}).out)["mold"]["sentence"].get<std::string>().starts_with(
      "No steel of the mold changes."));
  EXPECT_TRUE(json_of(compare(a, b, {"--direction", "best", "--actions", "off", "--json", "-"}).out)["mold"]
                  .is_null())
      << "it was not asked for";
}

TEST_F(Compare, FailsOnSteelAndOnTheVerdict) {
  const std::string a = bar("a.obj", 2.0), b = bar("b.obj", 3.0), none = bar("none.obj", 0.0);
  EXPECT_EQ(compare(a, b, {"--fail-on", "steel-to-add > 0"}).exit_code, 3);
  EXPECT_EQ(compare(a, b, {"--fail-on", "steel-to-add > 121, steel-to-cut > 0"}).exit_code, 0);
  EXPECT_EQ(compare(b, a, {"--fail-on", "steel-to-cut > 1%"}).exit_code, 3) << "of the part's volume";
  EXPECT_EQ(compare(a, b, {"--fail-on", "verdict > side-actions"}).exit_code, 0);
  const auto worse = compare(none, b, {"--fail-on", "verdict > two-plate"});
  EXPECT_EQ(worse.exit_code, 3);
  EXPECT_NE(worse.err.find("verdict was two-plate, is side-actions"), std::string::npos) << worse.err;
}

TEST_F(Compare, TellsAnotherUnit) {
  const auto run = compare(bar("a.obj", 2.0), bar("b.obj", 2.0, 1.0 / 25.4), {"--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("25.4 times as small"), std::string::npos) << run.out;
}

TEST_F(Compare, DrawsWhatDiffers) {
  const std::string a = bar("a.obj", 2.0), b = bar("b.obj", 3.0), image = folder.file("both.png");
  const auto draw = [&](const std::string& other) {
    const auto run = compare(a, other, {"--image", image, "--size", "400x160", "--view", "iso"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return test::read_png(image);
  };
  const Image same = draw(a), lit = draw(b);
  ASSERT_EQ(lit.width, 400);
  ASSERT_EQ(lit.height, 160);
  // Of A what is gone is lit, of B what is new.
  const auto pixels_that_differ = [&](int from, int to) {
    int count = 0;
    for (int y = 0; y < 160; ++y)
      for (int x = from; x < to; ++x)
        for (int c = 0; c < 3; ++c) {
          const auto at = static_cast<std::size_t>(4 * (400 * y + x) + c);
          if (std::abs(lit.rgba[at] - same.rgba[at]) > 24) ++count;
        }
    return count;
  };
  EXPECT_GT(pixels_that_differ(0, 200), 50);
  EXPECT_GT(pixels_that_differ(200, 400), 50);
  EXPECT_EQ(compare(a, b, {"--image", a}).exit_code, 2);
}

TEST_F(Compare, RefusesWhatMakesNoSense) {
  const std::string a = bar("a.obj", 2.0);
  for (const auto& more : std::vector<std::vector<std::string>>{
           {"--same-within", "-1"}, {"--same-within", "1e9"}, {"--direction", "up"}, {"--json", a}}) {
    const auto run = compare(a, bar("b.obj", 3.0), more);
    EXPECT_EQ(run.exit_code, 2) << more.front();
    EXPECT_EQ(run.error_lines(), 1U) << run.err;
  }
  const auto missing = compare(a, folder.file("none.stl"));
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(missing.error_lines(), 1U) << missing.err;
}

}  // namespace
}  // namespace moldlight
