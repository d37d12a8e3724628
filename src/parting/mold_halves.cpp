#include "parting/mold_halves.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/defect_edges.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/union_find.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/exact/facet_encounters.hpp"
#include "parting/hull/parting_surface.hpp"
#include "parting/mold_files.hpp"

namespace moldlight {

namespace {

/// What is tried, one after the other: the tolerance as a share of the part's diagonal, and the width, as a
/// share of it, below which facets as seen along the direction count as upright.
struct Attempt {
  double tolerance, upright;
};
constexpr Attempt k_attempts[] = {{1e-7, 1.0}, {1e-6, 1.0}, {1e-7, 0.1}, {1e-6, 0.1},
                                  {2e-6, 1.0}, {1e-8, 1.0}, {1e-8, 0.1}, {1e-7, 0.3},
                                  {1e-9, 0.1}, {1e-7, 0.0}, {4e-6, 0.1}, {1e-5, 0.1}};
/// So many are tried where the halves are certain but not beautiful: facets cross by rounding, or four meet
/// in an edge.
constexpr std::size_t k_most_for_beauty = 5;
constexpr double k_most_fold = 1e-8, k_most_gap = 1e-9;
/// More than this, in cubes of the diagonal, is not rounding that the ends' places may make good.
constexpr double k_most_restored = 1e-8;
/// What is thinner on average than this share of the diagonal, half the usual lateral tolerance, is no
/// insert: the plastic fills it.
constexpr double k_speck_thickness = 0.5 / 2048.0;

constexpr unsigned k_upper = Sheets::bit(Sheet::upper), k_lower = Sheets::bit(Sheet::lower),
                   k_hidden = Sheets::bit(Sheet::hidden), k_parting = Sheets::bit(Sheet::parting);

/// Facets with a smaller height, as a share of the diagonal, are told of as needles.
constexpr double k_needle = 1e-7;

using Facets = std::vector<std::array<SheetVertex, 3>>;

/// Least height of the triangle as seen along z.
double seen_width(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec2 p(b - a), q(c - a), r(c - b);
  const double longest = std::sqrt(std::max({glm::dot(p, p), glm::dot(q, q), glm::dot(r, r)}));
  return longest > 0.0 ? std::abs(p.x * q.y - p.y * q.x) / longest : 0.0;
}

Sheets part_sheets(const SplitMesh& split, const MoldHalves& halves, double diagonal,
                   const Attempt& attempt) {
  Sheets sheets;
  for (const glm::dvec3& vertex : split.vertices)
    sheets.vertices.push_back(halves.frame.to_mold((vertex - halves.centre) / diagonal));
  sheets.column_of.assign(sheets.vertices.size(), k_no_column);
  const double least = std::max(attempt.upright * attempt.tolerance, 1e-14);
  for (const SplitPiece& piece : split.pieces) {
    const glm::dvec3 &a = sheets.vertices[piece.corners[0]], &b = sheets.vertices[piece.corners[1]],
                     &c = sheets.vertices[piece.corners[2]];
    if (seen_width(a, b, c) < least) continue;
    const bool up = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0;
    const Sheet sheet = piece.region == Region::core && up      ? Sheet::upper
                        : piece.region == Region::cavity && !up ? Sheet::lower
                                                                : Sheet::hidden;
    sheets.facets.push_back({piece.corners, sheet});
  }
  return sheets;
}

/// Where the ends of the upper and the lower sheet do not sum up to nothing over a segment.
std::optional<MoldFault> residual(const Sheets& sheets, double diagonal) {
  double length = 0.0, longest = 0.0;
  glm::dvec3 place(0.0);
  for (const SegmentEdges& segment : sheets.by_segment(sheets.ends(k_upper | k_lower))) {
    int sum = 0;
    for (const SegmentEdge& edge : segment.edges) sum += edge.sign;
    if (sum == 0) continue;
    const double run = glm::distance(sheets.columns[segment.a], sheets.columns[segment.b]);
    length += run;
    if (run <= longest) continue;
    longest = run;
    place = 0.5 * (sheets.vertices[segment.edges[0].a] + sheets.vertices[segment.edges[0].b]);
  }
  if (length <= 0.0) return std::nullopt;
  return MoldFault{
      fmt::format("what is seen from above and what from below do not have the same outline, for {:.3g} "
                  "of its length: bodies overlap or touch there, or the surface is folded",
                  length * diagonal),
      k_mend_surface, place};
}

struct GraphTest {
  double covered = 0.0, folded = 0.0, most = 0.0;
  glm::dvec3 place{0.0};  // of the facet that is folded most
};
/// Facets as seen along z, those that face along `sign` and the others.
GraphTest graph_test(const std::vector<glm::dvec3>& vertices, const Facets& facets, double sign) {
  GraphTest test;
  for (const auto& [i, j, k] : facets) {
    const glm::dvec3 &a = vertices[i], &b = vertices[j], &c = vertices[k];
    const double seen = 0.5 * sign * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    (seen < 0.0 ? test.folded : test.covered) += std::abs(seen);
    if (-seen <= test.most) continue;
    test.most = -seen;
    test.place = (a + b + c) / 3.0;
  }
  return test;
}

MoldBody scaled_body(const std::vector<glm::dvec3>& vertices, const Facets& facets, double scale) {
  const BodyCheck check = check_body(vertices, facets);
  MoldBody body{.mesh = body_mesh(vertices, facets),
                .volume = check.volume * scale * scale * scale,
                .open_edges = check.open_edges};
  for (glm::dvec3& vertex : body.mesh.vertices) vertex *= scale;
  return body;
}

/// The bodies that hang together.
std::vector<Facets> components(std::size_t vertices, const Facets& facets) {
  UnionFind joined(vertices);
  for (const auto& facet : facets) {
    joined.join(facet[0], facet[1]);
    joined.join(facet[1], facet[2]);
  }
  std::map<std::uint32_t, Facets> found;
  for (const auto& facet : facets) found[joined.find(facet[0])].push_back(facet);
  std::vector<Facets> list;
  for (auto& [root, body] : found) list.push_back(std::move(body));
  return list;
}

double centred_volume(const TriangleMesh& mesh, const glm::dvec3& centre) {
  long double volume = 0.0L;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    volume += static_cast<long double>(
        glm::dot(mesh.corner(facet, 0) - centre,
                 glm::cross(mesh.corner(facet, 1) - centre, mesh.corner(facet, 2) - centre)));
  }
  return static_cast<double>(volume / 6.0L);
}

void measure_surface(const Sheets& sheets, double diagonal, double slope_deg, MoldHalves& halves) {
  constexpr double k_rounding_deg = 0.01;
  // A shut-off hangs together without the block's rim.
  UnionFind joined(sheets.vertices.size());
  glm::dvec2 low(INFINITY);
  for (const SheetFacet& facet : sheets.facets) {
    if (facet.sheet != Sheet::parting) continue;
    joined.join(facet.corners[0], facet.corners[1]);
    joined.join(facet.corners[1], facet.corners[2]);
  }
  std::uint32_t rim = 0;
  for (const SheetFacet& facet : sheets.facets) {
    if (facet.sheet != Sheet::parting) continue;
    for (const SheetVertex v : facet.corners) {
      const glm::dvec2 at(sheets.vertices[v]);
      if (at.x + at.y < low.x + low.y) {
        low = at;
        rim = v;
      }
    }
  }
  double steepest = 0.0;
  for (const SheetFacet& facet : sheets.facets) {
    if (facet.sheet != Sheet::parting) continue;
    const glm::dvec3 normal =
        glm::cross(sheets.vertices[facet.corners[1]] - sheets.vertices[facet.corners[0]],
                   sheets.vertices[facet.corners[2]] - sheets.vertices[facet.corners[0]]);
    const double area = 0.5 * glm::length(normal) * diagonal * diagonal;
    (joined.find(facet.corners[0]) == joined.find(rim) ? halves.parting_area : halves.shut_off_area) += area;
    if (glm::length(normal) <= 0.0) continue;
    const double slope = std::acos(std::clamp(normal.z / glm::length(normal), -1.0, 1.0));
    steepest = std::max(steepest, slope);
    if (glm::degrees(slope) > slope_deg + k_rounding_deg) halves.too_steep_area += area;
  }
  halves.steepest_deg = glm::degrees(steepest);
}

/// Where ends were moved farthest to stand in columns.
std::optional<glm::dvec3> most_moved(const Sheets& sheets) {
  std::optional<glm::dvec3> place;
  double most = -1.0;
  for (SheetVertex v = 0; v < sheets.vertices.size(); ++v) {
    const Column column = sheets.column_of[v];
    if (column == k_no_column || sheets.moved[column] <= most) continue;
    most = sheets.moved[column];
    place = sheets.vertices[v];
  }
  return place;
}

/// Counts facets whose least height is below `thinnest`; a corner of the longest of them.
std::optional<glm::dvec3> count_needles(const TriangleMesh& mesh, double thinnest, std::size_t& needles) {
  std::optional<glm::dvec3> place;
  double most = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, glm::distance(mesh.corner(facet, k), mesh.corner(facet, (k + 1) % 3)));
    const double twice_area = glm::length(glm::cross(mesh.corner(facet, 1) - mesh.corner(facet, 0),
                                                     mesh.corner(facet, 2) - mesh.corner(facet, 0)));
    if (twice_area >= thinnest * longest) continue;
    ++needles;
    if (longest <= most) continue;
    most = longest;
    place = mesh.corner(facet, 0);
  }
  return place;
}

