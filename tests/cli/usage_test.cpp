// Command lines that make no sense, and places that cannot be written to: found out at once, in one line.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "cli/small_part.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;
using test::run_moldlight;
using test::SmallPart;
using test::with;
using Arguments = std::vector<std::string>;

/// Expects the exit code, one line on stderr that holds all of `words`, nothing on stdout.
void expect_failure(const Arguments& arguments, int exit_code, const Arguments& words) {
  const auto run = run_moldlight(arguments);
  std::string command;
  for (const std::string& argument : arguments) command += " " + argument;
  EXPECT_EQ(run.exit_code, exit_code) << command << "\n" << run.err;
  EXPECT_EQ(run.out, "") << command;
  EXPECT_EQ(run.error_lines(), 1u) << command << "\n" << run.err;
  EXPECT_TRUE(run.err.starts_with("moldlight: ")) << command << "\n" << run.err;
  for (const std::string& word : words) {
    EXPECT_NE(run.err.find(word), std::string::npos) << command << ": no '" << word << "' in " << run.err;
  }
}

TEST(Usage, HelpAndVersionGoToStdout) {
  for (const Arguments& arguments : {Arguments{"--help"}, Arguments{"info", "--help"},
                                     Arguments{"classify", "-h"}, Arguments{"--version"}}) {
    const auto run = run_moldlight(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out, "");
  }
  EXPECT_TRUE(run_moldlight({"--version"}).out.starts_with("moldlight 0."));
}

TEST(Usage, CommandLinesThatMakeNoSenseEndWithTwo) {
  const SmallPart part;
  expect_failure({"melt"}, 2, {"melt"});
  expect_failure({"classify"}, 2, {"which part? moldlight classify PART …", "moldlight classify --help"});
  expect_failure({"compare", part.file()}, 2, {"which part? moldlight compare A B …"});
  expect_failure({"batch"}, 2, {"which command? moldlight batch plan|run|status|merge …"});
  expect_failure({"batch", "run"}, 2, {"which batch? moldlight batch run DIR …"});
  expect_failure({"classify", part.file()}, 2, {"--direction"});
  expect_failure({"info"}, 2, {"PART"});
  expect_failure({"info", part.file(), "--json"}, 2, {"--json"});
  expect_failure({"info", part.file(), "more"}, 2, {"'more' is one word too many"});
  expect_failure(part.classify({"--tau", "1,5"}), 2, {"'1,5' is not a number; write 1.5"});
  expect_failure(part.classify({"--tolerance", "0.05mm"}), 2, {"'0.05mm' is not a number; write 0.05"});
  // A mistyped option is named before one that is missing for it.
  expect_failure({"classify", part.file(), "--directoin", "z"}, 2, {"there is no option --directoin"});
  expect_failure({"classify", "--colour"}, 2, {"there is no option --colour"});
  expect_failure(part.classify({"--unit", "parsec"}), 2, {"--unit: 'parsec' is unknown"});
  expect_failure(part.classify({"--colour", "red"}), 2, {"--colour"});
  expect_failure(part.classify({"--quiet", "--verbose"}), 2, {"--quiet"});
  expect_failure(part.classify({"--readout", "facet-id", "--kernel-shape", "symmetric"}), 2, {"--readout"});
}

TEST(Usage, SizesThatAreNoneAreNamedWithTheirForm) {
  const SmallPart part;
  const std::vector<Arguments> commands = {part.classify({"--image", part.output("a.png")}),
                                           part.sweep({"--image-dir", part.output("pictures")}),
                                           {"view", part.file(), "--screenshot", part.output("a.png")}};
  for (Arguments arguments : commands) {
    arguments.insert(arguments.end(), {"--size", ""});
    for (const std::string text : {"99x", "x99", "1280", "640x480x2", "640 480", "a", ""}) {
      arguments.back() = text;
      expect_failure(arguments, 2, {"--size: '" + text + "' is not WIDTHxHEIGHT, such as 1280x720"});
    }
    for (const std::string text : {"640x15", "-640x480", "640x16385"}) {
      arguments.back() = text;
      expect_failure(arguments, 2, {"--size: '" + text + "' is out of range", "x16384 pixels"});
    }
  }
  expect_failure({"view", part.file(), "--size", "640x239"}, 2, {"'640x239' is out of range, 320x240 to"});
}

