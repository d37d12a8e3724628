#include "parting/make_halves.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "classify/number_format.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mold/exact/exact_regions.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/halves/parting_surface.hpp"
#include "parting/halves/tidy_solid.hpp"
#include "parting/mold_files.hpp"
#include "parting/mold_settings.hpp"
#include "parting/part_sheets.hpp"
#include "parting/upright_walls.hpp"
#include "parting/wall_caps.hpp"

namespace moldlight {

namespace {

/// So many are tried where the halves are certain but not beautiful: facets cross by rounding, or four meet
/// in an edge.
constexpr std::size_t k_most_tries_for_cleaner = 5;
/// So many with other bodies beside the part, which can be left out.
constexpr std::size_t k_most_beside = 8;
constexpr double k_most_fold = 1e-8, k_most_gap = 1e-9;
/// More than this, in cubes of the diagonal, is not rounding that the ends' places may make good.
constexpr double k_most_restored = 1e-8;

constexpr unsigned k_upper = Sheets::bit(Sheet::upper), k_lower = Sheets::bit(Sheet::lower),
                   k_hidden = Sheets::bit(Sheet::hidden), k_parting = Sheets::bit(Sheet::parting),
                   k_beside = Sheets::bit(Sheet::beside);
/// What bounds the inserts.
constexpr BodySheets k_fill{.sheets = k_hidden | k_beside, .turned = k_hidden};

/// Upright walls lower than this share of the diagonal are no contact, and less than this share of what was
/// given by hand is not missed.
constexpr double k_least_contact = 1.1e-4, k_least_missed = 1e-5;
/// Walls are set upright that are off by at most so much.
constexpr double k_usual_lateral = 1.0 / 2048.0;  // of the diagonal
constexpr double k_upright_reach = 2.0;           // lateral tolerances
constexpr double k_level_enough = 0.9;            // of the surface, in one plane
constexpr double k_more_contact = 1.5;  // with slides than without, where another try is worth its time
using Facets = std::vector<std::array<SheetVertex, 3>>;

MoldBody scaled_body(const std::vector<glm::dvec3>& vertices, const Facets& facets, double scale) {
  const BodyCheck check = check_body(vertices, facets);
  MoldBody body{.mesh = body_mesh(vertices, facets),
                .volume = check.volume * scale * scale * scale,
                .open_edges = check.open_edges};
  for (glm::dvec3& vertex : body.mesh.vertices) vertex *= scale;
  return body;
}

/// What the halves are made from.
struct HalvesWish {
  const SplitMesh& split;    // numbers facets as the part does, then those of what is beside it
  const TriangleMesh& mesh;  // the part, with upright walls
  const Beside& beside;
  const PartModel& model;
  const MeetingPlace& place;
  const std::vector<FacetWish>& assigned;
  const MoldSettings& settings;
  SheetCaps caps;
};

/// The line in the mold's frame.
std::vector<LinePiece> line_pieces(const PartingLine* line, const SheetFrame& frame) {
  std::vector<LinePiece> pieces;
  if (line == nullptr) return pieces;
  for (const PartingLoop& loop : line->loops) {
    if (loop.kind == LoopKind::action) continue;
    for (std::size_t k = 0; k < loop.points.size(); ++k)
      pieces.push_back(
          {frame.in_mold(loop.points[k]), frame.in_mold(loop.points[(k + 1) % loop.points.size()])});
  }
  return pieces;
}

ShelfShape shelf_shape(const MoldSettings& settings, double diagonal) {
  return {.ramp = std::tan(glm::radians(std::min(settings.ramp_deg, settings.slope_deg))),
          .slope = std::tan(glm::radians(settings.slope_deg)),
          .land = land_width(settings, diagonal) / diagonal};
}

/// The halves with one tolerance. Each step fills the halves, or says why not, and where in the mold's frame.
class Trial {
 public:
  Trial(const HalvesWish& asked, const SheetTolerance& attempt, MoldHalves& halves)
      : asked_(asked),
        attempt_(attempt),
        halves_(halves),
        frame_{halves.frame, halves.centre, asked.model.frame.diagonal} {}

