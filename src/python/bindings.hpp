// The classes of the Python module, one file each, and what they share.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>
#include <pybind11/pybind11.h>

#include "classify/classification.hpp"
#include "classify/part_model.hpp"
#include "classify/still_picture.hpp"
#include "python/keywords.hpp"
#include "python/values.hpp"
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
};
using PartClass = pybind11::class_<PythonPart>;

/// Part with how it is made and what it is; the others add its methods that ask for work, and the classes of
/// what these return.
PartClass add_part(pybind11::module_& module);
void add_classify(pybind11::module_& module, PartClass& part);
void add_sweep(pybind11::module_& module, PartClass& part);
void add_actions(pybind11::module_& module, PartClass& part);
void add_mold(pybind11::module_& module, PartClass& part);

/// The report's text as the program writes it.
[[nodiscard]] pybind11::str report_text(const nlohmann::ordered_json& json);

/// to_json() and to_dict(): `what` the command writes with --json, which `json` makes of an object.
template <typename Bound, typename Json>
void add_report(Bound& bound, const std::string& what, const std::string& command, const Json& json) {
  using Type = typename Bound::type;
  bound.def(
      "to_json", [json](const Type& self) { return report_text(json(self)); },
      fmt::format("to_json(self)\n--\n\n{}, as `moldlight {} --json` writes it.", what, command).c_str());
  bound.def(
      "to_dict", [json](const Type& self) { return to_python(json(self)); },
      fmt::format("to_dict(self)\n--\n\n{} as a dict.", what).c_str());
}

/// Reads a member of an object's report, as to_dict() has it; None where the report is without it.
template <typename Type>
auto report_member(const char* key) {
  return [key](const Type& self) {
    const auto json = self.json();
    return json.contains(key) ? to_python(json[key]) : pybind11::object(pybind11::none());
  };
}

/// A call that asks for the study of one direction.
struct StudyCall {
  const char* name;
  const PythonPart& part;
  const pybind11::object& direction;
  const pybind11::kwargs& keywords;
};
/// The study with all that `find` finds, and its verdict; `take` takes the settings that are the call's own.
[[nodiscard]] Study study_of(const StudyCall& call, const std::function<void(Given&, Questions&)>& take,
                             const std::function<void(Study&, const Progress&)>& find);

/// What a call for a picture asks for: size and settings.
[[nodiscard]] StillSettings picture_settings(const pybind11::kwargs& keywords, pybind11::object& progress);
/// The first lines of such a call's docstring.
[[nodiscard]] const char* picture_doc(std::string_view text);

/// {"core": …, "cavity": …, "both": …, "undercut": …}.
[[nodiscard]] pybind11::dict region_dict(const RegionValues& values);

}  // namespace moldlight::python
