#include "compare/revision_changes.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "render/surface_sheets.hpp"

namespace moldlight {

namespace {

using Of = RevisionChange::Of;

FacetIndex facet_of(const ComparedPart& part, const LitPolygon& lit) {
  return part.result.split->pieces[lit.piece].facet;
}

void add_pieces(Bounds& bounds, const ComparedPart& part, std::span<const PieceIndex> pieces) {
  const SplitMesh& split = *part.result.split;
  for (const PieceIndex piece : pieces)
    for (const auto corner : split.pieces[piece].corners) bounds.add(split.vertices[corner]);
}

/// How far a point of its plane is beyond the rim of a polygon; not above 0 inside.
double beyond(const ConvexPolygon& polygon, const glm::dvec3& normal, const glm::dvec3& point) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3& from = polygon[k];
    const glm::dvec3 outward = glm::cross(polygon[(k + 1) % polygon.size()] - from, normal);
    const double length = glm::length(outward);
    if (length > 0.0) farthest = std::max(farthest, glm::dot(point - from, outward) / length);
  }
  return farthest;
}

ChangeKind kind_of(const ChangedPlace& place) {
  return place.gone.area <= 0.0    ? ChangeKind::added
         : place.added.area <= 0.0 ? ChangeKind::gone
                                   : ChangeKind::changed;
}

}  // namespace

Revisions::Revisions(Comparison compared) : comparison(std::move(compared)) {
  const SurfaceChange& surface = comparison.surface;
  const auto add_matched = [&](bool same) {
    for (const Of of : {Of::undercut, Of::action}) {
      const auto& matched = of == Of::undercut ? comparison.undercuts : comparison.actions;
      for (std::size_t k = 0; k < matched.size(); ++k)
        if ((matched[k].kind == ChangeKind::same) == same) changes.push_back({of, matched[k].kind, k, {}});
    }
  };
  add_matched(false);
  for (std::size_t k = 0; k < surface.places.size(); ++k)
    changes.push_back({Of::place, kind_of(surface.places[k]), k, surface.places[k].bounds});
  for (std::size_t k = 0; k < surface.regions.size(); ++k)
    changes.push_back({Of::region, ChangeKind::changed, k, surface.regions[k].bounds});
  add_matched(true);
  for (const bool second : {false, true}) {
    const ComparedPart& side = part(second);
    lit[second ? 1 : 0] = lit_surface(comparison, !second);
    std::ranges::stable_sort(lit[second ? 1 : 0], {},
                             [&](const LitPolygon& one) { return facet_of(side, one); });
    for (std::size_t k = 0; k < changes.size(); ++k)
      add_pieces(changes[k].bounds, side, pieces_of(second, k));
  }
}

std::optional<std::size_t> Revisions::change_at(bool second, const PickedPoint& point) const {
  const ComparedPart& side = part(second);
  const UnitFrame& frame = side.model->frame;
  const glm::dvec3 at = frame.center + frame.diagonal * glm::dvec3(point.position);
  const std::vector<LitPolygon>& its = lit[second ? 1 : 0];
  const auto facet = [&](const LitPolygon& one) { return facet_of(side, one); };
  constexpr double k_rounding = 1e-5;  // of the diagonal: pixels are in single precision
  const LitPolygon* nearest = nullptr;
  double least = k_rounding * frame.diagonal;
  for (auto one = std::ranges::lower_bound(its, point.facet, {}, facet);
       one != its.end() && facet(*one) == point.facet; ++one) {
    const double away = beyond(*one->polygon, side.model->geometry.normals[point.facet], at);
    if (away > least) continue;
    least = away;
    nearest = &*one;
  }
  if (nearest == nullptr) return std::nullopt;
  const auto is_surface = [](const RevisionChange& change) {
    return change.of == Of::place || change.of == Of::region;
  };
  const auto first = std::ranges::find_if(changes, is_surface) - changes.begin();
  return static_cast<std::size_t>(first) + nearest->number +
         (nearest->what == Lit::other_region ? comparison.surface.places.size() : 0);
}

std::vector<LitPolygon> Revisions::lit_of(bool second, std::size_t change) const {
  const RevisionChange& asked = changes[change];
  std::vector<LitPolygon> found;
  if (asked.of != Of::place && asked.of != Of::region) return found;
  for (const LitPolygon& one : lit[second ? 1 : 0])
    if ((one.what == Lit::other_region) == (asked.of == Of::region) && one.number == asked.number)
      found.push_back(one);
  return found;
}

std::vector<PieceIndex> Revisions::pieces_of(bool second, std::size_t change) const {
  const RevisionChange& asked = changes[change];
  const auto& plan = part(second).plan;
  if (!plan || asked.of == Of::place || asked.of == Of::region) return {};
  const MatchedChange& matched =
      (asked.of == Of::undercut ? comparison.undercuts : comparison.actions)[asked.number];
  const auto& number = second ? matched.b : matched.a;
  if (!number) return {};
  if (asked.of == Of::undercut) return plan->undercuts[*number].undercut.pieces;
  std::vector<PieceIndex> pieces;
  for (const std::size_t undercut : plan->actions[*number].undercuts) {
    const auto& more = plan->undercuts[undercut].undercut.pieces;
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  return pieces;
}

std::optional<std::size_t> nearest_change(const Revisions& revisions, const RevisionChange& change) {
  std::optional<std::size_t> found;
  double nearest = 0.5 * change.bounds.diagonal();
  for (std::size_t k = 0; k < revisions.changes.size(); ++k) {
    const RevisionChange& other = revisions.changes[k];
    const double away = glm::distance(other.bounds.center(), change.bounds.center());
    if (other.of != change.of || away > nearest) continue;
    nearest = away;
    found = k;
  }
  return found;
}

std::vector<ViewBody> lit_bodies(const Revisions& revisions, bool second,
                                 const std::optional<std::size_t>& chosen,
                                 const std::optional<CutPlane>& cut) {
  const ComparedPart& part = revisions.part(second);
  const SplitMesh& split = *part.result.split;
  const UnitFrame& frame = part.model->frame;
  constexpr Colour k_chosen_surface = {255, 246, 214};
  const auto normal_of = [&](PieceIndex piece) {
    return part.model->geometry.normals[split.pieces[piece].facet];
  };
  SurfaceSheets changed(frame, lit_colour(second ? Lit::added : Lit::gone), cut),
      choice(frame, k_chosen_surface, cut), other(frame, lit_colour(Lit::other_region), cut);
  for (const LitPolygon& one : revisions.lit[second ? 1 : 0]) {
    const bool region = one.what == Lit::other_region;
    const bool here = chosen && revisions.changes[*chosen].number == one.number &&
                      revisions.changes[*chosen].of == (region ? Of::region : Of::place);
    (here ? choice : region ? other : changed).add(*one.polygon, normal_of(one.piece));
  }
  if (chosen) {
    for (const PieceIndex piece : revisions.pieces_of(second, *chosen)) {
      const auto& [a, b, c] = split.pieces[piece].corners;
      choice.add(std::array{split.vertices[a], split.vertices[b], split.vertices[c]}, normal_of(piece));
    }
  }
  std::vector<ViewBody> bodies;
  for (SurfaceSheets* sheets : {&changed, &other, &choice}) bodies.push_back(std::move(sheets->body));
  return bodies;
}

}  // namespace moldlight
