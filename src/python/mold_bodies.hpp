// The bodies of a mold as arrays and files.
#pragma once

#include <string>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "parting/mold_halves.hpp"

namespace moldlight::python {

namespace py = pybind11;

/// As they are written: a dict each, with name, vertices, faces, volume and closed.
[[nodiscard]] py::list body_dicts(const WrittenMold& mold);
/// 4 x 4: from where the bodies are written to the part, enlarged as the mold is.
[[nodiscard]] py::array mold_frame_array(const MoldHalves& halves);
/// Writes them as write_mold() does; the names of the files. Throws FileError.
[[nodiscard]] py::list write_bodies(WrittenMold mold, const std::string& folder,
                                    const MoldFileSettings& settings, const std::string& unit);

}  // namespace moldlight::python