  std::optional<MoldFault> run(const Progress& progress) {
    if (auto fault = make_surface(progress)) return fault;
    progress.report(k_halves_stage, 0.5);
    if (auto fault = make_bodies()) return fault;
    progress.report(k_halves_stage, 0.7);
    if (auto fault = make_inserts()) return fault;
    progress.report(k_halves_stage, 0.8);
    return certify(progress);
  }

 private:
  /// The sheets with the parting surface between them.
  std::optional<MoldFault> make_surface(const Progress& progress) {
    const double diagonal = frame_.diagonal;
    PartSheets part = part_sheets(asked_.split, static_cast<FacetIndex>(asked_.model.part.mesh.facets.size()),
                                  frame_, attempt_, asked_.caps);
    sheets_ = std::move(part.sheets);
    capped_ = part.added;
    progress.report(k_halves_stage, 0.1);
    hand_ = hand_walls(asked_.split, sheets_, asked_.assigned, attempt_);
    if (const auto at = sheets_.align_ends(attempt_.tolerance))
      return MoldFault{"facets are so small or so close that their corners coincide by rounding",
                       k_avoid_rounding, at};
    if (auto fault = residual(sheets_, diagonal)) return fault;
    sheets_.keep_volume(signed_volume(asked_.mesh) / (diagonal * diagonal * diagonal) + capped_,
                        k_most_restored);
    if (auto fault = overlap()) return fault;
    const double margin = block_margin(asked_.settings, diagonal) / diagonal;
    const Bounds box = box_of(sheets_);
    const std::vector<LinePiece> line = line_pieces(asked_.place.line, frame_);
    const double middle = glm::dot(halves_.centre, halves_.frame.z);
    const bool fixed = !asked_.beside.blanks.empty();
    const SurfaceWish wish{.low = fixed ? asked_.beside.low : on_grid(glm::dvec2(box.min) - margin),
                           .high = fixed ? asked_.beside.high : on_grid(glm::dvec2(box.max) + margin),
                           .grows = !fixed,
                           .height = (asked_.place.height - middle) / diagonal,
                           .shape = shelf_shape(asked_.settings, diagonal),
                           .tolerance = attempt_.tolerance,
                           .cone_margin = asked_.settings.registration ? margin : 0.0,
                           .walls = hand_.walls,
                           .line = line};
    PartingSurface surface;
    if (auto fault = add_parting_surface(sheets_, wish, surface, progress)) return fault;
    const Bounds all = box_of(sheets_);
    block_ = {.low = all.min.z - margin, .high = all.max.z + margin};
    rectangle_ = (surface.high.x - surface.low.x) * (surface.high.y - surface.low.y);
    halves_.block_low = surface.low;
    halves_.block_high = surface.high;
    halves_.margin = fixed ? asked_.beside.margin
                           : diagonal * std::max({box.min.x - surface.low.x, box.min.y - surface.low.y,
                                                  surface.high.x - box.max.x, surface.high.y - box.max.y});
    halves_.land = wish.shape.land * diagonal;
    report_surface(surface.forced);
    return std::nullopt;
  }

  /// Bodies of the part that overlap, which no surface between the halves changes.
  std::optional<MoldFault> overlap() {
    Facets fill;
    if (close_upright(sheets_, k_fill, fill)) return std::nullopt;
    for (const Facets& facets : connected_bodies(sheets_.vertices.size(), fill)) {
      if (auto fault = twice_there(insert_of(facets))) return fault;
    }
    return std::nullopt;
  }

  [[nodiscard]] MoldBody insert_of(const Facets& facets) const {
    return scaled_body(sheets_.vertices, facets, frame_.diagonal * halves_.scale);
  }
  [[nodiscard]] bool is_thin(const MoldBody& body) const {
    return is_speck(body, frame_.diagonal * halves_.scale);
  }
  /// Material that is there twice would be an insert inside out.
  [[nodiscard]] std::optional<MoldFault> twice_there(const MoldBody& body) const {
    if (body.volume >= 0.0 || is_thin(body)) return std::nullopt;
    return MoldFault{"bodies of the part overlap", k_mend_surface,
                     bounds(body.mesh).center() / (frame_.diagonal * halves_.scale)};
  }

