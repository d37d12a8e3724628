// moldlight.Part: made of arrays or read from a file.
#include "mesh/part.hpp"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include "base/error.hpp"
#include "classify/info_report.hpp"
#include "classify/json.hpp"
#include "classify/number_format.hpp"
#include "mesh/weld.hpp"
#include "mold/exact/united_bodies.hpp"
#include "python/bindings.hpp"

namespace moldlight::python {

template <>
inline constexpr bool k_bound<HealthReport> = true;

using namespace py::literals;

namespace {

/// The part of a caller's arrays, by the steps of a reader.
Part part_of(TriangleMesh mesh, const ReadOptions& options, const std::string& name,
             const Progress& progress) {
  Part part;
  part.file = name;
  part.format = "arrays";
  part.mesh = weld_vertices(mesh);
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  if (!options.unit.empty()) set_unit(part, options.unit);
  mend_part(part, options.repair, progress);
  if (part.mesh.facets.empty())
    throw UsageError("faces: none has an area; nothing is left of the part after the repair");
  return part;
}

PythonPart make_part(const py::object& vertices, const py::object& faces, const py::kwargs& keywords) {
  Given given("Part", keywords);
  ReadOptions options;
  given.take(array_options(), options);
  const py::object name_given = given.take("name"), progress = given.take("progress");
  const std::string name = name_given.is_none() ? std::string() : value_text(name_given, "name");
  given.end();
  TriangleMesh mesh = mesh_of(vertices, faces);
  return {watched(progress, [&](const Progress& work_progress) {
    Part part = part_of(std::move(mesh), options, name, work_progress);
    put_in_place_order(part, work_progress);
    return prepare_part(std::move(part), work_progress);
  })};
}

PythonPart read(const py::object& path, const py::kwargs& keywords) {
  Given given("read", keywords);
  ReadOptions options;
  given.take(reading_options(), options);
  const py::object progress = given.take("progress");
  given.end();
  const std::string file = path_of(path, "path");
  return {watched(progress,
                  [&](const Progress& work_progress) { return load_part(file, options, work_progress); })};
}

py::list body_list(const PythonPart& self) {
  py::list bodies;
  for (const Body& body : self.model->part.bodies) {
    bodies.append(py::dict("name"_a = to_python(Json(body.name)), "first_facet"_a = body.first_facet,
                           "facets"_a = body.facet_count));
  }
  return bodies;
}

std::string health_text(const HealthReport& health) {
  return fmt::format("<moldlight.Health: {} facets, {}, area {}, volume {}>", health.facets,
                     health.closed ? "closed" : "not closed", figure(health.area), figure(health.volume));
}

void add_health(py::module_& module) {
  py::class_<HealthReport>(module, "Health",
                           "State of a part's mesh. Counts of edges are of pairs of vertices; area and "
                           "volume are in the part's unit squared and cubed.")
      .def_readonly("facets", &HealthReport::facets)
      .def_readonly("vertices", &HealthReport::vertices, "Used by at least one facet.")
      .def_readonly("components", &HealthReport::components)
      .def_readonly("open_edges", &HealthReport::open_edges, "Used by one facet.")
      .def_readonly("nonmanifold_edges", &HealthReport::nonmanifold_edges, "Used by three facets or more.")
      .def_readonly("inconsistent_edges", &HealthReport::inconsistent_edges,
                    "Used by two facets that run through it in the same sense.")
      .def_readonly("degenerate_facets", &HealthReport::degenerate_facets,
                    "With two equal corners, or without area.")
      .def_readonly("duplicate_facets", &HealthReport::duplicate_facets)
      .def_readonly("closed", &HealthReport::closed, "Inside and outside are defined.")
      .def_readonly("area", &HealthReport::area)
      .def_readonly("volume", &HealthReport::volume)
      .def_property_readonly(
          "bounds",
          [](const HealthReport& health) {
            return py::make_tuple(to_python(health.bounds.min), to_python(health.bounds.max));
          },
          "The box around the part: its lowest corner and its highest.")
      .def("__repr__", health_text);
}

void add_properties(PartClass& part) {
  const auto of_part = [](auto Part::*member) {
    return [member](const PythonPart& self) { return to_python(Json(self.model->part.*member)); };
  };
  part.def_property_readonly("file", of_part(&Part::file), "The file's name, or the name given to arrays.")
      .def_property_readonly("format", of_part(&Part::format), "\"STL binary\", \"STEP\", …, \"arrays\".")
      .def_property_readonly("unit", of_part(&Part::unit), "\"mm\", …; empty if the file names none.")
      .def_property_readonly("repairs", of_part(&Part::repairs), "Changes by the repair, a sentence each.")
      .def_property_readonly(
          "warnings", [](const PythonPart& self) { return to_python(Json(self.model->warnings)); },
          "Why figures are in doubt, a sentence each.")
      .def_property_readonly("bodies", body_list,
                             "A dict a body: its name, its first facet, and how many it has.")
      .def_property_readonly(
          "health", [](const PythonPart& self) { return self.model->health; }, "State of the mesh.");
}

void add_arrays(PartClass& part) {
  part.def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return view(self.cast<const PythonPart&>().model->part.mesh.vertices, self);
          },
          "n x 3 float64, read only. Equal vertices of what was given are one.")
      .def_property_readonly(
          "faces",
          [](const PythonPart& self) { return listed(self.model->part.mesh.facets, self.model->part); },
          "m x 3 uint32, read only: facet k is facet k of the file or of the array given, unless a body was "
          "chosen or the mesh repaired. Which corner is first is not kept.")
      .def_property_readonly(
          "facet_areas",
          [](const PythonPart& self) { return listed(self.model->geometry.areas, self.model->part); },
          "Area of each facet: m float64, read only.")
      .def_property_readonly(
          "facet_normals",
          [](const PythonPart& self) { return listed(self.model->geometry.normals, self.model->part); },
          "Normal of each facet: m x 3 float64, read only, unit vectors that point outward.")
      .def_property_readonly(
          "face_of_facet",
          [](const PythonPart& self) -> py::object {
            const Part& read_part = self.model->part;
            if (read_part.facet_source.empty()) return py::none();
            return listed(read_part.facet_source, read_part);
          },
          "m uint32, read only: the CAD face or polygon of the file that each facet comes from; None where "
          "each facet is its own.");
}

