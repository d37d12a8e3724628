// Part.classify(): the regions of one direction, their areas, the split mesh, pictures.
#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include "classify/classifier.hpp"
#include "classify/classify_report.hpp"
#include "classify/headless.hpp"
#include "classify/json.hpp"
#include "classify/number_format.hpp"
#include "io/png.hpp"
#include "python/pages.hpp"
#include "study/study.hpp"

namespace moldlight::python {

namespace {

/// moldlight.Classification: what is shown of it does not change; the rest is found when it is asked for.
class PythonClassification {
 public:
  using BoundToPython = void;
  explicit PythonClassification(Study study) : study_(std::move(study)) {}

  [[nodiscard]] const PartModel& model() const { return study_.model(); }
  [[nodiscard]] const std::shared_ptr<const PartModel>& shared_model() const { return study_.shared_model(); }
  [[nodiscard]] const Classification& result() const { return *result_; }

  [[nodiscard]] Json json() const {
    const std::lock_guard lock(mutex_);
    return classify_json(study_, Progress());
  }
  [[nodiscard]] Backend backend() const { return result().settings.backend; }
  [[nodiscard]] report::Report report(const report::ReportContext& context) const {
    const std::lock_guard lock(mutex_);
    return report::classify_report(context, study_);
  }
  /// The result with its split mesh, from any thread.
  [[nodiscard]] Classification with_split(const Progress& progress) const {
    const std::lock_guard lock(mutex_);
    return study_.find<SplitRegions>(progress).result;
  }

  Recall recall = {};

