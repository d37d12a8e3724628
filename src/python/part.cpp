// moldlight.Part: made of arrays or read from a file.
#include "mesh/part.hpp"

#include <cstring>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include "base/error.hpp"
#include "base/shown_text.hpp"
#include "classify/info_report.hpp"
#include "classify/json.hpp"
#include "classify/number_format.hpp"
#include "io/part_formats.hpp"
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

/// A file's bytes, which a caller handed over or has open.
struct Content {
  std::string name;
  py::object bytes;  // null where a file is named
};

Content content_of(const py::object& file) {
  const auto is_bytes = [](const py::handle& value) {
    return PyBytes_Check(value.ptr()) || PyByteArray_Check(value.ptr()) || PyMemoryView_Check(value.ptr());
  };
  const bool open = !py::hasattr(file, "__fspath__") && py::hasattr(file, "read");
  if (!open && !is_bytes(file)) return {path_of(file, "path"), {}};
  Content content{"bytes", file};
  try {
    if (open) content.bytes = file.attr("read")();
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_UnicodeDecodeError)) throw;
    throw UsageError("path: the file is open as text, and is none; open it with the mode 'rb'");
  }
  if (open && py::hasattr(file, "name") && py::isinstance<py::str>(file.attr("name")))
    content.name = value_text(file.attr("name"), "path");
  if (py::isinstance<py::str>(content.bytes)) content.bytes = content.bytes.attr("encode")();
  if (!is_bytes(content.bytes)) throw UsageError("path: its read() gives neither bytes nor text");
  content.bytes = py::reinterpret_steal<py::object>(PyBytes_FromObject(content.bytes.ptr()));
  if (!content.bytes) throw py::error_already_set();
  return content;
}

PythonPart read(const py::object& path, const py::kwargs& keywords) {
  Given given("read", keywords);
  ReadOptions options;
  given.take(reading_options(), options);
  const py::object progress = given.take("progress"), format = given.take("format");
  given.end();
  if (!format.is_none()) {
    options.format = value_text(format, "format");
    if (!is_part_file_name("part." + options.format))
      throw UsageError(
          fmt::format("format: '{}' is none of {}", one_line(options.format), part_format_names(", ")));
  }
  const Content content = content_of(path);
  const std::string_view bytes = content.bytes ? std::string_view(py::cast<py::bytes>(content.bytes)) : "";
  return {watched(progress, [&](const Progress& work_progress) {
    return content.bytes ? load_part_bytes(content.name, bytes, options, work_progress)
                         : load_part(content.name, options, work_progress);
  })};
}

template <typename T>
py::bytes packed(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}
template <typename T>
std::vector<T> unpacked(const py::handle& bytes, std::size_t facets) {
  const auto text = bytes.cast<std::string_view>();
  std::vector<T> numbers(text.size() / sizeof(T));
  std::memcpy(numbers.data(), text.data(), numbers.size() * sizeof(T));
  if (facets != 0 && !numbers.empty() && numbers.size() != facets)
    throw UsageError("the pickled part is damaged");
  return numbers;
}

/// The part as it stands: its mesh, and what else is known of it.
py::tuple pickled(const PythonPart& self) {
  const Part& part = self.model->part;
  py::list bodies;
  for (const Body& body : part.bodies) bodies.append(py::make_tuple(py::bytes(body.name), body.facet_count));
  return py::make_tuple(mesh_arrays(part.mesh), py::bytes(part.file), part.format, part.unit, bodies,
                        packed(part.facet_source), part.has_cad_faces, packed(part.face_colours),
                        packed(part.file_facets), to_python(Json(part.warnings)),
                        to_python(Json(part.repairs)), to_python(Json(part.file_bodies)), part.chosen_body,
                        part.effort, to_python(Json(self.model->warnings)));
}

PythonPart unpickled(const py::tuple& state) {
  Part part;
  const auto mesh = state[0].cast<py::tuple>();
  part.mesh = mesh_of(mesh[0], mesh[1]);
  part.file = state[1].cast<std::string>();
  part.format = state[2].cast<std::string>();
  part.unit = state[3].cast<std::string>();
  const std::size_t facets = part.mesh.facets.size();
  std::uint64_t covered = 0;
  for (const py::handle& body : state[4]) {
    const auto both = body.cast<py::tuple>();
    part.bodies.push_back(
        {both[0].cast<std::string>(), static_cast<FacetIndex>(covered), both[1].cast<FacetIndex>()});
    covered += part.bodies.back().facet_count;
  }
  if (covered != facets) throw UsageError("the pickled part is damaged");
  part.facet_source = unpacked<std::uint32_t>(state[5], facets);
  part.has_cad_faces = state[6].cast<bool>();
  part.face_colours = unpacked<std::uint32_t>(state[7], 0);
  part.file_facets = unpacked<std::uint32_t>(state[8], facets);
  using Texts = std::vector<std::string>;
  part.warnings = state[9].cast<Texts>();
  part.repairs = state[10].cast<Texts>();
  part.file_bodies = state[11].cast<Texts>();
  part.chosen_body = state[12].cast<std::size_t>();
  part.effort = state[13].cast<double>();
  const auto warnings = state[14].cast<Texts>();  // of the mesh as it was read, too
  return {watched(py::none(), [&](const Progress& progress) {
    auto model = std::const_pointer_cast<PartModel>(prepare_part(std::move(part), progress));
    model->warnings = warnings;
    return std::shared_ptr<const PartModel>(model);
  })};
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

constexpr std::string_view k_read_text =
    "Reads a part: STL, OBJ, PLY, OFF, 3MF, STEP or IGES, recognised by its content.\n\n"
    "path: a file's name, its content as bytes, or what has read(), such as an open file.\n"
    "format: 'stl', 'obj' and so on, where neither content nor name says it.\n"
    "progress: as for Part().";

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
      .def_static("read", &read, py::arg("path"),
                  call_doc({.name = "read",
                            .arguments = "path",
                            .more = "format=None, progress=None",
                            .text = k_read_text,
                            .settings = "read"}));
  add_properties(part);
  add_arrays(part);
  add_report(part, "The health report", "info");
  part.def(py::pickle(&pickled, &unpickled))
      .def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, const py::object&) { return self; });
  part.def("__repr__", [](const PythonPart& self) {
    return py::str(fmt::format("<moldlight.Part {}: {} facets, {}>",
                               self.model->part.file.empty() ? "of arrays" : part_name(self.model->part),
                               self.model->health.facets,
                               self.model->health.closed ? "closed" : "not closed"));
  });
  return part;
}

}  // namespace moldlight::python
