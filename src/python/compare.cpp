// moldlight.compare(): what a revision of a part changes for the mold.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "compare/compare_figures.hpp"
#include "compare/compare_picture.hpp"
#include "compare/comparison.hpp"
#include "python/pages.hpp"

namespace moldlight::python {

using namespace py::literals;

namespace {

/// moldlight.Comparison.
struct PythonComparison {
  using BoundToPython = void;
  Comparison found;
  Recall recall = {};

  [[nodiscard]] const std::shared_ptr<const PartModel>& shared_model() const { return found.b.model; }
  [[nodiscard]] Backend backend() const { return found.a.result.settings.backend; }
  [[nodiscard]] Json json() const { return compare_json(found); }
  [[nodiscard]] report::Report report(const report::ReportContext& context) const {
    const std::vector<ComparedFigure> figures = comparison_figures(found);
    return report::compare_report(context, found, {{}, figures});
  }
};
using SharedComparison = std::shared_ptr<PythonComparison>;

SharedComparison compare(const PythonPart& before, const PythonPart& after, const py::object& direction,
                         const py::kwargs& keywords) {
  CompareQuestion question;
  const std::string asked = direction_text(direction, "direction");
  question.choice = asked == "best"   ? CompareDirection::best
                    : asked == "each" ? CompareDirection::each
                                      : CompareDirection::given;
  if (question.choice == CompareDirection::given) question.direction = direction_of(direction, "direction");
  Given given("compare", keywords);
  given.take(compare_options(), question.settings);
  given.take(action_options(), question.settings.actions);
  given.take(method_options(), question.method);
  const py::object progress_given = given.take("progress");
  given.end();
  validate(question.method, before.model->frame.diagonal);
  auto comparison = watched(progress_given, [&](const Progress& progress) {
    return std::make_shared<PythonComparison>(
        PythonComparison{compare_revisions(before.model, after.model, question, progress)});
  });
  // Found again by a method of the part, since pickle takes no function of a compiled module.
  const std::string_view before_text = "part.compare(";
  comparison->recall = {
      recalled("_compared", before, py::make_tuple(PythonPart(after), asked), keywords).reduced,
      "moldlight.compare(before, after, " +
          recalled("compare", before, py::make_tuple(asked), keywords).text.substr(before_text.size())};
  return comparison;
}

/// {"undercut": {"before", "after", "error"}, …}.
py::dict figures_of(const PythonComparison& self) {
  py::dict figures;
  for (const ComparedFigure& figure : comparison_figures(self.found))
    figures[py::str(std::string(figure.name))] =
        py::dict("before"_a = figure.before, "after"_a = figure.after, "error"_a = figure.error);
  return figures;
}

py::object met(const PythonComparison& self, const py::object& criteria) {
  const auto asked = parse_criteria(value_text(criteria, "criteria"), comparison_figure_names());
  return to_python(Json(met_criteria(asked, comparison_figures(self.found))));
}

constexpr std::string_view k_compare_text =
    "What a revision of a part changes for the mold. Returns a Comparison.\n\n"
    "before, after: two Parts.\n"
    "direction: as for classify(); 'best' is the best of the part before, 'each' the best of each part.\n"
    "isolated: as for classify(). progress: as for Part().";

void add_compare(py::module_& module, PartClass& part) {
  py::class_<PythonComparison, SharedComparison> result(
      module, "Comparison",
      "Result of moldlight.compare(). Lengths and areas are in the unit of the part before.");
  add_members(
      result,
      {{"verdict", "The Verdict: what changed as a sentence, and the state of the part after."},
       {"verdicts", "The Verdicts on both parts, a (before) and b (after); None without side actions."},
       {"surface", "Area that is gone and new."},
       {"places", "Places where surface changed, a dict each."},
       {"regions", "Areas of both parts, their difference, and what changed its region."},
       {"undercuts", "Undercuts that are gone, new or others; None without side actions."},
       {"actions", "Side actions that are gone, new or others; None without side actions."},
       {"mold", "What becomes of the mold of the part before; None where it was not asked for."},
       {"alignment", "How the part after was laid on the other; None without align."},
       {"direction", "Unit vectors of both parts, a and b."},
       {"remarks", "What else there is to say, a sentence each."}});
  result
      .def_property_readonly(
          "figures", figures_of,
          "Each figure that both parts have, by its name: a dict with before, after and error.")
      .def("met", &met, py::arg("criteria"),
           "met(self, criteria)\n--\n\nA sentence for each criterion that is met, as --fail-on takes them: "
           "'undercut > +1%, actions > 0'.")
      .def("__repr__", [](const PythonComparison& self) {
        return py::str(fmt::format("<moldlight.Comparison: {}>", comparison_verdict(self.found)));
      });
  add_picture(result,
              "Draws both parts side by side with what differs: height x width x 4 uint8. Needs OpenGL, no\n"
              "display.",
              [](const PythonComparison& self, const StillSettings& still, const Progress& progress) {
                const auto context = create_context(self.backend());
                return comparison_picture(*context, self.found, still, progress);
              });
  add_result(result, "compare");
  add_pages(result);
  module.def("compare", &compare, py::arg("before"), py::arg("after"), py::arg("direction") = "best",
             call_doc({.name = "compare",
                       .arguments = "before, after, direction='best'",
                       .more = "isolated=False, progress=None",
                       .text = k_compare_text,
                       .settings = "compare"}));
  part.def("_compared", &compare);
}

const CallSettings k_compare_settings("compare", compare_options(), action_options(), method_options());
const RegisteredCall k_compare_call(add_compare);

}  // namespace

}  // namespace moldlight::python
