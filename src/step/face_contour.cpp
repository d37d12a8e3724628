#include "step/face_contour.hpp"

#include <cmath>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>

namespace moldlight::step {

namespace {

constexpr int k_most_steps = 20;
constexpr double k_same_sine = 1e-12;

/// How far the normal is from the contour's at a point, and the shortest step in the parameters to it.
struct Slope {
  gp_Pnt point;
  double off = 0.0;
  gp_Vec2d gradient, step;
};

std::optional<Slope> slope_at(const Handle(Geom_Surface) & surface, const gp_Dir& direction, double sine,
                              const gp_Pnt2d& uv) {
  gp_Vec u, v, uu, vv, mixed;
  Slope slope;
  surface->D2(uv.X(), uv.Y(), slope.point, u, v, uu, vv, mixed);
  const gp_Vec across = u.Crossed(v);
  const double length = across.Magnitude();
  if (length <= gp::Resolution()) return std::nullopt;
  const gp_Vec normal = across / length, along(direction);
  slope.off = normal.Dot(along) - sine;
  const gp_Vec beside = (along - normal.Dot(along) * normal) / length;
  slope.gradient = gp_Vec2d((uu.Crossed(v) + u.Crossed(mixed)).Dot(beside),
                            (mixed.Crossed(v) + u.Crossed(vv)).Dot(beside));
  // Shortest on the surface, not among its parameters.
  const double e = u.Dot(u), f = u.Dot(v), g = v.Dot(v);
  const gp_Vec2d way(g * slope.gradient.X() - f * slope.gradient.Y(),
                     e * slope.gradient.Y() - f * slope.gradient.X());
  const double gain = way.Dot(slope.gradient);
  if (gain <= gp::Resolution()) return std::nullopt;
  slope.step = way * (-slope.off / gain);
  return slope;
}

}  // namespace

std::optional<Place> on_contour(const TopoDS_Face& face, const Contour& contour, const Place& from,
                                double reach) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  const double sine = face.Orientation() == TopAbs_REVERSED ? -contour.sine : contour.sine;
  Place place = from;
  gp_Pnt2d uv = from.uv;
  Handle(Geom2d_Curve) outline;
  double begin = 0.0, end = 0.0;
  if (place.on_edge) {
    outline = BRep_Tool::CurveOnSurface(place.on_edge->edge, face, begin, end);
    if (outline.IsNull() || BRep_Tool::Degenerated(place.on_edge->edge)) return std::nullopt;
    uv = outline->Value(place.on_edge->parameter);
  }
  const gp_Pnt2d start = uv;
  for (int k = 0; k < k_most_steps; ++k) {
    const auto slope = slope_at(surface, contour.direction, sine, uv);
    if (!slope || slope->point.Distance(from.point) > reach) return std::nullopt;
    place.point = slope->point;
    // On a seam the place stays on its side.
    place.uv = from.uv.Translated(gp_Vec2d(start, uv));
    if (std::abs(slope->off) < k_same_sine) return place;
    if (!place.on_edge) {
      uv.Translate(slope->step);
      continue;
    }
    double& parameter = place.on_edge->parameter;
    gp_Vec2d along;
    outline->D1(parameter, uv, along);
    const double gain = along.Dot(slope->gradient);
    if (std::abs(gain) <= gp::Resolution()) return std::nullopt;
    parameter -= slope->off / gain;
    if (parameter <= begin || parameter >= end) return std::nullopt;
    uv = outline->Value(parameter);
  }
  return std::nullopt;
}

}  // namespace moldlight::step
