#include "pieces/find_pieces.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/stopwatch.hpp"
#include "classify/classification.hpp"
#include "classify/method_options.hpp"
#include "mesh/faces.hpp"
#include "mold/surface_samples.hpp"
#include "pieces/choose_directions.hpp"
#include "pieces/locked_loops.hpp"
#include "sweep/sample_rays.hpp"

namespace moldlight {

namespace {

/// So many of the chooser's samples are asked for a proof, spread evenly among them.
constexpr std::size_t k_proof_samples = 1600;
/// Where the most that are allowed are not enough, so many are tried to be excluded.
constexpr std::size_t k_most_excluded_of_many = 3;
/// Undercuts of a flexible mold that are measured, and the least share of the surface of one.
constexpr std::size_t k_most_stretched = 100;
constexpr double k_stretched_share = 1e-4;
constexpr std::size_t k_air_points = 1 << 15U;

/// Excludes one direction fewer than were found; a surface that is closed asks for two in any case.
void prove(const PartModel& model, const ChosenDirections& chosen, const Progress& progress,
           PiecesResult& result) {
  progress.report("proving", 0.0);
  const ProofPart part{.mesh = model.part.mesh,
                       .geometry = model.geometry,
                       .adjacency = model.adjacency,
                       .positions = model.exact(progress).positions(),
                       .rays = model.rays()};
  SurfaceSamples some;
  std::size_t unreachable = 0;
  const std::size_t wanted = std::min(k_proof_samples, chosen.samples.size());
  for (std::size_t k = 0; k < wanted; ++k) {
    const JudgedSample& judged = chosen.samples[k * chosen.samples.size() / wanted];
    some.samples.push_back(judged.sample);
    unreachable += judged.reachable ? 0 : 1;
  }
  const auto count = static_cast<double>(some.samples.size());
  const double spare = count * result.settings.eps;
  // Where candidates release all but eps, so it is asked of any directions.
  if (static_cast<double>(unreachable) <= spare) unreachable = 0;
  result.proof_samples = some.samples.size();
  // By their error, once its standard deviation, more may be left of the samples than of the surface.
  result.proof =
      prove_cover(part, sample_elements(part, some),
                  {.query = {.tau_deg = result.query.tau_deg, .lateral = result.query.lateral},
                   .most = chosen.enough ? chosen.directions.size() - 1
                                         : std::min(chosen.directions.size(), k_most_excluded_of_many),
                   .spare = unreachable +
                            static_cast<std::size_t>(spare + std::sqrt(spare * (1.0 - result.settings.eps)))},
                  progress);
  result.lower_bound = std::max<std::size_t>(result.proof.excluded + 1, model.health.closed ? 2 : 1);
}

/// Measures the undercuts of a flexible mold and gives each to the piece that stretches least.
void stretch(const PartModel& model, std::span<const glm::dvec3> directions,
             std::span<const LeftPolygon> left, const Progress& progress, PiecesResult& result,
             SurfaceWishes& wishes) {
  const double least = k_stretched_share * model.geometry.total_area;
  const auto end =
      std::ranges::find_if(result.places, [&](const LeftPlace& place) { return place.area < least; });
  const std::span measured(
      result.places.begin(),
      std::min<std::size_t>(k_most_stretched, static_cast<std::size_t>(end - result.places.begin())));
  result.stretches = stretches(model, directions, left, measured, progress);
  wishes.stretched_by.assign(model.part.mesh.facets.size(), SurfaceWishes::k_none);
  for (std::size_t k = 0; k < measured.size(); ++k)
    for (const std::size_t polygon : measured[k].polygons)
      wishes.stretched_by[left[polygon].facet] = result.stretches[k].direction;
  std::erase_if(result.stretches, [&](const StretchedUndercut& one) {
    return one.depth.value_or(INFINITY) < k_shallow * model.frame.diagonal;
  });
}

/// What each piece forms, but for specks that it does not release: strips of them would close loops that no
/// piece has.
std::vector<std::uint32_t> held_by(const PartModel& model, const PiecesResult& result,
                                   const SurfaceWishes& wishes) {
  std::vector<std::uint32_t> held = result.formed.formed_by;
  const double sine_of_tau = std::sin(glm::radians(result.query.tau_deg));
  SampleRays rays;
  for (std::uint32_t by = 0; by < result.count(); ++by) {
    const glm::dvec3& direction = result.directions[by].direction;
    rays.begin({direction, result.query.lateral});
    for (std::size_t k = 0; k < held.size(); ++k) {
      const FacetIndex facet = result.formed.mesh.pieces[k].facet;
      if (result.formed.formed_by[k] != by || SurfaceWishes::of(wishes.stretched_by, facet) == by) continue;
      const glm::dvec3& normal = model.geometry.normals[facet];
      rays.add(k, model.frame.to_unit(result.formed.mesh.middle(k)), normal,
               facet_class(glm::dot(normal, direction), sine_of_tau));
    }
    rays.ask(model.rays());
    rays.for_each([&](std::size_t k, bool plus, bool, float) {
      if (!plus) held[k] = static_cast<std::uint32_t>(result.count());
    });
  }
  return held;
}

/// Throws UsageError for faces and pieces that there are not.
SurfaceWishes wishes_of(const PartModel& model, const PiecesResult& result) {
  const std::vector<CosmeticGroup> groups = cosmetic_groups(result.settings.cosmetic);
  SurfaceWishes wishes;
  if (groups.empty()) return wishes;
  wishes.formed_by.assign(model.part.mesh.facets.size(), SurfaceWishes::k_none);
  wishes.cosmetic = wishes.formed_by;
  const Faces faces = part_faces(model.part, model.geometry, model.adjacency);
  for (const auto& [piece, numbers] : groups) {
    if (piece && *piece >= result.count())
      throw UsageError(fmt::format("--cosmetic: there is no piece {}; the mold opens along {}", *piece + 1,
                                   plural(result.count(), "direction")));
    for (const std::uint32_t face : numbers) {
      check_face(face, faces);
      for (const FacetIndex facet : faces.facets(face)) {
        wishes.cosmetic[facet] = face;
        if (piece) wishes.formed_by[facet] = *piece;
      }
    }
  }
  return wishes;
}

/// What all pieces together leave in the part's box beside the part: points that are blocked along every
/// direction and lie outside of the part, by rays.
void measure_air(const PartModel& model, const Progress& progress, PiecesResult& result) {
  if (!model.exact(progress).closed()) return;
  const Bounds box = bounds(model.part.mesh);
  std::vector<glm::vec3> points;
  for (std::size_t k = 0; k < k_air_points; ++k) {
    const glm::dvec2 place = square_place(k);
    const glm::dvec3 in_box(place, (static_cast<double>(k) + 0.5) / static_cast<double>(k_air_points));
    points.push_back(model.frame.to_unit(box.min + in_box * (box.max - box.min)));
  }
  std::vector<std::uint8_t> blocked(points.size());
  for (const PieceDirection& direction : result.directions) {
    progress.report("looking for enclosed air", 0.0);
    blocked.resize(points.size());
    model.rays().blocked(points, glm::vec3(direction.direction), blocked);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (blocked[k] != 0) points[kept++] = points[k];
    }
    points.resize(kept);
  }
  const glm::vec3 along(result.directions.front().direction);
  std::size_t outside = 0;
  for (const glm::vec3& point : points) {
    const auto hit = model.rays().first_hit(point, along, false);
    outside += hit && glm::dot(model.geometry.normals[hit->facet], glm::dvec3(along)) < 0.0 ? 1 : 0;
  }
  const glm::dvec3 size = box.max - box.min;
  const double share = static_cast<double>(outside) / static_cast<double>(k_air_points);
  const double volume = size.x * size.y * size.z;
  result.enclosed_air = share * volume;
  result.enclosed_error = 2.0 * volume * std::sqrt(share * (1.0 - share) / static_cast<double>(k_air_points));
}

}  // namespace

