// The program's failures as Python's exceptions.
#pragma once

#include <pybind11/pybind11.h>

namespace moldlight::python {

/// Makes moldlight.Error with its subclasses, and every failure of the program one of them, with the
/// program's text, in which keywords stand for the flags of the command line. Memory that is not there is a
/// MemoryError.
void add_errors(pybind11::module_& module);

}  // namespace moldlight::python
