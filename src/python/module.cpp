// The Python module: what the package `moldlight` is made of.
#include <cstdlib>
#include <utility>

#include <pybind11/pybind11.h>
#include <tbb/global_control.h>

#include "base/threads.hpp"
#include "mold/region.hpp"
#include "python/bindings.hpp"
#include "python/errors.hpp"

namespace {

namespace py = pybind11;

/// Only where whoever started the process says how many threads it may compute with: other modules use the
/// same threads.
void limit_threads() {
  if (std::getenv(moldlight::k_threads_variable) == nullptr) return;
  // Never taken back, as TBB would start its threads then.
  [[maybe_unused]] static const tbb::global_control* volatile k_limit = new tbb::global_control(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(moldlight::usable_cores()));
}

py::tuple region_names() {
  py::list names;
  for (const moldlight::Region region : moldlight::k_regions)
    names.append(std::string(moldlight::region_name(region)));
  return py::tuple(names);
}

/// By the words of the setting `palette`.
py::dict region_colours() {
  py::dict palettes;
  for (const auto& [name, palette] : {std::pair{"paper", moldlight::Palette::paper},
                                      std::pair{"safe", moldlight::Palette::colour_blind_safe}}) {
    py::list colours;
    for (const moldlight::Region region : moldlight::k_regions) {
      const moldlight::Colour colour = moldlight::region_colour(region, palette);
      colours.append(py::make_tuple(colour.r, colour.g, colour.b));
    }
    palettes[name] = py::tuple(colours);
  }
  return palettes;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  using namespace moldlight::python;
  // They begin with signatures that Python reads from them.
  py::options options;
  options.disable_function_signatures();
  limit_threads();
  module.attr("__version__") = MOLDLIGHT_VERSION;
  module.attr("REGIONS") = region_names();
  module.attr("REGION_COLOURS") = region_colours();
  add_errors(module);
  PartClass part = add_part(module);
  add_classify(module, part);
  add_sweep(module, part);
  add_actions(module, part);
  add_mold(module, part);
  module.def("settings", &settings_list, py::arg("call"),
             "settings(call)\n--\n\nThe settings of a call: 'Part', 'read', 'classify', 'sweep', 'actions', "
             "'mold' or 'picture'.\nA list with a dict each: key, label, unit, help, type, default, words, "
             "least, greatest.");
}
