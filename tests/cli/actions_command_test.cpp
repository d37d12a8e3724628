// moldlight actions, as a user runs it.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"
#include "support/process.hpp"
#include "support/read_png.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;
using test::ScratchFolder;

class Actions : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> actions(std::vector<std::string> more) const {
    more.insert(more.begin(), {"actions", part.file(), "--direction", "z", "--unit", "mm"});
    return more;
  }
  test::SmallPart part;
};

/// The cup's hole in its wall.
TEST_F(Actions, AreToldInATable) {
  const auto run = run_moldlight(actions({}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("\nslide 1, recess "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("travel mm"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("No cheaper set"), std::string::npos) << run.out;
}

TEST_F(Actions, AreToldInJson) {
  const auto run = run_moldlight(actions({"--json", "-", "--clearance", "5"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = json_of(run.out);
  EXPECT_EQ(json["schema"], "moldlight.actions/2");
  EXPECT_EQ(json["settings"]["clearance_mm"], 5.0);
  EXPECT_EQ(json["settings"]["tau_deg"], 1.0);
  ASSERT_EQ(json["undercuts"].size(), 1U);
  for (const char* key :
       {"id", "area", "formed_area", "centre", "size_across", "size_along", "depth", "side", "blocked_by"})
    EXPECT_TRUE(json["undercuts"][0].contains(key)) << key;
  ASSERT_EQ(json["actions"].size(), 1U);
  const auto& action = json["actions"][0];
  for (const char* key : {"kind", "direction", "interval_deg", "travel", "stroke", "axis", "pitch", "turns",
                          "strain", "undercuts", "area", "side", "clear_to", "meets"})
    EXPECT_TRUE(action.contains(key)) << key;
  EXPECT_EQ(action["kind"], "slide");
  EXPECT_TRUE(action["stroke"].is_null());
  EXPECT_TRUE(action["clear_to"].is_null());
  EXPECT_EQ(action["undercuts"], nlohmann::ordered_json::array({1}));
  EXPECT_NEAR(action["travel"].get<double>() - json["undercuts"][0]["depth"].get<double>(), 5.0, 1e-9);
  EXPECT_EQ(json["unreleased"]["area"], 0.0);
  EXPECT_TRUE(json["optimal"].get<bool>());
  EXPECT_GT(action["body"]["volume"].get<double>(), 0.0);
  EXPECT_GT(action["body"]["least_section"].get<double>(), 0.0);
  EXPECT_TRUE(action["body"]["file"].is_null());
  EXPECT_EQ(action["clear"], true);
  EXPECT_EQ(run_moldlight(actions({"--json", "-", "--clearance", "5"})).out, run.out)
      << "the same every time";
}

TEST_F(Actions, AreToldInATableOfUndercuts) {
  const std::string csv = part.output("undercuts.csv");
  const auto run = run_moldlight(actions({"--csv", csv}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string text = test::file_bytes(csv);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_NE(text.find(",slide,"), std::string::npos) << text;
}

TEST_F(Actions, AreWrittenAsMeshBodiesAndPicture) {
  const std::string mesh = part.output("actions.obj"), bodies = part.output("bodies"),
                    image = part.output("actions.png");
  const auto run = run_moldlight(actions({"--mesh", mesh, "--bodies", bodies, "--step-bodies", "--image",
                                          image, "--size", "320x200", "--json", "-"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(test::file_bytes(mesh).find("\nusemtl slide_1\n"), std::string::npos);
  const std::filesystem::path body =
      std::filesystem::path(bodies) / (std::filesystem::path(part.file()).stem().string() + "_slide_1.stl");
  const auto info = run_moldlight({"info", body.string(), "--json", "-"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  const auto of_file = json_of(info.out)["part"], of_body = json_of(run.out)["actions"][0]["body"];
  EXPECT_TRUE(of_file["closed"].get<bool>()) << info.out;
  const std::string step = std::filesystem::path(part.file()).stem().string() + "_actions.step";
  EXPECT_NE(test::file_bytes(bodies + "/" + step).find("MANIFOLD_SOLID_BREP('slide_1',"), std::string::npos);
  EXPECT_EQ(of_body["file"], body.string());
  EXPECT_NEAR(of_body["volume"].get<double>(), of_file["volume"].get<double>(),
              1e-4 * of_file["volume"].get<double>());
  const Image with = test::read_png(image);
  EXPECT_EQ(with.width, 320);
  ASSERT_EQ(run_moldlight({"classify", part.file(), "--direction", "z", "--unit", "mm", "--image", image,
                           "--size", "320x200"})
                .exit_code,
            0);
  EXPECT_NE(test::read_png(image).rgba, with.rgba) << "the slide is seen";
  EXPECT_EQ(run_moldlight(actions({"--mesh", part.output("actions.txt")})).exit_code, 2);
  EXPECT_EQ(run_moldlight(actions({"--mesh", mesh, "--csv", mesh})).exit_code, 2) << "one file for two";
}

TEST_F(Actions, TakeWhatTheUserAllows) {
  const auto flags = [&](const std::string& flag, const std::string& value) {
    return run_moldlight(actions({flag, value}));
  };
  EXPECT_EQ(flags("--side-direction", "1,0,0").exit_code, 0);
  EXPECT_EQ(flags("--side-direction", "0,0,0").exit_code, 2);
  EXPECT_EQ(flags("--slide-angle", "91").exit_code, 2);
  EXPECT_EQ(flags("--lifter-angle", "0").exit_code, 2);
  const auto same = run_moldlight(actions({"--csv", part.file()}));
  EXPECT_EQ(same.exit_code, 2) << "the part is not overwritten";
}

}  // namespace
}  // namespace moldlight
