// What `moldlight sweep` puts out.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/shown_text.hpp"
#include "cli/small_part.hpp"
#include "cli/sweep_runs.hpp"
#include "support/boxes.hpp"
#include "support/read_png.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::json_of;
using test::keys;
using test::run_moldlight;
using test::SmallPart;
using test::sweep_of;
using test::with;
using test::without_time;
using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

/// But for lines of progress, which a slow machine has time for.
std::string beside_progress(const std::string& err) {
  std::string rest;
  std::istringstream lines(err);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" % ") == std::string::npos) rest += line + "\n";
  }
  return rest;
}

std::vector<Names> csv_rows(const std::string& path) {
  std::vector<Names> rows;
  std::istringstream lines(file_bytes(path));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    Names row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    rows.push_back(row);
  }
  return rows;
}

TEST(SweepCommand, PrintsATableAndNothingElseOnStdout) {
  const SmallPart part;
  const auto run = run_moldlight(part.sweep());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(beside_progress(run.err), "");
  for (const char* word : {"\ncup.obj best along ", "undercut unit²", "± unit²", "undercuts"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " in\n" << run.out;
  // The sentences below it are the terminal's to break.
  std::istringstream lines(run.out.substr(0, run.out.find("\n\n", run.out.find("\n\n") + 1)));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(letters_of(line).size(), 80U) << line;
  const std::string wide = run_moldlight(part.sweep({"--wide"})).out;
  for (const char* word : {"projected unit²", "tilt", "Pareto", "z-axis of the file"})
    EXPECT_NE(wide.find(word), std::string::npos) << word << " in\n" << wide;
  EXPECT_NE(run.out.find(" < 0.0"), std::string::npos) << "rounding is more than 0.0 in\n" << run.out;
  EXPECT_EQ(run.out.find("e-"), std::string::npos) << "no exponents in\n" << run.out;
  EXPECT_EQ(run.out.find("clamp force"), std::string::npos) << "without a pressure";
  EXPECT_EQ(run_moldlight(part.sweep({"--verbose"})).out, run.out);
  EXPECT_EQ(run_moldlight(part.sweep({"--quiet", "--jobs", "1"})).out, run.out);
}

TEST(SweepCommand, JsonHasTheKeysOfTheSchema) {
  const SmallPart part;
  const Json json = sweep_of(part.sweep({"--json", "-", "--pressure", "30"}));
  EXPECT_EQ(json["schema"], "moldlight.sweep/3");
  EXPECT_EQ(keys(json), (Names{"schema", "part", "settings", "evaluated", "skipped", "complete", "elapsed_s",
                               "remarks", "recommended", "candidates", "verdict"}));
  EXPECT_TRUE(json["recommended"].is_null()) << "not by an objective";
  EXPECT_EQ(json["complete"], true);
  EXPECT_GT(json["evaluated"].get<int>(), 60);
  ASSERT_GE(json["candidates"].size(), 2u);
  const Json& best = json["candidates"][0];
  const Names wanted = {"rank",
                        "tie_group",
                        "direction",
                        "sources",
                        "areas",
                        "undercut_uncertainty",
                        "projected_undercut",
                        "projected_area",
                        "draw_depth",
                        "near_vertical_area",
                        "reverse_draft",
                        "undercuts",
                        "tilt_margin_deg",
                        "pareto"};
  const Names found = keys(best);
  auto place = found.begin();
  for (const std::string& key : wanted) {
    place = std::find(place, found.end(), key);
    EXPECT_NE(place, found.end()) << key << " is missing or out of order";
  }
  EXPECT_EQ(keys(best["areas"]), (Names{"core", "cavity", "both", "undercut", "total", "near_vertical"}));
  EXPECT_EQ(best["rank"], 1);
  EXPECT_EQ(best["tie_group"], 1);
  EXPECT_TRUE(best["projected_undercut"].is_number());
  EXPECT_DOUBLE_EQ(best["clamp_force"].get<double>(), 30.0 * best["projected_area"].get<double>());
  EXPECT_EQ(best["sources"][0]["kind"], "axis");
  EXPECT_FALSE(json["settings"].contains("jobs")) << "the report does not depend on it";
}

TEST(SweepCommand, RecommendsAsAMoldMakerRanks) {
  const SmallPart part;
  const Json json = sweep_of(with(part.sweep({"--json", "-"}), "--rank", "mold"));
  const Json& recommended = json["recommended"];
  EXPECT_EQ(keys(recommended), (Names{"direction", "name", "why", "beside", "provisional"}));
  EXPECT_EQ(recommended["name"], "z") << "the cup opens upwards";
  EXPECT_EQ(recommended["direction"], Json({0.0, 0.0, 1.0}));
  EXPECT_EQ(recommended["provisional"], false);
  EXPECT_NE(recommended["why"].get<std::string>().find("The core is on the side of z"), std::string::npos);
  const Json& candidates = json["candidates"];
  ASSERT_GE(candidates.size(), 2U);
  EXPECT_EQ(candidates[0]["canonical"], "z");
  EXPECT_EQ(candidates[0]["name"], "z");
  EXPECT_TRUE(candidates[0]["rank_reasons"].empty());
  EXPECT_FALSE(candidates[1]["rank_reasons"].empty());
  const auto classified = run_moldlight(part.sweep({"--objective", "undercut", "--json", "-"}));
  EXPECT_TRUE(json_of(classified.out)["recommended"].is_null()) << "who names an objective ranks by it";
  const std::string table = run_moldlight(with(part.sweep(), "--rank", "mold")).out;
  EXPECT_NE(table.find("Recommended: z; "), std::string::npos) << table;
}

/// The figures of a sweep's candidates against classify, called with `classify` and its direction changed.
void expect_figures_of_classify(const Json& sweep, const Names& classify) {
  for (const Json& candidate : sweep["candidates"]) {
    std::string direction;
    for (const Json& component : candidate["direction"])
      direction += (direction.empty() ? "" : ",") + component.dump();
    const Json classified = json_of(run_moldlight(with(classify, "--direction", direction)).out);
    EXPECT_EQ(candidate["direction"].dump(), classified["direction"].dump());
    EXPECT_EQ(candidate["areas"].dump(), classified["areas"].dump()) << direction;
    EXPECT_EQ(candidate["fractions"].dump(), classified["fractions"].dump()) << direction;
    EXPECT_EQ(candidate["undercut_uncertainty"].dump(), classified["undercut_uncertainty"].dump())
        << direction;
    EXPECT_EQ(candidate["projected_undercut"].dump(), classified["projected_undercut"].dump());
    EXPECT_EQ(candidate["near_vertical_area"].dump(), classified["areas"]["near_vertical"].dump());
  }
}

TEST(SweepCommand, FinalFiguresAreThoseOfClassifyToTheLastDigit) {
  const SmallPart part;
  // A direction that no rounding suits.
  const Json json =
      sweep_of(part.sweep({"--json", "-", "--direction", "0.3,-0.7,0.11", "--tolerance", "0.02"}));
  ASSERT_GE(json["candidates"].size(), 2u);
  expect_figures_of_classify(json, part.classify({"--json", "-", "--tolerance", "0.02"}));
}

TEST(SweepCommand, IsTheSameWhateverTheJobs) {
  const SmallPart part;
  const std::string one = part.output("one.csv"), two = part.output("two.csv");
  const Json first = sweep_of(part.sweep({"--json", "-", "--jobs", "1", "--csv", one}));
  const Json second = sweep_of(part.sweep({"--json", "-", "--jobs", "2", "--csv", two}));
  EXPECT_EQ(without_time(first).dump(), without_time(second).dump());
  EXPECT_FALSE(file_bytes(one).empty());
  EXPECT_EQ(file_bytes(one), file_bytes(two));
}

TEST(SweepCommand, TheGlEngineDoesNotDependOnTheJobs) {
  const SmallPart part;
  const std::string one = part.output("one.csv"), three = part.output("three.csv");
  const Names arguments = with(part.sweep({"--json", "-"}), "--engine", "gl");
  const Json first = sweep_of(with(with(arguments, "--jobs", "1"), "--csv", one));
  const Json second = sweep_of(with(with(arguments, "--jobs", "3"), "--csv", three));
  EXPECT_EQ(first["settings"]["engine_used"].get<std::string>().rfind("gl (maps", 0), 0u);
  EXPECT_EQ(without_time(first).dump(), without_time(second).dump());
  EXPECT_FALSE(file_bytes(one).empty());
  EXPECT_EQ(file_bytes(one), file_bytes(three));
  const Json by_rays = sweep_of(with(arguments, "--engine", "rays"));
  EXPECT_EQ(first["candidates"][0]["areas"].dump(), by_rays["candidates"][0]["areas"].dump());
}

TEST(SweepCommand, ARealPartIsSweptAsItIsClassifiedWhateverTheJobs) {
  const SmallPart part;
  const std::string file = (test::asset_folder() / "parts" / "cable_clip.stl").string();
  const std::string one = part.output("one.csv"), three = part.output("three.csv");
  // Under the sanitizers the 134 directions that come of these take 5 s.
  const Names arguments = {"sweep", file, "--directions", "20", "--refine", "1", "--top", "2", "--json", "-"};
  const Json first = sweep_of(with(with(arguments, "--jobs", "1"), "--csv", one));
  const Json second = sweep_of(with(with(arguments, "--jobs", "3"), "--csv", three));
  EXPECT_EQ(without_time(first).dump(), without_time(second).dump());
  EXPECT_FALSE(file_bytes(one).empty());
  EXPECT_EQ(file_bytes(one), file_bytes(three));
  ASSERT_EQ(first["candidates"].size(), 2u);
  expect_figures_of_classify(first, {"classify", file, "--direction", "0,0,1", "--json", "-"});
}

TEST(SweepCommand, TinyUndercutsContradictNoVerdict) {
  const std::string file = (test::asset_folder() / "parts" / "tilted_bracket.stl").string();
  const auto run = run_moldlight({"sweep", file, "--candidates", "none", "--direction", "0.48,-0.36,0.8",
                                  "--objective", "undercut", "--refine", "0"});
  EXPECT_TRUE(run.out.starts_with("Two-plate mold: no undercut.\n")) << run.out;
  EXPECT_NE(run.out.find("\nThe best direction has no undercut but tiny ones, "), std::string::npos)
      << run.out;
}

TEST(SweepCommand, CsvHoldsEveryEvaluatedDirection) {
  const SmallPart part;
  const std::string csv = part.output("all.csv");
  const Json json = sweep_of(part.sweep({"--json", "-", "--csv", csv, "--thorough"}));
  const std::vector<Names> rows = csv_rows(csv);
  ASSERT_FALSE(rows.empty());
  EXPECT_EQ(rows[0], (Names{"x", "y", "z", "kind", "undercut", "undercut_error", "given_up"}));
  EXPECT_EQ(rows.size() - 1, json["evaluated"].get<std::size_t>());
  std::size_t uniform = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 7u);
    const double x = std::stod(rows[i][0]), y = std::stod(rows[i][1]), z = std::stod(rows[i][2]);
    EXPECT_NEAR(x * x + y * y + z * z, 1.0, 1e-12);
    EXPECT_GE(std::stod(rows[i][4]), 0.0);
    EXPECT_GT(std::stod(rows[i][5]), 0.0);
    if (rows[i][3] == "uniform") {
      ++uniform;
      EXPECT_EQ(rows[i][6], "0") << "thorough";
    }
  }
  EXPECT_GE(uniform, 55u);
}