  void report_surface(const ForcedSlope& forced) {
    const double square = frame_.diagonal * frame_.diagonal;
    halves_.surface = surface_figures(
        sheets_,
        {.slope_deg = asked_.settings.slope_deg, .narrow = k_narrow, .tolerance = attempt_.tolerance});
    SurfaceFigures& surface = halves_.surface;
    for (double* area : {&surface.parting_area, &surface.shut_off_area, &surface.too_steep_area,
                         &surface.shelf_area, &surface.ramp_area})
      *area *= square;
    const double middle = glm::dot(halves_.centre, halves_.frame.z);
    for (double* height :
         {&surface.shelf_height, &surface.low, &surface.high, &surface.rim_low, &surface.rim_high})
      *height = middle + frame_.diagonal * *height;
    if (forced.tangent > 0.0) {
      halves_.forced_deg = glm::degrees(std::atan(forced.tangent));
      halves_.forced_at = frame_.in_part(0.5 * (forced.high + forced.low));
    }
    halves_.contacts = contact_walls(sheets_, k_least_contact);
    for (ContactWall& contact : halves_.contacts) {
      contact.place = frame_.in_part(contact.place);
      contact.height *= frame_.diagonal;
      contact.area *= square;
      halves_.contact_area += contact.area;
    }
    const double lean = report_missed();
    halves_.missed_leaning = noted(lean, hand_.leaning_at);
  }

  /// What of the faces given by hand the halves form otherwise; returns the area of those that lean.
  double report_missed() {
    const MissedWalls missed = missed_walls(sheets_, hand_.walls, k_wall_reach * attempt_.tolerance);
    halves_.missed_upright = noted(missed.area, missed.at);
    double leaning = hand_.leaning_area;
    for (std::size_t k = 0; k < hand_.walls.size(); ++k) {
      if (hand_.released[k]) continue;
      const auto& [a, b, c] = hand_.walls[k].corners;
      leaning += std::max(0.5 * glm::length(glm::cross(b - a, c - a)) - missed.met_area[k], 0.0);
      if (!hand_.leaning_at) hand_.leaning_at = (a + b + c) / 3.0;
    }
    return leaning;
  }
  [[nodiscard]] MissedFaces noted(double area, const std::optional<glm::dvec3>& at) const {
    if (area <= k_least_missed * hand_.assigned_area || !at) return {};
    return {area * frame_.diagonal * frame_.diagonal, frame_.in_part(*at)};
  }

  [[nodiscard]] BodySheets half_sheets(bool core) const {
    return core ? BodySheets{k_upper | k_parting, k_upper | k_parting, halves_.block_low, halves_.block_high}
                : BodySheets{k_lower | k_parting, k_lower, halves_.block_low, halves_.block_high};
  }

  /// Core and cavity with the block around them, and what bounds the inserts.
  std::optional<MoldFault> make_bodies() {
    Facets core, cavity;
    for (const auto& [body, bounded] :
         {std::pair{half_sheets(true), &core}, {half_sheets(false), &cavity}, {k_fill, &fill_}}) {
      if (const auto at = close_upright(sheets_, body, *bounded))
        return MoldFault{
            bounded == &fill_ ? "the walls of an insert do not close" : "the walls of a half do not close",
            k_avoid_rounding, at};
    }
    const GraphTest above = graph_test(sheets_.vertices, core, -1.0),
                    below = graph_test(sheets_.vertices, cavity, 1.0);
    halves_.fold_area = std::max(above.folded, below.folded) / rectangle_;
    halves_.cover_gap = std::max(std::abs(above.covered - above.folded - rectangle_),
                                 std::abs(below.covered - below.folded - rectangle_)) /
                        rectangle_;
    if (halves_.fold_area > k_most_fold || halves_.cover_gap > k_most_fold)
      return MoldFault{fmt::format("a half would fold over itself, on {} of its area",
                                   error_text(std::max(halves_.fold_area, halves_.cover_gap))),
                       k_avoid_rounding, above.most > below.most ? above.place : below.place};
    add_block(sheets_, block_, true, core);
    add_block(sheets_, block_, false, cavity);
    const double scale = frame_.diagonal * halves_.scale;
    halves_.core = scaled_body(sheets_.vertices, core, scale);
    halves_.cavity = scaled_body(sheets_.vertices, cavity, scale);
    halves_.core.name = "core";
    halves_.cavity.name = "cavity";
    for (const Facets* half : {&core, &cavity}) {
      if (const BodyCheck check = check_body(sheets_.vertices, *half); check.open_at)
        return MoldFault{"a half is not closed", k_avoid_rounding, check.open_at};
    }
    halves_.block_volume = rectangle_ * (block_.high - block_.low) * scale * scale * scale;
    return std::nullopt;
  }

