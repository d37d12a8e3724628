// Part.pieces(): molds of several pieces.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "pieces/pieces_report.hpp"
#include "python/mold_bodies.hpp"
#include "python/pages.hpp"
#include "study/study.hpp"

namespace moldlight::python {

using namespace py::literals;

namespace {

/// moldlight.Pieces.
struct PythonPieces : StudyAnswer<pieces_json, report::pieces_report> {
  using StudyAnswer::StudyAnswer;

  [[nodiscard]] const PiecesResult& result() const { return *study.known<PiecesResult>(); }
  /// Throws Error where they were not asked for.
  [[nodiscard]] const PieceSolids& solids() const {
    const auto found = study.known<PieceSolids>();
    if (!found) throw Error("the pieces were found as surface; call pieces() with solids=True");
    return *found;
  }
  [[nodiscard]] std::string refusal() const { return solids_refusal(model(), solids()); }
};
using SharedPieces = std::shared_ptr<PythonPieces>;

SharedPieces pieces(const PythonPart& self, const py::kwargs& keywords) {
  Given given("pieces", keywords);
  Questions questions;
  given.take(pieces_options(), questions.pieces);
  given.take(pieces_method_options(), questions.query.method);
  given.take(pieces_solid_options(), questions.mold);
  const bool with_solids = given.take_switch("solids");
  const py::object progress_given = given.take("progress");
  given.end();
  auto found = watched(progress_given, [&](const Progress& progress) {
    Study study(self.model, questions);
    study.find<PiecesResult>(progress);
    if (with_solids) study.find<PieceSolids>(progress);
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

py::list write_solids(const PythonPieces& self, const py::object& folder, bool as_3mf, bool as_step) {
  if (const std::string refusal = self.refusal(); !refusal.empty()) throw Error(refusal);
  return write_bodies(self.solids().halves.written, path_of(folder, "folder"), {as_3mf, as_step},
                      self.model().part.unit);
}

constexpr std::string_view k_pieces_text =
    "Finds the fewest directions of a mold of several pieces, and which piece forms what. Returns a\n"
    "Pieces.\n\n"
    "solids: make the pieces as solids, too. margin, ramp_deg, land, slope_deg, shrink_pct and registration\n"
    "are those of their halves.\n"
    "isolated: as for classify(). progress: as for Part().";

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
              {"flexible", "Of a flexible mold a dict with undercuts and cuts; None of a rigid one."},
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
      .def_property_readonly(
          "refusal", [](const PythonPieces& self) { return self.refusal(); },
          "Why there are no solids; empty if there are. This and what follows needs solids=True.")
      .def_property_readonly(
          "bodies",
          [](const PythonPieces& self) {
            return self.refusal().empty() ? body_dicts(self.solids().halves.written) : py::list();
          },
          "The solids as they are written: a dict each with name, vertices, faces, volume and closed. Empty "
          "where there are none.")
      .def_property_readonly(
          "frame", [](const PythonPieces& self) { return mold_frame_array(self.solids().halves); },
          "4 x 4 float64: takes the bodies' coordinates to the part's.")
      .def("write", &write_solids, py::arg("folder"), py::arg("as_3mf") = false, py::arg("as_step") = false,
           "write(self, folder, as_3mf=False, as_step=False)\n--\n\nWrites the solids to a folder, an STL "
           "each, and all of "
           "them to mold.3mf or mold.step. Returns the files'\nnames. Raises Error where there are none.")
      .def("__repr__", [](const PythonPieces& self) {
        return py::str(fmt::format("<moldlight.Pieces: {}>", pieces_sentence(self.model(), self.result())));
      });
  add_result(found, "pieces");
  add_pages(found);
  part.def("pieces", &pieces,
           call_doc({.name = "pieces",
                     .arguments = "self",
                     .more = "solids=False, isolated=False, progress=None",
                     .text = k_pieces_text,
                     .settings = "pieces"}));
}

const CallSettings k_pieces_settings("pieces", pieces_options(), pieces_method_options(),
                                     pieces_solid_options());
const RegisteredCall k_pieces_call(add_pieces);

}  // namespace

}  // namespace moldlight::python
