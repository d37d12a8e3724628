// A presentation of the part, as a function of time: from its direction over undercuts and slides to the
// opened mold, each with a caption.
#pragma once

#include <string>
#include <vector>

#include "render/camera.hpp"

namespace moldlight::gui {

/// A part of it. The camera flies to its place first; then the mold opens, as far as it is to be.
struct Act {
  double length_s = 4.0;
  Camera camera = {};
  double open = 0.0;   // at its end
  double floor = 0.0;  // of the studio, z in the unit frame
  std::string caption = {};
};

/// What is shown at a time.
struct Moment {
  Camera camera;
  double open = 0.0, floor = 0.0;
  std::string caption;
};

class Presentation {
 public:
  /// The camera begins at the first act's place.
  explicit Presentation(std::vector<Act> acts);

  [[nodiscard]] Moment at(double time_s) const;
  [[nodiscard]] double length_s() const;
  /// When the mold begins to open, which takes its halves.
  [[nodiscard]] double opens_s() const;

 private:
  std::vector<Act> acts_;
};

}  // namespace moldlight::gui
