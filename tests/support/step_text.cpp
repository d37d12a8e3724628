#include "support/step_text.hpp"

#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace moldlight::test {

namespace {

/// Members of a list, such as "#4,#5".
std::string references(const std::vector<std::size_t>& numbers) {
  std::string list;
  for (const std::size_t number : numbers) list += (list.empty() ? "" : ",") + step_reference(number);
  return list;
}

std::string real(double value) { return fmt::format("{:.9E}", value); }

std::string reals(const glm::dvec3& value) {
  return real(value.x) + "," + real(value.y) + "," + real(value.z);
}

/// Corner k of a box has x, y and z at the far side by the bits of k.
glm::dvec3 corner_of(const glm::dvec3& size, unsigned corner) {
  return {(corner & 1U) != 0 ? size.x : 0.0, (corner & 2U) != 0 ? size.y : 0.0,
          (corner & 4U) != 0 ? size.z : 0.0};
}

// Seen from outside, the corners of each side run counter-clockwise.
constexpr unsigned k_sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

}  // namespace

std::string step_reference(std::size_t number) { return fmt::format("#{}", number); }

std::string StepText::file() const {
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('" +
         schema_ + "'));\nENDSEC;\nDATA;\n" + data_ + "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::size_t StepText::add(const std::string& entity) {
  data_ += fmt::format("#{}={};\n", ++count_, entity);
  return count_;
}

std::size_t StepText::point(const glm::dvec3& at) { return add("CARTESIAN_POINT('',(" + reals(at) + "))"); }

std::size_t StepText::direction(const glm::dvec3& along) {
  return add("DIRECTION('',(" + reals(along) + "))");
}

std::size_t StepText::placement(const StepPlacement& place) {
  const std::size_t origin = point(place.origin), z = direction(place.z), x = direction(place.x);
  return add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", origin, z, x));
}

std::size_t StepText::box_shell(const glm::dvec3& size) {
  std::array<std::size_t, 8> vertices{};
  for (unsigned k = 0; k < 8; ++k) {
    vertices[k] = add(fmt::format("VERTEX_POINT('',#{})", point(corner_of(size, k))));
  }
  std::array<std::array<std::size_t, 8>, 8> edges{};
  for (unsigned from = 0; from < 8; ++from) {
    for (const unsigned bit : {1U, 2U, 4U}) {
      if ((from & bit) != 0) continue;
      const unsigned to = from | bit;
      const glm::dvec3 start = corner_of(size, from);
      const std::size_t vector =
          add(fmt::format("VECTOR('',#{},1.)", direction(glm::normalize(corner_of(size, to) - start))));
      const std::size_t line = add(fmt::format("LINE('',#{},#{})", point(start), vector));
      edges[from][to] =
          add(fmt::format("EDGE_CURVE('',#{},#{},#{},.T.)", vertices[from], vertices[to], line));
    }
  }
  std::vector<std::size_t> faces;
  for (const auto& side : k_sides) {
    std::vector<std::size_t> loop;
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned from = side[i], to = side[(i + 1) % 4];
      const bool along = from < to;
      loop.push_back(add(fmt::format("ORIENTED_EDGE('',*,*,#{},.{}.)",
                                     along ? edges[from][to] : edges[to][from], along ? "T" : "F")));
    }
    const std::size_t edge_loop = add("EDGE_LOOP('',(" + references(loop) + "))");
    const std::size_t bound = add(fmt::format("FACE_OUTER_BOUND('',#{},.T.)", edge_loop));
    const glm::dvec3 start = corner_of(size, side[0]);
    const glm::dvec3 along = glm::normalize(corner_of(size, side[1]) - start);
    const glm::dvec3 across = glm::normalize(corner_of(size, side[3]) - start);
    const std::size_t plane =
        add(fmt::format("PLANE('',#{})", placement({start, glm::cross(along, across), along})));
    faces.push_back(add(fmt::format("ADVANCED_FACE('',(#{}),#{},.T.)", bound, plane)));
  }
  return add("CLOSED_SHELL('',(" + references(faces) + "))");
}

std::size_t StepText::box(const glm::dvec3& size) {
  return add(fmt::format("MANIFOLD_SOLID_BREP('',#{})", box_shell(size)));
}

std::size_t StepText::style(std::size_t item, const glm::dvec3& colour) {
  const std::size_t rgb = add("COLOUR_RGB(''," + reals(colour) + ")");
  const std::size_t filled = add(fmt::format("FILL_AREA_STYLE_COLOUR('',#{})", rgb));
  const std::size_t fill = add(fmt::format("FILL_AREA_STYLE('',(#{}))", filled));
  const std::size_t area = add(fmt::format("SURFACE_STYLE_FILL_AREA(#{})", fill));
  const std::size_t side = add(fmt::format("SURFACE_SIDE_STYLE('',(#{}))", area));
  const std::size_t usage = add(fmt::format("SURFACE_STYLE_USAGE(.BOTH.,#{})", side));
  const std::size_t assignment = add(fmt::format("PRESENTATION_STYLE_ASSIGNMENT((#{}))", usage));
  return add(fmt::format("STYLED_ITEM('',(#{}),#{})", assignment, item));
}

