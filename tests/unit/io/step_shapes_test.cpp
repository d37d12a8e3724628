// STEP files of every schema, unit and kind of assembly, and those without any shape, written entity by
// entity.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mesh/part.hpp"
#include "support/step_text.hpp"
#include "unit/io/read_text.hpp"

namespace moldlight {
namespace {

using test::read_bytes;
using test::read_error;
using test::StepText;
using test::StepUnit;

constexpr glm::dvec3 k_size(1, 2, 3);
constexpr double k_area = 22.0, k_volume = 6.0;
constexpr double k_tolerance = 1e-9;

class StepShapes : public testing::Test {
 protected:
  void SetUp() override {
    if (!MOLDLIGHT_STEP_BUILT) GTEST_SKIP() << "built without STEP support";
  }
};

/// Boxes of k_size with outward facets, as many as there are bodies.
void expect_boxes(const Part& part, std::size_t count) {
  ASSERT_EQ(part.bodies.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const Part body = extract_body(part, i);
    const HealthReport health = health_report(body.mesh, facet_geometry(body.mesh));
    EXPECT_TRUE(health.closed);
    EXPECT_NEAR(signed_volume(body.mesh), k_volume, k_tolerance);
    EXPECT_NEAR(health.area, k_area, k_tolerance);
  }
}

void expect_bounds(const Part& part, std::size_t body, const glm::dvec3& min, const glm::dvec3& max) {
  const Bounds box = bounds(extract_body(part, body).mesh);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.min[axis], min[axis], k_tolerance) << "body " << body << ", axis " << axis;
    EXPECT_NEAR(box.max[axis], max[axis], k_tolerance) << "body " << body << ", axis " << axis;
  }
}

TEST_F(StepShapes, KeepTheColoursOfFaces) {
  StepText text;
  const std::size_t context = text.context(StepUnit::mm), solid = text.box(k_size);
  const std::vector<std::size_t> faces = text.faces();
  ASSERT_EQ(faces.size(), 6u);
  text.product("box", "ADVANCED_BREP_SHAPE_REPRESENTATION", test::step_reference(solid), context);
  const std::size_t red = text.style(faces[2], {1.0, 0.0, 0.0}), all = text.style(solid, {0.2, 0.4, 0.6});
  text.show_styles(test::step_reference(red) + "," + test::step_reference(all), context);
  const Part part = read_bytes("a.step", text.file());
  expect_boxes(part, 1);
  // A face's own colour counts, elsewhere the solid's.
  const std::uint32_t rest = 0x336699;
  EXPECT_EQ(part.face_colours, (std::vector<std::uint32_t>{rest, rest, 0xFF0000, rest, rest, rest}));
  const Part body = extract_body(part, 0);
  EXPECT_EQ(body.face_colours, part.face_colours);
}

TEST_F(StepShapes, WithoutColoursHaveNone) {
  StepText text;
  text.box_product("box", k_size, text.context(StepUnit::mm));
  EXPECT_TRUE(read_bytes("a.step", text.file()).face_colours.empty());
}

TEST_F(StepShapes, ComeInAllThreeSchemas) {
  for (const std::string_view schema : {test::k_ap203, test::k_ap214, test::k_ap242}) {
    StepText text(schema);
    text.box_product("box", k_size, text.context(StepUnit::mm));
    const Part part = read_bytes("a.step", text.file());
    EXPECT_EQ(part.warnings, std::vector<std::string>()) << schema;
    expect_boxes(part, 1);
    EXPECT_EQ(part.bodies.at(0).name, "box");
  }
}

TEST_F(StepShapes, KeepTheUnitOfTheFile) {
  const std::pair<StepUnit, std::string> units[] = {
      {StepUnit::mm, "mm"}, {StepUnit::m, "m"}, {StepUnit::inch, "in"}};
  for (const auto& [unit, name] : units) {
    StepText text;
    text.box_product("box", k_size, text.context(unit));
    const Part part = read_bytes("a.step", text.file());
    EXPECT_EQ(part.unit, name);
    expect_boxes(part, 1);
  }
}

