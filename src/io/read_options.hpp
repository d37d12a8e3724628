// How a part file is read, and what is made of the part at once.
#pragma once

#include <memory>
#include <string>

#include "mesh/repair.hpp"

namespace moldlight {

class StepProgram;

struct ReadOptions {
  int max_facets = 200'000'000;  // a file with more is an error, [1, 1'400'000'000]

  // What the name's extension says where the content leaves the format open; empty: that of the name.
  std::string format = {};

  // STEP only: how close the facets keep to the CAD surface.
  double linear_deflection = 0.0;       // distance in the file's unit; 0: 0.0005 of the part's diagonal
  double angular_deflection_deg = 5.0;  // angle between neighbouring chords, (0, 90]

  // STEP and IGES: what reads stays there with the part, for write_step_part(); null: it ends.
  std::shared_ptr<StepProgram> stays = {};

  double effort = 1.0;  // times the usual work that exact regions may take, [1, 10'000]

  // What is made of it then, in this order.
  std::string unit = {};      // see set_unit; empty: as the file says
  std::string body = "all";   // see select_body
  RepairOptions repair = {};  // see repair_part

  bool operator==(const ReadOptions&) const = default;
};

}  // namespace moldlight
