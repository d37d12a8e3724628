// Heights of the parting surface at every place of the plane: a plane, the shelf, which level land and ramps
// join to an outline that leaves it. What is above the shelf pulls the surface up, over its land and down a
// ramp; the rest of the outline holds it down, by the steepest slope that is allowed; below the shelf alike.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "parting/halves/rim_segment.hpp"
#include "parting/halves/step_profile.hpp"

namespace moldlight {

/// A plane over the plane.
struct ShelfPlane {
  double height = 0.0;  // over the origin
  glm::dvec2 tilt{0.0};

  [[nodiscard]] double at(const glm::dvec2& place) const {
    return height + tilt.x * place.x + tilt.y * place.y;
  }
  /// Whether it meets all of the outline, but for this much.
  [[nodiscard]] bool meets(const std::vector<RimSegment>& rims, double slack) const;
};

/// The greatest, over segments and corners with heights, of height − slope · max(0, distance − land), over
/// what lies in front of them, so that it does not reach through the part.
class Envelope {
 public:
  struct Source {
    std::array<glm::dvec2, 2> ends{};
    std::array<double, 2> heights{};
    double land = 0.0;
    std::array<glm::dvec2, 2> fronts{};  // it counts on the left of one of these directions, or on them
  };
  Envelope() = default;
  Envelope(std::vector<Source> sources, double slope);

  /// `least` where all are lower.
  [[nodiscard]] double at(const glm::dvec2& place, double least) const;

 private:
  /// Neighbouring sources, in a box.
  struct Node {
    std::uint32_t first = 0, last = 0;  // sources
    std::uint32_t parts = 0;            // the first of two nodes; 0: none
    glm::dvec2 low{INFINITY}, high{-INFINITY};
    double most = -INFINITY, land = 0.0;
  };
  void split(std::uint32_t node);
  /// What no source of it exceeds at a place.
  [[nodiscard]] double bound(const Node& node, const glm::dvec2& place) const;
  void raise(const Node& node, const glm::dvec2& place, double& most) const;

  std::vector<Source> sources_;
  std::vector<Node> nodes_;  // the first has all
  double slope_ = 1.0;
};

class ShelfField {
 public:
  ShelfField(const std::vector<RimSegment>& rims, const ShelfPlane& shelf, const ShelfShape& shape);
  /// Steps in the shelf's place; its land and ramps join them to what of the outline they leave.
  ShelfField(const std::vector<RimSegment>& rims, StepProfile steps, const ShelfShape& shape);

  [[nodiscard]] double at(const glm::dvec2& place) const;
  /// Whether the shelf is all of the surface.
  [[nodiscard]] bool plane() const { return plane_; }
  [[nodiscard]] const ShelfPlane& shelf() const { return shelf_; }
  [[nodiscard]] const ShelfShape& shape() const { return shape_; }
  /// None where land and ramps join the shelf to the outline.
  [[nodiscard]] const std::optional<StepProfile>& steps() const { return steps_; }

  /// The shelf, or the steps.
  [[nodiscard]] double ground(const glm::dvec2& place) const {
    return steps_ ? steps_->at(place) : shelf_.at(place);
  }

 private:
  /// What leaves the shelf one way: pulls the surface along, and what holds it back; downwards with heights
  /// turned over.
  struct Side {
    Envelope pull, hold;
  };
  [[nodiscard]] double rise(const Side& side, const glm::dvec2& place, double sign) const;
  [[nodiscard]] Side side_of(const std::vector<RimSegment>& rims, double sign) const;

  ShelfPlane shelf_;
  ShelfShape shape_;
  bool plane_ = false;
  std::optional<StepProfile> steps_;
  Side up_, down_;
};

/// The level that most of the outline can be met at, by its length; of several, that at which most of the
/// line runs, then the one nearest to `wish`. `line`: heights of the line, one a segment, or not finite.
[[nodiscard]] double shelf_level(const std::vector<RimSegment>& rims, const std::vector<double>& line,
                                 double wish);

/// The plane through an outline that is in one.
[[nodiscard]] ShelfPlane fitted_plane(const std::vector<RimSegment>& rims);

/// The rectangle outside of which the surface around the outline is level.
struct LevelOutside {
  glm::dvec2 low{INFINITY}, high{-INFINITY};
};
[[nodiscard]] LevelOutside level_outside(const std::vector<RimSegment>& rims, const ShelfField& field);

}  // namespace moldlight