TEST_F(StepShapes, OfMixedUnitsComeInThatOfTheWhole) {
  StepText text;
  const std::size_t mm = text.context(StepUnit::mm), inch = text.context(StepUnit::inch);
  const StepText::Product whole = text.assembly("whole", mm);
  text.place(text.box_product("metric", k_size, mm), whole, {});
  text.place(text.box_product("imperial", k_size, inch), whole, {.origin = {100, 0, 0}});
  const Part part = read_bytes("a.step", text.file());
  EXPECT_EQ(part.unit, "mm");
  ASSERT_EQ(part.bodies.size(), 2u);
  expect_bounds(part, 0, {0, 0, 0}, {1, 2, 3});
  expect_bounds(part, 1, {100, 0, 0}, {125.4, 50.8, 76.2});
}

TEST_F(StepShapes, OfMixedUnitsWithoutAWholeAreBroughtToMillimetres) {
  StepText text;
  text.box_product("imperial", k_size, text.context(StepUnit::inch));
  text.box_product("metric", k_size, text.context(StepUnit::m));
  const Part part = read_bytes("a.step", text.file());
  EXPECT_EQ(part.unit, "mm");
  EXPECT_EQ(part.warnings,
            std::vector<std::string>{"the STEP file mixes units; all lengths were brought to millimetres"});
  ASSERT_EQ(part.bodies.size(), 2u);
  expect_bounds(part, 0, {0, 0, 0}, {25.4, 50.8, 76.2});
  expect_bounds(part, 1, {0, 0, 0}, {1000, 2000, 3000});
}

TEST_F(StepShapes, RepeatInNestedAssemblies) {
  StepText text;
  const std::size_t mm = text.context(StepUnit::mm);
  const StepText::Product box = text.box_product("box", k_size, mm);
  const StepText::Product pair = text.assembly("pair", mm), whole = text.assembly("whole", mm);
  text.place(box, pair, {});
  text.place(box, pair, {.origin = {10, 0, 0}, .z = {0, 1, 0}, .x = {0, 0, 1}});
  text.place(pair, whole, {});
  text.place(pair, whole, {.origin = {0, 0, 50}, .z = {1, 0, 0}, .x = {0, 1, 0}});
  const Part part = read_bytes("a.step", text.file());
  EXPECT_TRUE(part.warnings.empty());
  expect_boxes(part, 4);
  expect_bounds(part, 0, {0, 0, 0}, {1, 2, 3});
  expect_bounds(part, 1, {10, 0, 0}, {12, 3, 1});
  expect_bounds(part, 2, {0, 0, 50}, {3, 1, 52});
  expect_bounds(part, 3, {0, 10, 50}, {1, 12, 53});
}

/// Reads a box that is mapped into its place by an operator, as the only item or by an assembly.
std::string mapped(const StepText::Operator& target) {
  StepText text;
  const std::size_t mm = text.context(StepUnit::mm);
  text.product("whole", "SHAPE_REPRESENTATION", text.mapped_box(k_size, target, mm), mm);
  return text.file();
}

TEST_F(StepShapes, AreTurnedAndMovedByMaps) {
  const Part part =
      read_bytes("a.step", mapped({.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}, .origin = {20, 0, 0}}));
  EXPECT_TRUE(part.warnings.empty());
  expect_boxes(part, 1);
  expect_bounds(part, 0, {20, 0, 0}, {23, 1, 2});
}

/// OpenCASCADE would place them unmirrored and in full size without a word.
TEST_F(StepShapes, AreRefusedWhereAMapMirrorsOrScalesThem) {
  for (const std::string& file : {mapped({.y = {0, -1, 0}}), mapped({.scale = 2.0})}) {
    const std::string error = read_error("a.step", file);
    EXPECT_TRUE(error.starts_with("a.step: entity #")) << error;
    EXPECT_NE(error.find("this mirrors or scales a part of the assembly"), std::string::npos) << error;
  }
}