/// Facets that cross others.
std::vector<FacetIndex> crossed_facets(const TriangleMesh& mesh, const Progress& progress) {
  const UnitFrame frame = unit_frame(bounds(mesh));
  std::vector<glm::dvec3> positions;
  for (const glm::dvec3& vertex : mesh.vertices)
    positions.push_back((vertex - frame.center) / frame.diagonal);
  const FacetEncounters met = facet_encounters(mesh, positions, facet_geometry(mesh).normals, progress);
  std::vector<FacetIndex> crossed;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    if (!met.crossings.of(facet).empty()) crossed.push_back(facet);
  }
  return crossed;
}

/// Fills `halves`; says why not, and where in the mold's frame.
std::optional<MoldFault> try_halves(const SplitMesh& split, const PartModel& model, double height,
                                    const MoldSettings& settings, const Attempt& attempt, MoldHalves& halves,
                                    const Progress& progress) {
  const double diagonal = model.frame.diagonal;
  Sheets sheets = part_sheets(split, halves, diagonal, attempt);
  if (const auto place = sheets.stand_in_columns(attempt.tolerance))
    return MoldFault{"facets are so small or so close to each other that their ends cannot be told apart",
                     k_avoid_rounding, place};
  if (auto fault = residual(sheets, diagonal)) return fault;
  sheets.keep_volume(centred_volume(model.part.mesh, model.frame.center) / (diagonal * diagonal * diagonal),
                     k_most_restored);

  const double margin = block_margin(settings, diagonal) / diagonal;
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (const SheetFacet& facet : sheets.facets) {
    for (const SheetVertex v : facet.corners) {
      low = glm::min(low, sheets.vertices[v]);
      high = glm::max(high, sheets.vertices[v]);
    }
  }
  const double middle = glm::dot(halves.centre, halves.frame.z);
  const SurfaceWish wish{.low = on_grid(glm::dvec2(low) - margin),
                         .high = on_grid(glm::dvec2(high) + margin),
                         .height = (height - middle) / diagonal,
                         .slope = std::tan(glm::radians(settings.slope_deg)),
                         .tolerance = attempt.tolerance,
                         .cone_margin = settings.registration ? margin : 0.0};
  if (auto fault = add_parting_surface(sheets, wish)) return fault;
  for (const SheetFacet& facet : sheets.facets) {
    for (const SheetVertex v : facet.corners) {
      low.z = std::min(low.z, sheets.vertices[v].z);
      high.z = std::max(high.z, sheets.vertices[v].z);
    }
  }
  const BlockHeights block{.low = low.z - margin, .high = high.z + margin};
  halves.contacts = contact_walls(sheets, 1e-6);
  halves.parting_area = halves.shut_off_area = halves.too_steep_area = halves.contact_area = 0.0;
  measure_surface(sheets, diagonal, settings.slope_deg, halves);

  Facets core, cavity, fill;
  for (const auto& [body, bounded] :
       {std::pair{BodySheets{.sheets = k_upper | k_parting, .turned = k_upper | k_parting}, &core},
        {BodySheets{.sheets = k_lower | k_parting, .turned = k_lower}, &cavity},
        {BodySheets{.sheets = k_hidden, .turned = k_hidden}, &fill}}) {
    if (const auto place = close_upright(sheets, body, *bounded))
      return MoldFault{
          bounded == &fill ? "the walls of an insert do not close" : "the walls of a half do not close",
          k_avoid_rounding, place};
  }
  const GraphTest above = graph_test(sheets.vertices, core, -1.0),
                  below = graph_test(sheets.vertices, cavity, 1.0);
  const double rectangle = (wish.high.x - wish.low.x) * (wish.high.y - wish.low.y);
  halves.fold_area = std::max(above.folded, below.folded) / rectangle;
  halves.cover_gap = std::max(std::abs(above.covered - above.folded - rectangle),
                              std::abs(below.covered - below.folded - rectangle)) /
                     rectangle;
  if (halves.fold_area > k_most_fold || halves.cover_gap > k_most_fold)
    return MoldFault{fmt::format("a half would fold over itself, on {:.2g} of its area",
                                 std::max(halves.fold_area, halves.cover_gap)),
                     k_avoid_rounding, above.most > below.most ? above.place : below.place};
  add_block(sheets, block, true, core);
  add_block(sheets, block, false, cavity);

  const double scale = diagonal * halves.scale, cube = scale * scale * scale;
  halves.core = scaled_body(sheets.vertices, core, scale);
  halves.cavity = scaled_body(sheets.vertices, cavity, scale);
  for (const Facets* half : {&core, &cavity}) {
    if (const BodyCheck check = check_body(sheets.vertices, *half); check.open_at)
      return MoldFault{"a half is not closed", k_avoid_rounding, check.open_at};
  }
  halves.block_volume = rectangle * (block.high - block.low) * cube;
  const double grown = halves.scale * halves.scale * halves.scale;
  halves.part_volume = centred_volume(model.part.mesh, model.frame.center) * grown;
  halves.inserts.clear();
  halves.insert_volume = halves.specks_volume = 0.0;
  for (const Facets& facets : components(sheets.vertices.size(), fill)) {
    MoldBody body = scaled_body(sheets.vertices, facets, scale);
    halves.insert_volume += body.volume;
    const double area = facet_geometry(body.mesh).total_area;
    if (2.0 * std::abs(body.volume) > k_speck_thickness * scale * area) {
      // Material that is there twice would be an insert inside out.
      if (body.volume < 0.0)
        return MoldFault{"bodies of the part overlap", k_mend_surface, bounds(body.mesh).center() / scale};
      halves.inserts.push_back(std::move(body));
    } else {
      halves.specks_volume += body.volume;
    }
  }
  std::ranges::stable_sort(halves.inserts, std::greater(), &MoldBody::volume);
  halves.volume_gap = (halves.block_volume - halves.core.volume - halves.cavity.volume - halves.part_volume -
                       halves.insert_volume) /
                      halves.block_volume;
  if (std::abs(halves.volume_gap) > k_most_gap)
    return MoldFault{
        fmt::format("the volumes of block, halves, part and inserts are {:.2g} of the block apart",
                    std::abs(halves.volume_gap)),
        k_avoid_rounding, most_moved(sheets)};
  for (ContactWall& contact : halves.contacts) {
    contact.place = halves.centre + diagonal * halves.frame.to_part(contact.place);
    contact.height *= diagonal;
    contact.area *= diagonal * diagonal;
    halves.contact_area += contact.area;
  }
  halves.tolerance = attempt.tolerance;
  const WrittenMold written = written_mold(halves);
  if (!written.refusal.empty()) {
    MoldFault fault{written.refusal, k_avoid_rounding};
    if (written.refused_at)
      fault.place = halves.frame.to_mold(*written.refused_at - halves.centre) / diagonal;
    return fault;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    MoldBody& half = k == 0 ? halves.core : halves.cavity;
    const TriangleMesh& mesh = written.bodies[k].mesh;
    const std::vector<FacetIndex> crossed = crossed_facets(mesh, progress);
    half.crossed_facets = crossed.size();
    if (!crossed.empty()) half.crossed_at = place_in_part(halves, written, mesh.corner(crossed.front(), 0));
    if (const auto place = count_needles(mesh, k_needle * scale, half.needles))
      half.needle_at = place_in_part(halves, written, *place);
    half.crowded_edges = written.bodies[k].crowded_edges;
    half.leaning = written.bodies[k].leaning;
  }
  return std::nullopt;
}

}  // namespace