 private:
  mutable std::mutex mutex_;
  mutable Study study_;
  std::shared_ptr<const Classification> result_ = study_.known<Classification>();
};
using SharedClassification = std::shared_ptr<PythonClassification>;

/// moldlight.Border.
struct Border {
  using BoundToPython = void;
  std::string left, right;
  py::array vertices, points;
  bool closed = false;
};

/// moldlight.SplitMesh.
struct PythonSplit {
  using BoundToPython = void;
  std::shared_ptr<const SplitMesh> mesh;
  std::vector<FacetIndex> facets;  // of each piece, as the file lists them
  py::list borders;
};

SharedClassification classify(const PythonPart& self, const py::object& direction,
                              const py::kwargs& keywords) {
  bool compares = false, splits = false;
  const auto take = [&](Given& given, Questions& questions) {
    DraftSettings draft;
    given.take(draft_options(), draft);
    questions.required_draft_deg = draft.required_deg;
    compares = given.take_switch("compare_maps");
    splits = given.take_switch("split");
  };
  const auto find = [&](Study& study, const Progress& progress) {
    const Questions& questions = study.questions();
    const MethodSettings& method = questions.query.method;
    if (method.readout != Readout::exact || compares) {
      const auto context = create_context(method.backend);
      Classifier classifier(*context, self.model);
      Classification by_maps = classifier.classify(questions.query, progress, splits || compares);
      if (compares) classifier.compare_maps(by_maps, progress);
      study.keep(std::make_shared<const Classification>(std::move(by_maps)));
    }
    if (splits) study.find<SplitRegions>(progress);
    study.find<Classification>(progress);
    if (questions.required_draft_deg > 0.0) study.find<DraftCheck>(progress);
  };
  return answer_of<PythonClassification>({"classify", self, direction, keywords}, take, find);
}

/// {"core": …, "cavity": …, "both": …, "undercut": …}.
py::dict region_dict(const RegionValues& values) {
  py::dict dict;
  for (const Region region : k_regions) dict[py::str(std::string(region_name(region)))] = values[region];
  return dict;
}

/// m x 4: the area of each region in a facet.
py::array facet_areas(const PythonClassification& self) {
  FacetFractions areas = self.result().facet_fractions;
  for (std::size_t facet = 0; facet < areas.size(); ++facet)
    for (double& share : areas[facet]) share *= self.model().geometry.areas[facet];
  return listed(areas, self.model().part);
}

py::object face_table(const PythonClassification& self) {
  const std::vector<SourceAreas> faces = face_areas(self.model(), self.result());
  if (faces.empty()) return py::none();
  py::array_t<std::uint32_t> numbers(static_cast<py::ssize_t>(faces.size()));
  py::array_t<double> areas({static_cast<py::ssize_t>(faces.size()), py::ssize_t{k_region_count}});
  for (std::size_t i = 0; i < faces.size(); ++i) {
    numbers.mutable_data()[i] = faces[i].source;
    for (const Region region : k_regions)
      *areas.mutable_data(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(region)) =
          faces[i].areas[region];
  }
  return py::make_tuple(numbers, areas);
}

Border border_of(const SplitMesh& mesh, const RegionBorder& line) {
  std::vector<glm::dvec3> points;
  for (const VertexIndex vertex : line.vertices) points.push_back(mesh.vertices[vertex]);
  return {.left = std::string(region_name(line.left)),
          .right = std::string(region_name(line.right)),
          .vertices =
              py::array_t<VertexIndex>(static_cast<py::ssize_t>(line.vertices.size()), line.vertices.data()),
          .points = copy_of(points),
          .closed = line.closed()};
}

std::shared_ptr<PythonSplit> split_mesh(const PythonClassification& self, const py::object& progress_given) {
  std::vector<RegionBorder> borders;
  auto split = std::make_shared<PythonSplit>();
  watch(progress_given, [&](const Progress& progress) {
    split->mesh = self.with_split(progress).split;
    borders = region_borders(*split->mesh);
  });
  const std::vector<FacetIndex> in_file = listed_facets(self.model().part);
  std::vector<FacetIndex> places(in_file.size());
  for (FacetIndex place = 0; place < in_file.size(); ++place) places[in_file[place]] = place;
  for (const SplitPiece& piece : split->mesh->pieces) split->facets.push_back(places[piece.facet]);
  for (const RegionBorder& border : borders) split->borders.append(border_of(*split->mesh, border));
  return split;
}

/// An array over the pieces, whose numbers lie in the pieces themselves.
template <typename T>
py::array piece_view(const py::object& self, const T& (*first)(const SplitPiece&), std::size_t columns) {
  const std::vector<SplitPiece>& pieces = self.cast<const PythonSplit&>().mesh->pieces;
  return view(Rows<T>{.data = pieces.empty() ? nullptr : &first(pieces.front()),
                      .rows = pieces.size(),
                      .columns = columns,
                      .stride = sizeof(SplitPiece)},
              self);
}

const VertexIndex& first_corner(const SplitPiece& piece) { return piece.corners.front(); }
const std::uint8_t& region_code(const SplitPiece& piece) {
  return reinterpret_cast<const std::uint8_t&>(piece.region);
}

void add_split(py::module_& module) {
  py::class_<Border>(module, "Border", "A line between two regions of a split mesh.")
      .def_readonly("left", &Border::left, "The region left of the walk, seen from outside.")
      .def_readonly("right", &Border::right)
      .def_readonly("vertices", &Border::vertices,
                    "k uint32: vertices of the split mesh; the last is the first if closed.")
      .def_readonly("points", &Border::points, "k x 3 float64: where they are.")
      .def_readonly("closed", &Border::closed)
      .def("__repr__", [](const Border& border) {
        return fmt::format("<moldlight.Border of {} and {}: {} points>", border.left, border.right,
                           border.vertices.size());
      });
  py::class_<PythonSplit, std::shared_ptr<PythonSplit>>(
      module, "SplitMesh",
      "The part's mesh, split at the borders of its regions. Neighbours share whole edges, so it is closed "
      "if the part is. The part's own vertices come first.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) { return view(self.cast<const PythonSplit&>().mesh->vertices, self); },
          "n x 3 float64, read only.")
      .def_property_readonly(
          "faces", [](const py::object& self) { return piece_view<VertexIndex>(self, first_corner, 3); },
          "p x 3 uint32, read only; the pieces of one facet follow each other.")
      .def_property_readonly(
          "facets", [](const py::object& self) { return view(self.cast<const PythonSplit&>().facets, self); },
          "p uint32, read only: the part's facet that each comes from.")
      .def_property_readonly(
          "regions", [](const py::object& self) { return piece_view<std::uint8_t>(self, region_code, 1); },
          "p uint8, read only: places in moldlight.REGIONS.")
      .def_readonly("borders", &PythonSplit::borders, "The lines between regions, a Border each.")
      .def("__repr__", [](const PythonSplit& split) {
        return fmt::format("<moldlight.SplitMesh: {} facets, {} borders>", split.mesh->pieces.size(),
                           split.borders.size());
      });
}

Image drawn(const PythonClassification& self, const StillSettings& still, const Progress& progress) {
  const Classification whole = self.with_split(progress);
  const auto context = create_context(whole.settings.backend);
  return StillPainter(*context, self.shared_model()).draw(whole, still, progress);
}

void add_figures(py::class_<PythonClassification, SharedClassification>& result) {
  using C = PythonClassification;
  add_members(result, {{"verdict", "The Verdict on the direction."},
                       {"total_area", "", "/areas/total"},
                       {"near_vertical_area", "", "/areas/near_vertical"},
                       {"undercut_uncertainty", "Uncertainty of the undercut area."},
                       {"projected_area", ""},
                       {"projected_undercut", ""},
                       {"lateral_tolerance", ""},
                       {"warnings", "Why figures are in doubt, a sentence each.", "/part/warnings"},
                       {"fractions", "Shares of each region in the surface."},
                       {"uncertainty_parts", "Its parts: rounding, mesh, readout."},
                       {"identity", "The part's shadow found in two ways, and whether they agree."},
                       {"settings", "Every setting with its value."}});
  result
      .def_property_readonly(
          "areas", [](const C& self) { return region_dict(self.result().areas); },
          "The area of each region, in the part's unit squared.")
      .def_property_readonly(
          "direction", [](const C& self) { return to_python(self.result().direction); }, "Unit vector.")
      .def_property_readonly(
          "facet_fractions",
          [](const C& self) { return listed(self.result().facet_fractions, self.model().part); },
          "m x 4 float64, read only: the share of each region (moldlight.REGIONS) in a facet's area; 0 for a "
          "facet without area.")
      .def_property_readonly("facet_areas", facet_areas,
                             "m x 4 float64, read only: the area of each region in a facet.")
      .def_property_readonly("face_areas", face_table,
                             "(numbers, areas): of each face its number and the area of each region, f and f "
                             "x 4. Faces are those of CAD, else planes and bent walls that facets form.");
}

constexpr std::string_view k_classify_text =
    "The regions of the part for a mold that opens along a direction.\n\n"
    "direction: three numbers of any length, an axis such as 'z' or '-y', or 'best', what a sweep finds.\n"
    "split: make the split mesh at once, in place of when it is first asked for.\n"
    "compare_maps: measure how far the shadow maps are from exact regions; needs OpenGL.\n"
    "isolated: work in a process of its own, which keeps the result. What ends that process raises Error.\n"
    "progress: as for Part(). Returns a Classification.";

void add_classify(py::module_& module, PartClass& part) {
  add_split(module);
  py::class_<PythonClassification, SharedClassification> result(
      module, "Classification",
      "Result of part.classify(). Lengths and areas are in the part's unit; regions are in the order of "
      "moldlight.REGIONS.");
  add_figures(result);
  result
      .def("split_mesh", &split_mesh, py::arg("progress") = py::none(),
           "split_mesh(self, progress=None)\n--\n\nThe part's mesh, split at the borders of the exact "
           "regions: a SplitMesh.")
      .def("__repr__", [](const PythonClassification& self) {
        const Classification& found = self.result();
        return py::str(fmt::format("<moldlight.Classification along {}: undercut {} of {}>",
                                   direction_words(found.direction), figure(found.areas[Region::undercut]),
                                   figure(found.total_area)));
      });
  add_picture(result,
              "Draws the part in the colours of its regions: height x width x 4 uint8, red, green, "
              "blue,\nalpha, rows from above. Needs OpenGL, no display.",
              drawn);
  result.def("_png", [](const PythonClassification& self) {
    return py::bytes(watched(py::none(), [&](const Progress& progress) {
      return png_bytes(drawn(self, {.size = {800, 500}}, progress));
    }));
  });
  add_result(result, "classify");
  add_pages(result, true);
  part.def("classify", &classify, py::arg("direction"),
           call_doc({.name = "classify",
                     .arguments = "self, direction",
                     .more = "split=False, compare_maps=False, isolated=False, progress=None",
                     .text = k_classify_text,
                     .settings = "classify"}));
}

const CallSettings k_classify_settings("classify", method_options(), draft_options());
const RegisteredCall k_classify_call(add_classify);

}  // namespace

}  // namespace moldlight::python