TEST_F(StepShapes, AreMissedWhereThereIsNoFace) {
  const auto error_of = [](const std::string& kind, const auto& add_item) {
    StepText text;
    const std::size_t mm = text.context(StepUnit::mm);
    text.product("part", kind, test::step_reference(add_item(text)), mm);
    return read_error("a.step", text.file());
  };
  const std::string no_face = "a.step: holds no face; export the part as a solid";
  EXPECT_EQ(error_of("ADVANCED_BREP_SHAPE_REPRESENTATION",
                     [](StepText& text) {
                       const std::size_t shell = text.add("CLOSED_SHELL('',())");
                       return text.add("MANIFOLD_SOLID_BREP(''," + test::step_reference(shell) + ")");
                     }),
            no_face);
  EXPECT_EQ(error_of("GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
                     [](StepText& text) {
                       const std::string from = test::step_reference(text.point({0, 0, 0}));
                       const std::string to = test::step_reference(text.point({1, 1, 1}));
                       const std::size_t line = text.add("POLYLINE('',(" + from + "," + to + "))");
                       return text.add("GEOMETRIC_CURVE_SET('',(" + test::step_reference(line) + "))");
                     }),
            no_face);
  EXPECT_EQ(error_of("SHAPE_REPRESENTATION",
                     [](StepText& text) {
                       const std::size_t point = text.point({0, 0, 0});
                       return text.add("GEOMETRIC_SET('',(" + test::step_reference(point) + "))");
                     }),
            no_face);
  EXPECT_EQ(error_of("ADVANCED_BREP_SHAPE_REPRESENTATION",
                     [](StepText& text) { return text.add("MANIFOLD_SOLID_BREP('',$)"); }),
            "a.step: holds no shape; export the part as a solid");
}

TEST_F(StepShapes, AreMissedInEmptyAndEndlessAssemblies) {
  const std::string no_shape = "a.step: holds no shape; export the part as a solid";
  StepText empty;
  empty.assembly("empty", empty.context(StepUnit::mm));
  EXPECT_EQ(read_error("a.step", empty.file()), no_shape);

  StepText endless;
  const std::size_t mm = endless.context(StepUnit::mm);
  const StepText::Product first = endless.assembly("first", mm), second = endless.assembly("second", mm);
  endless.place(endless.box_product("box", k_size, mm), first, {});
  endless.place(first, second, {});
  endless.place(second, first, {});
  EXPECT_EQ(read_error("a.step", endless.file()), no_shape);
}

TEST_F(StepShapes, ThatAreOpenShellsAreRead) {
  StepText text;
  const std::string shell = test::step_reference(text.box_shell(k_size));
  const std::size_t model = text.add("SHELL_BASED_SURFACE_MODEL('',(" + shell + "))");
  text.product("shell", "MANIFOLD_SURFACE_SHAPE_REPRESENTATION", test::step_reference(model),
               text.context(StepUnit::mm));
  expect_boxes(read_bytes("a.step", text.file()), 1);
}

/// OpenCASCADE would drop the entity at the fault, and go on with what is left of the part.
TEST_F(StepShapes, AreRefusedAtTheFirstFaultOfSyntax) {
  StepText text;
  text.box_product("box", k_size, text.context(StepUnit::mm));
  const std::string sound = text.file();
  for (const std::string part : {"EDGE_LOOP('',(", "PLANE(", "#40="}) {
    std::string broken = sound;
    const std::size_t at = broken.find(part);
    ASSERT_NE(at, std::string::npos);
    broken.insert(at + part.size(), ")");
    const auto line = 1 + std::count(broken.begin(), broken.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    EXPECT_EQ(read_error("a.step", broken), "a.step: line " + std::to_string(line) +
                                                ": this is not what STEP allows here; export the part again");
  }
  EXPECT_EQ(read_error("a.step", "ISO-10303-21;\nEND-ISO-10303-21;\n"),
            "a.step: line 2: this is not what STEP allows here; export the part again");
}

}  // namespace
}  // namespace moldlight
