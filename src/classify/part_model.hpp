// A part with everything that is computed once and does not depend on the parting direction.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "io/part_formats.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mesh/part.hpp"
#include "mesh/unit_frame.hpp"
#include "mold/area_error.hpp"
#include "mold/exact/exact_part.hpp"
#include "mold/exact_rays.hpp"

namespace moldlight {

/// Immutable once loaded, so that runners and window share one from any thread. It does not move.
struct PartModel {
  Part part;
  FacetGeometry geometry;
  Adjacency adjacency;
  BentEdges edges;
  HealthReport health;
  UnitFrame frame;
  PartErrors errors;
  std::vector<std::string> warnings;  // of the reader and of the health report
  double load_ms = 0.0;

  /// What exact regions and exact rays need of the part, made at the first use; other threads that ask
  /// meanwhile wait. The first throws Cancelled, and is made anew when asked again.
  [[nodiscard]] const ExactPart& exact(const Progress& progress) const;
  [[nodiscard]] const ExactRays& rays() const;

 private:
  mutable std::once_flag exact_once_, rays_once_;
  mutable std::unique_ptr<const ExactPart> exact_;
  mutable std::unique_ptr<const ExactRays> rays_;
};

/// Reads and prepares a part, its facets ordered by place (mesh/place_order.hpp). Throws FileError for what
/// cannot be read and Cancelled.
[[nodiscard]] std::shared_ptr<const PartModel> load_part(const std::string& path, const ReadOptions& options,
                                                         const Progress& progress);

/// The same of a part file's bytes, which messages call `name`.
[[nodiscard]] std::shared_ptr<const PartModel> load_part_bytes(const std::string& name,
                                                               std::string_view bytes,
                                                               const ReadOptions& options,
                                                               const Progress& progress);

/// Prepares a part that is in memory already.
[[nodiscard]] std::shared_ptr<const PartModel> prepare_part(Part part, const Progress& progress);

}  // namespace moldlight
