#include "step/border_chains.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include <BRep_Tool.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2dAPI_ProjectPointOnCurve.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Pnt.hxx>

#include "step/face_contour.hpp"

namespace moldlight::step {

namespace {

constexpr double k_band = 15.0;  // beside a bent outline, in tolerances

/// A border comes to a pole straight along the parameters.
void straighten(Place& pole, const Place& before, const TopoDS_Face& face) {
  if (!pole.on_edge || !BRep_Tool::Degenerated(pole.on_edge->edge)) return;
  double begin = 0.0, end = 0.0;
  const auto curve = BRep_Tool::CurveOnSurface(pole.on_edge->edge, face, begin, end);
  const Geom2dAPI_ProjectPointOnCurve nearest(before.uv, curve, begin, end);
  if (nearest.NbPoints() == 0) return;
  pole.on_edge->parameter = nearest.LowerDistanceParameter();
  pole.uv = nearest.NearestPoint();
}

/// Facets leave their bent outline by the deflection, and a border that begins along it leaves the face
/// there: it goes straight to the outline from its first point, from the front, that is farther than `band`.
/// False for one that stays there all the way.
bool leave_outline(std::vector<Place>& places, const TopoDS_Face& face, double band) {
  if (!places.front().on_edge || BRep_Tool::Degenerated(places.front().on_edge->edge)) return true;
  OnEdge& at = *places.front().on_edge;
  double begin = 0.0, end = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(at.edge, begin, end);
  const auto outline = BRep_Tool::CurveOnSurface(at.edge, face, begin, end);
  if (outline.IsNull() || Geom2dAdaptor_Curve(outline).GetType() == GeomAbs_Line) return true;
  std::size_t first = 1;
  for (; first + 1 < places.size(); ++first) {
    const GeomAPI_ProjectPointOnCurve nearest(places[first].point, curve, begin, end);
    if (nearest.NbPoints() == 0 || nearest.LowerDistance() > band) break;
  }
  if (first + 1 == places.size() && places.back().on_edge && places.back().on_edge->edge.IsSame(at.edge))
    return false;
  places.erase(places.begin() + 1, places.begin() + static_cast<std::ptrdiff_t>(first));
  const gp_Pnt2d from = places[1].uv;
  const gp_Vec2d way(from, places[0].uv);
  if (way.Magnitude() <= gp::Resolution()) return true;
  const Handle(Geom2d_Curve) line = new Geom2d_TrimmedCurve(new Geom2d_Line(from, way), 0.0, way.Magnitude());
  const Geom2dAPI_InterCurveCurve meets(line, new Geom2d_TrimmedCurve(outline, begin, end));
  double nearest = way.Magnitude();
  for (int k = 1; k <= meets.NbPoints(); ++k) {
    const IntRes2d_IntersectionPoint& met = meets.Intersector().Point(k);
    if (met.ParamOnFirst() >= nearest) continue;
    nearest = met.ParamOnFirst();
    at.parameter = met.ParamOnSecond();
    places[0].uv = met.Value();
  }
  return true;
}

gp_Pnt point_of(const std::array<double, 3>& at, const gp_Trsf& to_body) {
  return gp_Pnt(at[0], at[1], at[2]).Transformed(to_body);
}

struct Step {
  const StepBorder* border;
  Place from, to;
  std::vector<Place> between = {};
  bool used = false;
};

/// Moves the ends of borders at contours, and all other borders that end there, and puts places between them,
/// since the contour bends there.
void move_to_contours(std::vector<Step>& steps, const TopoDS_Face& face, const FaceMesh& mesh,
                      const FaceBorders& asked) {
  struct Move {
    gp_Vec2d shift;  // on either side of a seam
    Place to;
  };
  std::map<std::uint32_t, std::optional<Move>> moves;  // by the vertex
  // The contour is in one of the facets on both sides.
  const auto reach = [&](const StepBorder& border) {
    return mesh.greatest_height(border.facet - asked.first_facet);
  };
  for (const Step& step : steps) {
    const StepBorder& border = *step.border;
    if (!border.on_contour()) continue;
    for (const auto& [place, vertex] :
         {std::pair(&step.from, border.vertices[0]), std::pair(&step.to, border.vertices[1])}) {
      const auto [entry, fresh] = moves.try_emplace(vertex);
      if (!fresh) continue;
      if (const auto moved = on_contour(face, {*asked.direction, border.contour}, *place, reach(border)))
        entry->second = Move{gp_Vec2d(place->uv, moved->uv), *moved};
    }
  }
  const auto move = [&](Place& place, std::uint32_t vertex) {
    const auto found = moves.find(vertex);
    if (found == moves.end() || !found->second) return false;
    const auto& there = found->second->to.on_edge;
    if (place.on_edge.has_value() != there.has_value() || (there && !there->edge.IsSame(place.on_edge->edge)))
      return false;
    place.uv.Translate(found->second->shift);
    place.point = found->second->to.point;
    if (there) place.on_edge->parameter = there->parameter;
    return true;
  };
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  for (Step& step : steps) {
    const StepBorder& border = *step.border;
    const double most = reach(border);
    const bool from = move(step.from, border.vertices[0]), to = move(step.to, border.vertices[1]);
    if (!border.on_contour() || !from || !to) continue;
    for (const double share : {0.25, 0.5, 0.75}) {
      Place place{.uv = step.from.uv.Translated(share * gp_Vec2d(step.from.uv, step.to.uv)),
                  .point = {},
                  .on_edge = {}};
      place.point = surface->Value(place.uv.X(), place.uv.Y());
      if (const auto moved = on_contour(face, {*asked.direction, border.contour}, place, most))
        step.between.push_back(*moved);
    }
  }
}

}  // namespace

std::vector<Chain> chains_of(const TopoDS_Face& face, const FaceBorders& asked) {
  const FaceMesh mesh(face, asked.tolerance);
  std::vector<Step> steps;
  std::map<std::uint32_t, std::vector<std::size_t>> out, in;
  std::map<std::uint32_t, OnEdge> on_edge;
  for (const StepBorder& border : asked.borders) {
    const gp_Pnt from = point_of(border.from, asked.to_body), to = point_of(border.to, asked.to_body);
    const std::size_t facet = border.facet - asked.first_facet;
    if (mesh.along_edge(facet, from, to)) continue;
    Step step{&border, mesh.place(facet, from), mesh.place(facet, to)};
    if (step.from.on_edge && step.to.on_edge && from.Distance(to) < k_near_edge * asked.tolerance) continue;
    out[border.vertices[0]].push_back(steps.size());
    in[border.vertices[1]].push_back(steps.size());
    steps.push_back(std::move(step));
    if (steps.back().from.on_edge) on_edge.try_emplace(border.vertices[0], *steps.back().from.on_edge);
    if (steps.back().to.on_edge) on_edge.try_emplace(border.vertices[1], *steps.back().to.on_edge);
  }
  // A facet that only touches an edge of the face does not know that it does.
  for (Step& step : steps) {
    for (const auto& [place, vertex] :
         {std::pair(&step.from, step.border->vertices[0]), std::pair(&step.to, step.border->vertices[1])}) {
      if (const auto found = on_edge.find(vertex); found != on_edge.end() && !place->on_edge)
        place->on_edge = found->second;
    }
  }
  if (asked.direction) move_to_contours(steps, face, mesh, asked);
  const auto passes = [&](std::uint32_t vertex) {
    if (on_edge.contains(vertex)) return false;
    const auto ins = in.find(vertex), outs = out.find(vertex);
    if (ins == in.end() || outs == out.end() || ins->second.size() != 1 || outs->second.size() != 1)
      return false;
    const StepBorder &a = *steps[ins->second.front()].border, &b = *steps[outs->second.front()].border;
    return a.left == b.left && a.right == b.right;
  };
  const bool reversed = face.Orientation() == TopAbs_REVERSED;
  std::vector<Chain> chains;
  const auto walk = [&](std::size_t start) {
    const StepBorder& begin = *steps[start].border;
    Chain chain{.places = {steps[start].from}, .first = begin.vertices[0]};
    chain.left = reversed ? begin.right : begin.left;
    chain.right = reversed ? begin.left : begin.right;
    for (std::size_t k = start; !steps[k].used;) {
      steps[k].used = true;
      std::ranges::copy(steps[k].between, std::back_inserter(chain.places));
      chain.places.push_back(steps[k].to);
      chain.last = steps[k].border->vertices[1];
      if (!passes(chain.last)) break;
      k = out.at(chain.last).front();
    }
    bool kept = true;
    for (int side = 0; side < 2; ++side) {
      straighten(chain.places.front(), chain.places[1], face);
      kept = leave_outline(chain.places, face, k_band * asked.tolerance) && kept;
      std::ranges::reverse(chain.places);
    }
    if (!kept) return;
    chains.push_back(std::move(chain));
  };
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (!steps[k].used && !passes(steps[k].border->vertices[0])) walk(k);
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (!steps[k].used) walk(k);
  return chains;
}

}  // namespace moldlight::step
