// What the classes of the Python module share.
#include <nlohmann/json.hpp>
#include <pybind11/numpy.h>

#include "classify/classify_report.hpp"
#include "python/bindings.hpp"
#include "python/work.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::python {

namespace py = pybind11;

py::str report_text(const nlohmann::ordered_json& json) { return py::str(json_text(json)); }

Study study_of(const StudyCall& call, const std::function<void(Given&, Questions&)>& take,
               const std::function<void(Study&, const Progress&)>& find) {
  const auto& model = call.part.model;
  Questions questions;
  MethodSettings& method = questions.query.method;
  const bool best = is_best(call.direction);
  if (!best) questions.query.direction = direction_of(call.direction, "direction");
  Given given(call.name, call.keywords);
  take(given, questions);
  given.take(method);
  const py::object progress_given = given.take("progress");
  given.end();
  validate(method, model->frame.diagonal);
  return watched(progress_given, [&](const Progress& progress) {
    if (best) {
      questions.best = best_direction(model, method, progress);
      questions.query.direction = Direction(questions.best->direction);
    }
    Study study(model, questions);
    find(study, progress);
    static_cast<void>(study.verdict(progress));
    return study;
  });
}

StillSettings picture_settings(const py::kwargs& keywords, py::object& progress) {
  StillSettings still;
  Given given("picture", keywords);
  const py::object size = given.take("size");
  if (!size.is_none()) {
    std::string text;
    if (py::isinstance<py::str>(size)) {
      text = value_text(size, "size");
    } else {
      const auto sides = words_text(size, "size");
      const std::size_t comma = sides.find(',');
      text = comma == std::string::npos ? sides : sides.substr(0, comma) + "x" + sides.substr(comma + 1);
    }
    still.size = parse_picture_size(text, "size");
  }
  given.take(still_options(), still);
  for (const std::string_view key : picture_looks())
    given.take(option_named(look_options(), key), still.look);
  progress = given.take("progress");
  given.end();
  return still;
}

const char* picture_doc(std::string_view text) {
  return call_doc({.name = "picture",
                   .arguments = "self",
                   .more = "size=(1600, 1000), progress=None",
                   .text = text,
                   .settings = "picture"});
}

py::dict region_dict(const RegionValues& values) {
  py::dict dict;
  for (const Region region : k_regions) dict[py::str(std::string(region_name(region)))] = values[region];
  return dict;
}

}  // namespace moldlight::python
