#include "mesh/part.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/length_unit.hpp"
#include "mesh/weld.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_listed_bodies = 20;

std::string list_of_bodies(const Part& part) {
  std::string list;
  for (std::size_t i = 0; i < std::min(part.bodies.size(), k_listed_bodies); ++i) {
    list += fmt::format("{}{}{}", i == 0 ? "" : ", ", i + 1,
                        part.bodies[i].name.empty() ? "" : " '" + part.bodies[i].name + "'");
  }
  return part.bodies.size() > k_listed_bodies ? list + ", ..." : list;
}

[[noreturn]] void fail_selection(const Part& part, std::string_view selector, std::string_view why) {
  throw UsageError(
      fmt::format("{}: {} '{}'; its bodies are {}", part.file, why, selector, list_of_bodies(part)));
}

std::size_t find_body(const Part& part, std::string_view selector) {
  if (const auto number = number_from<std::size_t>(selector)) {
    if (*number < 1 || *number > part.bodies.size()) fail_selection(part, selector, "there is no body");
    return *number - 1;
  }
  const auto is_named = [&](const Body& body) { return body.name == selector; };
  const auto found = std::find_if(part.bodies.begin(), part.bodies.end(), is_named);
  if (found == part.bodies.end()) fail_selection(part, selector, "there is no body");
  if (std::find_if(found + 1, part.bodies.end(), is_named) != part.bodies.end()) {
    fail_selection(part, selector, "more than one body is named");
  }
  return static_cast<std::size_t>(found - part.bodies.begin());
}

template <typename T>
std::vector<T> run_of(const std::vector<T>& values, const Body& body) {
  if (values.empty()) return {};
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(body.first_facet);
  return {first, first + static_cast<std::ptrdiff_t>(body.facet_count)};
}

}  // namespace

Part extract_body(const Part& part, std::size_t index) {
  CHECK(index < part.bodies.size());
  const Body& body = part.bodies[index];
  Part extracted;
  extracted.file = part.file;
  extracted.format = part.format;
  extracted.unit = part.unit;
  extracted.warnings = part.warnings;
  extracted.repairs = part.repairs;
  extracted.bodies = {{body.name, 0, body.facet_count}};
  for (const Body& each : part.bodies) extracted.file_bodies.push_back(each.name);
  extracted.chosen_body = index + 1;
  extracted.mesh.vertices = part.mesh.vertices;
  extracted.mesh.facets = run_of(part.mesh.facets, body);
  extracted.mesh = weld_vertices(extracted.mesh);
  extracted.facet_source = run_of(part.facet_source, body);
  extracted.has_cad_faces = part.has_cad_faces;
  extracted.face_colours = part.face_colours;
  extracted.file_facets = run_of(part.file_facets, body);
  if (part.file_facets.empty()) {
    for (FacetIndex facet = 0; facet < body.facet_count; ++facet) {
      extracted.file_facets.push_back(body.first_facet + facet);
    }
  }
  return extracted;
}

Part select_body(Part part, std::string_view selector) {
  if (selector == "all") return part;
  return extract_body(part, find_body(part, selector));
}

void set_unit(Part& part, std::string_view unit) {
  const LengthUnit to = parse_length_unit(unit);
  const auto from = find_length_unit(part.unit);
  part.unit = to.name;
  if (!from || from->mm == to.mm) return;
  for (glm::dvec3& vertex : part.mesh.vertices) vertex *= from->mm / to.mm;
  part.mesh = weld_vertices(part.mesh);
}

}  // namespace moldlight
