#include "io/step_text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace moldlight {

StepText::StepText(std::string_view description, std::string_view name) {
  text_ = fmt::format(
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('{}'),'2;1');\n"
      "FILE_NAME('{}','',(''),(''),'moldlight','moldlight','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n",
      plain(description), plain(name));
  add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
  add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1)");
  add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
  add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
  add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#3,'distance_accuracy_value','')");
  add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#6))"
      "GLOBAL_UNIT_ASSIGNED_CONTEXT((#3,#4,#5))REPRESENTATION_CONTEXT('',''))");
  placement({0, 0, 0}, {0, 0, 1});
}

StepText::Number StepText::add(std::string_view entity) {
  fmt::format_to(std::back_inserter(text_), "#{}={};\n", next_, entity);
  return next_++;
}

StepText::Number StepText::point(const glm::dvec3& at) {
  return add(fmt::format("CARTESIAN_POINT('',({},{},{}))", real(at.x), real(at.y), real(at.z)));
}

StepText::Number StepText::direction(const glm::dvec3& unit) {
  return add(fmt::format("DIRECTION('',({},{},{}))", real(unit.x), real(unit.y), real(unit.z)));
}

StepText::Number StepText::placement(const glm::dvec3& at, const glm::dvec3& axis) {
  const glm::dvec3 other = std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const Number first = point(at);
  direction(axis);
  direction(glm::normalize(other - axis * glm::dot(other, axis)));
  return add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", first, first + 1, first + 2));
}

StepText::Number StepText::product(std::string_view name) {
  const std::string known = plain(name);
  const Number context = add("PRODUCT_CONTEXT('',#1,'mechanical')");
  add(fmt::format("PRODUCT('{0}','{0}','',(#{1}))", known, context));
  add(fmt::format("PRODUCT_DEFINITION_FORMATION('','',#{})", context + 1));
  add("PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design')");
  return add(fmt::format("PRODUCT_DEFINITION('design','',#{},#{})", context + 2, context + 3));
}

void StepText::represent(Number definition, Number representation) {
  const Number shape = add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", definition));
  add(fmt::format("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", shape, representation));
}

std::string StepText::list(Number first, std::size_t count) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k)
    fmt::format_to(std::back_inserter(text), "{}#{}", k == 0 ? "" : ",", first + k);
  return text;
}

std::string StepText::plain(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    result += code < 0x20 || code > 0x7e || letter == '\'' || letter == '\\' ? '_' : letter;
  }
  return result;
}

std::string StepText::real(double value) {
  std::string text = fmt::format("{}", value);
  const std::size_t power = text.find('e');
  if (text.find('.') == std::string::npos) text.insert(std::min(power, text.size()), ".");
  std::ranges::transform(text, text.begin(), [](char c) { return c == 'e' ? 'E' : c; });
  return text;
}

std::string StepText::finished() && { return std::move(text_ += "ENDSEC;\nEND-ISO-10303-21;\n"); }

}  // namespace moldlight
