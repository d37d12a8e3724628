#include "step/border_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopoDS.hxx>
#include <gp_Ax22d.hxx>
#include <gp_Circ2d.hxx>
#include <gp_Dir2d.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>

namespace moldlight::step {

namespace {

constexpr double k_corner_rad = 0.35;       // a curve that bends by more at a point ends there
constexpr double k_arc_step_rad = 0.55;     // points on an arc are no farther apart
constexpr double k_arc_rise = 15.0;         // and rise no more over their chord, in tolerances
constexpr double k_tolerance_margin = 1.2;  // of tolerances over what was measured
constexpr std::size_t k_arc_points = 4;     // on an arc, at least

using Points = std::vector<gp_Pnt2d>;

/// The surface of a face, with its place.
class Ground {
 public:
  explicit Ground(const TopoDS_Face& face)
      : face_(face), surface_(BRep_Tool::Surface(face)), kind_(BRepAdaptor_Surface(face, false).GetType()) {}

  [[nodiscard]] bool plane() const { return kind_ == GeomAbs_Plane; }
  [[nodiscard]] gp_Pnt at(const gp_Pnt2d& uv) const { return surface_->Value(uv.X(), uv.Y()); }
  [[nodiscard]] const TopoDS_Face& face() const { return face_; }
  [[nodiscard]] const Handle(Geom_Surface) & surface() const { return surface_; }
  /// Of the point where the parameters move by `step`.
  [[nodiscard]] gp_Vec moved(const gp_Pnt2d& uv, const gp_Vec2d& step) const {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface_->D1(uv.X(), uv.Y(), point, along_u, along_v);
    return step.X() * along_u + step.Y() * along_v;
  }