  /// The slides' blanks that are in a body.
  [[nodiscard]] std::vector<std::size_t> blanks_in(const Facets& facets) const {
    constexpr double k_same = 1e-5;
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < asked_.beside.blanks.size(); ++k) {
      if (has_corner(sheets_.vertices, facets, asked_.beside.blanks[k].end, k_same)) found.push_back(k);
    }
    return found;
  }

  std::optional<MoldFault> make_inserts() {
    for (const Facets& facets : connected_bodies(sheets_.vertices.size(), fill_)) {
      MoldBody body = insert_of(facets);
      body.blanks = blanks_in(facets);
      halves_.insert_volume += body.volume;
      if (is_thin(body)) {
        halves_.specks_volume += body.volume;
        continue;
      }
      if (auto fault = twice_there(body)) return fault;
      halves_.inserts.push_back(std::move(body));
    }
    std::ranges::stable_sort(halves_.inserts, [](const MoldBody& p, const MoldBody& q) {
      if (p.blanks.empty() != q.blanks.empty()) return q.blanks.empty();
      return p.blanks.empty() ? p.volume > q.volume : p.blanks < q.blanks;
    });
    std::size_t loose = 0;
    for (MoldBody& body : halves_.inserts) {
      body.kind = body.blanks.empty() ? PieceKind::insert : PieceKind::slide;
      body.name = fmt::format("{}_{}", piece_name(body.kind),
                              1 + (body.blanks.empty() ? loose++ : body.blanks.front()));
    }
    join_lifted();
    return std::nullopt;
  }

  /// The halves with the inserts that lifters form.
  void join_lifted() {
    constexpr double k_same = 1e-4;
    if (asked_.beside.lifted.empty()) return;
    const std::vector<Facets> bodies = connected_bodies(sheets_.vertices.size(), fill_);
    for (const bool core : {true, false}) {
      std::vector<Facets> lifted;
      std::ranges::copy_if(bodies, std::back_inserter(lifted), [&](const Facets& body) {
        return std::ranges::any_of(asked_.beside.lifted, [&](const LiftedInsert& insert) {
          return insert.core_side == core && has_corner(sheets_.vertices, body, insert.corner, k_same);
        });
      });
      if (lifted.empty()) continue;
      auto half = half_with_bodies(sheets_, lifted, core, half_sheets(core), block_);
      if (!half) continue;
      for (glm::dvec3& vertex : half->vertices) vertex *= frame_.diagonal * halves_.scale;
      halves_.with_lifted[core ? 0 : 1] = std::move(*half);
    }
  }

  void keep_surface() {
    Facets between;
    for (const SheetFacet& facet : sheets_.facets) {
      if (facet.sheet == Sheet::parting) between.push_back(facet.corners);
    }
    halves_.surface_mesh = body_mesh(sheets_.vertices, between);
    for (glm::dvec3& vertex : halves_.surface_mesh.vertices) vertex *= frame_.diagonal * halves_.scale;
  }

