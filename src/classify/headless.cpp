#include "classify/headless.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "classify/classifier.hpp"
#include "gl/headless_context.hpp"
#include "mold/second_depth.hpp"

namespace moldlight {

namespace {

/// A closed channel, 3 wide, 4 long and 2 high, with walls and a floor of 1: facets up, down and upright, and
/// concave edges. The section's corners are numbered counter-clockwise, those of the far end follow.
std::shared_ptr<const PartModel> known_part() {
  constexpr std::array<std::array<double, 2>, 8> k_section = {
      {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  constexpr std::array<std::array<VertexIndex, 3>, 6> k_end = {
      {{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7}}};
  constexpr VertexIndex k_corners = 8;
  Part part;
  for (const double y : {0.0, 4.0}) {
    for (const auto& [x, z] : k_section) part.mesh.vertices.emplace_back(x, y, z);
  }
  for (const auto& [a, b, c] : k_end) {
    part.mesh.facets.push_back({a, b, c});
    part.mesh.facets.push_back({k_corners + a, k_corners + c, k_corners + b});
  }
  for (VertexIndex a = 0; a < k_corners; ++a) {
    const VertexIndex b = (a + 1) % k_corners;
    part.mesh.facets.push_back({a, k_corners + a, b});
    part.mesh.facets.push_back({b, k_corners + a, k_corners + b});
  }
  part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
  return prepare_part(std::move(part), Progress{});
}

}  // namespace

std::string driver_fault(const gl::Context& context) {
  constexpr double k_most_differing = 0.02;  // of the covered texels: roundings at the facets' edges
  static const std::shared_ptr<const PartModel> part = known_part();
  MethodSettings settings;
  settings.resolution = 128;
  const Query query{glm::dvec3(0.3, 0.2, 1.0), settings};
  PartMaps drawn(context, part);
  drawn.draw_maps(query);
  const MapFrame frame = map_frame(query.direction.unit());
  SecondDepthMaps known(settings.resolution);
  known.draw({part->part.mesh, unit_positions(part->part.mesh, part->frame), part->geometry.normals,
              part->edges.concave},
             frame, facet_classes(part->geometry, frame.z, settings.tau_deg), settings.edge_thickness);
  std::size_t covered = 0, differing = 0;
  for (const bool plus : {false, true}) {
    const std::vector<std::uint32_t> texels = drawn.maps().read(plus);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      covered += known.facets(plus)[i] != 0 ? 1 : 0;
      differing += known.facets(plus)[i] != texels[i] ? 1 : 0;
    }
  }
  const double share = static_cast<double>(differing) / static_cast<double>(covered);
  if (share <= k_most_differing) return "";
  return fmt::format("draws shadow maps wrongly: {:.0f} % of the texels of a known part", 100.0 * share);
}

std::unique_ptr<gl::Context> create_context(Backend backend) {
  return gl::create_headless_context(backend, {}, [](const gl::Context& context) {
    const std::string fault = driver_fault(context);
    if (!fault.empty()) throw Error(fmt::format("the driver {} {}", context.renderer(), fault));
  });
}

std::vector<BackendReport> backend_reports() {
  std::vector<BackendReport> reports;
  for (const auto& [backend, name] : {std::pair{Backend::egl, "EGL"}, std::pair{Backend::osmesa, "OSMesa"}}) {
    BackendReport report{name, "", ""};
    try {
      const std::unique_ptr<gl::Context> context = gl::create_headless_context(backend);
      report.renderer = context->renderer();
      report.fault = driver_fault(*context);
    } catch (const Error& error) {
      report.fault = error.what();
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace moldlight
