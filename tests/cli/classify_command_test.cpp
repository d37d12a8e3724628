// What `moldlight classify` puts out.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/small_part.hpp"
#include "io/part_formats.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::json_of;
using test::keys;
using test::run_moldlight;
using test::SmallPart;
using test::with;
using Json = nlohmann::ordered_json;

TEST(Classify, PrintsATableAndNothingElseOnStdout) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* line : {"\nCore ", "\nCavity ", "\nBoth ", "\nUndercut ", "\nSurface ",
                           "\nCross-check         passed,", "the file names no unit; --unit sets it"}) {
    EXPECT_NE(run.out.find(line), std::string::npos) << line << " in\n" << run.out;
  }
  EXPECT_EQ(run.out.find('\033'), std::string::npos) << "colour on what is no terminal";
  EXPECT_EQ(run_moldlight(part.classify({"--quiet"})).out, run.out);
}

TEST(Classify, VerboseReportsTheTimeOfEachStageOnStderr) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--verbose"}));
  EXPECT_EQ(run.out, run_moldlight(part.classify()).out);
  const std::size_t last = run.err.rfind("\nmoldlight: ");
  ASSERT_NE(last, std::string::npos) << run.err;
  const std::string times = run.err.substr(last);
  for (const char* text : {"reading ", " s, ", " s in all\n"})
    EXPECT_NE(times.find(text), std::string::npos) << text << " in" << times;
}

TEST(Classify, JsonHasTheKeysOfTheSchema) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--json", "-"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = json_of(run.out);
  using Names = std::vector<std::string>;
  EXPECT_EQ(json["schema"], "moldlight.classify/2");
  EXPECT_EQ(keys(json),
            (Names{"schema", "part", "direction", "settings", "texel", "lateral_tolerance", "areas",
                   "fractions", "undercut_uncertainty", "uncertainty_parts", "sampled_facets",
                   "projected_area", "projected_undercut", "identity", "timings_ms", "verdict"}));
  EXPECT_EQ(keys(json["verdict"]), (Names{"state", "sentence", "undercuts", "undercut_area",
                                          "unreleased_area", "specks", "actions", "reasons"}));
  EXPECT_EQ(keys(json["part"]), (Names{"file", "format", "unit", "facets", "vertices", "components", "closed",
                                       "area", "volume", "bounds", "warnings", "repairs"}));
  EXPECT_EQ(keys(json["part"]["bounds"]), (Names{"min", "max"}));
  EXPECT_EQ(keys(json["areas"]), (Names{"core", "cavity", "both", "undercut", "total", "near_vertical"}));
  EXPECT_EQ(keys(json["fractions"]), (Names{"core", "cavity", "both", "undercut"}));
  EXPECT_EQ(keys(json["uncertainty_parts"]), (Names{"rounding", "mesh", "readout"}));
  EXPECT_EQ(keys(json["identity"]), (Names{"core", "cavity", "gap", "gap_limit", "agrees"}));
  EXPECT_EQ(keys(json["timings_ms"]), (Names{"load", "regions", "readout", "total"}));
  for (const char* key :
       {"tau_deg", "kernel", "edge_thickness", "resolution", "readout", "backend", "renderer"}) {
    EXPECT_TRUE(json["settings"].contains(key)) << key;
  }
  EXPECT_EQ(json["part"]["facets"], part.shape().mesh.facets.size());
  EXPECT_EQ(json["part"]["closed"], true);
  EXPECT_EQ(json["settings"]["resolution"], 256);
  EXPECT_EQ(json["settings"]["readout"], "exact");
  for (const char* key : {"kernel", "tolerance", "backend", "renderer"})
    EXPECT_TRUE(json["settings"][key].is_null()) << key;
}