TEST(SweepCommand, TakesDirectionsByFlagAndFile) {
  const SmallPart part;
  const std::string list = part.folder().write("list.csv", "x,y,z\n0,3,4\n# none\n1,1,0\n");
  Names arguments = with(with(part.sweep({"--json", "-"}), "--refine", "0"), "--top", "1");
  arguments = with(with(arguments, "--candidates", "none"), "--directions-file", list);
  arguments.insert(arguments.end(), {"--direction", "-1,0,0", "--direction", "0,0,1"});
  const Json json = sweep_of(arguments);
  EXPECT_EQ(json["evaluated"], 4);
  ASSERT_EQ(json["candidates"].size(), 4u) << "what the user gives is listed";
  EXPECT_EQ(json["candidates"][0]["direction"], (Json{0.0, 0.0, 1.0}));
  for (const Json& candidate : json["candidates"]) EXPECT_EQ(candidate["sources"][0]["kind"], "user");
  const auto says_best = [](const Json& remark) {
    return remark.get<std::string>().starts_with("The given direction, z, is already best. The next has ");
  };
  EXPECT_EQ(std::ranges::count_if(json["remarks"], says_best), 1) << json["remarks"];
}

TEST(SweepCommand, RefusesWhatMakesNoSense) {
  const SmallPart part;
  const std::vector<std::pair<std::string, std::string>> values = {{"--direction", "0,0,0"},
                                                                   {"--direction", "nan,0,1"},
                                                                   {"--candidates", "axis,feather"},
                                                                   {"--objective", "beauty"},
                                                                   {"--objective", "undercut:-1"},
                                                                   {"--objective", "undercut:0"},
                                                                   {"--top", "0"},
                                                                   {"--directions", "-1"},
                                                                   {"--refine", "101"},
                                                                   {"--engine", "steam"},
                                                                   {"--jobs", "-1"},
                                                                   {"--time-limit", "-1"},
                                                                   {"--tilt-growth", "0"},
                                                                   {"--candidates", "none"}};
  for (const auto& [flag, value] : values) {
    const auto run = run_moldlight(with(part.sweep(), flag, value));
    EXPECT_EQ(run.exit_code, 2) << flag << " " << value << ": " << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(flag), std::string::npos) << run.err;
  }
}

