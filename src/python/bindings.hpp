// The classes of the Python module, one file each, and what they share.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/pybind11.h>

#include "classify/classification.hpp"
#include "classify/json.hpp"
#include "classify/part_model.hpp"
#include "classify/still_picture.hpp"
#include "python/keywords.hpp"
#include "python/values.hpp"
#include "python/work.hpp"
#include "report/describe/describe.hpp"
#include "study/study.hpp"

namespace moldlight::python {

/// The classes of the module: those that say so by a member type, and any that is named here, before it is
/// converted.
template <typename Type>
inline constexpr bool k_bound = requires {
  typename Type::BoundToPython;
};

}  // namespace moldlight::python

namespace pybind11::detail {

/// Objects that Python made without their __init__ (`Part.__new__(Part)`) hold no value: to use one raises
/// TypeError. pybind11 2.10 alone would hand out memory that nothing was written to.
template <typename Bound>
requires moldlight::python::k_bound<Bound>
class type_caster<Bound> : public type_caster_base<Bound> {
 public:
  bool load(handle source, bool convert) {
    if (isinstance<Bound>(source) &&
        reinterpret_cast<instance*>(source.ptr())->get_value_and_holder().value_ptr() == nullptr) {
      throw type_error(
          fmt::format("this moldlight.{} holds nothing: it was made without its __init__, as by __new__",
                      static_cast<std::string>(str(type::of(source).attr("__name__")))));
    }
    return type_caster_base<Bound>::load(source, convert);
  }
};

}  // namespace pybind11::detail

namespace moldlight::python {

/// moldlight.Part.
struct PythonPart {
  using BoundToPython = void;
  std::shared_ptr<const PartModel> model;

  /// The health report.
  [[nodiscard]] Json json() const;
};
using PartClass = py::class_<PythonPart>;

/// Part with how it is made and what it is; the others add its methods that ask for work, and the classes of
/// what these return.
PartClass add_part(py::module_& module);
/// The file of each of those registers it.
using AddCall = void (*)(py::module_& module, PartClass& part);
[[nodiscard]] std::vector<AddCall>& calls();
struct RegisteredCall {
  explicit RegisteredCall(AddCall add) { calls().push_back(add); }
};

/// The call that found a result: what pickle calls to find it again, and how a script has it.
struct Recall {
  py::object reduced = {};  // of __reduce__; null where it would not find the same
  std::string text;
};
[[nodiscard]] Recall recalled(const char* call, const PythonPart& part, const py::tuple& arguments,
                              const py::kwargs& keywords);

/// What a call returns: the study that has found all that is shown, and its reports.
template <Json (*k_json)(Study&, const Progress&),
          report::Report (*k_report)(const report::ReportContext&, Study&) = nullptr>
struct StudyAnswer {
  using BoundToPython = void;
  explicit StudyAnswer(Study found) : study(std::move(found)) {}
  Study study;
  Recall recall = {};

  [[nodiscard]] const PartModel& model() const { return study.model(); }
  [[nodiscard]] Json json() const {
    Study shared = study;
    return k_json(shared, Progress());
  }
  [[nodiscard]] const std::shared_ptr<const PartModel>& shared_model() const { return study.shared_model(); }
  [[nodiscard]] Backend backend() const { return study.questions().query.method.backend; }
  [[nodiscard]] report::Report report(const report::ReportContext& context) const {
    Study shared = study;
    return k_report(context, shared);
  }
};

/// The report's text as the program writes it.
[[nodiscard]] py::str report_text(const Json& json);

/// to_json() and to_dict(): `what` the command writes with --json, which json() of the object makes.
template <typename Bound>
void add_report(Bound& bound, const std::string& what, const std::string& command) {
  using Type = typename Bound::type;
  bound.def(
      "to_json", [](const Type& self) { return report_text(self.json()); },
      fmt::format("to_json(self)\n--\n\n{}, as `moldlight {} --json` writes it.", what, command).c_str());
  bound.def(
      "to_dict", [](const Type& self) { return to_python(self.json()); },
      fmt::format("to_dict(self)\n--\n\n{} as a dict.", what).c_str());
}

/// What a call for a picture asks for.
[[nodiscard]] StillSettings picture_settings(const py::kwargs& keywords, py::object& progress);
/// Its docstring, which begins with this text.
[[nodiscard]] const char* picture_doc(std::string_view text);

/// A property that is a member of the report, as to_dict() has it.
struct ReportMember {
  const char *name, *help;
  const char* place = nullptr;  // JSON pointer, where it is not the report's own member of that name
};
/// Adds them; where the report is without one it is None.
template <typename Bound>
void add_members(Bound& bound, std::initializer_list<ReportMember> members) {
  using Type = typename Bound::type;
  for (const auto& [name, help, place] : members) {
    const Json::json_pointer at(place != nullptr ? place : std::string("/") + name);
    bound.def_property_readonly(
        name,
        [at](const Type& self) {
          const auto json = self.json();
          return json.contains(at) ? to_python(json[at]) : py::object(py::none());
        },
        help);
  }
}

/// A call that asks for the study of one direction.
struct StudyCall {
  const char* name;
  const PythonPart& part;
  const py::object& direction;
  const py::kwargs& keywords;
};
/// What is kept of the call.
[[nodiscard]] inline Recall recalled(const StudyCall& call) {
  // Numbers of the caller's own array may change.
  const py::str direction(direction_text(call.direction, "direction"));
  return recalled(call.name, call.part, py::make_tuple(direction), call.keywords);
}
/// The study with all that `find` finds, and its verdict; `take` takes the settings that are the call's own.
[[nodiscard]] Study study_of(const StudyCall& call, const std::function<void(Given&, Questions&)>& take,
                             const std::function<void(Study&, const Progress&)>& find);

/// The same as a result that keeps the call.
template <typename Answer>
[[nodiscard]] std::shared_ptr<Answer> answer_of(const StudyCall& call,
                                                const std::function<void(Given&, Questions&)>& take,
                                                const std::function<void(Study&, const Progress&)>& find) {
  auto answer = std::make_shared<Answer>(study_of(call, take, find));
  answer->recall = recalled(call);
  return answer;
}

/// Adds picture(), which asks for size and settings and returns what `draw(self, still, progress)` draws;
/// `text` begins its docstring.
template <typename Bound, typename Draw>
void add_picture(Bound& bound, std::string_view text, const Draw& draw) {
  using Type = typename Bound::type;
  bound.def(
      "picture",
      [draw](const Type& self, const py::kwargs& keywords) {
        py::object progress_given;
        const StillSettings still = picture_settings(keywords, progress_given);
        validate(still);
        return image_array(
            watched(progress_given, [&](const Progress& progress) { return draw(self, still, progress); }));
      },
      picture_doc(text));
}

}  // namespace moldlight::python