TEST(Usage, DirectionsThatAreNoneEndWithTwo) {
  const SmallPart part;
  for (const std::string direction :
       {"0,0,0", "nan,0,0", "inf,0,0", "-inf,0,1", "1,2", "1,2,3,4", "", "a,b,c", "1,,2", "0,0,-0",
        "1e400,0,0", "0x10,0,0", "w", "--y", "xy", "-", "worst"}) {
    expect_failure(with(part.classify(), "--direction", direction), 2, {"--direction"});
  }
}

TEST(Usage, TheBestDirectionIsTheSweepsFirst) {
  const SmallPart part;
  const auto swept = run_moldlight({"sweep", part.file(), "--json", "-"});
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  const auto run = run_moldlight({"classify", part.file(), "--direction", "best", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(test::json_of(run.out)["direction"], test::json_of(swept.out)["candidates"][0]["direction"]);
}

TEST(Usage, AMissingPartIsNamedBeforeAMissingDisplay) {
  expect_failure({"view", "nowhere.stl"}, 1, {"nowhere.stl: cannot be opened"});
}

/// Without a display that ends with a way out, and does not wait.
TEST(Usage, WithoutACommandTheWindowOpens) { expect_failure({}, 1, {"no display to open a window on"}); }

TEST(Usage, DirectionsOfAnyLengthAreTaken) {
  const SmallPart part;
  const auto direction_of = [&](const std::string& text) {
    const auto run = run_moldlight(with(part.classify({"--json", "-"}), "--direction", text));
    EXPECT_EQ(run.exit_code, 0) << text << ": " << run.err;
    return run.exit_code == 0 ? test::json_of(run.out)["direction"] : nlohmann::ordered_json();
  };
  const nlohmann::ordered_json down = {-1.0, 0.0, 0.0};
  EXPECT_EQ(direction_of("-1,0,0"), down);
  EXPECT_EQ(direction_of("-1e-320,0,0"), down);
  EXPECT_EQ(direction_of("-1e308,0,0"), down);
  EXPECT_EQ(direction_of(" -5 , +0 , 0"), down);
  for (const char* text : {"-x", "-X"}) EXPECT_EQ(direction_of(text), down) << text;
  for (const char* text : {"y", "+y", "Y"})
    EXPECT_EQ(direction_of(text), (nlohmann::ordered_json{0.0, 1.0, 0.0})) << text;
  const auto run = run_moldlight({"classify", part.file(), "--direction=-2,0,0", "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(test::json_of(run.out)["direction"], down);
}

TEST(Usage, ValuesOutOfRangeEndWithTwo) {
  const SmallPart part;
  const std::vector<std::pair<std::string, std::string>> values = {
      {"--tau", "-0.1"},           {"--tau", "10.1"},         {"--tau", "nan"},
      {"--kernel", "0"},           {"--kernel", "2"},         {"--kernel", "11"},
      {"--kernel", "3.5"},         {"--tolerance", "0"},      {"--tolerance", "-1"},
      {"--tolerance", "inf"},      {"--edge-thickness", "9"}, {"--readout", "photograph"},
      {"--kernel-shape", "round"}, {"--max-facets", "0"},     {"--max-facets", "-3"}};
  for (const auto& [flag, value] : values) {
    expect_failure(part.classify({flag, value}), 2, {flag});
  }
  for (const auto& [flag, value] : {std::pair<std::string, std::string>{"--resolution", "0"},
                                    {"--resolution", "63"},
                                    {"--resolution", "8193"},
                                    {"--resolution", "-512"},
                                    {"--resolution", "99999999999"},
                                    {"--samples", "10"},
                                    {"--backend", "vulkan"}}) {
    expect_failure(with(part.classify(), flag, value), 2, {flag, value});
  }
}

TEST(Usage, TheLimitOfFacetsHolds) {
  const SmallPart part;
  expect_failure({"info", part.file(), "--max-facets", "12"}, 1, {part.file(), "--max-facets"});
}

TEST(Usage, PartsThatCannotBeReadEndWithOne) {
  const test::ScratchFolder folder;
  expect_failure({"info", folder.file("nowhere.stl")}, 1, {"nowhere.stl"});
  expect_failure({"info", folder.path().string()}, 1, {folder.path().string()});
  expect_failure({"classify", folder.file("nowhere.stl"), "--direction", "0,0,1"}, 1, {"nowhere.stl"});
  expect_failure({"info", "/dev/null"}, 1, {"/dev/null"});
}

TEST(Usage, OutputsThatCannotBeWrittenEndWithOneBeforeAnyWork) {
  const SmallPart part;
  const std::string file = part.folder().write("file", "");
  const std::vector<std::pair<std::string, std::string>> outputs = {
      {"--json", part.output("no/such/folder/a.json")},
      {"--facets", part.output("no/such/folder/a.csv")},
      {"--mesh", part.output("no/such/folder/a.ply")},
      {"--borders", part.output("no/such/folder/a.obj")},
      {"--json", part.folder().path().string()},
      {"--split-dir", file + "/below"},
      {"--split-dir", file}};
  for (const auto& [flag, path] : outputs) {
    // A part that is not there either: the output is looked at first.
    expect_failure(with(part.classify({flag, path}), "PART", part.output("nowhere.stl")), 1,
                   {path, "cannot be"});
  }
  expect_failure({"info", part.file(), "--json", part.output("no/a.json")}, 1, {"no/a.json"});
}

TEST(Usage, OutputsWithoutANameAreRefused) {
  const SmallPart part;
  for (const char* flag :
       {"--json", "--facets", "--faces", "--mesh", "--split-dir", "--borders", "--image"}) {
    expect_failure(part.classify({flag, ""}), 2, {flag, "empty"});
  }
  for (const char* flag : {"--json", "--csv", "--image-dir", "--directions-file"}) {
    expect_failure(part.sweep({flag, ""}), 2, {flag, "empty"});
  }
  for (const char* flag : {"--screenshot", "--script", "--settings"}) {
    expect_failure({"view", part.file(), flag, ""}, 2, {flag, "empty"});
  }
}

TEST(Usage, ProtectedFilesAndFoldersStay) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const SmallPart part;
  const std::string kept = part.folder().write("kept.json", "old");
  fs::permissions(kept, fs::perms::owner_read);
  expect_failure(part.classify({"--json", kept}), 1, {kept});
  EXPECT_EQ(test::file_bytes(kept), "old");
}

TEST(Usage, AFullDiskIsAFailureAndLeavesTheOldFile) {
  const SmallPart part;
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  expect_failure(part.classify({"--json", "/dev/full"}), 1, {"/dev/full", "space"});
}

TEST(Usage, OutputsThatMeetEndWithTwo) {
  const SmallPart part;
  const std::string file = part.output("out.csv");
  expect_failure(part.classify({"--json", file, "--facets", file}), 2, {"--json", "--facets"});
  expect_failure(part.classify({"--json", file, "--facets", part.output("./sub/../out.csv")}), 2,
                 {"--facets"});
  expect_failure(part.classify({"--mesh", part.file()}), 2, {"--mesh", part.file()});
  expect_failure(part.classify({"--mesh", part.output("a.step")}), 2, {"--mesh: ", "a.step", ".ply"});
  expect_failure(part.classify({"--borders", part.output("a.ply")}), 2, {"a.ply", ".csv"});
  expect_failure(part.classify({"--borders", part.file()}), 2, {"--borders", part.file()});
  expect_failure(part.classify({"--borders", file, "--facets", file}), 2, {"--borders", "--facets"});
  expect_failure(part.classify({"--facets", "-"}), 2, {"--facets"});
  expect_failure({"info", part.file(), "--json", part.file()}, 2, {"--json"});
  EXPECT_FALSE(fs::exists(file));
}

TEST(Usage, OutputsThatMeetInputsOrFoldersEndWithTwo) {
  const SmallPart part;
  const std::string list = part.folder().write("list.csv", "x,y,z\n0,0,1\n");
  expect_failure(part.sweep({"--directions-file", list, "--csv", list}), 2, {"--csv", "--directions-file"});
  EXPECT_EQ(test::file_bytes(list), "x,y,z\n0,0,1\n");
  const std::string folder = part.output("pieces"), inside = folder + "/deeper/a.csv";
  expect_failure(part.classify({"--split-dir", folder, "--facets", inside}), 2, {"--facets", "--split-dir"});
  expect_failure(part.sweep({"--image-dir", folder, "--csv", inside}), 2, {"--csv", "--image-dir"});
  expect_failure(part.classify({"--mesh", part.output("a.obj"), "--facets", part.output("a.mtl")}), 2,
                 {"--facets", "--mesh"});
  const std::string events = part.folder().write("events.json", "[]");
  expect_failure({"view", part.file(), "--script", events, "--screenshot", events}, 2, {"--script"});
  EXPECT_FALSE(fs::exists(folder));
}

TEST(Usage, SettingsOfTheWindowAreWrittenAndReadAgain) {
  const SmallPart part;
  const std::string first = part.output("first.json"), second = part.output("second.json");
  const auto run = [](const std::vector<std::string>& words) { return test::run_moldlight(words).exit_code; };
  ASSERT_EQ(run({"view", part.file(), "-d", "y", "--tau", "2.5", "--unit", "inch", "--save-settings", first}),
            0);
  const Json json = Json::parse(test::file_bytes(first));
  EXPECT_EQ(json["settings"]["direction"], Json({0.0, 1.0, 0.0}));
  EXPECT_EQ(json["settings"]["tau_deg"], 2.5);
  EXPECT_EQ(json["unit"], "in");
  ASSERT_EQ(run({"view", part.file(), "--settings", first, "--save-settings", second}), 0);
  EXPECT_EQ(test::file_bytes(second), test::file_bytes(first));
  ASSERT_EQ(run({"view", part.file(), "-d", "best", "--save-settings", second}), 0);
  EXPECT_NE(test::file_bytes(second), test::file_bytes(first));
  expect_failure({"view", part.file(), "--unit", "ell", "--save-settings", second}, 2, {"--unit", "ell"});
  expect_failure({"view", "--settings", first, "--save-settings", first}, 2, {"--save-settings"});
  for (const std::vector<std::string>& other :
       {std::vector<std::string>{"--screenshot", part.output("a.png")}, {"--benchmark"}}) {
    std::vector<std::string> words = {"view", part.file(), "--save-settings", second};
    words.insert(words.end(), other.begin(), other.end());
    expect_failure(words, 2, {"--save-settings", other.front()});
  }
}

TEST(Usage, ARevisionInTheWindowIsOneOfAPart) {
  const SmallPart part;
  expect_failure({"view", "--compare", part.file()}, 2, {"--compare needs a PART"});
  expect_failure({"view", part.file(), "--align"}, 2, {"--align", "--compare"});
  const std::string bad = part.folder().write("bad.stl", "solid nothing");
  expect_failure({"view", part.file(), "--compare", bad, "--screenshot", part.output("a.png")}, 1,
                 {"bad.stl"});
  EXPECT_FALSE(fs::exists(part.output("a.png")));
}

TEST(Usage, LengthsBeyondThePartEndWithTwo) {
  const SmallPart part;
  expect_failure(part.classify({"--tolerance", "1e20"}), 2, {"--tolerance", "1e+20"});
  expect_failure(part.sweep({"--tolerance", "1e20"}), 2, {"--tolerance", "1e+20"});
  expect_failure(part.classify({"--repair", "weld", "--weld-tolerance", "1e20"}), 2, {"--weld-tolerance"});
}

TEST(Usage, ScriptsThatAreNoneEndWithTwo) {
  const SmallPart part;
  const std::string nested = std::string(100'000, '[') + std::string(100'000, ']');
  for (const std::string& events :
       {std::string(), std::string("[]"), std::string("{}"), nested, std::string(R"([{"scale": 0}])"),
        std::string(R"([{"scale": -1}])"), std::string(R"([{"scale": 1e9}])"),
        std::string(R"([{"click": [10, 10], "times": 2000000000}])"), std::string(R"([{"wait": 1e18}])"),
        std::string(R"([{"wheel": 1e300}])"), std::string(R"([{"resize": [1, 1000000]}])"),
        std::string(R"([{"move": ["a", 1]}])")}) {
    const std::string file = part.folder().write("events.json", events);
    expect_failure({"view", part.file(), "--screenshot", part.output("a.png"), "--script", file}, 2,
                   {"--script"});
  }
  const std::string settings = part.folder().write("settings.json", R"({"schema": )" + nested + "}");
  expect_failure({"view", part.file(), "--screenshot", part.output("a.png"), "--settings", settings}, 2,
                 {"settings"});
  EXPECT_FALSE(fs::exists(part.output("a.png")));
}

TEST(Usage, HelpThatCannotBeWrittenIsAFailure) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  for (const std::string what : {"--help", "--version", "classify --help"}) {
    const test::ProcessResult run =
        test::Process({"/bin/sh", "-c", std::string("'" MOLDLIGHT_BINARY "' ") + what + " >/dev/full"}, {})
            .finish();
    EXPECT_EQ(run.exit_code, 1) << what;
    EXPECT_EQ(run.error_lines(), 1u) << run.err;
  }
}

std::size_t entries(const SmallPart& part) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(part.folder().path()), fs::directory_iterator()));
}