TEST(SweepCommand, FindsUnwritableOutputsBeforeTheWork) {
  const SmallPart part;
  for (const auto& [flag, path] :
       std::vector<std::pair<std::string, std::string>>{{"--json", part.output("no/such/a.json")},
                                                        {"--csv", part.output("no/such/a.csv")},
                                                        {"--csv", part.file()},
                                                        {"--image-dir", part.file() + "/below"}}) {
    auto arguments = part.sweep({flag, path, "--verbose"});
    const auto run = run_moldlight(arguments);
    EXPECT_TRUE(run.exit_code == 1 || run.exit_code == 2) << run.exit_code << run.err;
    EXPECT_EQ(run.error_lines(), 1u) << "nothing was read yet: " << run.err;
  }
}

TEST(SweepCommand, DrawsPicturesIntoAFolder) {
  const SmallPart part;
  const std::string folder = part.output("new/pictures");
  const Names arguments = part.sweep({"--image-dir", folder, "--size", "640x400", "--json", "-"});
  const Json json = sweep_of(arguments);
  EXPECT_EQ(json["settings"]["thorough"], true) << "the map shows figures, not bounds";
  const std::string sphere_file = folder + "/direction_sphere.png",
                    sheet_file = folder + "/contact_sheet.png";
  const Image sphere = test::read_png(sphere_file), sheet = test::read_png(sheet_file);
  EXPECT_EQ(sphere.width, 640);
  EXPECT_EQ(sphere.height, 400);
  EXPECT_GT(sheet.width, sheet.height) << "four tiles in a row";
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_TRUE(entry.path() == sphere_file || entry.path() == sheet_file) << entry;
  }
  // Again, with other colours: what was there is replaced, and the sphere's colours are for every eye.
  const std::string before = file_bytes(sphere_file), sheet_before = file_bytes(sheet_file);
  (void)sweep_of(with(arguments, "--palette", "safe"));
  EXPECT_EQ(file_bytes(sphere_file), before);
  EXPECT_NE(file_bytes(sheet_file), sheet_before);
  (void)sweep_of(with(arguments, "--theme", "dark"));
  EXPECT_NE(file_bytes(sphere_file), before);
  EXPECT_EQ(run_moldlight(part.sweep({"--theme", "dark"})).exit_code, 2) << "nothing to draw";
}

