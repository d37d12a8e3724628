// What the classes of the Python module share.
#include <nlohmann/json.hpp>
#include <pybind11/numpy.h>

#include "classify/classify_report.hpp"
#include "python/bindings.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::python {

namespace py = pybind11;

py::str report_text(const nlohmann::ordered_json& json) { return py::str(json_text(json)); }

AskedDirection::AskedDirection(const py::handle& direction) : best(is_best(direction)) {
  if (!best) given = direction_of(direction, "direction");
}

void AskedDirection::put(const std::shared_ptr<const PartModel>& model, Questions& questions,
                         const Progress& progress) const {
  if (best) questions.best = best_direction(model, questions.query.method, progress);
  questions.query.direction = best ? Direction(questions.best->direction) : given;
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