TEST(Usage, AFileBeyondTheLimitOfSizeIsAFailureAndLeavesNothing) {
  const SmallPart part;
  const std::size_t before = entries(part);
  test::ProcessSettings settings;
  settings.file_size_limit = 1024;
  const auto run = run_moldlight(part.classify({"--mesh", part.output("a.ply")}), settings);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
  EXPECT_NE(run.err.find("a.ply"), std::string::npos) << run.err;
  EXPECT_EQ(entries(part), before);
}

TEST(Usage, ThreadsThatCannotBeStartedEndNothing) {
  // 256 stacks do not go into the room: the sweep makes do with fewer or says what is missing.
  if (test::built_with_sanitizers()) GTEST_SKIP() << "the address sanitizer wants all room";
  const SmallPart part;
  for (const std::size_t megabytes : {150, 300, 400, 500, 700}) {
    test::ProcessSettings settings;
    settings.address_space_limit = megabytes << 20;
    settings.time_limit_s = 60.0;
    const auto run = run_moldlight(part.sweep({"--jobs", "256"}), settings);
    EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 1) << megabytes << ": " << run.exit_code;
    EXPECT_EQ(run.out.empty(), run.exit_code == 1) << megabytes;
    if (run.exit_code == 1) {
      EXPECT_NE(run.err.find("memory"), std::string::npos) << megabytes << run.err;
    }
  }
}