constexpr std::string_view k_part_text =
    "A part: a closed mesh of triangles, counter-clockwise seen from outside.\n\n"
    "vertices: n x 3 numbers of any kind and layout, finite.\n"
    "faces: m x 3 whole numbers from 0 to n - 1.\n"
    "name: what reports call the part.\n"
    "progress: called with a stage and the share of it that is done, some times a second. What it\n"
    "raises ends the work. So does returning False, which raises Cancelled.\n\n"
    "Part.read() reads a file. A part does not change, and threads may share it.";

const CallSettings k_part_settings("Part", array_options());
const CallSettings k_read_settings("read", reading_options());

}  // namespace

Json PythonPart::json() const {
  return watched(py::none(), [this](const Progress&) { return info_json(*model, defect_places(*model)); });
}

PartClass add_part(py::module_& module) {
  add_health(module);
  PartClass part(module, "Part",
                 call_doc({.name = "Part",
                           .arguments = "vertices, faces",
                           .more = "name='', progress=None",
                           .text = k_part_text,
                           .settings = "Part"}));
  part.def(py::init(&make_part), py::arg("vertices"), py::arg("faces"),
           call_doc({.name = "__init__",
                     .arguments = "self, vertices, faces",
                     .more = "name='', progress=None",
                     .text = k_part_text,
                     .settings = "Part"}))
      .def_static(
          "read", &read, py::arg("path"),
          call_doc({.name = "read",
                    .arguments = "path",
                    .more = "progress=None",
                    .text = "Reads a part: STL, OBJ, PLY, OFF, 3MF or STEP, recognised by its content.",
                    .settings = "read"}));
  add_properties(part);
  add_arrays(part);
  add_report(part, "The health report", "info");
  part.def("__repr__", [](const PythonPart& self) {
    return py::str(fmt::format("<moldlight.Part {}: {} facets, {}>",
                               self.model->part.file.empty() ? "of arrays" : part_name(self.model->part),
                               self.model->health.facets,
                               self.model->health.closed ? "closed" : "not closed"));
  });
  return part;
}

}  // namespace moldlight::python
