// A part as read from a file: its mesh and what the file says about it; one body of it, or another unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/face_colour.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A body of the file (STL solid, OBJ group or object, 3MF item, STEP solid): a run of facets.
struct Body {
  std::string name;
  FacetIndex first_facet = 0;
  FacetIndex facet_count = 0;
};

struct Part {
  std::string file;    // as the user gave it
  std::string format;  // "STL binary", "STL ASCII", "OBJ", …
  std::string unit;    // "mm", "in", …; empty where the file does not say
  TriangleMesh mesh;
  std::vector<Body> bodies;                 // at least one, covering all facets in order
  std::vector<std::uint32_t> facet_source;  // number of the file's polygon (OBJ, PLY, OFF) or CAD face (STEP)
                                            // that each facet comes from; empty where each facet is its own
  bool has_cad_faces = false;               // they are CAD faces
  std::vector<std::uint32_t> face_colours = {};  // of each CAD face, 0xRRGGBB or k_no_colour; empty where the
                                                 // file gives none a colour
  std::vector<std::string> warnings;             // one sentence each, for the user
  std::vector<std::uint32_t> file_facets = {};  // number in the file of each facet, k_no_facet for one that a
                                                // repair added; empty where facet k is facet k of the file
  std::vector<std::string> repairs = {};        // what a repair did, one sentence each
  std::vector<std::string> file_bodies = {};  // names of all bodies of the file where one of them was chosen
  std::size_t chosen_body = 0;                // its number among them, from 1; 0: all were taken
  double effort = 1.0;                        // times the usual work that its exact regions may take, >= 1
};

/// The part reduced to one body, or the part itself for "all". `selector` is a body's number in the list,
/// from 1, or its name. Throws UsageError that lists the bodies for a number or name that is not there or not
/// the only one.
[[nodiscard]] Part select_body(Part part, std::string_view selector);

/// Body `index` (from 0) of the part as a part of its own. file_facets has which facets of the file it has,
/// chosen_body and file_bodies from among which bodies it comes.
[[nodiscard]] Part extract_body(const Part& part, std::size_t index);

/// Brings the part to `unit` ("mm", "in", …): its lengths are converted where the part names another unit,
/// and only named where it names none. Throws UsageError for an unknown unit.
void set_unit(Part& part, std::string_view unit);

}  // namespace moldlight
