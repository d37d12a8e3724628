// Part.pieces(): molds of several pieces.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pieces/pieces_report.hpp"
#include "python/pages.hpp"
#include "study/study.hpp"

namespace moldlight::python {

using namespace py::literals;

namespace {

/// moldlight.Pieces.
struct PythonPieces : StudyAnswer<pieces_json> {
  using StudyAnswer::StudyAnswer;

  [[nodiscard]] const PiecesResult& result() const { return *study.known<PiecesResult>(); }
};
using SharedPieces = std::shared_ptr<PythonPieces>;

SharedPieces pieces(const PythonPart& self, const py::kwargs& keywords) {
  Given given("pieces", keywords);
  Questions questions;
  given.take(pieces_options(), questions.pieces);
  given.take(pieces_method_options(), questions.query.method);
  const py::object progress_given = given.take("progress");
  given.end();
  auto found = watched(progress_given, [&](const Progress& progress) {
    Study study(self.model, questions);
    study.find<PiecesResult>(progress);
    return std::make_shared<PythonPieces>(std::move(study));
  });
  found->recall = recalled("pieces", self, py::tuple(), keywords);
  return found;
}

py::list seam_lines(const PythonPieces& self) {
  py::list list;
  for (const PieceSeam& seam : self.result().formed.seams)
    list.append(
        py::dict("orders"_a = py::make_tuple(seam.a + 1, seam.b + 1), "points"_a = copy_of(seam.points)));
  return list;
}

constexpr std::string_view k_pieces_text =
    "Finds the fewest directions of a mold of several pieces, and which piece forms what. Returns a\n"
    "Pieces.\n\n"
    "progress: as for Part().";

void add_pieces(py::module_& module, PartClass& part) {
  py::class_<PythonPieces, SharedPieces> found(
      module, "Pieces", "Result of part.pieces(). Lengths, areas and volumes are in the part's unit.");
  add_members(
      found, {{"directions", "In the order of removal: a dict each, with direction, name, area, components."},
              {"count", "Number of directions."},
              {"lower_bound", "Fewer directions are impossible, for the samples of the proof."},
              {"proved", "No fewer directions are possible than were found."},
              {"optimal", "None of the directions that were tried do with fewer."},
              {"verdict", "The Verdict."},
              {"left", "Surface that no piece releases: a dict with area and places."},
              {"warnings", "Why figures are in doubt, a sentence each.", "/part/warnings"}});
  found
      .def("seam_lines", &seam_lines,
           "seam_lines(self)\n--\n\nThe seams between the pieces: a dict each, with orders and points, k x 3 "
           "float64.")
      .def(
          "mesh", [](const PythonPieces& self) { return mesh_arrays(piece_mesh(self.result().formed.mesh)); },
          "mesh(self)\n--\n\nThe part's mesh, split where other directions release it: vertices and faces.")
      .def_property_readonly(
          "piece_of_face",
          [](const py::object& self) {
            return view(self.cast<const PythonPieces&>().result().formed.formed_by, self);
          },
          "k uint32: the place in directions that forms each face of mesh(); count where none does.")
      .def("__repr__", [](const PythonPieces& self) {
        return py::str(fmt::format("<moldlight.Pieces: {}>", pieces_sentence(self.model(), self.result())));
      });
  add_result(found, "pieces");
  part.def("pieces", &pieces,
           call_doc({.name = "pieces",
                     .arguments = "self",
                     .more = "progress=None",
                     .text = k_pieces_text,
                     .settings = "pieces"}));
}

const CallSettings k_pieces_settings("pieces", pieces_options(), pieces_method_options());
const RegisteredCall k_pieces_call(add_pieces);

}  // namespace

}  // namespace moldlight::python
