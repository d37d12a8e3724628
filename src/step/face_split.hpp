// Splits faces of a part at the borders between labels. The borders come as chords on the facets: each point
// goes to its place among the parameters of its face's surface, where the facet's corners have theirs.
#pragma once

#include <cstdint>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include "io/step_labels.hpp"

namespace moldlight::step {

struct PlacedBody {
  TopoDS_Shape shape;  // without a place
  gp_Trsf place;
};

struct LabelledFace {
  TopoDS_Face face;
  std::uint32_t label = 0;
  double area = 0.0;  // mm²
};

struct LabelledPart {
  std::vector<TopoDS_Shape> bodies;  // in their places, which are in their coordinates
  std::vector<LabelledFace> faces;   // of the bodies
  std::vector<std::uint32_t> failed_faces;
};

/// `bodies` have been cut into the triangles whose numbers `labels` has. A face that cannot be split soundly
/// stays whole. Throws std::runtime_error where the borders are not on the facets.
[[nodiscard]] LabelledPart split_faces(const std::vector<PlacedBody>& bodies, const StepLabels& labels);

}  // namespace moldlight::step
