// The part's own faces in a STEP file, split, named and coloured, as OpenCASCADE reads them again; and IGES
// beside STEP of the same part.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mold/region.hpp"
#include "step/entities.hpp"
#include "step/face_area.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::step {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-10);
  return properties.Mass();
}

struct Read {
  bool valid = false;
  double volume = 0.0, area = 0.0;
  std::size_t faces = 0, loose_edges = 0;
  std::map<std::string, double> by_name;
  std::map<std::string, std::uint32_t> colours;  // of names; 1 where a name has several
};

void be_silent() { Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer)); }

Read read_again(const std::string& path) {
  be_silent();
  STEPControl_Reader reader;
  Read read;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return read;
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  const FaceColours colours = face_colours(reader);
  read.valid = BRepCheck_Analyzer(shape).IsValid();
  for (TopExp_Explorer walk(shape, TopAbs_SOLID); walk.More(); walk.Next())
    read.volume += volume_of(walk.Current());
  for (TopExp_Explorer walk(shape, TopAbs_EDGE, TopAbs_FACE); walk.More(); walk.Next()) ++read.loose_edges;
  for (TopExp_Explorer walk(shape, TopAbs_FACE); walk.More(); walk.Next()) {
    const auto entity = Handle(StepRepr_RepresentationItem)::DownCast(
        reader.WS()->TransferReader()->EntityFromShapeResult(walk.Current().Located(TopLoc_Location()), 1));
    const std::string name = entity.IsNull() ? "" : entity->Name()->ToCString();
    const auto colour = colours.find(walk.Current().TShape().get());
    const std::uint32_t rgb = colour == colours.end() ? 0 : colour->second;
    const auto known = read.colours.try_emplace(name, rgb).first;
    if (known->second != rgb) known->second = 1;
    const double area = area_of(TopoDS::Face(walk.Current()));
    read.by_name[name] += area;
    read.area += area;
    ++read.faces;
  }
  return read;
}

TopoDS_Shape cylinder(double radius, double length, const gp_Pnt& at, const gp_Dir& along) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(at, along), radius, length).Shape();
}

TopoDS_Shape box(const gp_Pnt& from, const gp_Pnt& to) { return BRepPrimAPI_MakeBox(from, to).Shape(); }

TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& what) {
  return BRepAlgoAPI_Cut(from, what).Shape();
}

TopoDS_Shape block_with_pocket() { return cut(box({0, 0, 0}, {40, 30, 10}), box({25, -5, 4}, {35, 20, 7})); }

TopoDS_Shape block_with_pin() {
  return BRepAlgoAPI_Fuse(cut(block_with_pocket(), cylinder(6, 20, {12, 15, -5}, {0, 0, 1})),
                          cylinder(4, 8, {32, 25, 9}, {0, 0, 1}))
      .Shape();
}

/// Half of the floor is hidden from above.
TopoDS_Shape floor_under_a_roof() {
  return cut(box({0, 0, 0}, {40, 30, 25}),
             BRepAlgoAPI_Fuse(box({5, -1, 5}, {41, 31, 20}), box({20, -1, 6}, {41, 31, 26})).Shape());
}

TopoDS_Shape plate_with_cross_holes() {
  return cut(cut(cut(box({0, 0, 0}, {60, 40, 20}), cylinder(5, 60, {30, -5, 10}, {0, 1, 0})),
                 cylinder(3, 70, {-5, 20, 6}, {1, 0, 0})),
             box({-1, 5, 12}, {61, 11, 17}));
}

TopoDS_Shape rounded_block() {
  const TopoDS_Shape block = box({0, 0, 0}, {30, 30, 30});
  BRepFilletAPI_MakeFillet fillet(block);
  for (TopExp_Explorer walk(block, TopAbs_EDGE); walk.More(); walk.Next())
    fillet.Add(4.0, TopoDS::Edge(walk.Current()));
  return cut(fillet.Shape(), BRepPrimAPI_MakeSphere(gp_Pnt(0, 15, 15), 6.0).Shape());
}