  /// The volumes, the bodies as they will be written, and what rounding does to the halves.
  std::optional<MoldFault> certify(const Progress& progress) {
    const double scale = halves_.scale * halves_.scale * halves_.scale;
    const double diagonal = frame_.diagonal;
    halves_.part_volume = scale * (signed_volume(asked_.mesh) + capped_ * diagonal * diagonal * diagonal);
    halves_.upright_volume = halves_.part_volume - scale * signed_volume(asked_.model.part.mesh);
    halves_.volume_gap = halves_.share_left();
    if (std::abs(halves_.volume_gap) > k_most_gap)
      return MoldFault{
          fmt::format("the volumes of halves, part and inserts differ from the block by {} of it",
                      error_text(std::abs(halves_.volume_gap))),
          k_avoid_rounding, most_moved(sheets_)};
    halves_.tolerance = attempt_.tolerance;
    keep_surface();
    WrittenMold& written = halves_.written = written_mold(halves_);
    if (!written.refusal.empty()) {
      MoldFault fault{written.refusal, k_avoid_rounding};
      if (written.refused_at) fault.place = frame_.in_mold(*written.refused_at);
      return fault;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      MoldBody& half = k == 0 ? halves_.core : halves_.cavity;
      const TriangleMesh& mesh = written.bodies[k].mesh;
      const double thinnest = k_needle * frame_.diagonal * halves_.scale;
      halves_.mended_facets += mend_crossed(halves_, k, thinnest, progress);
      const Needles needles = find_needles(mesh, thinnest);
      half.needles = needles.count;
      if (needles.place) half.needle_at = place_in_part(halves_, written, *needles.place);
      half.nonmanifold_edges = written.bodies[k].nonmanifold_edges;
      half.leaning = written.bodies[k].leaning;
    }
    return std::nullopt;
  }

  const HalvesWish& asked_;
  const SheetTolerance& attempt_;
  MoldHalves& halves_;
  SheetFrame frame_;
  Sheets sheets_;
  HandWalls hand_;
  BlockHeights block_;
  double rectangle_ = 0.0;
  double capped_ = 0.0;  // what caps add to the part, in cubes of the diagonal
  Facets fill_;
};

}  // namespace