 private:
  const TopoDS_Face& face_;
  Handle(Geom_Surface) surface_;
  GeomAbs_SurfaceType kind_;
};

/// How far `point` is from the line between two others on the surface.
double off_line(const Ground& ground, const gp_Pnt2d& from, const gp_Pnt2d& to, const gp_Pnt2d& point) {
  const gp_Vec2d line(from, to), way(from, point);
  const gp_Vec along = ground.moved(from, line), there = ground.moved(from, way);
  const double square = along.SquareMagnitude();
  const double share = square > 0.0 ? std::clamp(there.Dot(along) / square, 0.0, 1.0) : 0.0;
  return ground.at(point).Distance(ground.at(from.Translated(share * line)));
}

/// Marks the points between `a` and `b` that are needed (Douglas & Peucker 1973).
void mark_needed(const Ground& ground, const Points& points, std::size_t a, std::size_t b, double tolerance,
                 std::vector<bool>& needed) {
  std::vector<std::pair<std::size_t, std::size_t>> runs = {{a, b}};
  while (!runs.empty()) {
    const auto [from, to] = runs.back();
    runs.pop_back();
    std::size_t farthest = from;
    double most = tolerance;
    for (std::size_t k = from + 1; k < to; ++k) {
      const double off = off_line(ground, points[from], points[to], points[k]);
      if (off <= most) continue;
      most = off;
      farthest = k;
    }
    if (farthest == from) continue;
    needed[farthest] = true;
    runs.push_back({from, farthest});
    runs.push_back({farthest, to});
  }
}

Points simplified(const Ground& ground, const Points& points, double tolerance) {
  std::vector<bool> needed(points.size(), false);
  needed.front() = needed.back() = true;
  std::size_t middle = 0;  // of a closed chain, the farthest from its end
  const gp_Pnt start = ground.at(points.front());
  if (points.size() > 3 && start.Distance(ground.at(points.back())) < tolerance) {
    double most = 0.0;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
      const double far = start.Distance(ground.at(points[k]));
      if (far <= most) continue;
      most = far;
      middle = k;
    }
    needed[middle] = true;
  }
  if (middle > 0) mark_needed(ground, points, 0, middle, tolerance, needed);
  mark_needed(ground, points, middle, points.size() - 1, tolerance, needed);
  Points kept;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (needed[k]) kept.push_back(points[k]);
  return kept;
}

struct Circle {
  gp_Pnt2d centre;
  double radius = 0.0;
};

std::optional<Circle> circle_through(const gp_Pnt2d& a, const gp_Pnt2d& b, const gp_Pnt2d& c) {
  const gp_Vec2d to_b(a, b), to_c(a, c);
  const double twice = 2.0 * to_b.Crossed(to_c);
  if (std::abs(twice) < 1e-9 * to_b.Magnitude() * to_c.Magnitude()) return std::nullopt;
  const double b2 = to_b.SquareMagnitude(), c2 = to_c.SquareMagnitude();
  const gp_Vec2d to_centre((to_c.Y() * b2 - to_b.Y() * c2) / twice, (to_b.X() * c2 - to_c.X() * b2) / twice);
  return Circle{a.Translated(to_centre), to_centre.Magnitude()};
}

/// The circle that points from `a` to `b` of a plane go along, always in one sense; its sign is that of
/// `turned`, the angle in all.
std::optional<Circle> arc_along(const Points& points, std::size_t a, std::size_t b, double tolerance,
                                double& turned) {
  const auto circle = circle_through(points[a], points[(a + b) / 2], points[b]);
  if (!circle) return std::nullopt;
  turned = 0.0;
  for (std::size_t k = a; k <= b; ++k) {
    if (std::abs(circle->centre.Distance(points[k]) - circle->radius) > tolerance) return std::nullopt;
    if (k == a) continue;
    const double step = gp_Vec2d(circle->centre, points[k - 1]).Angle(gp_Vec2d(circle->centre, points[k]));
    const double rise = circle->radius * (1.0 - std::cos(0.5 * step));
    if (std::abs(step) > k_arc_step_rad || rise > k_arc_rise * tolerance ||
        (turned != 0.0 && (step > 0.0) != (turned > 0.0))) {
      return std::nullopt;
    }
    turned += step;
  }
  if (std::abs(turned) > 6.0) return std::nullopt;  // an arc is less than a whole turn
  return circle;
}

/// Makes the edges one after the other.
class EdgeMaker {
 public:
  EdgeMaker(const Ground& ground, TopoDS_Vertex first, TopoDS_Vertex last)
      : ground_(ground), from_(std::move(first)), last_(std::move(last)) {}

  /// `pieces` run straight in the parameters.
  void add(const Handle(Geom_Curve) & curve, const Handle(Geom2d_Curve) & parameters, double begin,
           double end, bool is_last, int pieces = 4) {
    const BRep_Builder builder;
    TopoDS_Vertex to = last_;
    if (!is_last) builder.MakeVertex(to, curve->Value(end), Precision::Confusion());
    double tolerance = Precision::Confusion();
    const int looks = 16 * pieces;
    for (int k = 0; k <= looks; ++k) {
      const double at = begin + (end - begin) * k / looks;
      tolerance = std::max(tolerance,
                           k_tolerance_margin * curve->Value(at).Distance(ground_.at(parameters->Value(at))));
    }
    TopoDS_Edge edge;
    builder.MakeEdge(edge, curve, tolerance);
    builder.UpdateEdge(edge, parameters, ground_.face(), tolerance);
    builder.Add(edge, from_.Oriented(TopAbs_FORWARD));
    builder.Add(edge, to.Oriented(TopAbs_REVERSED));
    builder.Range(edge, begin, end);
    builder.SameRange(edge, Standard_True);
    builder.SameParameter(edge, Standard_True);
    for (const auto& [vertex, at] : {std::pair(from_, begin), std::pair(to, end)}) {
      const double off = std::max(curve->Value(at).Distance(BRep_Tool::Pnt(vertex)),
                                  ground_.at(parameters->Value(at)).Distance(BRep_Tool::Pnt(vertex)));
      builder.UpdateVertex(vertex, std::max(tolerance, k_tolerance_margin * off));
    }
    edges_.push_back(edge);
    from_ = to;
  }

