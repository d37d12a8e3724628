#include "python/errors.hpp"

#include <exception>
#include <new>
#include <system_error>

#include "base/error.hpp"
#include "python/keywords.hpp"

namespace moldlight::python {

namespace py = pybind11;

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

}  // namespace

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

}  // namespace moldlight::python