struct Case {
  std::string name;
  TopoDS_Shape (*make)();
  /// By which facets' areas by region differ from those of exact faces, as share of the surface: of planes by
  /// rounding, of bent faces by a row of facets.
  double area_share = 1e-6;
  std::size_t least_split = 0;
};

class StepOutput : public testing::TestWithParam<Case> {};

void expect_part(const std::string& part, const std::string& direction, double area_share,
                 std::size_t least_split, const test::ScratchFolder& folder, double same_share = 1e-9) {
  const std::string out = folder.file("out.step"), json = folder.file("out.json");
  const auto run = test::run_moldlight(
      {"classify", part, "--direction", direction, "--step", out, "--json", json, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json report = Json::parse(test::file_bytes(json));
  const Json& step = report.at("step");
  EXPECT_EQ(step.at("failed_faces").size(), 0u) << step;
  EXPECT_GE(step.at("split_faces").get<std::size_t>(), least_split);
  const Read before = read_again(part), after = read_again(out);
  EXPECT_TRUE(after.valid);
  EXPECT_NEAR(after.volume, before.volume, same_share * before.volume);
  EXPECT_NEAR(after.area, before.area, same_share * before.area);
  EXPECT_GE(after.faces, before.faces + least_split);
  const double unit = report.at("part").at("unit") == "in" ? 25.4 * 25.4 : 1.0;
  for (const Region region : k_regions) {
    const std::string name(region_name(region));
    const double there = after.by_name.contains(name) ? after.by_name.at(name) : 0.0;
    EXPECT_NEAR(there, unit * step.at("areas").at(name).get<double>(), 1e-6 * before.area) << name;
    const double facets = unit * step.at("facet_areas").at(name).get<double>();
    EXPECT_NEAR(there, facets, area_share * before.area) << name;
    EXPECT_NEAR(facets, unit * report.at("areas").at(name).get<double>(),
                1e-9 * before.area + 1.01 * unit * step.at("moved_area").get<double>())
        << name;
    if (!after.colours.contains(name)) continue;
    const Colour colour = region_colour(region, Palette::paper);
    EXPECT_EQ(after.colours.at(name), std::uint32_t(colour.r << 16 | colour.g << 8 | colour.b)) << name;
  }
  EXPECT_FALSE(after.by_name.contains(""));
}

TEST_P(StepOutput, IsThePartSplitAndNamed) {
  const test::ScratchFolder folder;
  const std::string part = folder.file("part.step");
  be_silent();
  STEPControl_Writer writer;
  writer.Transfer(GetParam().make(), STEPControl_AsIs);
  ASSERT_EQ(writer.Write(part.c_str()), IFSelect_RetDone);
  expect_part(part, "z", GetParam().area_share, GetParam().least_split, folder);
}

INSTANTIATE_TEST_SUITE_P(
    Made, StepOutput,
    testing::Values(Case{"block_with_pocket", block_with_pocket, 1e-6, 0},
                    Case{"block_with_pin", block_with_pin, 2e-5, 0},
                    Case{"cylinder_across",
                         [] {
                           return cylinder(10, 40, {0, 0, 0}, {1, 0, 0});
                         },
                         2e-2, 1},
                    Case{"cone_across",
                         [] {
                           return BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 0}, {0, 1, 0}), 10.0, 3.0, 30.0).Shape();
                         },
                         2e-2, 1},
                    Case{"sphere", [] { return BRepPrimAPI_MakeSphere(12.0).Shape(); }, 2e-2, 1},
                    Case{"torus", [] { return BRepPrimAPI_MakeTorus(20.0, 6.0).Shape(); }, 2e-2, 1},
                    Case{"floor_under_a_roof", floor_under_a_roof, 1e-6, 1},
                    Case{"plate_with_cross_holes", plate_with_cross_holes, 2e-2, 0},
                    Case{"rounded_block", rounded_block, 2e-2, 2}),
    [](const auto& tested) { return tested.param.name; });

