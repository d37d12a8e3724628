// A part as the window takes it, with the directions that its own shape suggests: the direction snaps to them
// while Ctrl is held.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "mesh/faces.hpp"
#include "render/view_geometry.hpp"

namespace moldlight::gui {

struct FeatureDirection {
  glm::dvec3 direction{0, 0, 1};  // unit; its opposite is meant too
  std::string reason;
};

/// A part and what its pictures need, ready for the GL; copies share it.
struct LoadedPart {
  std::string path;
  ReadOptions reading;
  std::shared_ptr<const PartModel> model;
  std::shared_ptr<const ViewGeometry> geometry;
  std::shared_ptr<const Faces> faces;
  /// The axes of the file, axes of round walls, normals of large planes, directions along much wall area.
  std::vector<FeatureDirection> features;
};

/// Throws what the reading throws (FileError, Cancelled, …).
[[nodiscard]] LoadedPart load_for_window(const std::string& path, const ReadOptions& options,
                                         const Progress& progress);

/// A body of a part, by its place among them, as reading it alone would give it. Throws Cancelled.
[[nodiscard]] std::shared_ptr<const PartModel> body_model(const PartModel& whole, std::size_t body,
                                                          const Progress& progress);
/// The same ready for the window, without reading the file again.
[[nodiscard]] LoadedPart loaded_body(const LoadedPart& whole, std::size_t body, const Progress& progress);

/// A part that is in memory, without the directions. Throws Cancelled.
[[nodiscard]] LoadedPart pictured_part(const std::string& path, const ReadOptions& options,
                                       std::shared_ptr<const PartModel> part, const Progress& progress);

/// The body that has the facet, by its place among them.
[[nodiscard]] inline std::size_t body_of(const Part& part, FacetIndex facet) {
  const auto after = std::ranges::upper_bound(part.bodies, facet, {}, &Body::first_facet);
  return static_cast<std::size_t>(after - part.bodies.begin()) - 1;
}

/// The nearest feature or its opposite, however far; the direction itself where there is no feature.
[[nodiscard]] glm::dvec3 snapped_to(const std::vector<FeatureDirection>& features,
                                    const glm::dvec3& direction);

}  // namespace moldlight::gui