  [[nodiscard]] std::vector<TopoDS_Edge> take() { return std::move(edges_); }

 private:
  const Ground& ground_;
  TopoDS_Vertex from_, last_;
  std::vector<TopoDS_Edge> edges_;
};

void add_line(EdgeMaker& maker, const Ground& ground, const gp_Pnt2d& from, const gp_Pnt2d& to,
              bool is_last) {
  const gp_Vec2d way(from, to);
  const gp_Pnt start = ground.at(from);
  const gp_Vec line(start, ground.at(to));
  maker.add(new Geom_Line(start, line), new Geom2d_Line(from, way), 0.0, line.Magnitude(), is_last);
}

void add_arc(EdgeMaker& maker, const Ground& ground, const Circle& circle, const gp_Pnt2d& from,
             double turned, bool is_last) {
  const gp_Dir2d start{gp_Vec2d(circle.centre, from)};
  const gp_Circ2d arc(gp_Ax2d(circle.centre, start), circle.radius, turned > 0.0);
  const gp_Pln plane = BRepAdaptor_Surface(ground.face(), false).Plane();
  const Handle(Geom2d_Curve) parameters = new Geom2d_Circle(arc);
  maker.add(GeomAPI::To3d(parameters, plane), parameters, 0.0, std::abs(turned), is_last);
}

/// True where one parameter stays and the isoline is the edge.
bool add_isoline(EdgeMaker& maker, const Ground& ground, const gp_Pnt2d& from, const gp_Pnt2d& to,
                 bool is_last) {
  const gp_Vec2d way(from, to);
  const bool along_u = std::abs(way.Y()) <= 1e-9 * std::abs(way.X());
  if (!along_u && std::abs(way.X()) > 1e-9 * std::abs(way.Y())) return false;
  Handle(Geom_Curve) curve = along_u ? ground.surface()->VIso(from.Y()) : ground.surface()->UIso(from.X());
  double begin = along_u ? from.X() : from.Y(), end = along_u ? to.X() : to.Y();
  gp_Dir2d sense = along_u ? gp_Dir2d(1, 0) : gp_Dir2d(0, 1);
  gp_Pnt2d origin = along_u ? gp_Pnt2d(0, from.Y()) : gp_Pnt2d(from.X(), 0);
  if (begin > end) {
    const double turned_begin = curve->ReversedParameter(begin), turned_end = curve->ReversedParameter(end);
    curve->Reverse();
    sense.Reverse();
    origin = from.Translated(-turned_begin * gp_Vec2d(sense));
    begin = turned_begin;
    end = turned_end;
  }
  maker.add(curve, new Geom2d_Line(origin, sense), begin, end, is_last);
  return true;
}

/// Straight from point to point in the parameters; in space a cubic for each of these pieces, with the
/// surface's own tangents at its ends.
void add_curve(EdgeMaker& maker, const Ground& ground, const Points& points, std::size_t first,
               std::size_t last, bool is_last) {
  constexpr double k_piece_rad = 0.2;  // of bend in space, at most
  Points at = {points[first]};
  for (std::size_t k = first + 1; k <= last; ++k) {
    const gp_Pnt2d from = points[k - 1], to = points[k];
    const gp_Vec2d way(from, to);
    double bend = 0.0;
    const gp_Vec start = ground.moved(from, way);
    for (const double share : {0.5, 1.0}) {
      const gp_Vec there = ground.moved(from.Translated(share * way), way);
      if (start.Magnitude() > gp::Resolution() && there.Magnitude() > gp::Resolution())
        bend = std::max(bend, start.Angle(there));
    }
    const int pieces = 1 + static_cast<int>(bend / k_piece_rad);
    for (int piece = 1; piece <= pieces; ++piece)
      at.push_back(piece == pieces ? to : from.Translated(way * (double(piece) / pieces)));
  }
  const int pieces = static_cast<int>(at.size()) - 1;
  TColgp_Array1OfPnt2d poles_2d(1, pieces + 1);
  TColgp_Array1OfPnt poles(1, 3 * pieces + 1);
  TColStd_Array1OfReal knots(1, pieces + 1);
  TColStd_Array1OfInteger times_2d(1, pieces + 1), times(1, pieces + 1);
  for (int k = 0; k <= pieces; ++k) {
    const gp_Pnt2d here = at[static_cast<std::size_t>(k)];
    poles_2d(k + 1) = here;
    poles(3 * k + 1) = ground.at(here);
    knots(k + 1) =
        k == 0 ? 0.0
               : knots(k) + std::max(ground.at(at[static_cast<std::size_t>(k) - 1]).Distance(ground.at(here)),
                                     Precision::Confusion());
    times_2d(k + 1) = k == 0 || k == pieces ? 2 : 1;
    times(k + 1) = k == 0 || k == pieces ? 4 : 3;
    if (k == 0) continue;
    const gp_Pnt2d before = at[static_cast<std::size_t>(k) - 1];
    const gp_Vec2d way(before, here);
    poles(3 * k - 1) = poles(3 * k - 2).Translated(ground.moved(before, way) / 3.0);
    poles(3 * k) = poles(3 * k + 1).Translated(ground.moved(here, way) / -3.0);
  }
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, times, 3);
  const Handle(Geom2d_BSplineCurve) parameters = new Geom2d_BSplineCurve(poles_2d, knots, times_2d, 1);
  maker.add(curve, parameters, knots(1), knots(pieces + 1), is_last, pieces);
}