/// Of half a cylinder that lies on the plane z = 0, what the core forms is known.
TEST(StepOutputOfContours, HasTheBorderOnTheFaceItself) {
  constexpr double k_across = 0.07, k_radius = 12.0, k_length = 40.0;
  constexpr double k_half_turn = std::numbers::pi;
  const double core =
      k_radius * k_length * (k_half_turn - std::atan(k_across)) + 0.5 * k_half_turn * k_radius * k_radius;
  const test::ScratchFolder folder;
  const std::string part = folder.file("part.step"), out = folder.file("out.step"),
                    json = folder.file("out.json");
  be_silent();
  STEPControl_Writer writer;
  const TopoDS_Shape shape =
      cut(cylinder(k_radius, k_length, {0, 0, 0}, {1, 0, 0}), box({-1, -20, -20}, {50, 20, 0}));
  writer.Transfer(shape, STEPControl_AsIs);
  ASSERT_EQ(writer.Write(part.c_str()), IFSelect_RetDone);
  const auto run = test::run_moldlight({"classify", part, "--direction", "0.21,0.07,1", "--tau", "0",
                                        "--step", out, "--json", json, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Read read = read_again(out);
  EXPECT_TRUE(read.valid);
  const Json step = Json::parse(test::file_bytes(json)).at("step");
  EXPECT_NEAR(step.at("areas").at("core").get<double>(), core, 1e-6 * read.area);
  EXPECT_GT(std::abs(step.at("facet_areas").at("core").get<double>() - core), 1e-4 * read.area);
}

/// FreeCAD 0.20 ends at several products that stand beside each other.
TEST(StepOutputOfMolds, HasThePartingLineInTheProductOfThePart) {
  const test::ScratchFolder folder;
  const std::string part = folder.file("part.step"), out = folder.file("out.step");
  be_silent();
  STEPControl_Writer writer;
  writer.Transfer(floor_under_a_roof(), STEPControl_AsIs);
  ASSERT_EQ(writer.Write(part.c_str()), IFSelect_RetDone);
  const auto run = test::run_moldlight({"mold", part, "--direction", "z", "--step", out, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  STEPControl_Reader reader;
  ASSERT_EQ(reader.ReadFile(out.c_str()), IFSelect_RetDone);
  EXPECT_EQ(reader.NbRootsForTransfer(), 1);
  reader.TransferRoots();
  std::size_t free_edges = 0;
  for (TopExp_Explorer walk(reader.OneShape(), TopAbs_EDGE, TopAbs_FACE); walk.More(); walk.Next())
    ++free_edges;
  EXPECT_GE(free_edges, 4U);
  EXPECT_NE(test::file_bytes(out).find("GEOMETRIC_CURVE_SET('parting line 1, outer'"), std::string::npos);
}

class StepOutputOfFiles : public testing::TestWithParam<std::string> {};

TEST_P(StepOutputOfFiles, IsThePartSplitAndNamed) {
  fs::path part = test::data_folder() / GetParam();
  if (const auto shared = test::shared_folder(); !fs::exists(part) && shared)
    part = *shared / "parts" / GetParam();
  if (!fs::exists(part)) GTEST_SKIP() << "not found";
  // Edges of these are up to 0.012 mm off their surfaces, and readers fit the pieces of one that was cut
  // anew.
  const bool inexact = GetParam().starts_with("m5_");
  expect_part(part.string(), "z", 2e-2, 0, test::ScratchFolder(), inexact ? 1e-5 : 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Files, StepOutputOfFiles,
                         testing::Values("pin_and_block_inch.step", "pins_assembly_mm.step",
                                         "m5_base26_main.stp", "m5_watch_bottom.stp",
                                         "trimesh_featuretype.step"),
                         [](const auto& tested) { return fs::path(tested.param).stem().string(); });

class StepFlag : public testing::Test {
 protected:
  void SetUp() override {
    be_silent();
    STEPControl_Writer writer;
    writer.Transfer(block_with_pin(), STEPControl_AsIs);
    ASSERT_EQ(writer.Write(part_.c_str()), IFSelect_RetDone);
  }
  test::ScratchFolder folder_;
  std::string part_ = folder_.file("part.step"), out_ = folder_.file("out.step");
};

TEST_F(StepFlag, NamesFacesByTheirAction) {
  const auto run = test::run_moldlight({"actions", part_, "--direction", "z", "--step", out_, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Read read = read_again(out_);
  EXPECT_TRUE(read.valid);
  EXPECT_TRUE(read.by_name.contains("slide 1"));
}

TEST_F(StepFlag, WritesThePartingLineOfAMold) {
  const auto run = test::run_moldlight({"mold", part_, "--direction", "z", "--step", out_, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Read read = read_again(out_);
  EXPECT_TRUE(read.valid);
  EXPECT_GE(read.loose_edges, 4u);
  EXPECT_TRUE(read.by_name.contains("core"));
  EXPECT_TRUE(read.by_name.contains("cavity"));
}

TEST_F(StepFlag, WritesThePartingSurfaceOfAMold) {
  const std::string json = folder_.file("mold.json");
  const auto run = test::run_moldlight(
      {"mold", part_, "--direction", "z", "--fill-undercut", "--step", out_, "--json", json, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json surfaces = Json::parse(test::file_bytes(json)).at("surfaces");
  const double parting = surfaces.at("parting"), shut_offs = surfaces.at("shut_offs");
  ASSERT_GT(shut_offs, 100.0);  // in the hole
  const Read read = read_again(out_);
  EXPECT_TRUE(read.valid);
  EXPECT_NEAR(read.volume, read_again(part_).volume, 1e-6);
  EXPECT_NEAR(read.by_name.at(""), parting + shut_offs, 1e-6 * (parting + shut_offs));
  for (const char* name : {"parting surface 1", "parting surface 2"})
    EXPECT_NE(test::file_bytes(out_).find(std::string("SHELL_BASED_SURFACE_MODEL('") + name),
              std::string::npos)
        << name;
}

TEST_F(StepFlag, WritesRegistrationConesAsCones) {
  const std::string json = folder_.file("mold.json");
  const auto run = test::run_moldlight({"mold", part_, "--direction", "z", "--fill-undercut",
                                        "--registration", "--step", out_, "--json", json, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto count = [&](const std::string& file, const std::string& what) {
    const std::string text = test::file_bytes(file);
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count(part_, "CONICAL_SURFACE("), 0U);
  EXPECT_EQ(count(out_, "CONICAL_SURFACE("), 4U);
  const Read read = read_again(out_);
  EXPECT_TRUE(read.valid);
  EXPECT_LT(read.faces, 60U);  // each cone would have 48
  // Seen along the direction both are the same; facets of a cone are steeper.
  const Json surfaces = Json::parse(test::file_bytes(json)).at("surfaces");
  const double facets = surfaces.at("parting").get<double>() + surfaces.at("shut_offs").get<double>();
  EXPECT_LT(read.by_name.at(""), facets);
  EXPECT_NEAR(read.by_name.at(""), facets, 1e-4 * facets);
}

TEST_F(StepFlag, GivesTheSameFileAgain) {
  for (const std::string& name : {out_, folder_.file("again.step")}) {
    const auto run = test::run_moldlight({"classify", part_, "--direction", "z", "--step", name, "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  EXPECT_EQ(test::file_bytes(out_), test::file_bytes(folder_.file("again.step")));
}

TEST_F(StepFlag, RefusesAPartWithoutExactFaces) {
  const std::string stl = (test::asset_folder() / "parts" / "cable_clip.stl").string();
  const auto run = test::run_moldlight({"classify", stl, "--direction", "z", "--step", out_});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
  EXPECT_NE(run.err.find("--mesh"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(out_));
  EXPECT_EQ(test::run_moldlight({"classify", part_, "--direction", "z", "--step", part_}).exit_code, 2);
}

TEST_F(StepFlag, LeavesNothingHalfWritten) {
  const fs::path program = folder_.path() / "moldlight";
  fs::copy_file(MOLDLIGHT_BINARY, program);
  const fs::path real = fs::path(MOLDLIGHT_BINARY).parent_path() / "moldlight-step";
  const std::pair<std::string, std::string> ends[] = {{"exit 1", "exit code 1"},
                                                      {"kill -SEGV $$", "signal 11"},
                                                      {"echo nonsense >&3", "breaks"},
                                                      {"exec cat /dev/zero >&3", "breaks"}};
  for (const auto& [end, words] : ends) {
    const fs::path helper = folder_.write(
        "moldlight-step", "#!/bin/sh\n'" + real.string() +
                              "' \"$1\" \"$2\" \"$3\" \"$4\" \"$5\" read\ncat <&5 >/dev/null\n" + end + "\n");
    fs::permissions(helper, fs::perms::owner_all);
    const auto run =
        test::Process({program.string(), "classify", part_, "--direction", "z", "--step", out_}, {}).finish();
    EXPECT_EQ(run.exit_code, 1) << end;
    EXPECT_EQ(run.error_lines(), 1u) << run.err;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(out_)) << end;
  }
}

TEST(IgesInput, IsTheStepFilesPart) {
  be_silent();
  const test::ScratchFolder folder;
  const std::string step = folder.file("part.step"), iges = folder.file("part.igs");
  const TopoDS_Shape part = block_with_pin();
  STEPControl_Writer step_writer;
  step_writer.Transfer(part, STEPControl_AsIs);
  ASSERT_EQ(step_writer.Write(step.c_str()), IFSelect_RetDone);
  for (const int brep : {0, 1}) {  // loose trimmed surfaces, a solid
    for (const char* unit : {"MM", "INCH"}) {
      IGESControl_Writer iges_writer(unit, brep);
      iges_writer.AddShape(part);
      iges_writer.ComputeModel();
      ASSERT_TRUE(iges_writer.Write(iges.c_str()));
      std::vector<Json> reports;
      for (const std::string& file : {step, iges}) {
        const auto run =
            test::run_moldlight({"classify", file, "--direction", "z", "--json", "-", "--quiet"});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        reports.push_back(Json::parse(run.out));
      }
      EXPECT_EQ(reports[1].at("part").at("format"), "IGES");
      EXPECT_EQ(reports[1].at("part").at("unit"), std::string(unit) == "MM" ? "mm" : "in");
      EXPECT_TRUE(reports[1].at("part").at("closed").get<bool>()) << brep << unit;
      const double mm = std::string(unit) == "MM" ? 1.0 : 25.4;
      const auto value = [&](int k, const char* a, const char* b) {
        return reports[k].at(a).at(b).get<double>();
      };
      EXPECT_NEAR(mm * mm * mm * value(1, "part", "volume"), value(0, "part", "volume"),
                  1e-5 * value(0, "part", "volume"));
      for (const char* region : {"core", "cavity", "both", "undercut"})
        EXPECT_NEAR(mm * mm * value(1, "areas", region), value(0, "areas", region), 1e-2) << region;
    }
  }
}

TEST(IgesInput, CutAnywhereEndsInOneLine) {
  be_silent();
  const test::ScratchFolder folder;
  const std::string iges = folder.file("part.igs");
  IGESControl_Writer writer("MM", 0);
  writer.AddShape(block_with_pin());
  writer.ComputeModel();
  ASSERT_TRUE(writer.Write(iges.c_str()));
  const std::string whole = test::file_bytes(iges);
  const std::string last = whole.substr(whole.rfind('\n', whole.size() - 2) + 1);
  for (std::size_t k = 1; k < 40; ++k) {
    const std::size_t lines = whole.size() / 81 * k / 40;
    for (const std::string& end : {std::string(), last}) {
      const std::string name =
          folder.write("cut.igs", whole.substr(0, 81 * lines + (end.empty() ? k : 0)) + end);
      const auto run = test::run_moldlight({"info", name});
      if (run.exit_code == 0 && !end.empty()) continue;  // what is left of it
      EXPECT_EQ(run.exit_code, 1) << k << ": " << run.err;
      EXPECT_EQ(run.error_lines(), 1u) << k << ": " << run.err;
      EXPECT_EQ(run.out, "") << k;
    }
  }
}

}  // namespace
}  // namespace moldlight::step