TEST(Classify, TellsWhereDraftIsMissing) {
  const SmallPart part;
  const std::string table = part.output("draft.csv");
  const auto run = run_moldlight(part.classify({"--json", "-", "--required-draft", "2", "--draft", table}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = json_of(run.out);
  const Json& draft = json["draft"];
  EXPECT_EQ(keys(draft), (std::vector<std::string>{"required_deg", "rounding_deg", "below", "reverse",
                                                   "histogram", "finishes", "faces"}));
  // Its walls are upright: the halves form nothing else with too little draft.
  const double below =
      draft["below"]["core"]["area"].get<double>() + draft["below"]["cavity"]["area"].get<double>();
  EXPECT_GT(below, 0.0);
  EXPECT_EQ(draft["reverse"]["area"], 0.0);
  double walls = 0.0, binned = 0.0;
  for (const Json& wall : draft["faces"]) {
    EXPECT_NEAR(wall["turn_deg"].get<double>(), 2.0, 1e-6);
    walls += wall["area"].get<double>();
  }
  EXPECT_NEAR(walls, below, 1e-9 * below);
  for (const Json& bin : draft["histogram"]) {
    if (bin["from_deg"] < 2.0) binned += bin["core"].get<double>() + bin["cavity"].get<double>();
  }
  EXPECT_NEAR(binned, below, 1e-9 * below);
  const std::string text = file_bytes(table);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(text, '\n')), draft["faces"].size() + 1);
  EXPECT_EQ(run_moldlight(part.classify({"--draft", table})).exit_code, 2) << "it needs the angle";
  EXPECT_EQ(run_moldlight(part.classify({"--required-draft", "46"})).exit_code, 2);
}

TEST(Classify, AsksForDraftByFinish) {
  const SmallPart part;
  const auto json_with = [&](const std::string& finishes, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments =
        part.classify({"--json", "-", "--finish", part.folder().write("finish.csv", finishes)});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_moldlight(arguments);
  };
  const std::string table = part.output("walls.csv");
  const auto run = json_with("face,finish\n*,texture 0.05\n", {"--draft", table});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json draft = json_of(run.out)["draft"];
  ASSERT_EQ(draft["finishes"].size(), 1U);
  EXPECT_NEAR(draft["finishes"][0]["required_deg"].get<double>(), 2.0, 1e-9);
  EXPECT_GT(draft["finishes"][0]["below"]["area"].get<double>(), 0.0);
  EXPECT_NEAR(draft["finishes"][0]["below"]["area"].get<double>(),
              draft["below"]["core"]["area"].get<double>() + draft["below"]["cavity"]["area"].get<double>(),
              1e-6);
  for (const Json& wall : draft["faces"]) EXPECT_EQ(wall["finish"], "texture 0.05");
  EXPECT_NE(file_bytes(table).find(",texture 0.05\n"), std::string::npos);
  const Json inch = json_of(json_with("*,texture 0.0254 mm\n", {"--texture-rule", "inch"}).out);
  EXPECT_NEAR(inch["draft"]["finishes"][0]["required_deg"].get<double>(), 1.5, 1e-9);
  const auto wrong = json_with("0,polished\n1,shiny\n");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_EQ(wrong.error_lines(), 1U) << wrong.err;
  EXPECT_NE(wrong.err.find("line 2"), std::string::npos) << wrong.err;
  // The numbers are those of --faces, of a mesh, too.
  const std::string faces = part.output("faces.csv");
  ASSERT_EQ(run_moldlight(part.classify({"--faces", faces})).exit_code, 0);
  const std::string text = file_bytes(faces);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(text, '\n')),
            draft["finishes"][0]["faces"].get<std::size_t>() + 1);
}

TEST(Classify, JsonFiguresBelongTogether) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--direction", "3,0,4", "--json", "-"}));
  EXPECT_EQ(run.exit_code, 2) << "--direction was given twice";
  const auto arguments = with(part.classify({"--json", "-"}), "--direction", "3,0,4");
  const Json json = json_of(run_moldlight(arguments).out);
  EXPECT_DOUBLE_EQ(json["direction"][0].get<double>(), 0.6);
  EXPECT_DOUBLE_EQ(json["direction"][2].get<double>(), 0.8);
  const double total = json["areas"]["total"];
  EXPECT_DOUBLE_EQ(total, json["part"]["area"].get<double>());
  double sum = 0.0;
  for (const char* region : {"core", "cavity", "both", "undercut"}) {
    sum += json["areas"][region].get<double>();
    EXPECT_NEAR(json["fractions"][region].get<double>() * total, json["areas"][region].get<double>(),
                1e-9 * total);
  }
  EXPECT_NEAR(sum, total, 1e-9 * total);
  const Json& identity = json["identity"];
  EXPECT_EQ(identity["gap"].get<double>(), identity["core"].get<double>() - identity["cavity"].get<double>());
  EXPECT_EQ(identity["agrees"], true);
  EXPECT_EQ(json["projected_area"], std::max(identity["core"], identity["cavity"]));
  const Json& parts = json["uncertainty_parts"];
  EXPECT_EQ(json["undercut_uncertainty"], parts["rounding"]);
  EXPECT_GT(parts["rounding"], 0.0);
  EXPECT_EQ(parts["mesh"], 0.0);
}