MoldHalves make_halves(const PartModel& model, const glm::dvec3& direction, const MeetingPlace& place,
                       const MoldSettings& settings, const Progress& progress, const Beside& beside) {
  validate(settings, model.frame.diagonal);
  MoldHalves halves;
  halves.frame = mold_frame(model, direction);
  halves.centre = model.frame.center;
  halves.scale = 1.0 / (1.0 - 0.01 * settings.shrink_pct);
  Bounds box;
  for (const glm::dvec3& vertex : model.part.mesh.vertices) box.add(halves.frame.to_mold(vertex));
  halves.part_height = halves.scale * (box.max.z - box.min.z);
  if (!model.health.closed) {
    halves.refusal = "the part is not closed";
    halves.change = "repair the mesh (--repair full) first";
    for (const EdgeDefect kind : {EdgeDefect::open, EdgeDefect::inconsistent, EdgeDefect::nonmanifold}) {
      const auto chains = defect_chains(model.part.mesh, kind);
      if (halves.refused_at || chains.empty()) continue;
      halves.refused_at = chains.front().bounds.center();
    }
    halves.written = written_mold(halves);
    return halves;
  }
  const std::vector<FacetWish> assigned = assigned_facets(model, settings);
  std::optional<MoldFault> first;
  std::optional<MoldHalves> best;
  const SheetFrame frame{halves.frame, halves.centre, model.frame.diagonal};
  // Whether what was found is certified.
  std::optional<ThroughCaps> through;
  if (place.sides != nullptr && !place.sides->seen_through.empty()) through.emplace(*place.sides, frame);
  const auto try_all = [&](const ExactPart& exact, const UprightPart& part, const WallCaps* caps = nullptr) {
    SplitMesh split =
        exact_split(exact, {.direction = direction, .tau_deg = 0.0, .lateral = 0.0}, progress).mesh;
    for (SplitPiece& piece : split.pieces) {
      const std::size_t own = part.facet_of.size();
      piece.facet = piece.facet < own
                        ? part.facet_of[piece.facet]
                        : static_cast<FacetIndex>(piece.facet - own + model.part.mesh.facets.size());
    }
    if (caps != nullptr) split = caps->cut(split);
    const HalvesWish asked{split, part.mesh, beside,   model,
                           place, assigned,  settings, {caps, through ? &*through : nullptr}};
    std::size_t tried = 0;
    first.reset();
    std::optional<MoldHalves> found;
    for (const SheetTolerance& attempt : k_sheet_attempts) {
      if (tried >= k_most_beside && !beside.blanks.empty()) break;
      if (found && tried >= k_most_tries_for_cleaner) break;
      ++tried;
      progress.report(k_halves_stage, 0.0);
      MoldHalves attempted = halves;
      if (auto fault = Trial(asked, attempt, attempted).run(progress)) {
        if (!first) first = std::move(fault);
        continue;
      }
      const bool clean = attempted.clean() || (!beside.blanks.empty() && attempted.certified());
      if (!found || attempted.better_than(*found)) found = std::move(attempted);
      if (clean) break;
    }
    const bool divided = part.mesh.facets.size() != model.part.mesh.facets.size();
    if (found && divided && hides_itself(*found, progress)) return false;
    if (found) found->divided = divided;
    const bool certified = found && found->certified();
    if (found && (!best || found->nicer_than(*best))) best = std::move(found);
    return certified;
  };
  // The part's mesh, with the other bodies.
  const auto try_mesh = [&](const UprightPart& part, const WallCaps* caps = nullptr) {
    TriangleMesh all = part.mesh;
    for (const SlideBlank& blank : beside.blanks) {
      const auto number = static_cast<VertexIndex>(all.vertices.size());
      for (const glm::dvec3& vertex : blank.mesh.vertices)
        all.vertices.push_back(halves.centre + model.frame.diagonal * halves.frame.to_part(vertex));
      for (const auto& [a, b, c] : blank.mesh.facets)
        all.facets.push_back({number + a, number + b, number + c});
    }
    const FacetGeometry geometry = facet_geometry(all);
    const ExactPart exact(all, geometry, beside.blanks.empty() ? model.frame : unit_frame(bounds(all)),
                          progress, model.part.effort, {.in_front = false});
    return try_all(exact, part, caps);
  };
  const UprightPart own = part_as_it_is(model.part.mesh);
  const double lateral =
      place.sides != nullptr ? place.sides->lateral : k_usual_lateral * model.frame.diagonal;
  std::optional<WallCaps> caps;
  if (place.line != nullptr && place.sides != nullptr && place.line->is_planar(model.frame.diagonal))
    caps.emplace(*place.sides, *place.line, frame);
  // Round walls divided, which may make others lean, then not.
  for (const double reach : {k_upright_reach * lateral / model.frame.diagonal, 0.0}) {
    if (reach > 0.0 && !beside.divides) continue;
    const bool level = best && best->surface.shelf_share() > k_level_enough;
    if (best && best->certified() && (level || !beside.blanks.empty())) break;
    const auto upright = with_upright_walls(model.part.mesh, frame, reach, progress);
    const bool capped = caps && try_mesh(upright ? *upright : own, &*caps);
    if (upright && !capped) try_mesh(*upright);
  }
  if (!beside.blanks.empty()) {
    if (!best || best->contact_area > k_more_contact * beside.contact_area) try_mesh(own);
  } else if (!best || !best->clean() || best->contact_area > 0.0) {
    try_all(model.exact(progress), own);
  }
  if (best) {
    best->core.thinnest = thinnest_of(best->core.mesh);
    best->cavity.thinnest = thinnest_of(best->cavity.mesh);
    for (std::size_t k = 0; k < best->inserts.size(); ++k) {
      best->inserts[k].thinnest = thinnest_of(best->inserts[k].mesh);
      mend_crossed(*best, k + 2, k_needle * model.frame.diagonal * best->scale, progress);
    }
    return *best;
  }
  halves.refusal = first->what;
  halves.change = first->change;
  if (first->place)
    halves.refused_at = halves.centre + model.frame.diagonal * halves.frame.to_part(*first->place);
  halves.written = written_mold(halves);
  return halves;
}

}  // namespace moldlight
