// Part.sweep(): the best directions, their figures, what is proved.
#include "sweep/sweep.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/number_format.hpp"
#include "python/pages.hpp"
#include "study/study.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep_pictures.hpp"

namespace moldlight::python {

namespace {

/// moldlight.Sweep.
struct PythonSweep : StudyAnswer<sweep_json, report::sweep_report> {
  using StudyAnswer::StudyAnswer;

  [[nodiscard]] const SweepResult& result() const { return *study.known<SweepResult>(); }
  [[nodiscard]] Backend backend() const { return study.questions().sweep.method.backend; }
};
using SharedSweep = std::shared_ptr<PythonSweep>;

SweepSettings sweep_settings(Given& given) {
  SweepSettings settings;
  given.take(sweep_options(), settings);
  const ActionSettings usual = settings.action_settings;
  given.take(action_options(), settings.action_settings);
  given.take(method_options(), settings.method);
  if (settings.kinds.empty() && settings.user_directions.empty())
    throw UsageError("candidates: none; give user_directions");
  if (!(settings.action_settings == usual) && !seeks_actions(settings))
    throw UsageError("settings of side actions: give actions=True, too, or an objective of side actions");
  return settings;
}

SharedSweep sweep(const PythonPart& self, const py::kwargs& keywords) {
  Given given("sweep", keywords);
  const SweepSettings settings = sweep_settings(given);
  const py::object progress_given = given.take("progress");
  given.end();
  validate(settings.method, self.model->frame.diagonal);
  auto found = watched(progress_given, [&](const Progress& progress) {
    Study study(self.model, {.sweep = settings});
    study.find<SweepResult>(progress);
    return std::make_shared<PythonSweep>(std::move(study));
  });
  found->recall = recalled("sweep", self, py::tuple(), keywords);
  if (!found->result().complete) found->recall.reduced = {};
  return found;
}

/// A row a direction that was scored.
py::array scored(const PythonSweep& self, double EvaluatedDirection::*member) {
  py::array_t<double> numbers(static_cast<py::ssize_t>(self.result().evaluated.size()));
  double* number = numbers.mutable_data();
  for (const EvaluatedDirection& direction : self.result().evaluated) *number++ = direction.*member;
  return numbers;
}

py::array scored_directions(const PythonSweep& self) {
  std::vector<glm::dvec3> directions;
  for (const EvaluatedDirection& direction : self.result().evaluated)
    directions.push_back(direction.direction);
  return copy_of(directions);
}

py::object best(const PythonSweep& self) {
  if (self.result().candidates.empty()) return py::none();
  return to_python(self.result().recommended ? self.result().recommended->direction
                                             : self.result().candidates.front().classification.direction);
}

std::string text(const PythonSweep& self) {
  const std::string scored = fmt::format("{} directions scored", self.result().evaluated.size());
  if (self.result().candidates.empty()) return fmt::format("<moldlight.Sweep: {}>", scored);
  const Classification& found = self.result().candidates.front().classification;
  return fmt::format("<moldlight.Sweep: {}, best {} with undercut {}>", scored,
                     direction_words(found.direction), figure(found.areas[Region::undercut]));
}

constexpr std::string_view k_sweep_text =
    "Finds the best parting directions. Returns a Sweep.\n\n"
    "isolated: as for classify().\n"
    "progress: as for Part(), but where it returns False, the sweep ends with what is done by then.";

void add_sweep(py::module_& module, PartClass& part) {
  py::class_<PythonSweep, SharedSweep> found(
      module, "Sweep", "Result of part.sweep(). Lengths and areas are in the part's unit.");
  add_members(found,
              {{"candidates",
                "The listed directions, best first: a dict each, with direction, areas, tilt and the other "
                "figures of the report."},
               {"verdict", "The Verdict on the best direction; None where it was ended before."},
               {"proof", "The proof that prove asks for, as a dict; else None."},
               {"all_free", "The directions that all_free asks for, as a dict; else None."},
               {"remarks", "Remarks on the directions, a sentence each."},
               {"complete", "Neither the callback nor a time limit ended it."}});
  found
      .def_property_readonly("best_direction", best,
                             "The recommended direction, with the core on its side; with an objective the "
                             "first one listed. Unit vector, or None.")
      .def_property_readonly("scored_directions", scored_directions,
                             "k x 3 float64: every direction that was scored.")
      .def_property_readonly(
          "scored_undercut",
          [](const PythonSweep& self) { return scored(self, &EvaluatedDirection::undercut); },
          "k float64: the undercut by which each was scored, by samples.")
      .def_property_readonly(
          "scored_error",
          [](const PythonSweep& self) { return scored(self, &EvaluatedDirection::undercut_error); },
          "k float64: how far that may be off (95 %).")
      .def("__repr__", [](const PythonSweep& self) { return py::str(text(self)); });
  add_picture(found,
              "Draws the undercut over the half-sphere of directions: height x width x 4 uint8. Only "
              "size\nand theme count. With sweep(thorough=True) every figure of it is scored to the end.",
              [](const PythonSweep& self, const StillSettings& still, const Progress&) {
                return sweep_sphere_picture(self.study.model(), self.result(), still);
              });
  add_result(found, "sweep");
  add_pages(found, true);
  part.def("sweep", &sweep,
           call_doc({.name = "sweep",
                     .arguments = "self",
                     .more = "isolated=False, progress=None",
                     .text = k_sweep_text,
                     .settings = "sweep"}));
}

const CallSettings k_sweep_settings("sweep", sweep_options(), action_options(), method_options());
const RegisteredCall k_sweep_call(add_sweep);

}  // namespace

}  // namespace moldlight::python