TEST(Usage, AFailedRunLeavesNothingBehind) {
  const SmallPart part;
  const std::size_t before = entries(part);
  const auto arguments = part.classify({"--json", part.output("a.json"), "--mesh", part.output("a.ply"),
                                        "--facets", part.output("a.csv"), "--split-dir",
                                        part.output("pieces"), "--borders", part.output("b.csv")});
  expect_failure(with(arguments, "PART", part.output("nowhere.stl")), 1, {"nowhere.stl"});
  EXPECT_EQ(entries(part), before);
}

TEST(Usage, ABackendThatIsNotThereSaysWhatWasTried) {
  const SmallPart part;
  test::ProcessSettings settings;
  settings.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json"};
  const auto run = run_moldlight(with(part.classify({"--readout", "samples"}), "--backend", "egl"), settings);
  if (run.exit_code == 0) GTEST_SKIP() << "this EGL does not ask for vendors";
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("EGL"), std::string::npos) << run.err;
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
}

TEST(Usage, ABackendForPicturesThatIsNotThereEndsASweepBeforeItBegins) {
  const SmallPart part;
  test::ProcessSettings settings;
  settings.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json"};
  const auto run =
      run_moldlight(with(part.sweep({"--image-dir", part.output("pictures")}), "--backend", "egl"), settings);
  if (run.exit_code == 0) GTEST_SKIP() << "this EGL does not ask for vendors";
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "");  // no list of directions
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
}

TEST(Usage, NeitherHomeNorDisplayIsNeeded) {
  const SmallPart part;
  test::ProcessSettings settings;
  settings.removed_environment = {"HOME", "DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR", "LANG"};
  for (const std::string backend : {"auto", "osmesa"}) {
    const auto run =
        run_moldlight(with(part.classify({"--readout", "samples"}), "--backend", backend), settings);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
  }
}

}  // namespace
}  // namespace moldlight
