#include "step/cut_edges.hpp"

#include <algorithm>
#include <cmath>

#include <BOPTools_AlgoTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_CurveRepresentation.hxx>
#include <BRep_ListOfCurveRepresentation.hxx>
#include <BRep_TEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>

namespace moldlight::step {

namespace {

/// Files state tolerances that hold at the places that are looked at of the whole edge, but not of a piece.
void widen_tolerance(const TopoDS_Edge& edge) {
  constexpr int k_looks = 64;
  double begin = 0.0, end = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end);
  if (curve.IsNull()) return;
  double off = 0.0;
  const auto look = [&](const Handle(Geom2d_Curve) & parameters, const Handle(Geom_Surface) & surface,
                        const TopLoc_Location& location) {
    for (int k = 0; k <= k_looks; ++k) {
      const double at = begin + (end - begin) * k / k_looks;
      const gp_Pnt2d uv = parameters->Value(at);
      const gp_Pnt there = surface->Value(uv.X(), uv.Y()).Transformed(location.Transformation());
      off = std::max(off, there.Distance(curve->Value(at)));
    }
  };
  for (const Handle(BRep_CurveRepresentation) & one : Handle(BRep_TEdge)::DownCast(edge.TShape())->Curves()) {
    if (!one->IsCurveOnSurface()) continue;
    const TopLoc_Location location = edge.Location() * one->Location();
    look(one->PCurve(), one->Surface(), location);
    if (one->IsCurveOnClosedSurface()) look(one->PCurve2(), one->Surface(), location);
  }
  const BRep_Builder builder;
  builder.UpdateEdge(edge, 1.2 * off);
  for (TopoDS_Iterator walk(edge); walk.More(); walk.Next())
    builder.UpdateVertex(TopoDS::Vertex(walk.Value()), BRep_Tool::Tolerance(edge));
}

}  // namespace

void CutEdges::cut() {
  for (auto& [key, asked] : asked_) {
    Cut& cut = cuts_[key];
    const TopoDS_Edge edge = TopoDS::Edge(asked.front().edge.Oriented(TopAbs_FORWARD));
    double begin = 0.0, end = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end);
    BRep_Tool::Range(edge, begin, end);
    cut.stops = {{begin, TopExp::FirstVertex(edge)}, {end, TopExp::LastVertex(edge)}};
    std::ranges::sort(asked, {}, &OnEdge::parameter);
    for (const OnEdge& at : asked) {
      const auto near = [&](const Stop& stop) {
        return distance(curve, at.parameter, stop.parameter, end - begin) < tolerance_;
      };
      const std::size_t last = cut.stops.size() - 1;
      if (near(cut.stops[last]) || near(cut.stops[last - 1])) continue;
      if (at.parameter <= cut.stops[last - 1].parameter || at.parameter >= end) continue;
      Stop stop{at.parameter, {}};
      if (curve.IsNull())
        stop.vertex = cut.stops.front().vertex;
      else
        BRep_Builder().MakeVertex(stop.vertex, curve->Value(at.parameter), BRep_Tool::Tolerance(edge));
      cut.stops.insert(cut.stops.end() - 1, stop);
    }
    if (cut.stops.size() == 2) continue;
    BRep_Builder().MakeWire(cut.pieces);
    for (std::size_t k = 1; k < cut.stops.size(); ++k) {
      TopoDS_Edge piece;
      BOPTools_AlgoTools::MakeSplitEdge(edge, cut.stops[k - 1].vertex, cut.stops[k - 1].parameter,
                                        cut.stops[k].vertex, cut.stops[k].parameter, piece);
      widen_tolerance(piece);
      BRep_Builder().Add(cut.pieces, piece);
    }
    cut.edge = edge;
  }
}

std::pair<TopoDS_Vertex, double> CutEdges::stop(const OnEdge& at) const {
  const Cut& cut = cuts_.at(at.edge.TShape().get());
  double begin = 0.0, end = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(at.edge, begin, end);
  const Stop& nearest = *std::ranges::min_element(cut.stops, {}, [&](const Stop& stop) {
    return std::pair(distance(curve, at.parameter, stop.parameter, 1.0),
                     std::abs(stop.parameter - at.parameter));
  });
  return {nearest.vertex, nearest.parameter};
}

void CutEdges::append(const TopoDS_Edge& edge, TopTools_ListOfShape& list) const {
  const auto found = cuts_.find(edge.TShape().get());
  if (found == cuts_.end() || found->second.pieces.IsNull()) {
    list.Append(edge);
    return;
  }
  for (TopoDS_Iterator walk(found->second.pieces); walk.More(); walk.Next())
    list.Append(walk.Value().Oriented(edge.Orientation()));
}

void CutEdges::replace_in(BRepTools_ReShape& shapes) const {
  for (const auto& [key, cut] : cuts_)
    if (!cut.pieces.IsNull()) shapes.Replace(cut.edge, cut.pieces);
}

double CutEdges::distance(const Handle(Geom_Curve) & curve, double a, double b, double range) {
  constexpr double k_millionths = 1e6;
  return curve.IsNull() ? k_millionths * std::abs(a - b) / range : curve->Value(a).Distance(curve->Value(b));
}

}  // namespace moldlight::step
