#include "support/mold_rows.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/stopwatch.hpp"
#include "parting/make_halves.hpp"
#include "parting/planar_line.hpp"
#include "support/known_pulls.hpp"
#include "support/manifest.hpp"
#include "support/shared_parts.hpp"

namespace moldlight::test {

namespace {

namespace fs = std::filesystem;

PartRows rows_of(const fs::path& path, std::span<const KnownPull> pulls) {
  PartRows part{.path = path, .directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const KnownPull& known : pulls) {
    if (path.filename() != known.file) continue;
    part.pull = known.direction;
    if (std::ranges::find(part.directions, part.pull) == part.directions.end())
      part.directions.push_back(part.pull);
  }
  return part;
}

std::size_t narrower_than(const TriangleMesh& mesh, double width) {
  std::size_t count = 0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3 &a = mesh.corner(facet, 0), &b = mesh.corner(facet, 1), &c = mesh.corner(facet, 2);
    const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    count += glm::length(glm::cross(b - a, c - a)) < width * longest ? 1 : 0;
  }
  return count;
}

/// At a share of the values.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return NAN;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

std::vector<PartRows> part_rows(std::size_t most_facets) {
  std::vector<fs::path> demos;
  for (const auto& entry : fs::directory_iterator(asset_folder() / "parts")) demos.push_back(entry.path());
  std::ranges::sort(demos);
  std::vector<PartRows> parts;
  for (const fs::path& path : demos) parts.push_back(rows_of(path, k_demo_pulls));
  const auto shared = shared_folder();
  if (!shared) return parts;
  for (const ManifestRow& row : read_manifest()) {
    if (!row.file.starts_with("bad/") && row.facets.value_or(0) > 0 && *row.facets <= most_facets)
      parts.push_back(rows_of(*shared / "parts" / row.file, k_shared_pulls));
  }
  return parts;
}

std::string row_name(const PartRows& part, const glm::dvec3& direction) {
  return fmt::format("{} along {}, {}, {}", part.path.filename().string(), direction.x, direction.y,
                     direction.z);
}

SteelRow steel_row(const PartModel& model, const glm::dvec3& direction, const std::string& name) {
  SteelRow row;
  row.name = name;
  const double diagonal = model.frame.diagonal;
  // As the command makes them: along the parting line.
  const MoldLine line = find_mold_line(model, {direction, {}}, {}, Progress{});
  row.line_climb = std::max(line.line.outer_high - line.line.outer_low, 0.0) / diagonal;
  row.planar_line = row.line_climb <= 1e-4;
  const Stopwatch watch;
  const MoldHalves halves = make_halves(model, direction, meeting_place(line), {}, Progress{});
  row.ms = watch.elapsed_ms();
  const WrittenMold& written = halves.written;
  row.refusal = written.refusal;
  if (!row.refusal.empty()) return row;
  const SurfaceFigures& surface = halves.surface;
  row.rim = (surface.rim_high - surface.rim_low) / diagonal;
  row.surface_rise = (surface.high - surface.low) / diagonal;
  row.shelf_share = surface.shelf_share();
  row.faces = surface.faces;
  const double width = diagonal / 2000.0;
  for (std::size_t k = 0; k < 2; ++k) row.narrow += narrower_than(written.bodies[k].mesh, width);
  row.narrow -= std::min(row.narrow, narrower_than(model.part.mesh, width));
  row.crossed = halves.core.crossed_facets + halves.cavity.crossed_facets;
  row.contact = halves.contact_area / (diagonal * diagonal);
  const Bounds block = bounds(halves.core.mesh), part = bounds(model.part.mesh);
  if (axis_of(halves.frame.z) >= 0) {
    for (const int side : {0, 1}) {
      for (const int axis : {0, 1}) {
        const glm::dvec3 corner = (side == 0 ? part.min : part.max) - halves.centre;
        const double reach = std::max(std::abs(halves.frame.to_mold(corner)[axis]), 0.0);
        row.margin = std::max(row.margin, (side == 0 ? -block.min[axis] : block.max[axis]) - reach);
      }
    }
    row.margin /= diagonal;
  }
  return row;
}

std::string steel_line(const SteelRow& row) {
  if (!row.refusal.empty()) return fmt::format("{:<52} refused: {}", row.name, row.refusal);
  return fmt::format(
      "{:<52} line {} {:6.4f}  rim {:7.5f}  rise {:7.5f}  shelf {:5.3f}  faces {:4}  narrow {:5}  crossed "
      "{:4}  "
      "contact {:8.2e}  margin {:5.3f}  {:6.0f} ms",
      row.name, row.planar_line ? "planar" : "climbs", row.line_climb, row.rim, row.surface_rise,
      row.shelf_share, row.faces, row.narrow, row.crossed, row.contact, row.margin, row.ms);
}

std::string steel_summary(const std::vector<SteelRow>& rows) {
  std::size_t made = 0, flat = 0, planar = 0, one_plane = 0, with_narrow = 0, crossed = 0;
  std::vector<double> shares, faces, times;
  for (const SteelRow& row : rows) {
    if (!row.refusal.empty()) continue;
    ++made;
    flat += row.rim <= 1e-4 ? 1 : 0;
    planar += row.planar_line ? 1 : 0;
    one_plane += row.planar_line && row.surface_rise <= 1e-5 ? 1 : 0;
    with_narrow += row.narrow > 0 ? 1 : 0;
    crossed += row.crossed > 0 ? 1 : 0;
    shares.push_back(row.shelf_share);
    faces.push_back(static_cast<double>(row.faces));
    times.push_back(row.ms);
  }
  return fmt::format(
      "{} of {} rows have halves; the block's edge is flat on {}; {} of {} planar lines have a surface of "
      "one "
      "plane; shelf's share {:.3f} in the median, {:.3f} at the lower quartile; {} faces in the median; "
      "narrow "
      "facets on {} rows; facets that cross on {}; median {:.0f} ms, longest {:.0f} ms\n",
      made, rows.size(), flat, one_plane, planar, quantile(shares, 0.5), quantile(shares, 0.25),
      quantile(faces, 0.5), with_narrow, crossed, quantile(times, 0.5), quantile(times, 1.0));
}

}  // namespace moldlight::test