PiecesResult find_pieces(const PartModel& model, const MethodSettings& method, const PiecesSettings& settings,
                         const Progress& progress) {
  const Stopwatch stopwatch;
  validate(settings);
  validate(method, model.frame.diagonal);
  if (model.geometry.total_area <= 0.0) throw UsageError("the part has no surface to release");
  PiecesResult result;
  result.settings = settings;
  result.query = exact_query(model, {{}, method});
  const ChosenDirections chosen = choose_directions(model, result.query, settings, progress);
  result.enough = chosen.enough;
  result.optimal = chosen.optimal;
  result.releases_all = chosen.releases_all;
  result.left_area = chosen.left_area;
  result.unreachable_area = chosen.unreachable_area;
  result.places = left_places(model, chosen.left);
  std::vector<glm::dvec3> directions;
  for (const PullLine& line : chosen.directions) {
    result.directions.push_back({.direction = line.direction + 0.0, .name = line.name});  // no -0
    directions.push_back(line.direction);
  }
  if (!directions.empty()) {
    prove(model, chosen, progress, result);
    SurfaceWishes wishes = wishes_of(model, result);
    if (result.flexible()) stretch(model, directions, chosen.left, progress, result, wishes);
    result.formed = form_surface(model, result.query, directions, progress, wishes);
    if (result.flexible())
      result.cuts = locked_loops(result.formed.mesh, model.geometry.normals, held_by(model, result, wishes),
                                 result.count(), progress);
    for (const FormedPatch& patch : result.formed.patches) {
      result.directions[patch.direction].area += patch.area;
      ++result.directions[patch.direction].components;
    }
    measure_air(model, progress, result);
  }
  result.elapsed_s = 1e-3 * stopwatch.elapsed_ms();
  return result;
}

}  // namespace moldlight
