// Part.draft(): which walls have too little draft along a direction, and what it costs to turn them.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "parting/draft/draft_check.hpp"
#include "python/pages.hpp"
#include "study/study.hpp"

namespace moldlight::python {

namespace {

/// moldlight.Draft.
struct PythonDraft : StudyAnswer<classify_json, report::classify_report> {
  using StudyAnswer::StudyAnswer;

  [[nodiscard]] const DraftCheck& check() const { return *study.known<DraftCheck>(); }
};
using SharedDraft = std::shared_ptr<PythonDraft>;

/// A table of finishes as its file has it: of a dict, or none where a file is named.
std::string finish_lines(const py::object& finish) {
  std::string lines;
  if (!py::isinstance<py::dict>(finish)) return lines;
  for (const auto& [face, name] : py::cast<py::dict>(finish))
    lines += fmt::format("{},{}\n", value_text(face, "finish"), value_text(name, "finish"));
  return lines;
}

SharedDraft find_draft(const PythonPart& self, const py::object& direction, const py::kwargs& keywords) {
  FinishSettings settings;
  std::string lines, file;
  const auto take = [&](Given& given, Questions& questions) {
    DraftSettings draft;
    given.take(draft_options(), draft);
    questions.required_draft_deg = draft.required_deg;
    given.take(finish_options(), settings);
    const py::object finish = given.take("finish");
    lines = finish_lines(finish);
    if (!finish.is_none() && !py::isinstance<py::dict>(finish)) file = path_of(finish, "finish");
    if (draft.required_deg <= 0.0 && lines.empty() && file.empty())
      throw UsageError("draft: give required_draft_deg or finish");
  };
  return answer_of<PythonDraft>(
      {"draft", self, direction, keywords}, take, [&](Study& study, const Progress& progress) {
        Questions questions = study.questions();
        if (!file.empty())
          questions.finishes = read_finishes(file, study.model(), settings.texture_rule, progress);
        else if (!lines.empty())
          questions.finishes = finishes_in(lines, "finish", study.model(), settings.texture_rule);
        study.ask(std::move(questions));
        study.find<SplitRegions>(progress);
        study.find<DraftCheck>(progress);
      });
}

constexpr std::string_view k_draft_text =
    "The walls with too little draft, and how far each must turn. Returns a Draft.\n\n"
    "direction, isolated, progress: as for classify().\n"
    "finish: the finish of faces, which asks for a draft of its own: a dict such as {3: 'texture 0.03 mm'},\n"
    "or the name of a file as --finish reads it. Faces are numbered as in face_areas.";

void add_draft(py::module_& module, PartClass& part) {
  py::class_<PythonDraft, SharedDraft> found(
      module, "Draft", "Result of part.draft(). Lengths and areas are in the part's unit.");
  add_members(
      found,
      {{"verdict", "The Verdict on the direction.", nullptr},
       {"walls", "Walls with too little draft, a dict each, those that cost most thickness first.",
        "/draft/faces"},
       {"below", "Area and faces with too little draft, by half.", "/draft/below"},
       {"reverse", "What leans against the half that forms it: area, worst angle, place.", "/draft/reverse"},
       {"histogram", "Areas of core and cavity by draft, a dict a degree or so.", "/draft/histogram"},
       {"finishes", "What the faces of each finish have, a dict each.", "/draft/finishes"},
       {"required_deg", "The draft asked for of faces without a finish.", "/draft/required_deg"},
       {"direction", "Unit vector."},
       {"warnings", "Why figures are in doubt, a sentence each.", "/part/warnings"}});
  found
      .def_property_readonly(
          "sentence",
          [](const PythonDraft& self) { return to_python(Json(draft_sentence(self.model(), self.check()))); },
          "How much has too little draft.")
      .def("__repr__", [](const PythonDraft& self) {
        return py::str(fmt::format("<moldlight.Draft: {}>", draft_sentence(self.model(), self.check())));
      });
  add_picture(
      found, "Draws the regions with the areas by draft: height x width x 4 uint8. Needs OpenGL, no display.",
      [](const PythonDraft& self, const StillSettings& still, const Progress& progress) {
        const auto context = create_context(self.backend());
        const Image picture = StillPainter(*context, self.shared_model())
                                  .draw(self.study.known<SplitRegions>()->result, still, progress);
        return with_draft_histogram(picture, self.model(), self.check(), still);
      });
  add_result(found, "classify --required-draft");
  add_pages(found);
  part.def("draft", &find_draft, py::arg("direction"),
           call_doc({.name = "draft",
                     .arguments = "self, direction",
                     .more = "finish=None, isolated=False, progress=None",
                     .text = k_draft_text,
                     .settings = "draft"}));
}

const CallSettings k_draft_settings("draft", draft_options(), finish_options(), method_options());
const RegisteredCall k_draft_call(add_draft);

}  // namespace

}  // namespace moldlight::python