TEST(SweepCommand, PutsOutWhatIsDoneWhenInterrupted) {
  const SmallPart part;
  const std::string json = part.output("a.json"), csv = part.output("a.csv");
  const std::string folder = part.output("pictures");
  std::vector<std::string> arguments =
      part.sweep({"--json", json, "--csv", csv, "--image-dir", folder, "--verbose"});
  arguments.insert(arguments.begin(), MOLDLIGHT_BINARY);
  arguments = with(arguments, "--directions", "100000");
  test::Process process(arguments, {});
  ASSERT_TRUE(process.wait_for_error_text("scoring"));
  process.send_signal(SIGINT);
  const auto result = process.finish();
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
  const Json report = json_of(file_bytes(json));
  EXPECT_EQ(report["complete"], false);
  EXPECT_EQ(csv_rows(csv).size() - 1, report["evaluated"].get<std::size_t>());
  EXPECT_LT(report["evaluated"].get<std::size_t>(), 100'000u);
  for (const Json& candidate : report["candidates"]) EXPECT_EQ(candidate["measured"], false) << candidate;
  EXPECT_TRUE(fs::exists(folder + "/direction_sphere.png"));
  EXPECT_FALSE(fs::exists(folder + "/contact_sheet.png"));
  EXPECT_NE(result.err.find("contact_sheet.png was not drawn"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("not complete"), std::string::npos) << result.out;
  EXPECT_LT(result.processor_s, 60.0);
}

TEST(SweepCommand, EndsAtTheTimeLimitWithAWarning) {
  const SmallPart part;
  const auto run =
      run_moldlight(with(part.sweep({"--json", "-", "--time-limit", "0.01"}), "--directions", "100000"));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("time limit"), std::string::npos) << run.err;
  const Json report = json_of(run.out);
  EXPECT_EQ(report["complete"], false);
  EXPECT_GE(report["candidates"].size(), 1u) << "the best so far gets its figures";
  EXPECT_LT(run.processor_s, test::built_with_sanitizers() ? 60.0 : 20.0);
}

TEST(SweepCommand, TimeThatSufficesIsNoLimit) {
  const SmallPart part;
  const auto run = run_moldlight(part.sweep({"--json", "-", "--time-limit", "1000"}));
  EXPECT_EQ(beside_progress(run.err), "");
  EXPECT_EQ(json_of(run.out)["complete"], true);
}

TEST(SweepCommand, DirectionsOfACubeTie) {
  const SmallPart part;
  const std::string cube = part.output("cube.obj");
  const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {10, 10, 10});
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  write_coloured_mesh(cube, {mesh, regions});
  const auto arguments = with(part.sweep({"--json", "-"}), "PART", cube);
  const Json json = sweep_of(arguments);
  ASSERT_EQ(json["candidates"].size(), 4u);
  for (const Json& candidate : json["candidates"]) {
    EXPECT_EQ(candidate["tie_group"], 1) << candidate;
    EXPECT_EQ(candidate["areas"]["undercut"], 0.0);
    EXPECT_EQ(candidate["undercuts"], 0);
    EXPECT_EQ(candidate["tilt_margin_deg"], 30.0) << "at least";
    EXPECT_TRUE(candidate["tilt_toward"].is_null());
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(json["candidates"][i]["draw_depth"].get<double>(), 10.0, 1e-9) << "axes before others";
  }
}

