// Part.actions(): the side actions that release the undercuts of one direction.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "actions/actions_files.hpp"
#include "classify/headless.hpp"
#include "python/pages.hpp"
#include "study/study.hpp"

namespace moldlight::python {

using namespace py::literals;

namespace {

/// moldlight.Actions.
struct PythonActions : StudyAnswer<actions_json, report::actions_report> {
  using StudyAnswer::StudyAnswer;

  [[nodiscard]] const Classification& result() const { return study.known<SplitRegions>()->result; }
  [[nodiscard]] const ActionPlan& plan() const { return *study.known<ActionPlan>(); }
  [[nodiscard]] ActionsReport found() const {
    return {model(), result(), study.questions().actions, plan(), study.known<Changes>()->of_undercuts};
  }
};
using SharedActions = std::shared_ptr<PythonActions>;

SharedActions find_side_actions(const PythonPart& self, const py::object& direction,
                                const py::kwargs& keywords) {
  const auto take = [](Given& given, Questions& questions) {
    questions.with_actions = true;
    given.take(action_options(), questions.actions);
  };
  return answer_of<PythonActions>(
      {"actions", self, direction, keywords}, take,
      [](Study& study, const Progress& progress) { static_cast<void>(actions_report(study, progress)); });
}

py::list bodies_of_actions(const PythonActions& self, const py::object& /*progress*/) {
  py::list list;
  for (std::size_t k = 0; k < self.plan().actions.size(); ++k) {
    const auto& body = self.plan().actions[k].body;
    if (!body) continue;
    const py::tuple mesh = mesh_arrays(*body->solid);
    list.append(py::dict("name"_a = action_name(self.plan(), k), "action"_a = k, "vertices"_a = mesh[0],
                         "faces"_a = mesh[1]));
  }
  return list;
}

constexpr std::string_view k_actions_text =
    "The slides, lifters and other side actions that release the undercuts. Returns an Actions.\n\n"
    "direction, isolated, progress: as for classify().";

void add_actions(py::module_& module, PartClass& part) {
  py::class_<PythonActions, SharedActions> found(
      module, "Actions", "Result of part.actions(). Lengths and areas are in the part's unit.");
  add_members(found, {{"actions",
                       "A dict each, the largest area first: kind, direction, travel, the undercuts that it "
                       "releases, and the rest of the report."},
                      {"undercuts",
                       "A dict each, the largest first: area, depth, where it is, and what to change to do "
                       "without an action.",
                       "/undercuts"},
                      {"verdict", "The Verdict on the direction."},
                      {"unreleased", "Undercuts that nothing releases."},
                      {"optimal", "No cheaper set of the actions that were tried releases as much."},
                      {"warnings", "Why figures are in doubt, a sentence each.", "/part/warnings"}});
  found
      .def_property_readonly(
          "direction", [](const PythonActions& self) { return to_python(self.result().direction); },
          "Unit vector.")
      .def("bodies", &bodies_of_actions, py::arg("progress") = py::none(),
           "bodies(self, progress=None)\n--\n\nThe closed solids that the actions move, where the mold is "
           "closed: a dict each with name, action\n(its place in actions), vertices and faces. Some actions "
           "have none.")
      .def("__repr__", [](const PythonActions& self) {
        return py::str(fmt::format("<moldlight.Actions: {}>", actions_text(self.plan())));
      });
  add_picture(
      found,
      "Draws the part with the bodies of its actions, pulled out: height x width x 4 uint8. Needs\n"
      "OpenGL, no display.",
      [](const PythonActions& self, const StillSettings& still, const Progress& progress) {
        const auto context = create_context(self.result().settings.backend);
        const auto pulled = pulled_bodies(self.found());
        return StillPainter(*context, self.study.shared_model()).draw(self.result(), still, progress, pulled);
      });
  add_result(found, "actions");
  add_pages(found);
  part.def("actions", &find_side_actions, py::arg("direction"),
           call_doc({.name = "actions",
                     .arguments = "self, direction",
                     .more = "isolated=False, progress=None",
                     .text = k_actions_text,
                     .settings = "actions"}));
}

const CallSettings k_actions_settings("actions", action_options(), method_options());
const RegisteredCall k_actions_call(add_actions);

}  // namespace

}  // namespace moldlight::python