void StepText::show_styles(const std::string& styles, std::size_t context) {
  add(fmt::format("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({}),#{})", styles, context));
}

std::vector<std::size_t> StepText::faces() const {
  constexpr std::string_view k_face = "=ADVANCED_FACE";
  std::vector<std::size_t> numbers;
  for (std::size_t at = data_.find(k_face); at != std::string::npos; at = data_.find(k_face, at + 1))
    numbers.push_back(std::stoul(data_.substr(data_.rfind('#', at) + 1)));
  return numbers;
}

std::size_t StepText::context(StepUnit unit) {
  std::size_t length = 0;
  if (unit == StepUnit::inch) {
    const std::size_t mm = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const std::size_t measure = add(fmt::format("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#{})", mm));
    const std::size_t dimensions = add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
    length = add(
        fmt::format("(CONVERSION_BASED_UNIT('INCH',#{})LENGTH_UNIT()NAMED_UNIT(#{}))", measure, dimensions));
  } else {
    length = add(fmt::format("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({},.METRE.))",
                             unit == StepUnit::mm ? ".MILLI." : "$"));
  }
  const std::size_t angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  const std::size_t solid_angle = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
  const std::size_t uncertainty = add(fmt::format(
      "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),#{},'distance_accuracy_value','')", length));
  return add(
      fmt::format("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{}))"
                  "GLOBAL_UNIT_ASSIGNED_CONTEXT((#{},#{},#{}))REPRESENTATION_CONTEXT('',''))",
                  uncertainty, length, angle, solid_angle));
}

StepText::Product StepText::product(const std::string& name, const std::string& kind,
                                    const std::string& items, std::size_t context) {
  const std::size_t application = add("APPLICATION_CONTEXT('mechanical design')");
  const std::size_t product_context = add(fmt::format("PRODUCT_CONTEXT('',#{},'mechanical')", application));
  const std::size_t definition_context =
      add(fmt::format("PRODUCT_DEFINITION_CONTEXT('part definition',#{},'design')", application));
  const std::size_t thing = add(fmt::format("PRODUCT('{0}','{0}','',(#{1}))", name, product_context));
  const std::size_t formation = add(fmt::format("PRODUCT_DEFINITION_FORMATION('','',#{})", thing));
  Product result;
  result.definition =
      add(fmt::format("PRODUCT_DEFINITION('design','',#{},#{})", formation, definition_context));
  const std::size_t shape = add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", result.definition));
  result.representation = add(fmt::format("{}('{}',({}),#{})", kind, name, items, context));
  add(fmt::format("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", shape, result.representation));
  return result;
}

StepText::Product StepText::box_product(const std::string& name, const glm::dvec3& size,
                                        std::size_t context) {
  return product(name, "ADVANCED_BREP_SHAPE_REPRESENTATION", references({placement({}), box(size)}), context);
}

StepText::Product StepText::assembly(const std::string& name, std::size_t context) {
  return product(name, "SHAPE_REPRESENTATION", references({placement({})}), context);
}

void StepText::place(const Product& part, const Product& whole, const StepPlacement& place) {
  const std::size_t from = placement({}), to = placement(place);
  const std::size_t transformation = add(fmt::format("ITEM_DEFINED_TRANSFORMATION('','',#{},#{})", from, to));
  const std::size_t relation = add(
      fmt::format("(REPRESENTATION_RELATIONSHIP('','',#{},#{})"
                  "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{})SHAPE_REPRESENTATION_RELATIONSHIP())",
                  part.representation, whole.representation, transformation));
  const std::size_t use = add(fmt::format("NEXT_ASSEMBLY_USAGE_OCCURRENCE('{}','','',#{},#{},$)", count_,
                                          whole.definition, part.definition));
  const std::size_t shape = add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", use));
  add(fmt::format("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{},#{})", relation, shape));
}

std::string StepText::mapped_box(const glm::dvec3& size, const Operator& target, std::size_t context) {
  const std::size_t source = add(fmt::format("ADVANCED_BREP_SHAPE_REPRESENTATION('',({}),#{})",
                                             references({placement({}), box(size)}), context));
  const std::size_t map = add(fmt::format("REPRESENTATION_MAP(#{},#{})", placement({}), source));
  const std::size_t x = direction(target.x), y = direction(target.y), z = direction(target.z);
  const std::size_t turn =
      add(fmt::format("CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',#{},#{},#{},{},#{})", x, y,
                      point(target.origin), real(target.scale), z));
  return references({placement({}), add(fmt::format("MAPPED_ITEM('',#{},#{})", map, turn))});
}

}  // namespace moldlight::test
