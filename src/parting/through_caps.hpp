// Where a half sees a wall only through a hole into an action's room: it ends at the hole's rim, and the
// action's piece goes on from there.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"
#include "parting/assignment.hpp"
#include "parting/halves/sheets.hpp"
#include "parting/sheet_frame.hpp"

namespace moldlight {

/// A cap over each such hole, in the sheets' frame: straight along the way in which the action leaves, from
/// rim to rim, so that it moves out past the end of the half's pin.
class ThroughCaps {
 public:
  ThroughCaps(const Assignment& sides, const SheetFrame& frame);

  /// The heights of the cap over a facet of the part that one half sees, with these corners; none where it
  /// has none. What of the wall is nearer to the patch than twice the lateral tolerance is capped, too.
  [[nodiscard]] std::optional<std::array<double, 3>> heights(Sheet sheet,
                                                             const std::array<glm::dvec3, 3>& corners) const;

 private:
  struct Segment {
    glm::dvec3 from{0.0}, to{0.0};
  };
  using Chain = std::vector<Segment>;
  struct Cap {
    Sheet sheet = Sheet::upper;
    Bounds bounds;  // of the patch
    std::vector<std::array<glm::dvec3, 3>> patch;
    Chain rim;
    glm::dvec2 way{1, 0};  // unit
  };
  [[nodiscard]] Chain rim_over(const Cap& cap, const std::map<VertexIndex, Chain>& chains) const;
  [[nodiscard]] bool is_under(const Cap& cap, const glm::dvec3& at) const;
  [[nodiscard]] double height(const Cap& cap, const glm::dvec2& at) const;

  double reach_ = 0.0;  // in diagonals
  std::vector<Cap> caps_;
};

}  // namespace moldlight
