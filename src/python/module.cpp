// The Python module: what the package `moldlight` is made of, the program's failures as Python's exceptions,
// and what the classes share.
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <tbb/global_control.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "classify/classify_report.hpp"
#include "classify/json.hpp"
#include "mold/region.hpp"
#include "python/bindings.hpp"
#include "python/keywords.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::python {

namespace {

// Live as long as the interpreter, as its own exceptions do.
struct Exceptions {
  PyObject *error = nullptr, *usage = nullptr, *file = nullptr, *cancelled = nullptr;
};
Exceptions& exceptions() {
  static Exceptions types;
  return types;
}

PyObject* make_type(py::module_& module, const char* name, const char* help, const py::object& bases) {
  const std::string full = std::string("moldlight.") + name;
  PyObject* type = PyErr_NewExceptionWithDoc(full.c_str(), help, bases.ptr(), nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.add_object(name, py::reinterpret_borrow<py::object>(type));
  return type;
}

void raise(PyObject* type, std::string_view text) {
  const std::string message = with_keywords(text);
  PyObject* message_object =
      PyUnicode_DecodeUTF8(message.data(), static_cast<Py_ssize_t>(message.size()), "replace");
  if (message_object == nullptr) return;
  PyErr_SetObject(type, message_object);
  Py_DECREF(message_object);
}

void translate(std::exception_ptr failure) {
  static const std::string k_no_threads = "the system allows no more threads or the like: ";
  const Exceptions& types = exceptions();
  try {
    if (failure) std::rethrow_exception(failure);
  } catch (const Cancelled&) {
    raise(types.cancelled, "the progress callback ended the work");
  } catch (const UsageError& error) {
    raise(types.usage, error.what());
  } catch (const FileError& error) {
    raise(types.file, error.what());
  } catch (const Error& error) {
    raise(types.error, error.what());
  } catch (const std::bad_alloc&) {
    raise(PyExc_MemoryError, "there is not enough memory for this part with these settings");
  } catch (const std::system_error& error) {
    raise(types.error, k_no_threads + error.what());
  } catch (const std::runtime_error& error) {
    // TBB's own threads: it throws a std::runtime_error with the name of the call that failed.
    if (!std::string_view(error.what()).starts_with("pthread_")) throw;
    raise(types.error, k_no_threads + error.what());
  }
}

/// Makes moldlight.Error with its subclasses, and every failure of the program one of them, with the
/// program's text, in which keywords stand for the flags of the command line. Memory that is not there is a
/// MemoryError.
void add_errors(py::module_& module) {
  Exceptions& types = exceptions();
  types.error = make_type(module, "Error", "A failure: what happened, where, and what to do.",
                          py::reinterpret_borrow<py::object>(PyExc_Exception));
  const auto under_error = [&](PyObject* more) {
    return more == nullptr ? py::reinterpret_borrow<py::object>(types.error)
                           : py::object(py::make_tuple(py::handle(types.error), py::handle(more)));
  };
  types.usage = make_type(module, "UsageError", "An argument or setting that makes no sense.",
                          under_error(PyExc_ValueError));
  types.file =
      make_type(module, "FileError", "A file that cannot be read or written.", under_error(PyExc_OSError));
  types.cancelled =
      make_type(module, "Cancelled", "The progress callback ended the work.", under_error(nullptr));
  py::register_exception_translator(translate);
}

/// Only where whoever started the process says how many threads it may compute with: other modules use the
/// same threads.
void limit_threads() {
  if (std::getenv(k_threads_variable) == nullptr) return;
  // Never taken back, as TBB would start its threads then.
  [[maybe_unused]] static const tbb::global_control* volatile k_limit = new tbb::global_control(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(usable_cores()));
}

py::tuple region_names() {
  py::list names;
  for (const Region region : k_regions) names.append(std::string(region_name(region)));
  return py::tuple(names);
}

/// By the words of the setting `palette`.
py::dict region_colours() {
  py::dict palettes;
  for (const auto& [name, palette] :
       {std::pair{"paper", Palette::paper}, std::pair{"safe", Palette::colour_blind_safe}}) {
    py::list colours;
    for (const Region region : k_regions) {
      const Colour colour = region_colour(region, palette);
      colours.append(py::make_tuple(colour.r, colour.g, colour.b));
    }
    palettes[name] = py::tuple(colours);
  }
  return palettes;
}

const CallSettings k_picture_settings("picture", still_options(), picture_looks());

}  // namespace

std::vector<AddCall>& calls() {
  static std::vector<AddCall> registered;
  return registered;
}

py::str report_text(const Json& json) { return py::str(json_text(json)); }

Study study_of(const StudyCall& call, const std::function<void(Given&, Questions&)>& take,
               const std::function<void(Study&, const Progress&)>& find) {
  const auto& model = call.part.model;
  Questions questions;
  MethodSettings& method = questions.query.method;
  const bool best = is_best(call.direction);
  if (!best) questions.query.direction = direction_of(call.direction, "direction");
  Given given(call.name, call.keywords);
  take(given, questions);
  given.take(method_options(), method);
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
  given.take(picture_looks(), still.look);
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

}  // namespace moldlight::python

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
  for (const AddCall add : calls()) add(module, part);
  module.def("settings", &settings_list, py::arg("call"),
             "settings(call)\n--\n\nThe settings of a call: 'Part', 'read', 'classify', 'draft', 'sweep', "
             "'pieces', 'actions', 'mold',\n'compare', 'picture', 'to_html' or 'to_pdf'. A list with a dict "
             "each: key, label, unit, help, type,\ndefault, words, least, greatest.");
}