glm::dvec3 insert_place(const MoldHalves& halves, std::size_t insert) {
  return halves.centre + halves.frame.to_part(bounds(halves.inserts[insert].mesh).center() / halves.scale);
}

MoldHalves make_halves(const PartModel& model, const glm::dvec3& direction, double height,
                       const MoldSettings& settings, const Progress& progress) {
  MoldHalves halves;
  halves.frame = mold_frame(direction);
  halves.centre = model.frame.center;
  halves.scale = 1.0 / (1.0 - 0.01 * settings.shrink_pct);
  if (!model.health.closed) {
    halves.refusal = "the part is not closed, so that it has no inside";
    halves.change = "close it: --repair full mends small holes, moldlight info lists all of them";
    for (const EdgeDefect kind : {EdgeDefect::open, EdgeDefect::inconsistent, EdgeDefect::nonmanifold}) {
      const auto chains = defect_chains(model.part.mesh, kind);
      if (halves.refused_at || chains.empty()) continue;
      halves.refused_at = chains.front().bounds.center();
    }
    return halves;
  }
  const ExactSplit split =
      exact_split(model.exact(progress), {.direction = direction, .tau_deg = 0.0, .lateral = 0.0}, progress);
  std::optional<MoldFault> first;
  std::optional<MoldHalves> best;
  std::size_t tried = 0;
  for (const Attempt& attempt : k_attempts) {
    if (best && tried >= k_most_for_beauty) break;
    ++tried;
    progress.report("making the halves", 0.0);
    MoldHalves attempted = halves;
    const auto fault = try_halves(split.mesh, model, height, settings, attempt, attempted, progress);
    if (fault) {
      if (!first) first = fault;
      continue;
    }
    if (!best || attempted.cleaner_than(*best)) best = std::move(attempted);
    if (best->blemishes() == 0 && !best->leans()) break;
  }
  if (best) return *best;
  halves.refusal = first->what;
  halves.change = first->change;
  if (first->place)
    halves.refused_at = halves.centre + model.frame.diagonal * halves.frame.to_part(*first->place);
  return halves;
}

}  // namespace moldlight
