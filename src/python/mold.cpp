// Part.mold(): the parting line of one direction, and the two halves.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/headless.hpp"
#include "classify/json.hpp"
#include "parting/line_files.hpp"
#include "parting/mold_picture.hpp"
#include "python/keywords.hpp"
#include "python/mold_bodies.hpp"
#include "python/pages.hpp"
#include "study/study.hpp"

namespace moldlight::python {

using namespace py::literals;

namespace {

/// moldlight.Mold.
struct PythonMold : StudyAnswer<mold_json, report::mold_report> {
  using StudyAnswer::StudyAnswer;

  [[nodiscard]] const Assignment& assignment() const { return study.known<MoldLine>()->assignment; }
  [[nodiscard]] const PartingLine& line() const { return study.known<MoldLine>()->line; }
  [[nodiscard]] const MoldHalves& halves() const {
    return study.questions().with_actions ? study.known<MoldPieces>()->halves : *study.known<MoldHalves>();
  }
  [[nodiscard]] const WrittenMold& written() const { return halves().written; }
  /// Why there are no halves to write; empty where there are.
  [[nodiscard]] std::string refusal() const {
    Study shared = study;
    return mold_refusal(shared, Progress());
  }
};
using SharedMold = std::shared_ptr<PythonMold>;

SharedMold find_mold(const PythonPart& self, const py::object& direction, const py::kwargs& keywords) {
  const auto take = [](Given& given, Questions& questions) {
    given.take(mold_options(), questions.mold);
    questions.with_actions = given.take_switch("actions");
  };
  return answer_of<PythonMold>(
      {"mold", self, direction, keywords}, take,
      [](Study& study, const Progress& progress) { static_cast<void>(mold_report(study, progress)); });
}

py::list loops(const PythonMold& self) {
  py::list list;
  for (const PartingLoop& loop : self.line().loops) {
    list.append(py::dict("kind"_a = std::string(loop_name(loop.kind)), "points"_a = copy_of(loop.points),
                         "length"_a = loop.length));
  }
  return list;
}

py::list write(const PythonMold& self, const py::object& folder_given, bool as_3mf, bool as_step) {
  const std::string folder = path_of(folder_given, "folder");
  if (const std::string refusal = self.refusal(); !refusal.empty()) throw Error(refusal);
  return write_bodies(self.written(), folder, {as_3mf, as_step}, self.model().part.unit);
}

void write_line(const PythonMold& self, const py::object& path_given) {
  const std::string path = path_of(path_given, "path");
  check_line_extension(path);
  watch(py::none(), [&](const Progress&) {
    write_lines(path, lines_to_write(self.model(), self.assignment(), self.line()));
  });
}

py::object area_of(const PythonMold& self) {
  py::dict areas;
  for (const MoldSide side : k_mold_sides)
    areas[py::str(std::string(side_name(side)))] = self.assignment().area(side);
  return areas;
}

constexpr std::string_view k_mold_text =
    "The parting line of a direction and the two halves of a mold. Returns a Mold.\n\n"
    "direction, isolated, progress: as for classify().\n"
    "actions: find the side actions, too, and which inserts go with them.";

void add_mold(py::module_& module, PartClass& part) {
  py::class_<PythonMold, SharedMold> mold(
      module, "Mold", "Result of part.mold(). Lengths, areas and volumes are in the part's unit.");
  add_members(mold, {{"verdict", "The Verdict on the direction."},
                     {"parting_line", "The parting line in a sentence."},
                     {"warnings", "Why figures are in doubt, a sentence each.", "/part/warnings"}});
  mold.def_property_readonly("areas", area_of,
                             "What core, cavity and side actions form, in the part's unit squared.")
      .def_property_readonly("loops", loops,
                             "The loops of the parting line: a dict each with kind ('outer', 'shut-off', "
                             "'action'), points (k x 3, closed, the first is not repeated) and length.")
      .def_property_readonly(
          "direction", [](const PythonMold& self) { return to_python(self.assignment().direction); },
          "Unit vector.")
      .def("write_line", &write_line, py::arg("path"),
           "write_line(self, path)\n--\n\nWrites the parting line, by the ending of the file's name: .dxf, "
           ".step, .svg, .obj or .csv.")
      .def_property_readonly(
          "refusal", [](const PythonMold& self) { return with_keywords(self.refusal()); },
          "Why there are no halves; empty if there are halves.")
      .def_property_readonly(
          "bodies", [](const PythonMold& self) { return body_dicts(self.written()); },
          "Core, cavity and inserts, as they are written: a dict each with name, "
          "vertices, faces, volume and closed. Empty where there are none.")
      .def_property_readonly(
          "in_part_frame", [](const PythonMold& self) { return self.written().part_frame; },
          "The bodies are in the part's own coordinates; else the direction is upward, about the part's "
          "centre.")
      .def_property_readonly(
          "frame", [](const PythonMold& self) { return mold_frame_array(self.halves()); },
          "4 x 4 float64: takes the bodies' coordinates to the part's, whose origin is "
          "where it is enlarged from for shrinkage.")
      .def("write", &write, py::arg("folder"), py::arg("as_3mf") = false, py::arg("as_step") = false,
           "write(self, folder, as_3mf=False, as_step=False)\n--\n\nWrites the bodies to a folder, an STL "
           "each, and all of "
           "them to mold.3mf or mold.step. Returns the files'\nnames. Raises Error where there are no halves "
           "to write.")
      .def("__repr__", [](const PythonMold& self) {
        return py::str(fmt::format("<moldlight.Mold: {}>",
                                   parting_verdict(self.assignment(), self.line(), self.model())));
      });
  add_picture(mold,
              "Draws the part with its parting line and the opened halves: height x width x 4 uint8. Of the\n"
              "settings view, theme and palette count. Needs OpenGL, no display.",
              [](const PythonMold& self, const StillSettings& still, const Progress& progress) {
                const auto context = create_context(self.study.questions().query.method.backend);
                return mold_picture(*context, {self.model(), self.assignment(), self.line(), self.halves()},
                                    still, progress);
              });
  add_result(mold, "mold");
  add_pages(mold);
  part.def("mold", &find_mold, py::arg("direction"),
           call_doc({.name = "mold",
                     .arguments = "self, direction",
                     .more = "actions=False, isolated=False, progress=None",
                     .text = k_mold_text,
                     .settings = "mold"}));
}

const CallSettings k_mold_settings("mold", mold_options(), method_options());
const RegisteredCall k_mold_call(add_mold);

}  // namespace

}  // namespace moldlight::python
