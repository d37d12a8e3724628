#include "python/mold_bodies.hpp"

#include <nlohmann/json.hpp>

#include "parting/mold_files.hpp"
#include "python/values.hpp"
#include "python/work.hpp"

namespace moldlight::python {

using namespace py::literals;

py::list body_dicts(const WrittenMold& mold) {
  py::list list;
  for (const WrittenBody& body : mold.bodies) {
    const py::tuple mesh = mesh_arrays(body.mesh);
    list.append(py::dict("name"_a = body.name, "vertices"_a = mesh[0], "faces"_a = mesh[1],
                         "volume"_a = body.volume, "closed"_a = body.closed));
  }
  return list;
}

py::array mold_frame_array(const MoldHalves& halves) {
  const glm::dmat4 numbers = to_part_of(halves);
  py::array_t<double> frame({py::ssize_t{4}, py::ssize_t{4}});
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) *frame.mutable_data(row, column) = numbers[column][row];
  return frame;
}

py::list write_bodies(WrittenMold mold, const std::string& folder, const MoldFileSettings& settings,
                      const std::string& unit) {
  watch(py::none(), [&](const Progress&) { write_mold(folder, settings, unit, mold); });
  py::list files;
  for (const WrittenBody& body : mold.bodies)
    if (!body.file.empty()) files.append(to_python(Json(body.file)));
  return files;
}

}  // namespace moldlight::python
