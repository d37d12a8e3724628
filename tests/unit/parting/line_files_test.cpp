// The written parting line, read back by readers that share nothing with the writers.
#include "parting/line_files.hpp"

#include <cmath>
#include <map>
#include <sstream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#if MOLDLIGHT_STEP_BUILT
#include <BRepAdaptor_Curve.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#endif

namespace moldlight {
namespace {

using test::file_bytes;

constexpr double k_inch = 25.4;

WrittenLines two_loops() {
  WrittenLines lines{.loops = {}, .direction = {0, 0, 1}, .unit = "in", .name = "a part's name\n0\nEOF"};
  lines.loops.push_back({"outer", {{0, 0, 0.125}, {4, 0, 0.125}, {4, 3, 1e-9}, {0, 3, -1.0 / 3.0}}});
  lines.loops.push_back({"shut-off", {{1, 1, 0}, {1, 2, 0}, {2, 2, 123456.789012345678}}});
  return lines;
}

double length_of(const std::vector<glm::dvec3>& points) {
  double length = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k)
    length += glm::distance(points[k], points[(k + 1) % points.size()]);
  return length;
}

class LineFiles : public ::testing::Test {
 protected:
  std::string written(const std::string& name) {
    const std::string path = folder.file(name);
    write_lines(path, two_loops());
    return path;
  }
  test::ScratchFolder folder;
};

/// Pairs of a group code and a value, as any reader of DXF takes them.
TEST_F(LineFiles, DxfHasAClosedPolylineALoop) {
  std::istringstream text(file_bytes(written("line.dxf")));
  struct Polyline {
    std::string layer;
    int flags = 0;
    std::vector<glm::dvec3> points;
  };
  std::vector<Polyline> polylines;
  std::string code, value, entity, comments;
  int layers = 0;
  bool ended = false;
  while (std::getline(text, code) && std::getline(text, value)) {
    const int group = std::stoi(code);
    if (group == 0) {
      entity = value;
      ended = value == "EOF";
      if (value == "POLYLINE") polylines.emplace_back();
      if (value == "VERTEX") polylines.back().points.emplace_back(0.0);
      layers += value == "LAYER" ? 1 : 0;
    }
    if (group == 999) comments += value + "|";
    if (entity == "POLYLINE" && group == 8) polylines.back().layer = value;
    if (entity == "POLYLINE" && group == 70) polylines.back().flags = std::stoi(value);
    if (entity == "VERTEX" && group == 8) {
      EXPECT_EQ(value, polylines.back().layer);
    }
    if (entity == "VERTEX" && group == 70) {
      EXPECT_EQ(value, "32");
    }
    if (entity == "VERTEX" && group >= 10 && group <= 30)
      polylines.back().points.back()[group / 10 - 1] = std::stod(value);
  }
  EXPECT_TRUE(ended);
  EXPECT_EQ(layers, 3);
  EXPECT_NE(comments.find("unit: in"), std::string::npos) << comments;
  ASSERT_EQ(polylines.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(polylines[k].flags, 9);
    EXPECT_EQ(polylines[k].points, two_loops().loops[k].points);
  }
  EXPECT_EQ(polylines[0].layer, "OUTER");
  EXPECT_EQ(polylines[1].layer, "SHUT_OFF");
}

TEST_F(LineFiles, ObjHasAPolylineALoop) {
  std::istringstream text(file_bytes(written("line.obj")));
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::size_t>> lines;
  std::vector<std::string> groups;
  for (std::string row; std::getline(text, row);) {
    std::istringstream words(row);
    std::string word;
    words >> word;
    if (word == "v") {
      glm::dvec3 p;
      words >> p.x >> p.y >> p.z;
      points.push_back(p);
    } else if (word == "g") {
      words >> groups.emplace_back();
    } else if (word == "l") {
      lines.emplace_back();
      for (std::size_t number = 0; words >> number;) lines.back().push_back(number);
    }
  }
  EXPECT_EQ(groups, (std::vector<std::string>{"outer", "shut-off"}));
  ASSERT_EQ(lines.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<glm::dvec3> loop = two_loops().loops[k].points;
    ASSERT_EQ(lines[k].size(), loop.size() + 1);
    EXPECT_EQ(lines[k].front(), lines[k].back());
    for (std::size_t i = 0; i < loop.size(); ++i) EXPECT_EQ(points.at(lines[k][i] - 1), loop[i]);
  }
}

TEST_F(LineFiles, CsvHasALineAPoint) {
  std::istringstream text(file_bytes(written("line.csv")));
  std::string row;
  std::getline(text, row);
  EXPECT_EQ(row, "loop,kind,x,y,z");
  std::map<std::string, std::size_t> counts;
  while (std::getline(text, row)) ++counts[row.substr(0, row.find(',', row.find(',') + 1))];
  EXPECT_EQ(counts, (std::map<std::string, std::size_t>{{"1,outer", 4}, {"2,shut-off", 3}}));
}

TEST_F(LineFiles, SvgIsXmlInMillimetres) {
  const std::string path = written("line.svg"), text = file_bytes(path);
  EXPECT_NE(text.find("mm\" height="), std::string::npos);
  std::size_t paths = 0, groups = 0;
  for (std::size_t at = 0; (at = text.find("<path", at)) != std::string::npos; ++at) ++paths;
  for (std::size_t at = 0; (at = text.find("<g ", at)) != std::string::npos; ++at) ++groups;
  EXPECT_EQ(paths, 7U);
  EXPECT_EQ(groups, 2U);
  const double width = std::stod(text.substr(text.find("width=\"") + 7));
  EXPECT_NEAR(width, 4 * k_inch * 1.06, 1e-6);
}

TEST_F(LineFiles, AreRefusedByTheirExtension) {
  EXPECT_THROW(check_line_extension("line.stl"), UsageError);
  EXPECT_THROW(check_line_extension("line"), UsageError);
  for (const auto& format : line_formats()) check_line_extension("line." + std::string(format.extension));
}

#if MOLDLIGHT_STEP_BUILT
/// By OpenCASCADE: an edge a side, as long as the loop, in millimetres.
TEST_F(LineFiles, StepIsReadByOpenCascade) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Reader reader;
  ASSERT_EQ(reader.ReadFile(written("line.step").c_str()), IFSelect_RetDone);
  ASSERT_EQ(reader.TransferRoots(), 1);
  double length = 0.0;
  std::size_t edges = 0;
  for (TopExp_Explorer edge(reader.OneShape(), TopAbs_EDGE); edge.More(); edge.Next()) {
    length += GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(TopoDS::Edge(edge.Current())));
    ++edges;
  }
  const WrittenLines lines = two_loops();
  EXPECT_GT(edges, 0U);
  EXPECT_NEAR(length, k_inch * (length_of(lines.loops[0].points) + length_of(lines.loops[1].points)),
              1e-6 * length);
}
#endif

}  // namespace
}  // namespace moldlight