TEST(Classify, AreasAreThoseOfTheFormula) {
  const SmallPart part;
  const Json json = json_of(run_moldlight(part.classify({"--json", "-", "--tolerance", "0.02"})).out);
  for (const Region region : k_regions) {
    EXPECT_NEAR(json["areas"][std::string(region_name(region))].get<double>(), part.shape().expected[region],
                1e-9 * part.shape().expected.total())
        << region_name(region);
  }
}

TEST(Classify, FacetTableIsInFileOrderAndAddsUpToTheJson) {
  const SmallPart part;
  const std::string csv = part.output("facets.csv"), report = part.output("report.json");
  const auto run = run_moldlight(part.classify({"--facets", csv, "--json", report}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const FacetGeometry geometry = facet_geometry(part.shape().mesh);
  std::istringstream lines(file_bytes(csv));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "facet,area,core,cavity,both,undercut");
  RegionValues sums;
  std::size_t facet = 0;
  for (; std::getline(lines, line); ++facet) {
    std::istringstream row(line);
    double values[6];
    char comma = 0;
    for (double& value : values) row >> value >> comma;
    ASSERT_EQ(values[0], static_cast<double>(facet));
    ASSERT_LT(facet, geometry.areas.size());
    EXPECT_NEAR(values[1], geometry.areas[facet], 1e-9 * geometry.total_area);
    for (const Region region : k_regions) sums[region] += values[1] * values[2 + static_cast<int>(region)];
  }
  EXPECT_EQ(facet, geometry.areas.size());
  const Json json = json_of(file_bytes(report));
  for (const Region region : k_regions) {
    EXPECT_NEAR(sums[region], json["areas"][std::string(region_name(region))].get<double>(),
                1e-12 * geometry.total_area);
  }
}

TEST(Classify, WritesTheMeshSplitAtTheBordersWhateverTheReadout) {
  const SmallPart part;
  const double area = facet_geometry(part.shape().mesh).total_area;
  for (const std::string name : {"out.ply", "out.obj", "out.stl"}) {
    auto arguments = with(part.classify({"--mesh", part.output(name)}), "--direction", "0.36,0.48,0.8");
    const auto run = run_moldlight(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::string bytes = file_bytes(part.output(name));
    arguments.insert(arguments.end(), {"--readout", "facet-id"});
    const auto sampled = run_moldlight(arguments);
    ASSERT_EQ(sampled.exit_code, 0) << sampled.err;
    EXPECT_EQ(file_bytes(part.output(name)), bytes) << name;
    const Part back = read_part(part.output(name), {}, Progress());
    EXPECT_GT(back.mesh.facets.size(), part.shape().mesh.facets.size()) << name;
    EXPECT_NEAR(facet_geometry(back.mesh).total_area, area, (name == "out.stl" ? 1e-6 : 1e-12) * area);
    EXPECT_TRUE(health_report(back.mesh, facet_geometry(back.mesh)).closed) << name;
  }
  EXPECT_TRUE(fs::exists(part.output("out.mtl")));
}

TEST(Classify, SplitsThePartIntoOneStlARegion) {
  const SmallPart part;
  const std::string folder = part.output("pieces/deeper");
  const auto run = run_moldlight(part.classify({"--split-dir", folder, "--tolerance", "0.02"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const Region region : k_regions) {
    const std::string file = folder + "/cup_" + std::string(region_name(region)) + ".stl";
    const RegionValues& expected = part.shape().expected;
    EXPECT_NEAR(facet_geometry(read_part(file, {}, Progress()).mesh).total_area, expected[region],
                1e-6 * expected.total());
  }
}

TEST(Classify, WritesTheBordersOfRegions) {
  const SmallPart part;
  for (const std::string name : {"lines.obj", "lines.csv"}) {
    const auto run = run_moldlight(part.classify({"--borders", part.output(name)}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  const std::string obj = file_bytes(part.output("lines.obj"));
  EXPECT_NE(obj.find("\ng core-both\nl "), std::string::npos);
  std::istringstream lines(file_bytes(part.output("lines.csv")));
  std::size_t points = 0;
  std::string line, last;
  for (std::getline(lines, line); std::getline(lines, line); ++points) last = line;
  EXPECT_GT(points, 20U);
  const auto chains = std::stoul(last) + 1;
  std::size_t polylines = 0;
  for (std::size_t at = obj.find("\nl "); at != std::string::npos; at = obj.find("\nl ", at + 1)) ++polylines;
  EXPECT_EQ(polylines, chains);
}

TEST(Classify, ComparesTheMapsWithExactRegions) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--compare-maps", "--json", part.output("a.json")}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = json_of(file_bytes(part.output("a.json")));
  EXPECT_EQ(json["settings"]["backend"], "OSMesa");
  const Json& maps = json["compare_maps"];
  EXPECT_EQ(keys(maps), (std::vector<std::string>{"differing_area", "differing_share", "error", "samples",
                                                  "excess", "areas", "shares"}));
  EXPECT_GE(maps["samples"], 20000);
  const double total = json["areas"]["total"];
  double differing = 0.0, excess = 0.0;
  for (const auto& [exact, row] : maps["areas"].items()) {
    double sum = 0.0;
    for (const auto& [shown, area] : row.items()) {
      sum += area.get<double>();
      if (shown != exact) differing += area.get<double>();
      EXPECT_NEAR(maps["shares"][exact][shown].get<double>() * total, area.get<double>(), 1e-9 * total);
    }
    EXPECT_NEAR(sum, json["areas"][exact].get<double>(), 1e-9 * total) << exact;
    excess += maps["excess"][exact].get<double>();
  }
  EXPECT_NEAR(excess, 0.0, 1e-9 * total);
  EXPECT_NEAR(maps["differing_area"].get<double>(), differing, 1e-9 * total);
  EXPECT_NEAR(maps["differing_share"].get<double>() * total, differing, 1e-9 * total);
  EXPECT_GT(differing, 0.0);
  EXPECT_GT(maps["error"], 0.0);
  EXPECT_LT(maps["error"], 0.01 * total);
  const auto table = run.out.find("\nshadow maps: ");
  ASSERT_NE(table, std::string::npos) << run.out;
  EXPECT_NE(run.out.find(" % of the area differs, undercut ", table), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\ncore      core ", table), std::string::npos) << run.out;
  EXPECT_EQ(run_moldlight(part.classify({"--compare-maps"})).out, run.out);
  EXPECT_FALSE(json_of(run_moldlight(part.classify({"--json", "-"})).out).contains("compare_maps"));
}

TEST(Classify, SamplesAndFacetIdAreBothThere) {
  const SmallPart part;
  const Json exact = json_of(run_moldlight(part.classify({"--json", "-"})).out);
  for (const std::string readout : {"samples", "facet-id"}) {
    const Json json = json_of(run_moldlight(part.classify({"--json", "-", "--readout", readout})).out);
    EXPECT_EQ(json["settings"]["readout"], readout);
    EXPECT_EQ(json["settings"]["backend"], "OSMesa");
    EXPECT_NE(json["areas"], exact["areas"]);
    EXPECT_EQ(json["identity"], exact["identity"]);
    const double off = json["areas"]["undercut"].get<double>() - exact["areas"]["undercut"].get<double>();
    EXPECT_EQ(json["uncertainty_parts"]["readout"], std::abs(off));
  }
}

TEST(Classify, ExactRegionsNeedNoGl) {
  const SmallPart part;
  test::ProcessSettings settings;
  settings.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json", "GALLIUM_DRIVER=none"};
  const auto arguments = with(part.classify(), "--backend", "egl");
  const auto run = run_moldlight(arguments, settings);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
}

TEST(Classify, WarnsOfAnOpenPartOnStderrAndInJson) {
  const test::ScratchFolder folder;
  const std::string file =
      folder.write("open.stl",
                   "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                   "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
  const std::vector<std::string> arguments = {"classify", file, "--direction", "0,0,1", "--json", "-"};
  const auto run = run_moldlight(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.err.starts_with("moldlight: warning: 3 open edges")) << run.err;
  EXPECT_FALSE(json_of(run.out)["part"]["warnings"].empty());
  auto quiet = arguments;
  quiet.push_back("-q");
  EXPECT_EQ(run_moldlight(quiet).err, "");
}

TEST(Classify, TakesANameThatIsNoUtf8) {
  const SmallPart part;
  const std::string odd = part.output("t\xE4st\n.obj");
  fs::copy_file(part.file(), odd);
  const auto arguments = with(part.classify({"--json", "-"}), "PART", odd);
  const auto run = run_moldlight(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NO_THROW(static_cast<void>(json_of(run.out)));
}

}  // namespace
}  // namespace moldlight