bool is_isoline(const gp_Pnt2d& from, const gp_Pnt2d& to) {
  const double du = std::abs(to.X() - from.X()), dv = std::abs(to.Y() - from.Y());
  return std::min(du, dv) <= 1e-9 * std::max(du, dv);
}

/// Where a curve from `first` has to end: before an isoline, at a corner, at the last point.
std::size_t curve_end(const Ground& ground, const Points& points, std::size_t first) {
  std::size_t last = first + 1;
  for (; last + 1 < points.size(); ++last) {
    if (is_isoline(points[last], points[last + 1])) break;
    const gp_Vec before = ground.moved(points[last], gp_Vec2d(points[last - 1], points[last]));
    const gp_Vec after = ground.moved(points[last], gp_Vec2d(points[last], points[last + 1]));
    if (before.Magnitude() <= gp::Resolution() || after.Magnitude() <= gp::Resolution() ||
        before.Angle(after) > k_corner_rad)
      break;
  }
  return last;
}

}  // namespace

std::vector<TopoDS_Edge> border_edges(const TopoDS_Face& face, const TopoDS_Vertex& first,
                                      const TopoDS_Vertex& last, const std::vector<gp_Pnt2d>& points,
                                      double tolerance) {
  const Ground ground(face);
  const Points kept = simplified(ground, points, tolerance);
  EdgeMaker maker(ground, first, last);
  const std::size_t end = kept.size() - 1;
  for (std::size_t k = 0; k < end;) {
    if (ground.plane()) {
      std::size_t to = k;
      double turned = 0.0;
      std::optional<Circle> circle;
      for (std::size_t next = k + k_arc_points - 1; next <= end; ++next) {
        double longer = 0.0;
        const auto found = arc_along(kept, k, next, tolerance, longer);
        if (!found) break;
        circle = found;
        turned = longer;
        to = next;
      }
      if (circle) {
        add_arc(maker, ground, *circle, kept[k], turned, to == end);
        k = to;
      } else {
        add_line(maker, ground, kept[k], kept[k + 1], k + 1 == end);
        ++k;
      }
    } else if (add_isoline(maker, ground, kept[k], kept[k + 1], k + 1 == end)) {
      ++k;
    } else {
      const std::size_t to = curve_end(ground, kept, k);
      add_curve(maker, ground, kept, k, to, to == end);
      k = to;
    }
  }
  return maker.take();
}

}  // namespace moldlight::step
