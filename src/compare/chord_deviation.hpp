// How far a mesh may lie off the surface that it stands for: two tessellations of one surface differ by that.
#pragma once

#include <vector>

#include "classify/part_model.hpp"
#include "mesh/faces.hpp"

namespace moldlight {

/// An estimate a facet, in the part's unit; 0 for a facet of a plane. Of a surface that bends by an angle b
/// from facet to facet, each w wide, the chords are off by w b / 8. What bends is known from the part's
/// faces: those of CAD, else round walls of 10 steps a turn or more.
struct ChordDeviation {
  std::vector<double> normal;   // off the facet's plane
  std::vector<double> lateral;  // of its rim: the greatest of the facets around its corners
  std::vector<double> step;     // the widest around its corners, across the bend: shadows move by that
  std::vector<double> spread;   // tangent of half the angle to the next step
  double greatest = 0.0;
};
[[nodiscard]] ChordDeviation chord_deviation(const PartModel& model, const Faces& faces);

}  // namespace moldlight