TEST(SweepCommand, APartWithoutAreaHasDirectionsWithoutArea) {
  const SmallPart part;
  const std::string flat =
      part.folder().write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 0 0\nf 1 2 3\nf 1 4 3\n");
  const auto arguments = with(part.sweep({"--json", "-"}), "PART", flat);
  const auto run = run_moldlight(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = json_of(run.out);
  EXPECT_EQ(json["complete"], true);
  for (const Json& candidate : json["candidates"]) EXPECT_EQ(candidate["areas"]["undercut"], 0.0);
  EXPECT_EQ(run_moldlight({"sweep", flat, "--directions", "10"}).exit_code, 0);
  EXPECT_EQ(run_moldlight({"sweep", flat, "--directions", "10", "--engine", "gl"}).exit_code, 0);
}

/// Figures by CAD face are those of one direction alone.
TEST(SweepCommand, APartOfCadFacesHasAReport) {
  if (!MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built without OpenCASCADE";
  const SmallPart part;
  const std::string step = (test::data_folder() / "pins_assembly_mm.step").string();
  const Json json = sweep_of(with(part.sweep({"--json", "-"}), "PART", step));
  EXPECT_EQ(json["part"]["format"], "STEP");
  ASSERT_EQ(json["candidates"].size(), 4u);
}

TEST(SweepCommand, MoreThreadsThanCoresAreNoMatterOfStderr) {
  const SmallPart part;
  const auto run = run_moldlight(part.sweep({"--jobs", "64", "--quiet"}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
}

}  // namespace
}  // namespace moldlight
