// Shortcuts from a mesh to its classification.
#pragma once

#include <memory>

#include "classify/classifier.hpp"
#include "gl/context.hpp"

namespace moldlight::test {

/// One headless context for all tests of a program, current on the calling thread.
[[nodiscard]] const gl::Context& shared_context();

[[nodiscard]] std::shared_ptr<const PartModel> model_of(TriangleMesh mesh, double effort = 1.0);

[[nodiscard]] Classification classify_mesh(TriangleMesh mesh, const Query& query);

/// Largest difference of a region's area, as a share of the part's area.
[[nodiscard]] double worst_region_error(const Classification& result, const RegionValues& expected);

}  // namespace moldlight::test
